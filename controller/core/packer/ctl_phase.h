/* SPDX-License-Identifier: Apache-2.0 */
/* The one place through which a cut is shifted against the film. Whoever moves a cut away from a bag length
 * behind the last one asks here how far it may go, and moves it here. Film in 1/256 pulse of its motor. */
#ifndef CTL_PHASE_H
#define CTL_PHASE_H

#include "packer/ctl_feed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    int64_t bag;          /* bag length */
    int64_t length_limit; /* maximum difference of a bag's film from it */
    int64_t step_limit;   /* maximum shift of a cut besides */
} ctl_phase_limits;

/* How the cuts are shifted: by the limits; where they are not in register yet, by a tenth of a bag, and by
 * half of it in half of the time; beside all that a fiftieth of a bag for the operator's hand. */
typedef enum {
    CTL_PHASE_LIMITED,
    CTL_PHASE_FAST,
    CTL_PHASE_FAST_AND_SHORT,
    CTL_PHASE_BY_HAND
} ctl_phase_mode;

typedef struct {
    int64_t step;   /* of the last planned cut: the shift beside the part of the bag's length, */
    int64_t length; /* and that part */
    uint32_t limited;
    uint32_t limited_in_row;
} ctl_phase;

/* Returns the shift of the next cut: of the wanted one the part `length`, which is the difference of the
 * bag's film, and a step, both within their limits. */
int64_t ctl_phase_allow(ctl_phase* phase, const ctl_phase_limits* limits, ctl_phase_mode mode, int64_t wanted,
                        int64_t length);
/* The next cut is a bag length behind the last one. */
void ctl_phase_none(ctl_phase* phase);
/* Returns true when the step that would be left of the wanted shift is within its limit. */
bool ctl_phase_reaches(const ctl_phase_limits* limits, int64_t wanted, int64_t length);
/* Returns the maximum shift. */
int64_t ctl_phase_max(const ctl_phase_limits* limits, ctl_phase_mode mode);
/* Shifts the film, and with it the command at its next cut, in so many ticks outside the sealing window. */
void ctl_phase_move(ctl_feed* film, int64_t* command, int64_t shift, uint64_t span);

#ifdef __cplusplus
}
#endif

#endif
