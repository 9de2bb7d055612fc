/* SPDX-License-Identifier: Apache-2.0 */
/* The pins of the machine beside its axes: inputs, drive enable, cam switches. Limit switches are reported
 * only. The emergency stop ends a motion, but no safety depends on that: what stops the machine safely is
 * wired without the controller. */
#ifndef CTL_IO_H
#define CTL_IO_H

#include "motion/ctl_motion.h"
#include "motion/ctl_switches.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The time after which an output under test goes off unless it is tried again. */
#define CTL_TRY_HOLD_US 500000u

#define CTL_COUNT_CONTACT(name, bit, address) +1u
#define CTL_CONTACT_COUNT (0u CTL_CONTACTS(CTL_COUNT_CONTACT))

/* The speed of the cycle for the leads of the switches, and the ramp's that it was computed from. */
typedef struct {
    uint32_t speed;
    uint32_t ramp_full;
    uint32_t ramp_speed;
} ctl_switch_speed;

typedef struct {
    uint16_t inputs;   /* bits CTL_INPUT_BIT_..., as the slice began, by kind of contact and filtered */
    uint16_t closed;   /* the inputs whose contact is normally closed */
    uint16_t filtered; /* those with a filter time */
    uint16_t bounces;  /* those that have changed for less than it */
    uint32_t changed_us[CTL_CONTACT_COUNT]; /* since when, modulo 2^32 */
    uint32_t parameter_writes;              /* at which the parameters were read */
    uint32_t outputs;                       /* bits CTL_OUTPUT_BIT_..., as they are now */
    bool has_moved;                         /* since power-up */
    uint64_t moved_us;
    bool was_stopped; /* the emergency stop was pressed since power-up */
    uint64_t stopped_us;
    uint16_t tower;  /* outputs of the light tower, */
    uint32_t around; /* and those to the machines around */
    uint32_t tried;  /* outputs that a person holds on at standstill */
    uint64_t tried_until_us;
    ctl_switches switches;
    ctl_switch_speed switch_speed;
    uint16_t switch_levels;
} ctl_io;

void ctl_io_init(ctl_io* io, const ctl_board* board);
/* Starts a slice: reads the inputs, ends a motion when the emergency stop is pressed, enables the drives. */
void ctl_io_begin(ctl_io* io, ctl_motion* motion);
/* Ends a slice: updates the cam switches. */
void ctl_io_slice(ctl_io* io, const ctl_motion* motion);
bool ctl_io_drive_alarm(const ctl_io* io);
/* Returns true when it is pressed now or was shortly before: a bouncing contact is one warning. */
bool ctl_io_emergency_stop(const ctl_io* io, const ctl_board* board);
/* Switches these outputs on for CTL_TRY_HOLD_US, 0: none. Only the gate in ctl_start.c switches any on. */
void ctl_io_try(ctl_io* io, const ctl_board* board, uint32_t outputs);
/* Writes the registers of the group `io`. */
void ctl_io_registers(const ctl_io* io, const ctl_motion* motion, uint16_t* registers);

#ifdef __cplusplus
}
#endif

#endif
