/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_feed.h"

#include "packer/ctl_gate.h"

void ctl_feed_reset(ctl_feed* feed, uint32_t cycle, int64_t start, int64_t length)
{
    feed->cycle = cycle;
    feed->phase = 0;
    feed->start = start;
    feed->length = length;
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
    const int64_t left =
        feed->span == 0 ? 0 : feed->shift - ctl_smooth_share(feed->shift, feed->passed, feed->span);
    end_shift(feed);
    feed->start -= left;
    feed->shift = left + shift;
    feed->span = span;
}

void ctl_feed_advance(ctl_feed* feed, uint32_t ticks, int64_t next_length)
{
    feed->phase += ticks;
    if (feed->phase == feed->cycle) {
        feed->start += feed->length;
        feed->length = next_length;
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
    const int64_t even = feed->start + (int64_t)((uint64_t)feed->length * feed->phase / feed->cycle);
    return feed->span == 0 ? even : even + ctl_smooth_share(feed->shift, feed->passed, feed->span);
}
