/* SPDX-License-Identifier: Apache-2.0 */
/* The shift of the line ahead of its master, superimposed while it is engaged. */
#include "base/ctl_smooth.h"
#include "master/ctl_master.h"

/* A shift of the phase takes so many times its way: it is at most 1.5 times as fast as in the mean. */
#define PHASE_STRETCH 12
#define SHARE_BITS 20u
#define FULL_CIRCLE 36000 /* 0.01 degrees */

static int32_t set_phase(const ctl_master* master)
{
    return (int16_t)master->board->master[CTL_REG_MASTER_PHASE - CTL_REG_MASTER_SOURCE];
}

void ctl_master_settle_phase(ctl_master* master)
{
    ctl_master_phase* phase = &master->phase;
    const int32_t target = set_phase(master);
    if (master->in_phase)
        master->clutch.offset +=
            phase->way - phase->done + (int64_t)(target - phase->set) * master->cycle / FULL_CIRCLE;
    *phase = (ctl_master_phase){.set = target};
}

void ctl_master_keep_phase(ctl_master* master)
{
    ctl_master_phase* phase = &master->phase;
    const int64_t left = (phase->way - phase->done) * FULL_CIRCLE / (int64_t)master->cycle;
    *phase = (ctl_master_phase){.set = phase->set - (int32_t)left, .moved = phase->moved};
}

int64_t ctl_master_take_shift(ctl_master* master)
{
    const int64_t moved = master->phase.moved;
    master->phase.moved = 0;
    return moved;
}

/* The line goes to its set phase within a stretch of the master that makes it faster or slower by an eighth,
 * with 3 x^2 - 2 x^3. */
static void begin_shift(ctl_master* master, int64_t at, int32_t target)
{
    ctl_master_phase* phase = &master->phase;
    const int64_t way = (int64_t)(target - phase->set) * master->cycle / FULL_CIRCLE;
    const int64_t size = way < 0 ? -way : way;
    const int64_t stretch = PHASE_STRETCH * size;
    phase->set = target;
    phase->from = at;
    phase->way = way;
    phase->done = 0;
    phase->stretch = stretch > master->cycle / 2 ? stretch : master->cycle / 2;
}

void ctl_master_shift_phase(ctl_master* master, int64_t at)
{
    ctl_master_phase* phase = &master->phase;
    const int32_t target = set_phase(master);
    if (phase->way == phase->done && target != phase->set && master->clutch.state == CTL_CLUTCH_ON)
        begin_shift(master, at, target);
    if (phase->way == phase->done)
        return;
    const int64_t passed = at - phase->from;
    const int64_t within = passed < 0 ? 0 : passed < phase->stretch ? passed : phase->stretch;
    const uint64_t x = ((uint64_t)within << SHARE_BITS) / (uint64_t)phase->stretch;
    const bool ends = within == phase->stretch;
    const int64_t done = ends ? phase->way : ctl_smooth_at(phase->way, x << (CTL_SMOOTH_BITS - SHARE_BITS));
    ctl_clutch_shift(&master->clutch, done - phase->done);
    phase->moved += done - phase->done;
    phase->done = done;
}
