/* SPDX-License-Identifier: Apache-2.0 */
/* A gear of N / D between the counts of an encoder and the ticks of a table, in whole numbers: the remainder
 * is carried, so that at any count the ticks are floor(count * N / D), forward and back, however far. */
#ifndef CTL_GEAR_H
#define CTL_GEAR_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_GEAR_BITS 16u

typedef struct {
    uint64_t numerator;
    uint64_t denominator;
    uint64_t whole; /* ticks per count, */
    uint64_t rest;  /* and so much more, in 1 / denominator */
    uint64_t fine;  /* the same together in 1 / 2^CTL_GEAR_BITS, rounded down */
    int64_t count;
    int64_t ticks;      /* at that count, */
    uint64_t remainder; /* and so much more, in 1 / denominator */
} ctl_gear;

/* Sets the ratio, the numerator below 2^56 and the denominator below 2^42, neither 0. The present `count` is
 * tick 0. */
void ctl_gear_set(ctl_gear* gear, uint64_t numerator, uint64_t denominator, int64_t count);
/* Goes on with another ratio where it is: `behind` ticks of the old one, and its remainder, behind tick 0 of
 * the new one. Rounded to 1 / 2^CTL_GEAR_BITS count. */
void ctl_gear_change(ctl_gear* gear, uint64_t numerator, uint64_t denominator, int64_t behind);
/* Returns the ticks at a count and a fraction of the next one, in 1 / 2^CTL_GEAR_BITS. They do not fall while
 * the position rises. */
int64_t ctl_gear_ticks(ctl_gear* gear, int64_t count, uint32_t fraction);

#ifdef __cplusplus
}
#endif

#endif
