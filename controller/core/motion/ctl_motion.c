/* SPDX-License-Identifier: Apache-2.0 */
/* States and commands; what moves the axis meanwhile is in ctl_motion_slice.c. */
#include "motion/ctl_motion.h"

#include <string.h>

#define MS_PER_S 1000u
#define HOMING_REVOLUTIONS 2u
#define TURNED_SHARE 720 /* of a revolution: half a degree */

static uint32_t ramp_ticks(const ctl_motion* motion, uint32_t time_ms)
{
    const uint64_t ticks = (uint64_t)time_ms * motion->board->config.timer_clock_hz / MS_PER_S;
    return ticks < UINT32_MAX ? (uint32_t)ticks : UINT32_MAX;
}

void ctl_motion_init(ctl_motion* motion)
{
    ctl_ramp_reset(&motion->ramp, ramp_ticks(motion, CTL_JOG_RAMP_MS));
    motion->direction = 1;
    motion->actual = motion->board->port.encoder(motion->board->port.context);
    motion->commanded = motion->actual;
    for (uint32_t i = 0; i < CTL_SPEED_SAMPLES; ++i) {
        motion->meter.position[i] = motion->actual;
        motion->meter.time_us[i] = motion->board->now_us;
    }
    ctl_table_init(&motion->table, &motion->board->config);
    ctl_press_reset(&motion->press);
    if (ctl_motion_is_press(motion))
        ctl_motion_take_top(motion);
    if (motion->banks->has_active)
        ctl_table_reset(&motion->table, ctl_active_bank(motion->banks));
    ctl_motion_stand(motion);
}

bool ctl_motion_standstill(const ctl_motion* motion)
{
    const uint16_t state = motion->state;
    return state == CTL_STATE_IDLE || state == CTL_STATE_READY ||
           (state == CTL_STATE_FAULT && motion->park.phase == CTL_PARK_OFF);
}

bool ctl_motion_in_cycle(const ctl_motion* motion)
{
    const uint16_t state = motion->state;
    return !motion->manual && (state == CTL_STATE_RUNNING || state == CTL_STATE_STOPPING);
}

bool ctl_motion_follows(const ctl_motion* motion)
{
    return motion->state == CTL_STATE_RUNNING && motion->follows;
}

bool ctl_motion_may_change(const ctl_motion* motion)
{
    return ctl_packer_may_change(motion->packer, ctl_motion_standstill(motion));
}

void ctl_motion_change_program(ctl_motion* motion)
{
    const bool had_program = motion->banks->has_active;
    const bool same =
        had_program && ctl_bank_same_machine(ctl_active_bank(motion->banks), ctl_staged_bank(motion->banks));
    ctl_transfer_apply(motion->transfer, motion->banks);
    ctl_jam_forget(&motion->packer->jam);
    const bool stands_right = motion->in_phase || !ctl_bank_needs_homing(ctl_active_bank(motion->banks));
    if (same && stands_right && ctl_table_between_cycles(&motion->table) && ctl_motion_may_change(motion)) {
        ctl_table_change_bank(&motion->table, ctl_active_bank(motion->banks));
        ctl_packer_change_bank(motion->packer, ctl_active_bank(motion->banks), motion->banks->active_crc,
                               &motion->ramp);
    } else {
        ctl_packer_break_off(motion->packer);
        ctl_park_forget(&motion->park);
        motion->in_phase = false;
        motion->homed = motion->homed && same;
        ctl_table_reset(&motion->table, ctl_active_bank(motion->banks));
    }
    if (ctl_motion_is_press(motion) && !same)
        ctl_motion_take_top(motion);
    if (motion->state == CTL_STATE_IDLE)
        motion->state = CTL_STATE_READY;
}

uint16_t ctl_motion_change_refusal(ctl_motion* motion)
{
    const ctl_bank* staged = ctl_staged_bank(motion->banks);
    motion->change = ctl_change_between(motion->board, motion->packer, ctl_active_bank(motion->banks), staged,
                                        motion->direction);
    const uint16_t line_refusal = ctl_packer_refusal(motion->packer, staged);
    if (line_refusal != CTL_REFUSAL_NONE)
        return line_refusal;
    /* Behind an encoder the line comes to rest where the steps demand it. */
    return motion->master->leads ? ctl_master_refusal(motion->master, staged)
                                 : ctl_change_refusal(&motion->change);
}

static bool repeats(const ctl_motion* motion)
{
    return ctl_bank_at_end(ctl_active_bank(motion->banks)) == CTL_END_BEHAVIOR_REPEAT;
}

