/* SPDX-License-Identifier: Apache-2.0 */
/* A feeding axis: a given length per cycle in proportion to its phase, plus at most one correction. The
 * correction is spread over a given part of the cycle with 3 x^2 - 2 x^3, so that the speed has no step. The
 * film is corrected outside the sealing window. Positions in 1/256 pulse of its motor. */
#ifndef CTL_FEED_H
#define CTL_FEED_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_FINE 256

typedef struct {
    uint32_t cycle;  /* ticks */
    uint32_t phase;  /* 0..cycle-1 */
    int64_t start;   /* where the cycle began */
    int64_t length;  /* of this cycle, without the correction */
    int64_t shift;   /* the present correction */
    uint64_t passed; /* ticks of it */
    uint64_t span;   /* its duration in ticks; 0: no correction */
    /* Values that save divisions in each slice; computed one slice after they are first needed. */
    bool has_rate;
    int64_t per_tick;      /* length / cycle, */
    uint32_t rest;         /* its remainder, */
    uint32_t rest_share;   /* and that in 1 / 2^32 of the cycle */
    uint64_t span_inverse; /* 2^62 / span; 0: not yet, or span is too long for it */
} ctl_feed;

void ctl_feed_reset(ctl_feed* feed, uint32_t cycle, int64_t start, int64_t length);
/* Starts a correction over `span` ticks; the rest of an earlier one is added to it. */
void ctl_feed_correct(ctl_feed* feed, int64_t shift, uint64_t span);
/* Advances by `ticks`, at most to the end of the cycle; the next cycle has `next_length`. */
void ctl_feed_advance(ctl_feed* feed, uint32_t ticks, int64_t next_length);
int64_t ctl_feed_position(const ctl_feed* feed);
/* Returns a length of an axis in micrometers, which feeds `feed_um` for so many whole pulses. */
int64_t ctl_feed_um(int64_t length, uint32_t feed_um, uint32_t pulses);

#ifdef __cplusplus
}
#endif

#endif
