/* SPDX-License-Identifier: Apache-2.0 */
/* Where an axis was some time ago. A sensor and its input filter answer late: the position that is latched
 * with an edge is that of the answer, and the edge was where the axis was a dead time earlier. Positions in
 * 1/256 pulse. */
#ifndef CTL_PAST_H
#define CTL_PAST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One sample per millisecond; between them the position is taken as a straight line: at 10 m/s^2 that is
 * 0.00125 mm off. They reach back for the longest dead time, 20 ms. */
#define CTL_PAST_SAMPLES 24u
#define CTL_PAST_SAMPLE_US 1000u

/* The lower 32 bits of times and positions; differences are exact. */
typedef struct {
    uint32_t us;
    uint32_t at;
} ctl_past_sample;

typedef struct {
    ctl_past_sample samples[CTL_PAST_SAMPLES]; /* as a ring */
    uint32_t newest;
    ctl_past_sample before; /* at the start of the present slice */
    ctl_past_sample now;
} ctl_past;

/* A way of the axis, 1/256 pulse, and its time. */
typedef struct {
    int32_t way;
    uint32_t us;
} ctl_past_way;

/* The axis has stood here. */
void ctl_past_reset(ctl_past* past, uint64_t now_us, int64_t at);
/* Ends a slice. */
void ctl_past_add(ctl_past* past, uint64_t now_us, int64_t at);
/* Returns the position `dead_us` before the axis passed `at` in the present slice. */
int64_t ctl_past_before(const ctl_past* past, int64_t at, uint32_t dead_us);

/* Returns the way of the last ten samples or, with `back` 1, that of the ten before. */
ctl_past_way ctl_past_last_way(const ctl_past* past, uint32_t back);

#ifdef __cplusplus
}
#endif

#endif
