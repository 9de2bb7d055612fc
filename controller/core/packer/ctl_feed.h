/* SPDX-License-Identifier: Apache-2.0 */
/* An axis that feeds: so much a cycle in proportion to its phase, plus at most one correction, which is
 * spread over a given part of the cycle with 3 x^2 - 2 x^3, so that the speed has no step. The film takes its
 * corrections outside the sealing window. Positions in 1/256 pulse of its motor. */
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
    int64_t shift;   /* the correction under way */
    uint64_t passed; /* ticks of it */
    uint64_t span;   /* ticks that it takes; 0: none under way */
    /* Values that spare each slice its divisions; computed in a slice after the one that needs them first. */
    bool has_rate;
    int64_t per_tick;      /* length / cycle, */
    uint32_t rest;         /* its remainder, */
    uint32_t rest_share;   /* and that in 1 / 2^32 of the cycle */
    uint64_t span_inverse; /* 2^62 / span; 0: not yet, or span is too long for it */
} ctl_feed;

void ctl_feed_reset(ctl_feed* feed, uint32_t cycle, int64_t start, int64_t length);
/* From now on, over `span` ticks; what an earlier one has left is done at once with it. */
void ctl_feed_correct(ctl_feed* feed, int64_t shift, uint64_t span);
/* Moves on by at most to the end of the cycle; the next one has `next_length`. */
void ctl_feed_advance(ctl_feed* feed, uint32_t ticks, int64_t next_length);
int64_t ctl_feed_position(const ctl_feed* feed);

#ifdef __cplusplus
}
#endif

#endif
