/* SPDX-License-Identifier: Apache-2.0 */
/* The change of program of a running machine: by the clock, which slows down for it, or with an encoder that
 * leads, which does not. */
#include "motion/ctl_motion.h"

bool ctl_motion_changes(const ctl_motion* motion)
{
    return motion->transfer->state == CTL_STAGED_STATE_ARMED && motion->state == CTL_STATE_RUNNING &&
           ctl_bank_at_end(ctl_active_bank(motion->banks)) == CTL_END_BEHAVIOR_REPEAT;
}

/* Plans the change at the next boundary over which no correction of the film goes on. It was computed when it
 * was asked for, and is again when a parameter or the direction has changed. */
static void plan(ctl_motion* motion)
{
    if (motion->change.writes != motion->board->parameter_writes ||
        motion->change.direction != motion->direction)
        motion->change = ctl_change_between(motion->board, motion->packer, ctl_active_bank(motion->banks),
                                            ctl_staged_bank(motion->banks), motion->direction);
    motion->packer->busy = true;
    motion->change_ticks = ctl_motion_to_boundary(motion);
    if (ctl_packer_correcting(motion->packer))
        motion->change_ticks += ctl_bank_cycle_ticks(motion->table.bank);
    motion->change_planned = true;
    motion->change_opens = false;
}

void ctl_motion_plan_change(ctl_motion* motion, uint32_t slice)
{
    const uint32_t cycle = ctl_bank_cycle_ticks(motion->table.bank);
    plan(motion);
    motion->change_speed = ctl_ramp_speed_of(&motion->ramp, motion->change.share);
    /* The slice that meets the boundary may begin faster by twice what the ramp loses in it. */
    if (motion->change_speed < motion->ramp.full && motion->change_speed > 3u * slice)
        motion->change_speed -= 2u * slice;
    while (!ctl_ramp_can_approach(&motion->ramp, motion->change_ticks, motion->change_speed))
        motion->change_ticks += cycle;
}

/* Between the last pulse of one cycle and the first of the next the armed program takes over. `ticks` of the
 * master that are left of this slice go on with the same speed of the film. */
static void take_over_armed(ctl_motion* motion, uint32_t* ticks)
{
    const bool is_led = motion->master->leads && motion->master->clutch.state == CTL_CLUTCH_ON;
    const uint64_t share = is_led ? 0u : ctl_ramp_whole_share(&motion->ramp);
    ctl_transfer_apply(motion->transfer, motion->banks);
    ctl_table_change_bank(&motion->table, ctl_active_bank(motion->banks));
    ctl_jam_forget(&motion->packer->jam);
    ctl_motion_set_ramp(motion);
    if (is_led) {
        *ticks = ctl_master_change(motion->master, ctl_active_bank(motion->banks), &motion->ramp, *ticks);
    } else {
        motion->ramp.speed =
            ctl_ramp_speed_of(&motion->ramp, ctl_change_share_behind(&motion->change, share));
        *ticks = (uint32_t)ctl_change_share_behind(&motion->change, *ticks);
    }
    ctl_packer_change_bank(motion->packer, ctl_active_bank(motion->banks), motion->banks->active_crc,
                           &motion->ramp);
    motion->change_planned = false;
    motion->begins = true;
}

/* The line comes to rest at a boundary by its clutch, as the axes would step too far at the master's speed.
 * It has travelled `ahead` ticks more than its table. */
static void rest_for_change(ctl_motion* motion, uint32_t ahead)
{
    motion->change_planned = false;
    motion->change_rests = true;
    motion->stop_remaining =
        ctl_master_disengage(motion->master, &motion->ramp, ctl_motion_to_boundary(motion) - ahead);
}

/* On somebody else's film the knife stands open meanwhile, and nothing else moves. */
static bool is_open(const ctl_motion* motion)
{
    return !motion->packer->wheel.on || motion->packer->knife_gate.state == CTL_GATE_STATE_STANDING;
}

/* Returns true when this speed is a larger share of full speed than the steps allow; it is never twice as
 * fast. */
static bool steps_too_far(const ctl_motion* motion, uint32_t speed)
{
    const uint64_t steps = motion->change.steps;
    return !motion->packer->wheel.on && steps < UINT32_MAX &&
           (uint64_t)speed << CTL_RAMP_SHARE_BITS >= (steps + 1u) * motion->ramp.full;
}

/* Returns true while the encoder is too fast for the armed program, or does not lead the line alone. */
static bool must_wait(const ctl_motion* motion)
{
    const ctl_master* master = motion->master;
    return master->leads && (master->clutch.state != CTL_CLUTCH_ON || master->clutch.ends ||
                             ctl_master_refusal(master, ctl_staged_bank(motion->banks)) != CTL_REFUSAL_NONE);
}

void ctl_motion_plan_led_change(ctl_motion* motion)
{
    const bool changes = ctl_motion_changes(motion);
    motion->change_planned = motion->change_planned && changes;
    if (motion->change_rests || !changes || motion->direction < 0)
        return;
    const bool is_new = !motion->change_planned;
    if (is_new)
        plan(motion);
    const bool decides = motion->change_decides;
    motion->change_decides = is_new; /* in the next slice, as a plan takes long */
    if (decides && !is_new && !must_wait(motion) && steps_too_far(motion, motion->ramp.top))
        rest_for_change(motion, 0);
}

void ctl_motion_change_at_rest(ctl_motion* motion)
{
    uint32_t none = 0;
    const ctl_bank* staged = ctl_staged_bank(motion->banks);
    if (ctl_motion_changes(motion) && ctl_table_between_cycles(&motion->table) &&
        ctl_packer_may_change(motion->packer, true) &&
        ctl_master_refusal(motion->master, staged) == CTL_REFUSAL_NONE) {
        take_over_armed(motion, &none); /* the next slice engages */
        return;
    }
    motion->change_rests = false;
    ctl_motion_run(motion);
}

/* At a boundary: takes over, or runs on as slowly to the next one. */
void ctl_motion_pass_boundary(ctl_motion* motion, uint32_t* ticks)
{
    const bool waits =
        !ctl_packer_is_prepared(motion->packer, motion->transfer->staged_crc) || must_wait(motion);
    if (!waits && motion->master->leads && steps_too_far(motion, motion->ramp.speed)) {
        rest_for_change(motion, *ticks);
        return;
    }
    if (!waits && is_open(motion) && ctl_table_between_cycles(&motion->table) &&
        ctl_motion_may_change(motion)) {
        take_over_armed(motion, ticks);
        return;
    }
    motion->change_opens =
        !waits && (motion->change_opens || !is_open(motion) || ctl_packer_must_open(motion->packer));
    motion->change_ticks += ctl_bank_cycle_ticks(motion->table.bank);
}

void ctl_motion_lose_phase(ctl_motion* motion)
{
    motion->homed = motion->homed && ctl_motion_is_press(motion);
    motion->in_phase = false;
    ctl_park_forget(&motion->park);
    ctl_packer_break_off(motion->packer);
    if (motion->banks->has_active)
        ctl_table_reset(&motion->table, ctl_active_bank(motion->banks));
}
