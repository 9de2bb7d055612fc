/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_past.h"

#define WAY_SAMPLES 10u

static ctl_past_sample sample(uint64_t now_us, int64_t at)
{
    const ctl_past_sample taken = {(uint32_t)(now_us & 0xFFFFFFFFu), (uint32_t)((uint64_t)at & 0xFFFFFFFFu)};
    return taken;
}

void ctl_past_reset(ctl_past* past, uint64_t now_us, int64_t at)
{
    past->now = sample(now_us, at);
    past->before = past->now;
    past->newest = 0;
    for (uint32_t i = 0; i < CTL_PAST_SAMPLES; ++i)
        past->samples[i] = past->now;
}

void ctl_past_add(ctl_past* past, uint64_t now_us, int64_t at)
{
    past->before = past->now;
    past->now = sample(now_us, at);
    if (past->now.us - past->samples[past->newest].us < CTL_PAST_SAMPLE_US)
        return;
    past->newest = past->newest + 1u == CTL_PAST_SAMPLES ? 0 : past->newest + 1u;
    past->samples[past->newest] = past->now;
}

/* `way` x `part` / `whole`, part <= whole; way below 2^31 in size. */
static int32_t share(int32_t way, uint32_t part, uint32_t whole)
{
    if (whole == 0)
        return 0;
    const uint64_t product = (uint64_t)(way < 0 ? -(int64_t)way : way) * part;
    /* The shorter division where it does. */
    const uint32_t size = product <= UINT32_MAX ? (uint32_t)product / whole : (uint32_t)(product / whole);
    return way < 0 ? -(int32_t)size : (int32_t)size;
}

/* Microseconds from the edge to the end of the slice, which the axis passes evenly. */
static uint32_t since_edge(const ctl_past* past, int64_t at)
{
    const int32_t way = (int32_t)(past->now.at - past->before.at);
    const int32_t left = (int32_t)(past->now.at - (uint32_t)((uint64_t)at & 0xFFFFFFFFu));
    const uint32_t slice_us = past->now.us - past->before.us;
    if (way <= 0 || left <= 0)
        return 0;
    return left >= way ? slice_us : (uint32_t)share((int32_t)slice_us, (uint32_t)left, (uint32_t)way);
}

int64_t ctl_past_before(const ctl_past* past, int64_t at, uint32_t dead_us)
{
    if (dead_us == 0)
        return at;
    const uint32_t ago_us = since_edge(past, at) + dead_us;
    ctl_past_sample newer = past->now;
    uint32_t index = past->newest;
    for (uint32_t i = 0; i < CTL_PAST_SAMPLES; ++i) {
        const ctl_past_sample older = past->samples[index];
        if (past->now.us - older.us >= ago_us) {
            const uint32_t from_older = past->now.us - older.us - ago_us;
            newer.at =
                older.at + (uint32_t)share((int32_t)(newer.at - older.at), from_older, newer.us - older.us);
            break;
        }
        newer = older;
        index = index == 0 ? CTL_PAST_SAMPLES - 1u : index - 1u;
    }
    return at - (int32_t)((uint32_t)((uint64_t)at & 0xFFFFFFFFu) - newer.at);
}

/* The sample so many before the newest one. */
static ctl_past_sample older_by(const ctl_past* past, uint32_t count)
{
    return past
        ->samples[past->newest >= count ? past->newest - count : past->newest + CTL_PAST_SAMPLES - count];
}

ctl_past_way ctl_past_last_way(const ctl_past* past, uint32_t back)
{
    const ctl_past_sample newer = older_by(past, WAY_SAMPLES * back);
    const ctl_past_sample older = older_by(past, WAY_SAMPLES * (back + 1u));
    const ctl_past_way way = {(int32_t)(newer.at - older.at), newer.us - older.us};
    return way;
}
