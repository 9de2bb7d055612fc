/* SPDX-License-Identifier: Apache-2.0 */
/* Moves the axis during one slice of time, and measures it. */
#include "motion/ctl_motion.h"

#include <stddef.h>

#define US_PER_S 1000000
#define SPEED_SAMPLE_US 1000u
#define RIPPLE_SHARE 32u /* of the speed of an encoder that leads, that counts as full speed */

/* The slice, in which the engine's ticks are those of the timer. */
static ctl_pace pace_of(const ctl_motion* motion, uint32_t ticks)
{
    return (ctl_pace){&motion->board->port, motion->board->tick, ticks, ticks};
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

/* The table moves on by the travel of the pace. */
static void run_table(ctl_motion* motion, ctl_pace pace)
{
    ctl_table* table = &motion->table;
    while (pace.travel != 0) {
        if (ctl_table_between_cycles(table)) {
            ctl_table_begin_cycle(table, motion->direction);
            ctl_park_begin_cycle(&motion->park, motion->commanded);
        }
        const bool held = ctl_table_holding(table);
        uint32_t used = pace.travel;
        motion->commanded += ctl_table_advance(table, motion->direction, &used, &pace);
        (void)ctl_pace_take(&pace, used, used);
        const bool over = ctl_table_between_cycles(table) || ctl_table_holding(table) != held;
        if (over && used != 0 && !count_cycle(motion))
            return;
    }
}

/* The master moves on by the travel of the pace, of a packing machine at most to the end of its cycle: film
 * and infeed with it, then the table. Takes off what was used and returns its ticks. */
static uint32_t move_on(ctl_motion* motion, ctl_pace* pace)
{
    uint32_t used = pace->travel;
    if (!ctl_packer_active(motion->packer)) {
        if (motion->change_planned && used > motion->change_ticks)
            used = (uint32_t)motion->change_ticks;
        run_table(motion, ctl_pace_take(pace, used, used));
        return used;
    }
    const bool changes_next =
        motion->change_planned && motion->change_ticks <= ctl_motion_to_boundary(motion);
    const bool running =
        (motion->state == CTL_STATE_RUNNING && !motion->change_rests) || motion->packer->wheel.on;
    const bool slows = motion->change_planned && !motion->master->leads;
    const uint64_t run_ticks = slows ? motion->change_ticks : CTL_DRIVE_NO_END;
    const bool gains = motion->stop == CTL_STOP_AT_BOUNDARY && !motion->master->leads;
    const ctl_drive drive = {
        .ramp = &motion->ramp,
        .running = running,
        .end_ticks = running ? run_ticks : motion->stop_remaining,
        .end_speed = running ? motion->change_speed : 0,
        .limit = gains ? motion->stop_limit : 0,
        .changes = changes_next,
        .opens = motion->change_planned && motion->change_opens,
    };
    const uint32_t knife = ctl_packer_advance(motion->packer, &drive, &used);
    run_table(motion, ctl_pace_take(pace, used, knife));
    return used;
}

static void travel(ctl_motion* motion, ctl_pace pace)
{
    while (pace.travel != 0) {
        if (motion->change_planned && motion->change_ticks == 0)
            ctl_motion_pass_boundary(motion, &pace.travel);
        const uint32_t used = move_on(motion, &pace);
        if (motion->change_planned)
            motion->change_ticks -= used;
    }
}

/* Somebody else drives the film: where it is corrected, the line is shifted against it instead. */
static void follow_film(ctl_motion* motion)
{
    ctl_master* master = motion->master;
    ctl_packer* packer = motion->packer;
    ctl_packer_shift_line(packer, ctl_master_take_shift(master));
    ctl_master_shift(master, ctl_packer_wheel_shift(packer, ctl_master_ahead(master)));
    packer->wheel.opens = master->clutch.state != CTL_CLUTCH_ON || motion->state != CTL_STATE_RUNNING;
    if (packer->wheel.slips)
        ctl_motion_fault(motion, CTL_FAULT_BIT_MASTER_SLIP);
}

/* The film of somebody else goes on: the run ends as soon as the knife stands open. */
static void leave_film(ctl_motion* motion)
{
    if (motion->packer->knife_gate.state != CTL_GATE_STATE_STANDING)
        return;
    ctl_master_release(motion->master, &motion->ramp);
    motion->ramp.speed = 0;
    motion->stop_remaining = 0;
}

/* The encoder moves the line. */
static void slice_led(ctl_motion* motion, ctl_pace pace)
{
    const int32_t way = ctl_master_travel(motion->master, &motion->ramp, pace.ticks);
    motion->direction = way < 0 ? -1 : 1;
    pace.travel = (uint32_t)(way < 0 ? -way : way);
    if (motion->master->fault != CTL_LOST_NONE) {
        ctl_motion_fault(motion, motion->master->fault);
        return;
    }
    if (way < 0)
        motion->change_planned = false;
    travel(motion, pace);
    if (motion->packer->wheel.on)
        follow_film(motion);
    if (motion->packer->wheel.on && motion->state == CTL_STATE_STOPPING)
        leave_film(motion);
    else if (motion->state == CTL_STATE_STOPPING || motion->change_rests)
        motion->stop_remaining = ctl_master_to_end(motion->master);
    if (motion->state == CTL_STATE_RUNNING && motion->master->too_fast)
        (void)ctl_motion_stop_at_cycle_end(motion);
}

/* Nobody knows when the line goes on: the knife opens meanwhile. */
static bool opens_under_line(ctl_motion* motion)
{
    ctl_park* park = &motion->park;
    if (!ctl_park_begin_under_line(park, motion->board, motion->packer, motion->commanded,
                                   ctl_tracker_stands(&motion->master->tracker)))
        return false;
    ctl_master_release(motion->master, &motion->ramp);
    ctl_motion_begin_move(motion, ctl_park_target(park, motion->packer, motion->commanded));
    return true;
}

static void slice_stopping(ctl_motion* motion, ctl_pace pace)
{
    motion->change_planned = false;
    motion->change_rests = false;
    const ctl_master* master = motion->master;
    if (master->leads && (master->speed < 0 || ctl_tracker_stands(&master->tracker)))
        (void)ctl_motion_stop_now(motion); /* the end of the cycle may never come */
    if (motion->master->leads) {
        slice_led(motion, pace);
        return;
    }
    switch (motion->stop) {
    case CTL_STOP_NOW:
        pace.travel = ctl_ramp_down(&motion->ramp, pace.ticks);
        break;
    case CTL_STOP_AT_REST:
        pace.travel = ctl_ramp_up(&motion->ramp, pace.ticks);
        break;
    case CTL_STOP_AT_BOUNDARY:
        pace.travel = ctl_ramp_land(&motion->ramp, pace.ticks, motion->stop_remaining, motion->stop_limit);
        break;
    }
    travel(motion, pace);
    motion->stop_remaining -= pace.travel < motion->stop_remaining ? pace.travel : motion->stop_remaining;
}

static void slice_running(ctl_motion* motion, ctl_pace pace)
{
    const uint32_t ticks = pace.ticks;
    const int32_t wanted = ctl_motion_wanted_direction(motion);
    if (motion->master->leads) {
        if (motion->change_rests && motion->master->clutch.state == CTL_CLUTCH_OFF) {
            ctl_motion_change_at_rest(motion);
            return;
        }
        ctl_motion_plan_led_change(motion);
        if (!opens_under_line(motion))
            slice_led(motion, pace);
        return;
    }
    if (motion->one_bag && ctl_motion_ends_with_bag(motion)) {
        slice_stopping(motion, pace);
        return;
    }
    if (motion->board->hand[0] != motion->speed_percent && ctl_packer_takes_other_speed(motion->packer))
        ctl_motion_limit_speed(motion);
    const bool changes = wanted == motion->direction && ctl_motion_changes(motion);
    motion->change_planned = motion->change_planned && changes;
    if (changes) {
        if (!motion->change_planned)
            ctl_motion_plan_change(motion, ticks);
        pace.travel = ctl_ramp_approach(&motion->ramp, ticks, motion->change_ticks, motion->change_speed);
        travel(motion, pace);
        return;
    }
    if (wanted == motion->direction) {
        pace.travel = ctl_ramp_up(&motion->ramp, ticks);
        travel(motion, pace);
        return;
    }
    pace.travel = ctl_ramp_down(&motion->ramp, ticks);
    travel(motion, pace);
    if (motion->ramp.speed == 0)
        motion->direction = wanted;
}

void ctl_motion_come_to_rest(ctl_motion* motion)
{
    if (!ctl_park_begin(&motion->park, motion->board, motion->packer, motion->commanded))
        ctl_motion_rest(motion);
}

/* Running, or stopping from it: the master moves, then what follows it at its own pace. */
static void slice_table(ctl_motion* motion, ctl_pace pace)
{
    while (pace.travel != 0 && ctl_motion_in_cycle(motion)) {
        const uint32_t longest = ctl_table_longest_pass(&motion->table);
        const uint32_t ticks = pace.travel < longest ? pace.travel : longest;
        const ctl_pace part = ctl_pace_take(&pace, ticks, ticks);
        if (motion->state == CTL_STATE_RUNNING)
            slice_running(motion, part);
        else
            slice_stopping(motion, part);
        motion->commanded += ctl_table_pass(&motion->table, ticks, &part);
        if (ctl_table_too_fast(&motion->table)) {
            ctl_motion_fault(motion, CTL_FAULT_BIT_MASTER_TOO_FAST);
            return;
        }
        const bool landed = motion->stop != CTL_STOP_AT_BOUNDARY || motion->stop_remaining == 0;
        if (motion->state == CTL_STATE_STOPPING && motion->ramp.speed == 0 && landed &&
            ctl_table_settled(&motion->table)) {
            ctl_motion_come_to_rest(motion);
            return;
        }
    }
}

static void measure(ctl_motion* motion)
{
    ctl_speed_meter* meter = &motion->meter;
    motion->actual = motion->board->port.encoder(motion->board->port.context);
    const uint8_t newest = (uint8_t)((meter->next + CTL_SPEED_SAMPLES - 1u) % CTL_SPEED_SAMPLES);
    if (motion->board->now_us - meter->time_us[newest] >= SPEED_SAMPLE_US && !motion->packer->busy) {
        const int64_t span_us = (int64_t)(motion->board->now_us - meter->time_us[meter->next]);
        motion->actual_hz = (motion->actual - meter->position[meter->next]) * US_PER_S / span_us;
        meter->position[meter->next] = motion->actual;
        meter->time_us[meter->next] = motion->board->now_us;
        meter->next = (uint8_t)((meter->next + 1u) % CTL_SPEED_SAMPLES);
    }
    const int64_t error = motion->commanded - motion->actual;
    const int64_t limit = ctl_parameter32(motion->board, CTL_REG_PARAMETER_FOLLOWING_ERROR_LIMIT);
    const bool follows = motion->state != CTL_STATE_FAULT || motion->park.phase == CTL_PARK_OPENING;
    if (follows && (error > limit || error < -limit))
        ctl_motion_fault(motion, CTL_FAULT_BIT_FOLLOWING_ERROR);
}

static ctl_jam_slice jam_slice(const ctl_motion* motion, int32_t from_cut)
{
    const ctl_port* port = &motion->board->port;
    const ctl_packer* packer = motion->packer;
    const ctl_ramp* ramp = &motion->ramp;
    const uint32_t ripple = ramp->led ? ramp->full / RIPPLE_SHARE : 0u;
    const bool is_full = ramp->speed + ripple >= ramp->full && ramp->speed <= ramp->full + ripple;
    const ctl_jam_slice slice = {
        .now_us = (uint32_t)motion->board->now_us,
        .cycle = (uint32_t)motion->park.cycle_at,
        .from_cut = from_cut,
        .in_phase = packer->film_gate.state == CTL_GATE_STATE_RUNNING &&
                    packer->knife_gate.state == CTL_GATE_STATE_RUNNING,
        .share = is_full ? CTL_JAM_FULL_SPEED : ctl_ramp_share(ramp, CTL_JAM_FULL_SPEED),
        .limited = motion->torque_limited,
        .torque = port->torque == NULL ? 0 : port->torque(port->context),
    };
    return slice;
}

/* Compares the torque of the knife with what it was in good cycles. */
static void watch_for_jam(ctl_motion* motion)
{
    const ctl_packer* packer = motion->packer;
    ctl_jam* jam = &motion->packer->jam;
    if (packer->busy) {
        ctl_jam_miss(jam);
        return;
    }
    if (!jam->settings.on || !motion->park.known || ctl_motion_standstill(motion) ||
        !ctl_packer_is_set(packer))
        return;
    const int32_t from_cut = (int32_t)ctl_park_from_cut(&motion->park, packer, motion->actual);
    if (motion->park.jam) {
        ctl_jam_run_on(jam, from_cut);
        return;
    }
    const ctl_jam_slice slice = jam_slice(motion, from_cut);
    if (ctl_motion_in_cycle(motion) && ctl_jam_watch(jam, &slice))
        ctl_motion_stop_jam(motion);
}

void ctl_motion_slice(ctl_motion* motion, uint32_t ticks)
{
    const ctl_pace pace = pace_of(motion, ticks);
    motion->begins = false;
    switch (motion->state) {
    case CTL_STATE_IDLE:
    case CTL_STATE_READY:
        ctl_motion_begin_jog_when_asked(motion);
        break;
    case CTL_STATE_RUNNING:
    case CTL_STATE_STOPPING:
        if (motion->park.phase != CTL_PARK_OFF)
            ctl_motion_slice_park(motion, pace);
        else if (motion->manual)
            ctl_motion_slice_manual_stop(motion, pace);
        else if (ctl_motion_is_press(motion))
            ctl_motion_slice_stroke(motion, &pace);
        else
            slice_table(motion, pace);
        break;
    case CTL_STATE_JOGGING:
        if (motion->measures)
            ctl_motion_slice_measure(motion, &pace);
        else
            ctl_motion_slice_jogging(motion, pace);
        break;
    case CTL_STATE_HOMING:
        ctl_motion_slice_homing(motion, pace);
        break;
    case CTL_STATE_FAULT:
        if (motion->park.phase != CTL_PARK_OFF)
            ctl_motion_slice_park(motion, pace);
        break;
    default:
        break;
    }
    measure(motion);
    watch_for_jam(motion);
    if (ctl_motion_standstill(motion) || motion->park.phase != CTL_PARK_OFF || motion->park.stands)
        ctl_park_watch(&motion->park, motion->board, motion->packer, motion->actual);
}
