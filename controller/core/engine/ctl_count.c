/* SPDX-License-Identifier: Apache-2.0 */
#include "engine/ctl_count.h"

#include "engine/ctl_ramp.h"

#define MS_PER_S 1000u

void ctl_count_clear(ctl_count* count)
{
    const ctl_count nothing = {{1, 1, 0}, 0, 0, 0, 0, 0, 0};
    *count = nothing;
}

void ctl_count_start(ctl_count* count, ctl_count_speed speed, uint32_t pulses)
{
    /* With the speed f reached after R ticks, n = f t^2 / (2 R clock): t^2 = n * 2 R clock / f. */
    const uint64_t ramp_ticks = (uint64_t)speed.ramp_ms * speed.clock_hz / MS_PER_S;
    const uint64_t numerator = 2u * ramp_ticks * speed.clock_hz;
    const uint64_t rising = (uint64_t)speed.frequency_hz * speed.ramp_ms / (2u * MS_PER_S);
    count->speed = speed;
    count->square = numerator / speed.frequency_hz;
    count->rest = (uint32_t)(numerator % speed.frequency_hz);
    count->total = pulses;
    count->rising = rising < pulses / 2u ? (uint32_t)rising : pulses / 2u;
    count->sent = 0;
    count->elapsed = 0;
}

/* Ticks from standstill to pulse `number` of a ramp up. */
static uint64_t ramp_ticks(const ctl_count* count, uint32_t number)
{
    return ctl_square_root(number * count->square +
                           (uint64_t)number * count->rest / count->speed.frequency_hz);
}

/* Ticks that `pulses` pulses between the ramps take. */
static uint64_t level_ticks(const ctl_count* count, uint32_t pulses)
{
    const uint64_t even = (uint64_t)pulses * count->speed.clock_hz / count->speed.frequency_hz;
    if (pulses != 1 || count->total != 2u * count->rising + 1u)
        return even;
    /* Alone between two ramps that may not reach the speed it is as slow as they are there. */
    const uint64_t slope = ramp_ticks(count, count->rising + 1u) - ramp_ticks(count, count->rising);
    return slope > even ? slope : even;
}

/* Ticks from the start of the run to pulse `number`, 1..total. */
static uint64_t pulse_ticks(const ctl_count* count, uint32_t number)
{
    const uint32_t level_end = count->total - count->rising;
    if (number <= count->rising)
        return ramp_ticks(count, number);
    if (number <= level_end)
        return ramp_ticks(count, count->rising) + level_ticks(count, number - count->rising);
    return 2u * ramp_ticks(count, count->rising) + level_ticks(count, level_end - count->rising) -
           ramp_ticks(count, count->total - number);
}

uint32_t ctl_count_advance(ctl_count* count, uint32_t ticks, int32_t direction, const ctl_pace* pace)
{
    const uint32_t sent_before = count->sent;
    const uint64_t before = count->elapsed;
    count->elapsed += ticks;
    while (count->sent < count->total) {
        const uint64_t at = pulse_ticks(count, count->sent + 1u);
        if (at > count->elapsed)
            break;
        /* After a brake the rest of the run may say that a pulse was due already. */
        const uint32_t tick = at > before ? (uint32_t)(at - before) : 1u;
        const ctl_train train = {.count = 1, .direction = direction, .tick = tick, .divisor = 1};
        ctl_pace_give(pace, &train);
        count->sent += 1;
    }
    return count->sent - sent_before;
}

void ctl_count_brake(ctl_count* count)
{
    if (count->sent <= count->rising) {
        count->rising = count->sent;
        count->total = 2u * count->sent;
    } else if (count->sent < count->total - count->rising) {
        count->total = count->sent + count->rising;
    }
}

void ctl_count_halt(ctl_count* count)
{
    count->total = count->sent;
    count->rising = 0;
}

bool ctl_count_done(const ctl_count* count)
{
    return count->sent == count->total;
}

uint32_t ctl_count_hz(const ctl_count* count)
{
    if (ctl_count_done(count))
        return 0;
    return (uint32_t)(count->speed.clock_hz /
                      (pulse_ticks(count, count->sent + 1u) - pulse_ticks(count, count->sent)));
}
