/* SPDX-License-Identifier: Apache-2.0 */
#include "master/ctl_tracker.h"

#define ONE (INT64_C(1) << CTL_TRACKER_BITS)
#define GAIN_BITS 16u
/* Farther off than so many counts it begins anew. */
#define MAX_ERROR (4096 * ONE)
/* Counts that have not changed for so many time constants stand, but not sooner than this. */
#define STILL_CONSTANTS 16u
#define STILL_US 50000u

/* value * factor / 2^bits, toward 0. */
static int64_t scaled(int64_t value, uint64_t factor, uint32_t bits)
{
    return value < 0 ? -(int64_t)((uint64_t)-value * factor >> bits)
                     : (int64_t)((uint64_t)value * factor >> bits);
}

void ctl_tracker_reset(ctl_tracker* tracker, int64_t count, uint32_t constant_us)
{
    *tracker = (ctl_tracker){.count = count, .constant_us = constant_us, .still_us = UINT32_MAX};
}

bool ctl_tracker_stands(const ctl_tracker* tracker)
{
    const uint32_t still_us = STILL_CONSTANTS * tracker->constant_us;
    return tracker->still_us >= (still_us > STILL_US ? still_us : STILL_US);
}

static void set_step(ctl_tracker* tracker, uint32_t us)
{
    const uint64_t both = tracker->constant_us + (uint64_t)us;
    const uint64_t share = ((uint64_t)tracker->constant_us << GAIN_BITS) / both;
    tracker->step_us = us;
    tracker->keep = (uint32_t)(share * share >> GAIN_BITS);
    tracker->gain = (uint32_t)(((uint64_t)us << CTL_TRACKER_BITS) / (both * both));
}

void ctl_tracker_pass(ctl_tracker* tracker, uint32_t us)
{
    tracker->passed_us += us;
    tracker->ahead += tracker->speed * (int64_t)us;
    if (!ctl_tracker_stands(tracker))
        tracker->still_us += us;
}

void ctl_tracker_read(ctl_tracker* tracker, int64_t count)
{
    if (tracker->passed_us == 0)
        return;
    if (tracker->passed_us != tracker->step_us)
        set_step(tracker, tracker->passed_us);
    tracker->passed_us = 0;
    const int64_t counts = count - tracker->count;
    if (ctl_tracker_stands(tracker) && counts >= -1 && counts <= 1) {
        tracker->error = counts * ONE;
        tracker->ahead = 0;
        tracker->speed = 0;
        return;
    }
    tracker->count = count;
    if (counts != 0)
        tracker->still_us = 0;
    const bool jumps = counts > MAX_ERROR / ONE || counts < -(MAX_ERROR / ONE);
    const int64_t error = jumps ? MAX_ERROR : counts * ONE - tracker->ahead;
    tracker->error = error;
    if (jumps || error >= MAX_ERROR || error <= -MAX_ERROR) {
        tracker->ahead = 0;
        tracker->speed = 0;
        return;
    }
    tracker->ahead = -scaled(error, tracker->keep, GAIN_BITS);
    tracker->speed += scaled(scaled(error, 1u, GAIN_BITS), tracker->gain, CTL_TRACKER_BITS - GAIN_BITS);
}

ctl_tracked ctl_tracker_ahead(const ctl_tracker* tracker, uint32_t us)
{
    const int64_t ahead = tracker->ahead + tracker->speed * (int64_t)us;
    const int64_t whole = (ahead - (ahead < 0 ? ONE - 1 : 0)) / ONE;
    return (ctl_tracked){tracker->count + whole,
                         (uint32_t)(ahead - whole * ONE) >> (CTL_TRACKER_BITS - GAIN_BITS)};
}