void ctl_motion_stand(ctl_motion* motion)
{
    ctl_master_release(motion->master, &motion->ramp);
    motion->ramp.speed = 0;
    motion->manual = false;
    motion->start_after_home = false;
    motion->state = motion->banks->has_active ? CTL_STATE_READY : CTL_STATE_IDLE;
    /* A table that does not repeat is over when it was stopped: the next start is its beginning. */
    if (motion->banks->has_active && !repeats(motion) && !ctl_table_between_cycles(&motion->table))
        ctl_table_reset(&motion->table, ctl_active_bank(motion->banks));
    if (motion->transfer->state == CTL_STAGED_STATE_ARMED && ctl_table_between_cycles(&motion->table) &&
        ctl_motion_may_change(motion))
        ctl_motion_change_program(motion);
}

/* Step tables ramp by the parameter. Others may have their master's ramp in the bank; where they have none,
 * full speed comes at once at the start of a cycle, and the parameter serves all other changes of speed. */
void ctl_motion_set_ramp(ctl_motion* motion)
{
    const ctl_bank* bank = ctl_active_bank(motion->banks);
    const uint32_t bank_ms = ctl_bank_master_ramp_ms(bank);
    const uint32_t ramp_ms =
        bank_ms != 0 ? bank_ms : ctl_parameter16(motion->board, CTL_REG_PARAMETER_RAMP_TIME);
    const uint32_t full = ramp_ticks(motion, ramp_ms);
    if (ctl_bank_ramp_shape(bank) == CTL_RAMP_SHAPE_SCURVE)
        ctl_ramp_reset_s(&motion->ramp, full);
    else
        ctl_ramp_reset(&motion->ramp, full);
    ctl_motion_limit_speed(motion);
}

void ctl_motion_limit_speed(ctl_motion* motion)
{
    motion->speed_percent = motion->board->hand[CTL_REG_HAND_SPEED - CTL_REG_HAND_SPEED];
    if (repeats(motion))
        ctl_ramp_limit(&motion->ramp, motion->speed_percent);
    if (motion->one_bag)
        ctl_motion_limit_bag(motion);
}

static void begin_master_ramp(ctl_motion* motion)
{
    const ctl_bank* bank = ctl_active_bank(motion->banks);
    ctl_motion_set_ramp(motion);
    if (ctl_bank_master_ramp_ms(bank) == 0 && ctl_bank_layout(bank) != CTL_TABLE_LAYOUT_STEP_TABLE &&
        ctl_table_between_cycles(&motion->table))
        motion->ramp.speed = motion->ramp.limit;
}

int32_t ctl_motion_wanted_direction(const ctl_motion* motion)
{
    const ctl_bank* bank = ctl_active_bank(motion->banks);
    if (!repeats(motion) || ctl_bank_layout(bank) != CTL_TABLE_LAYOUT_CAM_POINTS)
        return 1;
    const int32_t direction = ctl_bank_direction(bank);
    return ctl_parameter16(motion->board, CTL_REG_PARAMETER_MASTER_DIRECTION) != 0 ? -direction : direction;
}

/* Where in its cycle a run begins. */
static uint32_t start_position(const ctl_motion* motion)
{
    const ctl_bank* bank = ctl_active_bank(motion->banks);
    return ctl_packer_drives(motion->packer, bank) ? ctl_packer_start_position(motion->packer, bank)
                                                   : ctl_table_position(&motion->table);
}

void ctl_motion_take_wheel(ctl_motion* motion)
{
    const ctl_bank* bank = ctl_active_bank(motion->banks);
    const ctl_master* master = motion->master;
    ctl_packer* packer = motion->packer;
    packer->wheel.counts = master->tracker.count;
    packer->wheel.reversed = master->reversed;
    packer->wheel.opens = true;
    ctl_packer_take_wheel(packer, bank, ctl_master_is_wheel(master, bank) && ctl_packer_drives(packer, bank));
}

/* The film that a wheel measures goes on meanwhile. One bag is made by the clock. */
static void engage(ctl_motion* motion)
{
    const ctl_bank* bank = ctl_active_bank(motion->banks);
    ctl_master* master = motion->master;
    ctl_packer* packer = motion->packer;
    ctl_motion_take_wheel(motion);
    if (!motion->one_bag)
        ctl_master_engage(master, bank, start_position(motion), &motion->ramp);
    ctl_packer_run(packer, bank, motion->banks->active_crc, &motion->ramp);
    if (packer->wheel.on)
        ctl_packer_join_film(packer, ctl_master_ahead(master));
}

