/* SPDX-License-Identifier: Apache-2.0 */
/* A program bank: header and rows as they came over the line. What the rows are, and which of them are good,
 * is said where they are executed. */
#ifndef CTL_BANK_H
#define CTL_BANK_H

#include "base/ctl_port.h"
#include "ctl_registers.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A board with little memory may be compiled with smaller banks; it says so in its identity. */
#ifndef CTL_BANK_STORAGE
#define CTL_BANK_STORAGE CTL_BANK_REGISTERS
#endif

typedef struct {
    uint16_t registers[CTL_BANK_STORAGE];
} ctl_bank;

typedef struct {
    uint16_t result; /* CTL_TRANSFER_RESULT_... */
    uint16_t detail; /* row, or offset in the header, that was refused */
} ctl_verdict;

/* The list behind the rows of a cam: the knots or segments of which its curve is made. */
typedef struct {
    uint16_t count;     /* header register with the number of entries */
    uint16_t registers; /* of one entry; 0: the kind has no list */
    uint16_t capacity;
} ctl_bank_list;

/* Bit n set: program kind n can be executed. All kinds of the register map can. */
#define CTL_PROGRAM_KINDS ((2u << CTL_PROGRAM_KIND_LAST) - 2u)

/* The same of table layouts. */
#define CTL_TABLE_LAYOUTS ((2u << CTL_TABLE_LAYOUT_PRESS_STAGES) - 2u)

uint16_t ctl_bank_kind(const ctl_bank* bank);   /* CTL_PROGRAM_KIND_... */
uint16_t ctl_bank_layout(const ctl_bank* bank); /* CTL_TABLE_LAYOUT_... */
uint16_t ctl_bank_at_end(const ctl_bank* bank); /* CTL_END_BEHAVIOR_...; step tables repeat */
/* The time of the master from standstill to full speed; 0 when the layout has none or full speed comes at
 * once. */
uint16_t ctl_bank_master_ramp_ms(const ctl_bank* bank);
uint16_t ctl_bank_ramp_shape(const ctl_bank* bank); /* CTL_RAMP_SHAPE_... */
/* The direction of the master: -1 where the program wants it to run through the rows from their end to their
 * beginning. */
int32_t ctl_bank_direction(const ctl_bank* bank);
/* The kind follows a virtual master, whose speed goes on when the program changes. */
bool ctl_bank_follows_master(const ctl_bank* bank);
ctl_bank_list ctl_bank_list_of(const ctl_bank* bank);
uint32_t ctl_bank_list_count(const ctl_bank* bank);
/* Offset of the list's first register. */
uint32_t ctl_bank_list_offset(const ctl_bank* bank);
uint32_t ctl_bank_row_count(const ctl_bank* bank);
/* Registers in use: header, rows and what follows them; the header alone when the layout is not known. */
uint32_t ctl_bank_length(const ctl_bank* bank);
uint32_t ctl_bank_crc(const ctl_bank* bank);
uint32_t ctl_bank_cycle_ticks(const ctl_bank* bank);
/* Returns the bag length of a cutter. */
uint32_t ctl_bank_bag_um(const ctl_bank* bank);
uint32_t ctl_bank_remainder(const ctl_bank* bank);
uint32_t ctl_bank_divisor(const ctl_bank* bank);
/* Register of row `index`, `size` registers long each. */
static inline const uint16_t* ctl_bank_row_at(const ctl_bank* bank, uint32_t index, uint32_t size)
{
    return &bank->registers[CTL_OFFSET_BANK_ROWS + size * index];
}
/* The axis must stand on its index mark before the table's first cycle; moves start where the axis stands. */
bool ctl_bank_needs_homing(const ctl_bank* bank);
/* Pulses from one index mark to the next, `revolutions` times, rounded down: of the knife shaft, or of the
 * motor where there is no knife. */
uint32_t ctl_bank_revolution_pulses(const ctl_bank* bank, uint32_t revolutions);
/* Knife angle in 0.01 degrees of an axis position in pulses from the index mark. */
uint16_t ctl_bank_knife_angle(const ctl_bank* bank, int64_t position);

static inline ctl_verdict ctl_refuse(uint16_t result, uint32_t detail)
{
    const ctl_verdict verdict = {result, (uint16_t)detail};
    return verdict;
}
/* How far the check of a bank's rows has come; all 0 at first. */
typedef struct {
    uint32_t row;
    uint64_t ticks; /* sums of the rows so far */
    uint64_t pulses;
    uint64_t window; /* ticks of the last rows, as many as a slice may meet */
    int64_t last;    /* position of the row before */
    bool after_pause;
} ctl_row_check;

/* Returns the whole turn of the shaft with the index mark that is nearest to this position, in pulses. */
int64_t ctl_bank_nearest_turn(const ctl_bank* bank, int64_t position);
/* Registers that a bank of this board may have. */
uint32_t ctl_bank_capacity(const ctl_config* config);
/* Registers of a row of the bank's layout; 0 when the layout is not known. */
uint32_t ctl_bank_row_registers(const ctl_bank* bank);
/* The shortest cycle. A slice is shorter, so it crosses at most one boundary between cycles. */
#define CTL_MIN_CYCLE_US 2000u
/* Returns the first header register that no bank of `length` registers may have so on this board;
 * CTL_BANK_HEADER_REGISTERS when there is none. */
uint32_t ctl_bank_bad_header(const ctl_bank* bank, const ctl_config* config, uint32_t length);
/* Returns the header register of the cycle's time, its remainder or its divisor that is outside its range;
 * CTL_BANK_HEADER_REGISTERS when there is none. */
uint32_t ctl_bank_bad_cycle(const ctl_bank* bank, const ctl_config* config);
/* Returns true when `pulses` of the rows are the header's `length_um` of an axis, to one pulse. */
bool ctl_bank_is_distance(const ctl_bank* bank, int64_t pulses, int64_t length_um);
/* The kind and the data of the machine are the same (knife radius, knives and gear, or the feed; pulses per
 * revolution): the axis need not stand still for a change. */
bool ctl_bank_same_machine(const ctl_bank* one, const ctl_bank* other);

#ifdef __cplusplus
}
#endif

#endif
