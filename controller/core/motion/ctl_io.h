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

typedef struct {
    uint16_t inputs;  /* bits CTL_INPUT_BIT_..., as the slice began */
    uint16_t outputs; /* bits CTL_OUTPUT_BIT_..., as they are now */
    bool has_moved;   /* since power-up */
    uint64_t moved_us;
    bool was_stopped; /* the emergency stop was pressed since power-up */
    uint64_t stopped_us;
    ctl_switches switches;
} ctl_io;

void ctl_io_init(ctl_io* io, const ctl_board* board);
/* Starts a slice: reads the inputs, ends a motion when the emergency stop is pressed, enables the drives. */
void ctl_io_begin(ctl_io* io, ctl_motion* motion);
/* Ends a slice: updates the cam switches. */
void ctl_io_slice(ctl_io* io, const ctl_motion* motion);
bool ctl_io_drive_alarm(const ctl_io* io);
/* Returns true when it is pressed now or was shortly before: a bouncing contact is one warning. */
bool ctl_io_emergency_stop(const ctl_io* io, const ctl_board* board);
/* Writes the registers of the group `io`. */
void ctl_io_registers(const ctl_io* io, const ctl_motion* motion, uint16_t* registers);

#ifdef __cplusplus
}
#endif

#endif
