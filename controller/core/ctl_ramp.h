/* SPDX-License-Identifier: Apache-2.0 */
/* Speed of the master against the table's, with linear ramps, in whole numbers only: the speed is speed /
 * full, both in timer ticks, and changes by one per tick. The travel (master ticks) is exact over any number
 * of calls; at full speed a master tick is a timer tick. */
#ifndef CTL_RAMP_H
#define CTL_RAMP_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    uint32_t full;  /* ticks from standstill to full speed, not 0 */
    uint32_t speed; /* 0..full */
    uint64_t rest;  /* travel not yet handed out, in 1 / (2 full) ticks */
} ctl_ramp;

/* Stand still, with `full` ticks to full speed from now on. */
void ctl_ramp_reset(ctl_ramp* ramp, uint32_t full);

/* Each takes the timer ticks that pass and returns the master ticks travelled. */
uint32_t ctl_ramp_up(ctl_ramp* ramp, uint32_t ticks);
uint32_t ctl_ramp_down(ctl_ramp* ramp, uint32_t ticks);
/* Runs on so that it stands still exactly after `remaining` master ticks; does not speed up beyond `limit`.
 * Has landed when it returns `remaining`. Needs ctl_ramp_can_land(). */
uint32_t ctl_ramp_land(ctl_ramp* ramp, uint32_t ticks, uint64_t remaining, uint32_t limit);
/* The ramp is short enough to stand still within `remaining` master ticks. */
int ctl_ramp_can_land(const ctl_ramp* ramp, uint64_t remaining);

/* Largest root with root * root <= square. */
uint32_t ctl_square_root(uint64_t square);

#ifdef __cplusplus
}
#endif

#endif
