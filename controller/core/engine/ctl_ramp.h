/* SPDX-License-Identifier: Apache-2.0 */
/* Speed of the master against the table's, with ramps, in whole numbers only. `speed` goes from 0 to `full`,
 * or to a lower `limit`, by one per timer tick. Linear: speed / full is the share of full speed. S-curve: the
 * share is 2 x^2 up to x = speed / full = 1/2 and 1 - 2 (1 - x)^2 beyond, so that the acceleration rises and
 * falls linearly; both shapes travel full / 2 from standstill to full speed. The travel (master ticks) is
 * exact over any number of calls; at full speed a master tick is a timer tick. */
#ifndef CTL_RAMP_H
#define CTL_RAMP_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    uint32_t full;  /* ticks from standstill to full speed, not 0 */
    uint32_t speed; /* 0..full */
    uint32_t limit; /* 0..full: it gains no more than this, and comes down to it */
    uint64_t rest;  /* travel not yet handed out: linear in 1 / (2 full) ticks, S-curve in 1 / 2^31 */
    bool s_curve;
    /* Another master leads: */
    bool led;
    uint32_t top;     /* its speed */
    uint32_t stretch; /* of it, in which the line comes from standstill to that speed or back */
    uint64_t way;     /* of the line from standstill */
    uint32_t place;   /* of the master in the stretch for that way, 1 / 2^15 */
} ctl_ramp;

/* Stand still, with `full` ticks to full speed from now on, linearly. */
void ctl_ramp_reset(ctl_ramp* ramp, uint32_t full);
/* The same with an S-curve. */
void ctl_ramp_reset_s(ctl_ramp* ramp, uint32_t full);

/* Another master leads, at the speed `top`, which may be above full speed: the speed of the line is that
 * share of it which 3 x^2 - 2 x^3 is on the way x^3 - x^4 / 2 of the stretch, and `top` from half of the
 * stretch on. */
void ctl_ramp_lead(ctl_ramp* ramp, uint32_t top, uint32_t stretch, uint64_t way);

/* Its limit is so much of full speed, percent. */
void ctl_ramp_limit(ctl_ramp* ramp, uint32_t percent);

/* Each takes the timer ticks that pass and returns the master ticks travelled. The first goes up, or down to
 * the limit. */
uint32_t ctl_ramp_up(ctl_ramp* ramp, uint32_t ticks);
uint32_t ctl_ramp_down(ctl_ramp* ramp, uint32_t ticks);
/* Runs on so that it stands still exactly after `remaining` master ticks; does not speed up beyond `limit`.
 * Has landed when it returns `remaining`. Needs ctl_ramp_can_land(). */
uint32_t ctl_ramp_land(ctl_ramp* ramp, uint32_t ticks, uint64_t remaining, uint32_t limit);
/* Runs on so that its speed is at most `end` after `remaining` master ticks; until then it
 * speeds up as far as that allows. Needs ctl_ramp_can_approach(). */
uint32_t ctl_ramp_approach(ctl_ramp* ramp, uint32_t ticks, uint64_t remaining, uint32_t end);
/* The ramp is short enough to slow down to `end` within `remaining` master ticks. */
bool ctl_ramp_can_approach(const ctl_ramp* ramp, uint64_t remaining, uint32_t end);
/* The ramp is short enough to stand still within `remaining` master ticks. */
bool ctl_ramp_can_land(const ctl_ramp* ramp, uint64_t remaining);
/* Speed of a linear ramp that goes up, or of one that is led, while the master travels `way` ticks more. */
uint32_t ctl_ramp_speed_after(const ctl_ramp* ramp, uint32_t way);
/* Master ticks that a linear ramp travels down to standstill. */
uint64_t ctl_ramp_stopping_way(const ctl_ramp* ramp);
/* Largest speed of a linear ramp at `way` ticks before it has come down to `end`, of one that is led before
 * it stands; at most `most`, where no root is needed. */
uint32_t ctl_ramp_speed_before(const ctl_ramp* ramp, uint64_t way, uint32_t end, uint32_t most);
/* The share of `value` that the present speed is of full speed, rounded down; value below 2^32. */
uint32_t ctl_ramp_share(const ctl_ramp* ramp, uint32_t value);

/* The share of full speed in 1 / 2^31, and the largest speed with at most that share. */
uint64_t ctl_ramp_whole_share(const ctl_ramp* ramp);
uint32_t ctl_ramp_speed_of(const ctl_ramp* ramp, uint64_t share);
#define CTL_RAMP_SHARE_BITS 31u

/* Largest root with root * root <= square. */
uint32_t ctl_square_root(uint64_t square);

#ifdef __cplusplus
}
#endif

#endif