void ctl_motion_run(ctl_motion* motion)
{
    begin_master_ramp(motion);
    motion->direction = ctl_motion_wanted_direction(motion);
    engage(motion);
    motion->follows = motion->master->leads;
    motion->manual = false;
    motion->start_after_home = false;
    motion->change_planned = false;
    motion->change_rests = false;
    ctl_park_run(&motion->park);
    if (motion->one_bag)
        ctl_packer_scrap_next(motion->packer);
    motion->state = CTL_STATE_RUNNING;
    motion->begins = true;
    if (ctl_motion_is_press(motion))
        ctl_motion_begin_stroke(motion);
}

static void take_by_hand(ctl_motion* motion, uint32_t frequency_hz, int32_t direction)
{
    ctl_ramp_reset(&motion->ramp, ramp_ticks(motion, CTL_JOG_RAMP_MS));
    motion->manual = true;
    motion->manual_hz = frequency_hz;
    motion->manual_direction = direction;
    motion->manual_rest = 0;
}

void ctl_motion_begin_move(ctl_motion* motion, int64_t target)
{
    const int64_t way = target - motion->commanded;
    const uint64_t distance = (uint64_t)(way < 0 ? -way : way);
    take_by_hand(motion, ctl_parameter32(motion->board, CTL_REG_PARAMETER_HOME_FREQUENCY), way < 0 ? -1 : 1);
    motion->target = target;
    motion->homing_left =
        (distance * motion->board->config.timer_clock_hz + motion->manual_hz - 1u) / motion->manual_hz;
}

void ctl_motion_begin_manual(ctl_motion* motion, uint32_t frequency_hz, int32_t direction)
{
    take_by_hand(motion, frequency_hz, direction);
    ctl_park_forget(&motion->park);
    motion->in_phase = false;
    ctl_packer_break_off(motion->packer);
    if (motion->banks->has_active)
        ctl_table_reset(&motion->table, ctl_active_bank(motion->banks));
}

static void begin_homing(ctl_motion* motion)
{
    const ctl_bank* bank = ctl_active_bank(motion->banks);
    int64_t stale_mark;
    motion->board->port.index(motion->board->port.context, &stale_mark);
    ctl_motion_begin_manual(motion, ctl_parameter32(motion->board, CTL_REG_PARAMETER_HOME_FREQUENCY), 1);
    motion->homed = false;
    motion->state = CTL_STATE_HOMING;
    if ((motion->board->config.kept_positions & 1u << CTL_IO_BIT_AXIS_KEPT) != 0) {
        motion->origin = ctl_bank_nearest_turn(bank, motion->commanded);
        motion->homing = CTL_HOMING_RETURN;
        ctl_motion_begin_move(motion, motion->origin);
        return;
    }
    motion->homing = CTL_HOMING_SEARCH;
    motion->homing_left = ctl_bank_revolution_pulses(bank, HOMING_REVOLUTIONS);
}

void ctl_motion_fault(ctl_motion* motion, uint16_t fault_bit)
{
    /* The others speak against the axis, not against its table. */
    const bool may_open = fault_bit == CTL_FAULT_BIT_ACTIVE_TABLE_DAMAGED && !ctl_motion_standstill(motion);
    motion->fault = (uint16_t)(motion->fault | 1u << fault_bit);
    motion->state = CTL_STATE_FAULT;
    if (motion->press.stage != CTL_PRESS_STAGE_STANDING) {
        ctl_press_abandon(&motion->press);
        motion->cycle_count += 1;
    }
    ctl_master_release(motion->master, &motion->ramp);
    ctl_measure_end(&motion->measure,
                    fault_bit == CTL_FAULT_BIT_DRIVE_ALARM ? CTL_REFUSAL_DRIVE_ALARM : CTL_REFUSAL_IN_FAULT);
    motion->measures = false;
    motion->ramp.speed = 0;
    motion->manual = false;
    motion->start_after_home = false;
    motion->park.phase = CTL_PARK_OFF;
    motion->homed = motion->homed && ctl_motion_is_press(motion);
    motion->in_phase = false;
    ctl_packer_break_off(motion->packer);
    if (may_open)
        (void)ctl_park_begin(&motion->park, motion->board, motion->packer, motion->commanded);
}

/* On film that somebody else drives a knife joins at the boundary of its cycle, where it is open. */
static bool begins_at_boundary(const ctl_motion* motion)
{
    return ctl_master_is_wheel(motion->master, ctl_active_bank(motion->banks)) && motion->park.known &&
           !ctl_table_between_cycles(&motion->table);
}

