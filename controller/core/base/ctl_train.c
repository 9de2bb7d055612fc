/* SPDX-License-Identifier: Apache-2.0 */
#include "base/ctl_train.h"

ctl_train ctl_train_even(uint32_t count, uint32_t ticks)
{
    if (count == 0)
        return (ctl_train){.direction = 1, .divisor = 1};
    const uint32_t period = ticks / count;
    const uint32_t rest = ticks % count;
    return (ctl_train){count, 1, period, rest, period, rest, count};
}

ctl_train ctl_train_line(int64_t from, int64_t to, uint32_t ticks)
{
    const bool forward = to >= from;
    const int64_t whole = ctl_whole_pulses(from);
    const int64_t moved = ctl_whole_pulses(to) - whole;
    const uint64_t way = forward ? (uint64_t)(to - from) : (uint64_t)(from - to);
    ctl_train train = {.direction = forward ? 1 : -1, .divisor = 1};
    if (moved == 0)
        return train;
    train.count = (uint32_t)(forward ? moved : -moved);
    if (way > UINT32_MAX) { /* no output stage is so fast */
        const ctl_train even = ctl_train_even(train.count, ticks);
        train.tick = even.tick;
        return train;
    }
    /* Forward ceil(left * ticks / way), backwards floor(left * ticks / way) + 1; `left` is at most a pulse.
     */
    const uint32_t left =
        (uint32_t)(forward ? (whole + 1) * CTL_TRAIN_FINE - from : from - whole * CTL_TRAIN_FINE);
    const uint64_t first = (uint64_t)left * ticks + way - (forward ? 1u : 0u);
    const uint64_t distance = (uint64_t)CTL_TRAIN_FINE * ticks;
    train.divisor = (uint32_t)way;
    if (distance + way <= UINT32_MAX) { /* the shorter divisions: a slice, or 2 ms at 8 MHz */
        train.tick = (uint32_t)first / train.divisor;
        train.fraction = (uint32_t)first % train.divisor;
        train.period = (uint32_t)distance / train.divisor;
        train.rest = (uint32_t)distance % train.divisor;
    } else {
        train.tick = (uint32_t)(first / way);
        train.fraction = (uint32_t)(first % way);
        train.period = (uint32_t)(distance / way);
        train.rest = (uint32_t)(distance % way);
    }
    return train;
}

ctl_train ctl_train_until(ctl_train* train, uint32_t tick)
{
    ctl_train passed = *train;
    ctl_train left = *train; /* in registers: in memory, gcc loads and stores it again at each pulse */
    while (left.count != 0 && left.tick <= tick)
        (void)ctl_train_next(&left);
    *train = left;
    passed.count -= left.count;
    return passed;
}
