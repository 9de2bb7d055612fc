/* SPDX-License-Identifier: Apache-2.0 */
#include "master/ctl_clutch.h"

#define BITS 30u
#define ONE (UINT64_C(1) << BITS)

void ctl_clutch_open(ctl_clutch* clutch, int64_t line)
{
    clutch->state = CTL_CLUTCH_OFF;
    clutch->ends = false;
    clutch->line = line;
}

void ctl_clutch_engage(ctl_clutch* clutch, int64_t master, int64_t line, ctl_clutch_curve curve)
{
    clutch->state = CTL_CLUTCH_ENGAGING;
    clutch->ends = false;
    clutch->on = curve;
    clutch->from = master;
    clutch->line = line;
    clutch->offset = line + curve.way - (master + curve.stretch);
}

int64_t ctl_clutch_nearest_end(const ctl_clutch* clutch, int64_t line, ctl_clutch_curve curve)
{
    const int64_t engaged = clutch->line + clutch->on.way;
    return (clutch->state == CTL_CLUTCH_ENGAGING && engaged > line ? engaged : line) + curve.way;
}

void ctl_clutch_disengage(ctl_clutch* clutch, int64_t end, ctl_clutch_curve curve)
{
    clutch->ends = true;
    clutch->end = end;
    clutch->off = curve;
}

void ctl_clutch_shift(ctl_clutch* clutch, int64_t ticks)
{
    clutch->from -= ticks;
    clutch->offset += ticks;
}

/* The line's way from standstill, the master being so far in the stretch. */
static int64_t way_at(ctl_clutch_curve curve, uint32_t passed)
{
    const uint64_t x = ((uint64_t)passed << BITS) / curve.stretch;
    const uint64_t x2 = x * x >> BITS;
    const uint64_t x3 = x2 * x >> BITS;
    const uint64_t x4 = x2 * x2 >> BITS;
    const uint64_t x5 = x4 * x >> BITS;
    const int64_t even = (int64_t)((uint64_t)curve.stretch * (x3 - x4 / 2u) >> BITS);
    const uint64_t smooth = 10u * x3 + 6u * x5 - 15u * x4;
    const int64_t more = 2 * (int64_t)curve.way - (int64_t)curve.stretch; /* twice */
    const int64_t shifted = (int64_t)((uint64_t)(more < 0 ? -more : more) * smooth >> (BITS + 1u));
    return even + (more < 0 ? -shifted : shifted);
}

/* The line between standstill and the master, before and behind it. */
static int64_t engaging(const ctl_clutch* clutch, int64_t passed)
{
    return clutch->line + (passed <= 0 ? 0 : way_at(clutch->on, (uint32_t)passed));
}

static int64_t disengaging(const ctl_clutch* clutch, int64_t passed)
{
    const int64_t left = clutch->off.stretch - passed;
    return clutch->end - (left <= 0 ? 0 : way_at(clutch->off, (uint32_t)left));
}

int64_t ctl_clutch_follow(ctl_clutch* clutch, int64_t master)
{
    if (clutch->state == CTL_CLUTCH_OFF)
        return clutch->line;
    const int64_t passed = master - clutch->from;
    if (clutch->state == CTL_CLUTCH_ENGAGING && passed < (int64_t)clutch->on.stretch)
        return engaging(clutch, passed);
    const int64_t line = master + clutch->offset;
    const int64_t into_end = line - (clutch->end - clutch->off.way);
    clutch->state = CTL_CLUTCH_ON;
    if (!clutch->ends || into_end < 0)
        return line;
    clutch->state = CTL_CLUTCH_DISENGAGING;
    if (into_end < (int64_t)clutch->off.stretch)
        return disengaging(clutch, into_end);
    ctl_clutch_open(clutch, clutch->end);
    return clutch->end;
}