void ctl_motion_return(ctl_motion* motion)
{
    ctl_park* park = &motion->park;
    const bool to_boundary = begins_at_boundary(motion);
    ctl_park_return(park);
    park->to_boundary = to_boundary;
    ctl_motion_begin_move(motion, to_boundary ? ctl_park_boundary(park, motion->packer, motion->commanded)
                                              : park->place);
}

void ctl_motion_set_off(ctl_motion* motion)
{
    if (motion->in_phase && (motion->park.away || begins_at_boundary(motion))) {
        ctl_motion_return(motion);
        motion->state = CTL_STATE_RUNNING;
    } else if (motion->in_phase || !ctl_bank_needs_homing(ctl_active_bank(motion->banks))) {
        ctl_motion_run(motion);
    } else {
        begin_homing(motion);
        motion->start_after_home = true;
    }
}

void ctl_motion_start(ctl_motion* motion)
{
    motion->one_bag = false;
    ctl_motion_set_off(motion);
}

void ctl_motion_home(ctl_motion* motion)
{
    if (ctl_motion_is_press(motion))
        ctl_motion_take_top(motion);
    else
        begin_homing(motion);
}

uint16_t ctl_motion_stop_now(ctl_motion* motion)
{
    if (ctl_motion_standstill(motion))
        return CTL_REFUSAL_NOT_RUNNING;
    if (motion->state == CTL_STATE_JOGGING) {
        motion->heartbeat->jog_blocked = true;
        ctl_measure_end(&motion->measure, CTL_REFUSAL_NONE);
    } else if (motion->state == CTL_STATE_FAULT) {
        ctl_park_stop(&motion->park);
        motion->manual = false;
    } else {
        if (ctl_motion_is_press(motion))
            ctl_press_stop(&motion->press);
        if (motion->park.phase == CTL_PARK_CUTTING) /* the rest of its turn is not made up for */
            motion->in_phase = false;
        ctl_park_stop(&motion->park);
        ctl_master_release(motion->master, &motion->ramp);
        motion->stop = CTL_STOP_NOW;
        motion->stop_remaining = ctl_ramp_stopping_way(&motion->ramp);
        motion->state = CTL_STATE_STOPPING;
    }
    return CTL_REFUSAL_NONE;
}

void ctl_motion_stop_jam(ctl_motion* motion)
{
    const uint64_t speed = motion->ramp.speed;
    const uint32_t full = motion->ramp.full;
    const int64_t from_cut = ctl_park_from_cut(&motion->park, motion->packer, motion->actual);
    ctl_master_release(motion->master, &motion->ramp);
    ctl_ramp_reset(&motion->ramp,
                   ramp_ticks(motion, ctl_parameter16(motion->board, CTL_REG_PARAMETER_JAM_STOP_TIME)));
    motion->ramp.speed = (uint32_t)(speed * motion->ramp.full / full);
    motion->park.jam = true;
    motion->stop = CTL_STOP_NOW;
    motion->stop_remaining = ctl_ramp_stopping_way(&motion->ramp);
    motion->state = CTL_STATE_STOPPING;
    ctl_packer_spoil(motion->packer, from_cut < 0);
}

/* Unlike other faults this one keeps film and knife in phase: the axis was under control all the time. */
static void hold_jam(ctl_motion* motion)
{
    motion->ramp.speed = 0;
    motion->manual = false;
    motion->fault = (uint16_t)(motion->fault | 1u << CTL_FAULT_BIT_JAM);
    motion->state = CTL_STATE_FAULT;
}

void ctl_motion_rest(ctl_motion* motion)
{
    if (motion->park.jam)
        hold_jam(motion);
    else
        ctl_motion_stand(motion);
}

void ctl_motion_emergency_stop(ctl_motion* motion)
{
    motion->park.emergency = true;
    ctl_measure_end(&motion->measure, CTL_REFUSAL_EMERGENCY_STOP);
    (void)ctl_motion_stop_now(motion);
}

uint32_t ctl_motion_to_boundary(const ctl_motion* motion)
{
    const uint32_t cycle = ctl_bank_cycle_ticks(motion->table.bank);
    const bool packs = ctl_packer_active(motion->packer);
    const uint32_t position =
        packs ? ctl_packer_position(motion->packer) : ctl_table_position(&motion->table);
    return motion->direction > 0 || ctl_table_between_cycles(&motion->table) ? cycle - position : position;
}

