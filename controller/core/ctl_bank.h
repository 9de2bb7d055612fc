/* SPDX-License-Identifier: Apache-2.0 */
/* A program bank: header and step-table rows as they came over the line, and the check that a bank must pass
 * before it may ever move the axis. */
#ifndef CTL_BANK_H
#define CTL_BANK_H

#include "ctl_port.h"
#include "ctl_registers.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    uint16_t registers[CTL_BANK_REGISTERS];
} ctl_bank;

typedef struct {
    uint16_t result; /* CTL_TRANSFER_RESULT_... */
    uint16_t detail; /* row, or offset in the header, that was refused */
} ctl_verdict;

typedef struct {
    uint32_t pulses;
    uint32_t ticks;
} ctl_row;

uint32_t ctl_bank_row_count(const ctl_bank* bank);
/* Registers in use: header and rows. */
uint32_t ctl_bank_length(const ctl_bank* bank);
uint32_t ctl_bank_crc(const ctl_bank* bank);
uint32_t ctl_bank_cycle_ticks(const ctl_bank* bank);
ctl_row ctl_bank_row(const ctl_bank* bank, uint32_t index);
/* Pulses of `knife_revolutions` turns of the knife shaft, rounded down. */
uint32_t ctl_bank_revolution_pulses(const ctl_bank* bank, uint32_t knife_revolutions);
/* Knife angle in 0.01 degrees of an axis position in pulses from the index mark. */
uint16_t ctl_bank_knife_angle(const ctl_bank* bank, int64_t position);

/* Everything that must hold for the rows to be executed on this board; `length` registers were received. */
ctl_verdict ctl_bank_check(const ctl_bank* bank, const ctl_config* config, uint32_t length);
/* Knife radius, knives, pulses per revolution and gear are the same: the shaft need not stand still for a
 * change. */
bool ctl_bank_same_machine(const ctl_bank* one, const ctl_bank* other);

#ifdef __cplusplus
}
#endif

#endif
