/* SPDX-License-Identifier: Apache-2.0 */
/* Makes one bag out of standstill, or one cut of the knife alone. */
#include "motion/ctl_motion.h"

#include "base/ctl_words.h"

#define SPEED_SHARE 5u /* of full speed */

void ctl_motion_limit_bag(ctl_motion* motion)
{
    ctl_ramp* ramp = &motion->ramp;
    const uint32_t cycle = ctl_bank_cycle_ticks(ctl_active_bank(motion->banks));
    const uint32_t landing = ctl_square_root((uint64_t)ramp->full * cycle);
    const uint32_t slow = ramp->full / SPEED_SHARE;
    ramp->limit = landing < slow ? landing : slow;
}

void ctl_motion_start_bag(ctl_motion* motion)
{
    motion->one_bag = true;
    ctl_motion_set_off(motion);
}

bool ctl_motion_ends_with_bag(ctl_motion* motion)
{
    if (!ctl_packer_cuts_next(motion->packer))
        return false;
    (void)ctl_motion_stop_at_cycle_end(motion);
    motion->stop_limit = motion->ramp.limit;
    return true;
}

void ctl_motion_start_cut(ctl_motion* motion)
{
    const ctl_bank* bank = ctl_active_bank(motion->banks);
    const int64_t cycle = (int32_t)ctl_get32(&bank->registers[CTL_OFFSET_BANK_ADVANCE]);
    ctl_park_begin_cut(&motion->park, motion->packer, motion->commanded, cycle);
    ctl_packer_cut_alone(motion->packer);
    ctl_motion_begin_move(motion, motion->commanded + cycle);
    motion->follows = false;
    motion->state = CTL_STATE_RUNNING;
}

void ctl_motion_end_cut(ctl_motion* motion)
{
    ctl_park_end_cut(&motion->park);
    ctl_motion_stand(motion);
}
