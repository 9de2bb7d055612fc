/* SPDX-License-Identifier: Apache-2.0 */
/* Position and speed of an encoder between and beyond its counts: a second-order tracker (alpha-beta). With
 * a = T / (T + t), T the time constant and t the time from count to count, alpha = 1 - a^2 and
 * beta = (1 - a)^2, so that it is critically damped. At constant speed it does not lag; with the acceleration
 * A it lags by A T^2. Positions in 1 / 2^32 count, which a fall and a rise of the counts add nothing to. */
#ifndef CTL_TRACKER_H
#define CTL_TRACKER_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_TRACKER_BITS 32u

typedef struct {
    int64_t count;        /* last one read */
    int64_t ahead;        /* of it the tracked position is, 1 / 2^32 count */
    int64_t speed;        /* counts per microsecond, 1 / 2^32 */
    int64_t error;        /* last count minus what was expected, 1 / 2^32 */
    uint32_t constant_us; /* time constant */
    uint32_t step_us;     /* that the next two were computed for */
    uint32_t keep;        /* a^2, 1 / 2^16 */
    uint32_t gain;        /* beta / t, 1 / 2^32 per microsecond */
    uint32_t passed_us;   /* since the last count was read */
    uint32_t still_us;    /* since it changed */
} ctl_tracker;

typedef struct {
    int64_t count;
    uint32_t fraction; /* 1 / 2^16 */
} ctl_tracked;

/* Stands at this count. */
void ctl_tracker_reset(ctl_tracker* tracker, int64_t count, uint32_t constant_us);
void ctl_tracker_pass(ctl_tracker* tracker, uint32_t us);
/* Takes the count that is read now. Where the counts stand, one more or fewer is noise: an edge to and fro.
 */
void ctl_tracker_read(ctl_tracker* tracker, int64_t count);
/* Returns where the encoder will be so much later. */
ctl_tracked ctl_tracker_ahead(const ctl_tracker* tracker, uint32_t us);
/* Returns true when the counts stand: the tracked position is the count. */
bool ctl_tracker_stands(const ctl_tracker* tracker);

#ifdef __cplusplus
}
#endif

#endif
