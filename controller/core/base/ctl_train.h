/* SPDX-License-Identifier: Apache-2.0 */
/* A train of pulses at even distances: what a pulse timer is loaded with. A distance is so many ticks, and
 * one more whenever the rests of the distances add up to a tick, so that no pulse is a tick off its place and
 * no division is needed from one to the next. */
#ifndef CTL_TRAIN_H
#define CTL_TRAIN_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    uint32_t count;    /* pulses */
    int32_t direction; /* 1 or -1 */
    uint32_t tick;     /* when the first one leaves */
    uint32_t fraction; /* of a tick by which it is later than that, in 1 / divisor */
    uint32_t period;   /* ticks from one to the next */
    uint32_t rest;     /* and so much more, in 1 / divisor */
    uint32_t divisor;
} ctl_train;

/* Positions that a train is made from are in 1/256 pulse. */
#define CTL_TRAIN_FINE 256

/* Returns the whole pulses up to a position. */
static inline int64_t ctl_whole_pulses(int64_t fine)
{
    return (fine - (fine < 0 ? CTL_TRAIN_FINE - 1 : 0)) / CTL_TRAIN_FINE;
}

/* Returns the tick of the next pulse and takes it off. The count must not be 0. */
static inline uint32_t ctl_train_next(ctl_train* train)
{
    const uint32_t tick = train->tick;
    train->count -= 1u;
    train->tick += train->period;
    train->fraction += train->rest;
    if (train->fraction >= train->divisor) {
        train->fraction -= train->divisor;
        train->tick += 1u;
    }
    return tick;
}

/* Returns the train of `count` pulses forward, of which pulse j (1..count) leaves floor(j * ticks / count)
 * ticks after tick 0. */
ctl_train ctl_train_even(uint32_t count, uint32_t ticks);
/* Returns the train of an axis that moves evenly from `from` to `to`, 1/256 pulse, in `ticks`: a pulse leaves
 * at the first tick at which the axis has reached it, or backwards, has left it. */
ctl_train ctl_train_line(int64_t from, int64_t to, uint32_t ticks);
/* Takes off the pulses up to and with this tick, and returns them. */
ctl_train ctl_train_until(ctl_train* train, uint32_t tick);

#ifdef __cplusplus
}
#endif

#endif
