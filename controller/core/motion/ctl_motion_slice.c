/* SPDX-License-Identifier: Apache-2.0 */
/* Moves the axis during one slice of time, and measures it. */
#include "motion/ctl_motion.h"

#define US_PER_S 1000000
#define SPEED_SAMPLE_US 1000u

void ctl_motion_emit(ctl_motion* motion, int64_t pulses)
{
    if (pulses == 0)
        return;
    motion->commanded += pulses;
    motion->board->port.pulses(motion->board->port.context, (int32_t)pulses);
}

/* Between the last pulse of one cycle and the first of the next an armed program takes over. */
static void take_over_armed(ctl_motion* motion)
{
    if (motion->transfer->state != CTL_STAGED_STATE_ARMED || motion->state != CTL_STATE_RUNNING)
        return;
    ctl_transfer_apply(motion->transfer, motion->banks);
    ctl_table_change_bank(&motion->table, ctl_active_bank(motion->banks));
    ctl_packer_change_bank(motion->packer, ctl_active_bank(motion->banks));
}

static void cross_boundary(ctl_motion* motion)
{
    ctl_table* table = &motion->table;
    if (!ctl_packer_active(motion->packer))
        take_over_armed(motion);
    ctl_table_begin_cycle(table, motion->direction);
}

/* A cycle was completed; false when the table ends with it. */
static bool count_cycle(ctl_motion* motion)
{
    motion->cycle_count += 1;
    if (ctl_bank_at_end(motion->table.bank) != CTL_END_BEHAVIOR_STOP)
        return true;
    motion->stop = CTL_STOP_NOW;
    motion->state = CTL_STATE_STOPPING;
    motion->ramp.speed = 0;
    return false;
}

/* The master moves on by so many ticks. */
static void run_table(ctl_motion* motion, uint32_t ticks)
{
    ctl_table* table = &motion->table;
    while (ticks != 0) {
        if (ctl_table_between_cycles(table))
            cross_boundary(motion);
        const bool held = ctl_table_holding(table);
        uint32_t used = ticks;
        ctl_motion_emit(motion, ctl_table_advance(table, motion->direction, &used));
        ticks -= used;
        const bool over = ctl_table_between_cycles(table) || ctl_table_holding(table) != held;
        if (over && used != 0 && !count_cycle(motion))
            return;
    }
}

/* The master moves on: film, infeed and knife of a packing machine, otherwise the table at once. */
static void travel(ctl_motion* motion, uint32_t ticks)
{
    if (!ctl_packer_active(motion->packer)) {
        run_table(motion, ticks);
        return;
    }
    while (ticks != 0) {
        if (motion->transfer->state == CTL_STAGED_STATE_ARMED && ctl_packer_position(motion->packer) == 0 &&
            ctl_table_between_cycles(&motion->table) &&
            ctl_motion_may_change(motion, ctl_staged_bank(motion->banks)))
            take_over_armed(motion);
        const ctl_drive drive = {&motion->ramp, motion->state == CTL_STATE_RUNNING};
        uint32_t used = ticks;
        run_table(motion, ctl_packer_advance(motion->packer, &drive, &used));
        ticks -= used;
    }
}

/* Pulses of jogging or homing in so many ticks at full speed, without their sign. */
static int64_t manual_pulses(ctl_motion* motion, uint32_t ticks)
{
    const uint64_t sum = (uint64_t)ticks * motion->manual_hz + motion->manual_rest;
    motion->manual_rest = sum % motion->board->config.timer_clock_hz;
    return (int64_t)(sum / motion->board->config.timer_clock_hz);
}

static void slice_running(ctl_motion* motion, uint32_t ticks)
{
    const int32_t wanted = ctl_motion_wanted_direction(motion);
    if (wanted == motion->direction) {
        travel(motion, ctl_ramp_up(&motion->ramp, ticks));
        return;
    }
    travel(motion, ctl_ramp_down(&motion->ramp, ticks));
    if (motion->ramp.speed == 0)
        motion->direction = wanted;
}

static void slice_stopping(ctl_motion* motion, uint32_t ticks)
{
    switch (motion->stop) {
    case CTL_STOP_NOW:
        travel(motion, ctl_ramp_down(&motion->ramp, ticks));
        break;
    case CTL_STOP_AT_REST:
        travel(motion, ctl_ramp_up(&motion->ramp, ticks));
        break;
    case CTL_STOP_AT_BOUNDARY: {
        const uint32_t travelled =
            ctl_ramp_land(&motion->ramp, ticks, motion->stop_remaining, motion->stop_limit);
        travel(motion, travelled);
        motion->stop_remaining -= travelled;
        break;
    }
    }
}

/* Running, or stopping from it: the master moves, then what follows it at its own pace. */
static void slice_table(ctl_motion* motion, uint32_t ticks)
{
    while (ticks != 0 && ctl_motion_in_cycle(motion)) {
        const uint32_t longest = ctl_table_longest_pass(&motion->table);
        const uint32_t part = ticks < longest ? ticks : longest;
        ticks -= part;
        if (motion->state == CTL_STATE_RUNNING)
            slice_running(motion, part);
        else
            slice_stopping(motion, part);
        ctl_motion_emit(motion, ctl_table_pass(&motion->table, part));
        if (ctl_table_too_fast(&motion->table)) {
            ctl_motion_fault(motion, CTL_FAULT_BIT_MASTER_TOO_FAST);
            return;
        }
        const bool landed = motion->stop != CTL_STOP_AT_BOUNDARY || motion->stop_remaining == 0;
        if (motion->state == CTL_STATE_STOPPING && motion->ramp.speed == 0 && landed &&
            ctl_table_settled(&motion->table))
            ctl_motion_stand(motion);
    }
}

