/* SPDX-License-Identifier: Apache-2.0 */
/* Moves the axis by hand during one slice: jogging, homing, a knife that opens or returns. */
#include "motion/ctl_motion.h"

/* Pulses at even distances, up to the end of the pace. */
static void emit_evenly(ctl_motion* motion, int64_t pulses, const ctl_pace* pace)
{
    ctl_train train = ctl_train_even((uint32_t)(pulses < 0 ? -pulses : pulses), pace->travel);
    train.direction = pulses < 0 ? -1 : 1;
    motion->commanded += pulses;
    ctl_pace_give(pace, &train);
}

/* Pulses of jogging or homing while the ramp travels so far, at most `max`; returns their number. Pulse j
 * leaves at floor((j * clock - rest) / frequency). */
uint32_t ctl_motion_move_by_hand(ctl_motion* motion, ctl_pace pace, uint32_t travelled, uint64_t max)
{
    const uint32_t clock_hz = motion->board->config.timer_clock_hz;
    const uint32_t hz = motion->manual_hz;
    const uint64_t first = clock_hz - motion->manual_rest;
    const uint64_t sum = (uint64_t)travelled * hz + motion->manual_rest;
    const uint64_t whole = sum / clock_hz;
    const ctl_train train = {.count = (uint32_t)(whole < max ? whole : max),
                             .direction = motion->manual_direction,
                             .tick = (uint32_t)(first / hz),
                             .fraction = (uint32_t)(first % hz),
                             .period = clock_hz / hz,
                             .rest = clock_hz % hz,
                             .divisor = hz};
    motion->manual_rest = sum % clock_hz;
    motion->commanded += train.direction * (int64_t)train.count;
    pace.travel = travelled;
    ctl_pace_give(&pace, &train);
    return train.count;
}

void ctl_motion_slice_manual_stop(ctl_motion* motion, ctl_pace pace)
{
    (void)ctl_motion_move_by_hand(motion, pace, ctl_ramp_down(&motion->ramp, pace.ticks), UINT64_MAX);
    if (motion->ramp.speed == 0)
        ctl_motion_come_to_rest(motion);
}

void ctl_motion_slice_jogging(ctl_motion* motion, ctl_pace pace)
{
    const bool held = ctl_jog_request(motion->heartbeat) == motion->manual_direction &&
                      (motion->manual_direction < 0 || !ctl_motion_force_forbids(motion));
    const uint32_t travelled =
        held ? ctl_ramp_up(&motion->ramp, pace.ticks) : ctl_ramp_down(&motion->ramp, pace.ticks);
    (void)ctl_motion_move_by_hand(motion, pace, travelled, UINT64_MAX);
    if (!held && motion->ramp.speed == 0)
        ctl_motion_stand(motion);
}

static void search_index(ctl_motion* motion, ctl_pace pace)
{
    int64_t mark = 0;
    if (motion->board->port.index(motion->board->port.context, &mark)) {
        motion->origin = mark;
        motion->homing = CTL_HOMING_BRAKE;
    }
    motion->homing_left -=
        ctl_motion_move_by_hand(motion, pace, ctl_ramp_up(&motion->ramp, pace.ticks), motion->homing_left);
    if (motion->homing_left == 0)
        ctl_motion_fault(motion, CTL_FAULT_BIT_DRIVE_NOT_FOLLOWING);
}

static void end_homing(ctl_motion* motion)
{
    const bool start = motion->start_after_home;
    motion->homed = true;
    motion->in_phase = true;
    ctl_motion_stand(motion);
    if (start)
        ctl_motion_run(motion);
}

/* Moves to the target; returns true when the axis is there. */
static bool move_to_target(ctl_motion* motion, ctl_pace pace)
{
    const uint32_t travelled =
        ctl_ramp_land(&motion->ramp, pace.ticks, motion->homing_left, motion->ramp.full);
    motion->homing_left -= travelled;
    if (motion->homing_left != 0) {
        (void)ctl_motion_move_by_hand(motion, pace, travelled, UINT64_MAX);
        return false;
    }
    emit_evenly(motion, motion->target - motion->commanded, &pace);
    return true;
}

void ctl_motion_slice_park(ctl_motion* motion, ctl_pace pace)
{
    ctl_park* park = &motion->park;
    if (park->phase == CTL_PARK_WAITING) {
        if (!ctl_park_is_due(park, motion->board))
            return;
        ctl_motion_begin_move(motion, ctl_park_target(park, motion->packer, motion->commanded));
        park->phase = CTL_PARK_OPENING;
        park->away = true;
        return;
    }
    if (park->phase == CTL_PARK_OPEN) {
        if (ctl_tracker_stands(&motion->master->tracker) || motion->master->speed <= 0)
            return;
        ctl_motion_return(motion);
        return;
    }
    if (!move_to_target(motion, pace))
        return;
    if (park->line) {
        park->phase = CTL_PARK_OPEN;
        return;
    }
    if (park->phase == CTL_PARK_CUTTING) {
        ctl_motion_end_cut(motion);
        return;
    }
    const bool returned = park->phase == CTL_PARK_RETURNING;
    park->phase = CTL_PARK_OFF;
    if (returned && park->to_boundary) {
        ctl_table_reset(&motion->table, ctl_active_bank(motion->banks));
        ctl_packer_break_off(motion->packer);
    }
    if (returned)
        ctl_motion_run(motion);
    else if (motion->state == CTL_STATE_FAULT)
        motion->manual = false;
    else
        ctl_motion_rest(motion);
}

void ctl_motion_slice_homing(ctl_motion* motion, ctl_pace pace)
{
    switch (motion->homing) {
    case CTL_HOMING_SEARCH:
        search_index(motion, pace);
        break;
    case CTL_HOMING_BRAKE:
        (void)ctl_motion_move_by_hand(motion, pace, ctl_ramp_down(&motion->ramp, pace.ticks), UINT64_MAX);
        if (motion->ramp.speed == 0) { /* it went past the mark; the same pulses lead back to it */
            ctl_motion_begin_move(motion, motion->origin);
            motion->homing = CTL_HOMING_RETURN;
        }
        break;
    case CTL_HOMING_RETURN:
        if (!move_to_target(motion, pace))
            break;
        motion->homing = CTL_HOMING_ARRIVED;
        if (motion->start_after_home)
            ctl_motion_take_wheel(motion);
        break;
    case CTL_HOMING_ARRIVED: /* the start of a run has a slice of its own */
        end_homing(motion);
        break;
    }
}

void ctl_motion_begin_jog_when_asked(ctl_motion* motion)
{
    const int32_t direction = ctl_jog_request(motion->heartbeat);
    if (direction == 0 || (direction > 0 && ctl_motion_force_forbids(motion)))
        return;
    ctl_motion_begin_manual(motion, ctl_parameter32(motion->board, CTL_REG_PARAMETER_JOG_FREQUENCY),
                            direction);
    motion->state = CTL_STATE_JOGGING;
}
