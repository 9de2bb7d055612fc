/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_feed.h"

#include "packer/ctl_gate.h"

#define INVERSE_BITS 62u

static void take_length(ctl_feed* feed, int64_t length)
{
    feed->has_rate = feed->has_rate && length == feed->length;
    feed->length = length;
}

/* One of the divisions that are still due. */
static void prepare(ctl_feed* feed)
{
    if (feed->has_rate) {
        if (feed->span_inverse == 0 && feed->span != 0 && feed->span <= UINT32_MAX)
            feed->span_inverse = ((uint64_t)1 << INVERSE_BITS) / feed->span;
        return;
    }
    feed->has_rate = true;
    feed->per_tick = feed->length / feed->cycle;
    feed->rest = (uint32_t)(feed->length % feed->cycle);
    feed->rest_share = (uint32_t)(((uint64_t)feed->rest << 32) / feed->cycle);
}

/* length * phase / cycle, rounded down: the share may be one too small. */
static int64_t even_part(const ctl_feed* feed)
{
    if (!feed->has_rate)
        return (int64_t)((uint64_t)feed->length * feed->phase / feed->cycle);
    const uint64_t product = (uint64_t)feed->rest * feed->phase;
    uint32_t part = (uint32_t)((uint64_t)feed->rest_share * feed->phase >> 32);
    if (product - (uint64_t)part * feed->cycle >= feed->cycle)
        part += 1u;
    return feed->per_tick * feed->phase + part;
}

/* The correction so far, at the share passed / span, rounded down likewise. */
static int64_t shifted(const ctl_feed* feed)
{
    if (feed->span_inverse == 0)
        return ctl_smooth_share(feed->shift, feed->passed, feed->span);
    uint64_t x = feed->passed * feed->span_inverse >> (INVERSE_BITS - CTL_SMOOTH_BITS);
    if ((feed->passed << CTL_SMOOTH_BITS) - x * feed->span >= feed->span)
        x += 1u;
    return ctl_smooth_at(feed->shift, x);
}

void ctl_feed_reset(ctl_feed* feed, uint32_t cycle, int64_t start, int64_t length)
{
    feed->has_rate = feed->has_rate && cycle == feed->cycle;
    feed->cycle = cycle;
    feed->phase = 0;
    feed->start = start;
    take_length(feed, length);
    feed->shift = 0;
    feed->passed = 0;
    feed->span = 0;
}

/* The correction is over: it has become part of where the cycle began. */
static void end_shift(ctl_feed* feed)
{
    feed->start += feed->shift;
    feed->shift = 0;
    feed->passed = 0;
    feed->span = 0;
}

void ctl_feed_correct(ctl_feed* feed, int64_t shift, uint64_t span)
{
    const int64_t left = feed->span == 0 ? 0 : feed->shift - shifted(feed);
    end_shift(feed);
    feed->start -= left;
    feed->shift = left + shift;
    feed->span = span;
    feed->span_inverse = 0;
}

void ctl_feed_advance(ctl_feed* feed, uint32_t ticks, int64_t next_length)
{
    prepare(feed);
    feed->phase += ticks;
    if (feed->phase == feed->cycle) {
        feed->start += feed->length;
        take_length(feed, next_length);
        feed->phase = 0;
    }
    if (feed->span == 0)
        return;
    feed->passed += ticks;
    if (feed->passed >= feed->span)
        end_shift(feed);
}

int64_t ctl_feed_position(const ctl_feed* feed)
{
    const int64_t even = feed->start + even_part(feed);
    return feed->span == 0 ? even : even + shifted(feed);
}

int64_t ctl_feed_um(int64_t length, uint32_t feed_um, uint32_t pulses)
{
    const int64_t turn = (int64_t)pulses * CTL_FINE;
    const int64_t turns = length / turn; /* apart, so that no product is too large */
    return turns * feed_um + (length - turns * turn) * feed_um / turn;
}
