/* SPDX-License-Identifier: Apache-2.0 */
#include "master/ctl_gear.h"

#define ONE (INT64_C(1) << CTL_GEAR_BITS)

/* More counts at once are divided, fewer are carried one by one. */
#define COUNTS_CARRIED 16u
/* Their product with the rest is below 2^64. */
#define MAX_STRIDE (INT64_C(1) << 21)

void ctl_gear_set(ctl_gear* gear, uint64_t numerator, uint64_t denominator, int64_t count)
{
    gear->numerator = numerator;
    gear->denominator = denominator;
    gear->whole = numerator / denominator;
    gear->rest = numerator % denominator;
    gear->fine = (gear->whole << CTL_GEAR_BITS) + (gear->rest << CTL_GEAR_BITS) / denominator;
    gear->count = count;
    gear->ticks = 0;
    gear->remainder = 0;
}

void ctl_gear_change(ctl_gear* gear, uint64_t numerator, uint64_t denominator, int64_t behind)
{
    const uint64_t part = (gear->remainder << CTL_GEAR_BITS) / gear->denominator;
    const int64_t fine = behind * ONE + (int64_t)part;
    const int64_t per_count = (int64_t)gear->fine;
    const int64_t counts = (fine * ONE + (fine < 0 ? -per_count : per_count) / 2) / per_count;
    ctl_gear_set(gear, numerator, denominator, gear->count);
    const int64_t ticks = counts * (int64_t)gear->fine / ONE;
    const uint64_t above = (uint64_t)ticks & (uint64_t)(ONE - 1);
    gear->ticks = (ticks - (int64_t)above) / ONE;
    gear->remainder = above * denominator >> CTL_GEAR_BITS;
}

static void go_forward(ctl_gear* gear, uint32_t counts)
{
    uint64_t remainder = gear->remainder + counts * gear->rest;
    gear->ticks += (int64_t)(counts * gear->whole);
    if (counts > COUNTS_CARRIED) {
        gear->ticks += (int64_t)(remainder / gear->denominator);
        remainder %= gear->denominator;
    }
    while (remainder >= gear->denominator) {
        remainder -= gear->denominator;
        gear->ticks += 1;
    }
    gear->remainder = remainder;
}

static void go_back(ctl_gear* gear, uint32_t counts)
{
    uint64_t owed = counts * gear->rest;
    gear->ticks -= (int64_t)(counts * gear->whole);
    if (counts > COUNTS_CARRIED) {
        gear->ticks -= (int64_t)(owed / gear->denominator);
        owed %= gear->denominator;
    }
    while (owed > gear->remainder) {
        gear->remainder += gear->denominator;
        gear->ticks -= 1;
    }
    gear->remainder -= owed;
}

int64_t ctl_gear_ticks(ctl_gear* gear, int64_t count, uint32_t fraction)
{
    while (count != gear->count) {
        const int64_t way = count - gear->count;
        const int64_t stride = way > MAX_STRIDE ? MAX_STRIDE : way < -MAX_STRIDE ? -MAX_STRIDE : way;
        if (stride > 0)
            go_forward(gear, (uint32_t)stride);
        else
            go_back(gear, (uint32_t)-stride);
        gear->count += stride;
    }
    return gear->ticks + (int64_t)(gear->fine * fraction >> (2u * CTL_GEAR_BITS));
}