uint16_t ctl_motion_stop_at_cycle_end(ctl_motion* motion)
{
    if (motion->state == CTL_STATE_STOPPING)
        return CTL_REFUSAL_NONE;
    if (motion->state != CTL_STATE_RUNNING || motion->manual)
        return ctl_motion_stop_now(motion);
    if (ctl_motion_is_press(motion)) {
        motion->state = CTL_STATE_STOPPING;
        return CTL_REFUSAL_NONE;
    }
    const uint16_t at_end = ctl_bank_at_end(ctl_active_bank(motion->banks));
    if (at_end == CTL_END_BEHAVIOR_HOLD_SPEED)
        return ctl_motion_stop_now(motion);
    if (at_end == CTL_END_BEHAVIOR_STOP) {
        motion->stop = CTL_STOP_AT_REST;
        motion->state = CTL_STATE_STOPPING;
        return CTL_REFUSAL_NONE;
    }
    motion->stop = CTL_STOP_AT_BOUNDARY;
    motion->state = CTL_STATE_STOPPING;
    if (motion->packer->wheel.on && motion->master->leads) {
        motion->stop_remaining = CTL_DRIVE_NO_END;
        motion->change_rests = false;
        return CTL_REFUSAL_NONE;
    }
    if (motion->master->leads) {
        motion->direction = 1; /* to the end of the cycle, even while a cam goes back */
        if (!motion->change_rests)
            motion->stop_remaining =
                ctl_master_disengage(motion->master, &motion->ramp, ctl_motion_to_boundary(motion));
        motion->change_rests = false;
        return CTL_REFUSAL_NONE;
    }
    motion->stop_remaining = ctl_motion_to_boundary(motion);
    const uint32_t cycle = ctl_bank_cycle_ticks(motion->table.bank);
    while (!ctl_ramp_can_land(&motion->ramp, motion->stop_remaining))
        motion->stop_remaining += cycle;
    /* Stopped soon after a start, it may gain some speed, so that the end of the cycle is not hours away. */
    motion->stop_limit = motion->ramp.full / 4u;
    return CTL_REFUSAL_NONE;
}

void ctl_motion_stop_unattended(ctl_motion* motion)
{
    if (motion->measures && ctl_heartbeat_lost(motion->heartbeat, motion->board))
        ctl_measure_end(&motion->measure, CTL_REFUSAL_HEARTBEAT_LOST);
    if (motion->state == CTL_STATE_RUNNING || motion->state == CTL_STATE_HOMING || motion->measures)
        (void)ctl_motion_stop_at_cycle_end(motion);
}

/* After a jam the axis stands where it was sent to, unless somebody has turned it. */
static bool keeps_place(const ctl_motion* motion)
{
    const int64_t error = motion->commanded - motion->actual;
    const int64_t most = ctl_bank_revolution_pulses(ctl_active_bank(motion->banks), 1) / TURNED_SHARE;
    return motion->in_phase && error <= most && error >= -most;
}

uint16_t ctl_motion_reset_fault(ctl_motion* motion)
{
    if (motion->state != CTL_STATE_FAULT)
        return CTL_REFUSAL_NO_FAULT;
    if (!ctl_motion_standstill(motion) || motion->actual_hz != 0 ||
        (motion->banks->has_active && !ctl_active_bank_intact(motion->banks)))
        return CTL_REFUSAL_FAULT_PERSISTS;
    motion->fault = 0;
    motion->banks->check_position = 0;
    if (keeps_place(motion)) {
        ctl_motion_stand(motion);
        return CTL_REFUSAL_NONE;
    }
    /* The axis keeps its position: the following error is cleared, homing finds the mark again. */
    motion->commanded = motion->actual;
    motion->in_phase = false;
    if (motion->banks->has_active)
        ctl_table_reset(&motion->table, ctl_active_bank(motion->banks));
    ctl_motion_stand(motion);
    return CTL_REFUSAL_NONE;
}

uint16_t ctl_motion_master_angle(const ctl_motion* motion)
{
    const ctl_table* table = &motion->table;
    if (!motion->banks->has_active)
        return 0;
    return (uint16_t)((uint64_t)ctl_table_position(table) * 36000u / ctl_bank_cycle_ticks(table->bank));
}

uint16_t ctl_motion_master_speed(const ctl_motion* motion)
{
    return motion->manual ? (uint16_t)0 : (uint16_t)ctl_ramp_share(&motion->ramp, 10000u);
}

int64_t ctl_motion_commanded_hz(const ctl_motion* motion)
{
    if (ctl_motion_is_press(motion) && ctl_motion_in_cycle(motion))
        return ctl_press_hz(&motion->press);
    if (motion->manual)
        return motion->manual_direction * (int64_t)ctl_ramp_share(&motion->ramp, motion->manual_hz);
    return ctl_motion_in_cycle(motion) ? ctl_table_hz(&motion->table, &motion->ramp) : 0;
}
