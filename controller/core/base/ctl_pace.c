/* SPDX-License-Identifier: Apache-2.0 */
#include "base/ctl_pace.h"

#include <stddef.h>

ctl_pace ctl_pace_take(ctl_pace* pace, uint32_t travel, uint32_t inner)
{
    ctl_pace first = *pace;
    if (travel != pace->travel)
        first.ticks =
            pace->ticks == pace->travel ? travel : (uint32_t)((uint64_t)travel * pace->ticks / pace->travel);
    first.travel = inner;
    pace->start += first.ticks;
    pace->ticks -= first.ticks;
    pace->travel -= travel;
    return first;
}

/* Ticks of the engine, in 1 / divisor, as ticks of the timer, in 1 / (divisor * travel). */
static ctl_train stretched(const ctl_pace* pace, const ctl_train* train)
{
    ctl_train result = *train;
    uint64_t divisor = (uint64_t)train->divisor * pace->travel;
    uint64_t first = ((uint64_t)train->tick * train->divisor + train->fraction) * pace->ticks;
    uint64_t distance = ((uint64_t)train->period * train->divisor + train->rest) * pace->ticks;
    while (divisor > UINT32_MAX) {
        divisor >>= 1;
        first >>= 1;
        distance >>= 1;
    }
    /* A pulse is in the pace by its whole tick, and the rest of the last one's may end behind it: then all
     * leave earlier by that, less than a tick of the engine. */
    const uint64_t end = pace->ticks * divisor;
    const uint64_t last = first + (train->count - 1u) * distance;
    if (last > end && last - end < end / pace->travel && last - end <= first)
        first -= last - end;
    result.divisor = (uint32_t)divisor;
    if ((first | distance) <= UINT32_MAX) { /* the shorter divisions */
        result.tick = (uint32_t)first / result.divisor;
        result.fraction = (uint32_t)first % result.divisor;
        result.period = (uint32_t)distance / result.divisor;
        result.rest = (uint32_t)distance % result.divisor;
        return result;
    }
    result.tick = (uint32_t)(first / divisor);
    result.fraction = (uint32_t)(first % divisor);
    result.period = (uint32_t)(distance / divisor);
    result.rest = (uint32_t)(distance % divisor);
    return result;
}

void ctl_pace_give(const ctl_pace* pace, const ctl_train* train)
{
    if (pace == NULL || train->count == 0)
        return;
    ctl_train given = pace->ticks == pace->travel || pace->travel == 0 ? *train : stretched(pace, train);
    given.tick += pace->start;
    pace->port->pulses(pace->port->context, &given);
}
