/* SPDX-License-Identifier: Apache-2.0 */
#include "ctl_ramp.h"

void ctl_ramp_reset(ctl_ramp* ramp, uint32_t full)
{
    ramp->full = full;
    ramp->speed = 0;
    ramp->rest = 0;
}

/* Travel while the speed changes evenly from the present one to `end`. */
static uint32_t travel(ctl_ramp* ramp, uint32_t end, uint32_t ticks)
{
    const uint64_t unit = 2u * (uint64_t)ramp->full;
    const uint64_t sum = ((uint64_t)ramp->speed + end) * ticks + ramp->rest;
    ramp->speed = end;
    ramp->rest = sum % unit;
    return (uint32_t)(sum / unit);
}

uint32_t ctl_ramp_up(ctl_ramp* ramp, uint32_t ticks)
{
    uint32_t travelled = 0;
    if (ramp->speed < ramp->full) {
        const uint32_t rising = ramp->full - ramp->speed < ticks ? ramp->full - ramp->speed : ticks;
        travelled = travel(ramp, ramp->speed + rising, rising);
        ticks -= rising;
    }
    return travelled + ticks; /* ticks are left over only at full speed */
}

uint32_t ctl_ramp_down(ctl_ramp* ramp, uint32_t ticks)
{
    const uint32_t falling = ramp->speed < ticks ? ramp->speed : ticks;
    return travel(ramp, ramp->speed - falling, falling);
}

uint32_t ctl_square_root(uint64_t square)
{
    uint64_t root = 0;
    for (uint64_t bit = (uint64_t)1 << 31; bit != 0; bit >>= 1) {
        if ((root + bit) * (root + bit) <= square)
            root += bit;
    }
    return (uint32_t)root;
}

int ctl_ramp_can_land(const ctl_ramp* ramp, uint64_t remaining)
{
    return (uint64_t)ramp->speed * ramp->speed <= 2u * (uint64_t)ramp->full * remaining;
}

uint32_t ctl_ramp_land(ctl_ramp* ramp, uint32_t ticks, uint64_t remaining, uint32_t limit)
{
    /* Speed from which the ramp ends exactly there: v = sqrt(2 a d). */
    const uint32_t curve = ctl_square_root(2u * (uint64_t)ramp->full * remaining);
    if (curve <= ticks) {
        ramp->speed = 0;
        ramp->rest = 0;
        return (uint32_t)remaining;
    }
    uint32_t end = ramp->speed;
    if (end < limit)
        end = limit - end < ticks ? limit : end + ticks;
    if (end > curve - ticks)
        end = curve - ticks;
    const uint32_t travelled = travel(ramp, end, ticks);
    if (travelled < remaining)
        return travelled;
    ramp->speed = 0;
    ramp->rest = 0;
    return (uint32_t)remaining;
}
