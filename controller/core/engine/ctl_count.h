/* SPDX-License-Identifier: Apache-2.0 */
/* A counted run of the pulse generator: so many pulses from standstill to standstill, with even ramps at both
 * ends. Pulse n comes at a time that follows from n alone, so it does not matter how time is cut into calls,
 * and when all are sent there is none left to be stopped. */
#ifndef CTL_COUNT_H
#define CTL_COUNT_H

#include "base/ctl_pace.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    uint32_t clock_hz;
    uint32_t frequency_hz; /* between the ramps, 1..clock_hz */
    uint32_t ramp_ms;      /* from standstill to that, at most CTL_COUNT_MAX_RAMP_MS */
} ctl_count_speed;

#define CTL_COUNT_MAX_RAMP_MS 1000u

typedef struct {
    ctl_count_speed speed;
    uint64_t
        square; /* pulse n of the ramp up comes sqrt(n * (square + rest / frequency)) ticks after the start */
    uint32_t rest;   /* below frequency_hz */
    uint32_t total;  /* pulses of the run */
    uint32_t rising; /* of these on the ramp up, and as many on the ramp down */
    uint32_t sent;
    uint64_t elapsed; /* ticks since the start */
} ctl_count;

/* Stand with nothing to send. */
void ctl_count_clear(ctl_count* count);
void ctl_count_start(ctl_count* count, ctl_count_speed speed, uint32_t pulses);
/* Moves on by `ticks`; returns the pulses that came, which are given in this direction. */
uint32_t ctl_count_advance(ctl_count* count, uint32_t ticks, int32_t direction, const ctl_pace* pace);
/* Fewer pulses than begun with: only those of the ramp down from the present speed. */
void ctl_count_brake(ctl_count* count);
/* No pulse comes any more. */
void ctl_count_halt(ctl_count* count);
bool ctl_count_done(const ctl_count* count);
/* Frequency now, from the distance to the next pulse; 0 when done. */
uint32_t ctl_count_hz(const ctl_count* count);

#ifdef __cplusplus
}
#endif

#endif
