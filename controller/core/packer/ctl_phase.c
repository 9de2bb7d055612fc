/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_phase.h"

#define FAST_SHARE 10
#define BY_HAND_SHARE 50

static int64_t limited(int64_t value, int64_t limit)
{
    if (value > limit)
        return limit;
    return value < -limit ? -limit : value;
}

static int64_t step_limit(const ctl_phase_limits* limits, ctl_phase_mode mode)
{
    switch (mode) {
    case CTL_PHASE_FAST:
        return limits->bag / FAST_SHARE;
    case CTL_PHASE_FAST_AND_SHORT:
        return limits->bag / (2 * FAST_SHARE);
    case CTL_PHASE_BY_HAND:
        return limits->bag / BY_HAND_SHARE;
    default:
        return limits->step_limit;
    }
}

int64_t ctl_phase_allow(ctl_phase* phase, const ctl_phase_limits* limits, ctl_phase_mode mode, int64_t wanted,
                        int64_t length)
{
    phase->length = limited(length, limits->length_limit);
    phase->step = limited(wanted - phase->length, step_limit(limits, mode));
    const int64_t shift = phase->length + phase->step;
    if (shift == wanted || mode != CTL_PHASE_LIMITED) {
        phase->limited_in_row = 0;
    } else {
        phase->limited += 1;
        phase->limited_in_row += 1;
    }
    return shift;
}

void ctl_phase_none(ctl_phase* phase)
{
    phase->length = 0;
    phase->step = 0;
}

bool ctl_phase_reaches(const ctl_phase_limits* limits, int64_t wanted, int64_t length)
{
    const int64_t step = wanted - limited(length, limits->length_limit);
    return step <= limits->step_limit && step >= -limits->step_limit;
}

int64_t ctl_phase_max(const ctl_phase_limits* limits, ctl_phase_mode mode)
{
    return step_limit(limits, mode) + (mode == CTL_PHASE_LIMITED ? limits->length_limit : 0);
}

void ctl_phase_move(ctl_feed* film, int64_t* command, int64_t shift, uint64_t span)
{
    ctl_feed_correct(film, shift, span);
    *command += shift;
}
