/* SPDX-License-Identifier: Apache-2.0 */
/* The end of a run after a number of bags. */
#include "motion/ctl_motion.h"

/* More bags than a ramp takes. */
#define MAX_BAGS_AHEAD 255u

bool ctl_motion_jaws_are_open(const ctl_motion* motion)
{
    return !ctl_park_touches(&motion->park, motion->packer, motion->actual);
}

static bool can_end_within(const ctl_motion* motion, uint64_t way)
{
    return motion->master->leads ? ctl_master_can_disengage(motion->master, &motion->ramp, way)
                                 : ctl_ramp_can_land(&motion->ramp, way);
}

void ctl_motion_end_after(ctl_motion* motion, uint32_t bags)
{
    const ctl_packer* packer = motion->packer;
    if (bags > MAX_BAGS_AHEAD || motion->state != CTL_STATE_RUNNING || motion->manual ||
        !ctl_packer_active(packer))
        return;
    /* This cycle's cut is still to come. */
    const uint32_t first = packer->film.phase < packer->cut ? 1u : 0u;
    const uint32_t cycle = packer->cycle;
    bool later;
    if (packer->wheel.on && motion->master->leads) /* the knife opens at once */
        later = bags != 0;
    else
        later = bags > first && can_end_within(motion, ctl_motion_to_boundary(motion) +
                                                           (uint64_t)(bags - first - 1u) * cycle);
    if (later)
        return;
    (void)ctl_motion_stop_at_cycle_end(motion);
}