/* Jogging or homing was stopped. */
static void slice_manual_stop(ctl_motion* motion, uint32_t ticks)
{
    ctl_motion_emit(motion,
                    motion->manual_direction * manual_pulses(motion, ctl_ramp_down(&motion->ramp, ticks)));
    if (motion->ramp.speed == 0)
        ctl_motion_stand(motion);
}

static void slice_jogging(ctl_motion* motion, uint32_t ticks)
{
    const bool held = ctl_jog_request(motion->heartbeat) == motion->manual_direction &&
                      (motion->manual_direction < 0 || !ctl_motion_force_forbids(motion));
    const uint32_t travelled = held ? ctl_ramp_up(&motion->ramp, ticks) : ctl_ramp_down(&motion->ramp, ticks);
    ctl_motion_emit(motion, motion->manual_direction * manual_pulses(motion, travelled));
    if (!held && motion->ramp.speed == 0)
        ctl_motion_stand(motion);
}

static void search_index(ctl_motion* motion, uint32_t ticks)
{
    int64_t mark = 0;
    if (motion->board->port.index(motion->board->port.context, &mark)) {
        motion->origin = mark;
        motion->homing = CTL_HOMING_BRAKE;
    }
    int64_t pulses = manual_pulses(motion, ctl_ramp_up(&motion->ramp, ticks));
    if ((uint64_t)pulses > motion->homing_left)
        pulses = (int64_t)motion->homing_left;
    ctl_motion_emit(motion, pulses);
    motion->homing_left -= (uint64_t)pulses;
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

/* It went past the mark while it braked; the same pulses lead back to it. */
static void begin_return(ctl_motion* motion)
{
    const int64_t beyond = motion->commanded - motion->origin;
    const uint64_t distance = (uint64_t)(beyond < 0 ? -beyond : beyond);
    motion->manual_direction = beyond < 0 ? 1 : -1;
    motion->manual_rest = 0;
    motion->homing = CTL_HOMING_RETURN;
    motion->homing_left =
        (distance * motion->board->config.timer_clock_hz + motion->manual_hz - 1u) / motion->manual_hz;
}

static void return_to_mark(ctl_motion* motion, uint32_t ticks)
{
    const uint32_t travelled = ctl_ramp_land(&motion->ramp, ticks, motion->homing_left, motion->ramp.full);
    const int64_t pulses = manual_pulses(motion, travelled);
    motion->homing_left -= travelled;
    if (motion->homing_left != 0) {
        ctl_motion_emit(motion, motion->manual_direction * pulses);
        return;
    }
    ctl_motion_emit(motion, motion->origin - motion->commanded);
    end_homing(motion);
}

static void slice_homing(ctl_motion* motion, uint32_t ticks)
{
    switch (motion->homing) {
    case CTL_HOMING_SEARCH:
        search_index(motion, ticks);
        break;
    case CTL_HOMING_BRAKE:
        ctl_motion_emit(motion, manual_pulses(motion, ctl_ramp_down(&motion->ramp, ticks)));
        if (motion->ramp.speed == 0)
            begin_return(motion);
        break;
    case CTL_HOMING_RETURN:
        return_to_mark(motion, ticks);
        break;
    }
}

static void begin_jog_when_asked(ctl_motion* motion)
{
    const int32_t direction = ctl_jog_request(motion->heartbeat);
    if (direction == 0 || (direction > 0 && ctl_motion_force_forbids(motion)))
        return;
    ctl_motion_begin_manual(motion, ctl_parameter32(motion->board, CTL_REG_PARAMETER_JOG_FREQUENCY),
                            direction);
    motion->state = CTL_STATE_JOGGING;
}

static void measure(ctl_motion* motion)
{
    ctl_speed_meter* meter = &motion->meter;
    motion->actual = motion->board->port.encoder(motion->board->port.context);
    const uint8_t newest = (uint8_t)((meter->next + CTL_SPEED_SAMPLES - 1u) % CTL_SPEED_SAMPLES);
    if (motion->board->now_us - meter->time_us[newest] >= SPEED_SAMPLE_US) {
        const int64_t span_us = (int64_t)(motion->board->now_us - meter->time_us[meter->next]);
        motion->actual_hz = (motion->actual - meter->position[meter->next]) * US_PER_S / span_us;
        meter->position[meter->next] = motion->actual;
        meter->time_us[meter->next] = motion->board->now_us;
        meter->next = (uint8_t)((meter->next + 1u) % CTL_SPEED_SAMPLES);
    }
    const int64_t error = motion->commanded - motion->actual;
    const int64_t limit = ctl_parameter32(motion->board, CTL_REG_PARAMETER_FOLLOWING_ERROR_LIMIT);
    if (motion->state != CTL_STATE_FAULT && (error > limit || error < -limit))
        ctl_motion_fault(motion, CTL_FAULT_BIT_FOLLOWING_ERROR);
}

void ctl_motion_slice(ctl_motion* motion, uint32_t ticks)
{
    switch (motion->state) {
    case CTL_STATE_IDLE:
    case CTL_STATE_READY:
        begin_jog_when_asked(motion);
        break;
    case CTL_STATE_RUNNING:
    case CTL_STATE_STOPPING:
        if (motion->manual)
            slice_manual_stop(motion, ticks);
        else if (ctl_motion_is_press(motion))
            ctl_motion_slice_stroke(motion, ticks);
        else
            slice_table(motion, ticks);
        break;
    case CTL_STATE_JOGGING:
        slice_jogging(motion, ticks);
        break;
    case CTL_STATE_HOMING:
        slice_homing(motion, ticks);
        break;
    default:
        break;
    }
    measure(motion);
}
