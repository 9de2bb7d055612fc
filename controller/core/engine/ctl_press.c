/* SPDX-License-Identifier: Apache-2.0 */
/* The stroke; what a bank must fulfil is in ctl_press_check.c. */
#include "engine/ctl_press.h"

#include "base/ctl_words.h"

#define US_PER_MS 1000u

ctl_press_row ctl_press_row_of(const ctl_bank* bank, uint32_t index)
{
    const uint16_t* at = &bank->registers[CTL_OFFSET_BANK_ROWS + CTL_STAGE_REGISTERS * index];
    const ctl_press_row row = {ctl_get32(&at[0]), (int32_t)ctl_get32(&at[2]), ctl_get32(&at[4]),
                               ctl_get32(&at[6])};
    return row;
}

static ctl_press_row row_of(const ctl_press* press, uint32_t index)
{
    return ctl_press_row_of(press->bank, index);
}

void ctl_press_reset(ctl_press* press)
{
    static const ctl_press nothing = {.fault = CTL_PRESS_NO_FAULT, .direction = 1};
    *press = nothing;
    ctl_count_clear(&press->count);
}

/* The nearest number of whole pulses. */
static int64_t whole_pulses(int64_t fine)
{
    const int64_t half = CTL_PRESS_FINE / 2;
    return (fine < 0 ? fine - half : fine + half) / CTL_PRESS_FINE;
}

/* Begins a run to `end` when the ram is short of it; false when it is there or was sent often enough. */
static bool go_on(ctl_press* press, uint32_t index, int64_t position)
{
    const ctl_press_row row = row_of(press, index);
    const ctl_count_speed speed = {press->clock_hz, row.frequency_hz, row.time_ms};
    const int32_t direction = index == CTL_PRESS_RETURN ? -1 : 1;
    const int64_t left = direction * whole_pulses((int64_t)row.end * CTL_PRESS_FINE - position);
    if (left <= 0 || press->runs > CTL_PRESS_ADDITIONS)
        return false;
    press->runs += 1;
    press->direction = direction;
    press->resting = false;
    ctl_count_start(&press->count, speed, left > UINT32_MAX / 2u ? UINT32_MAX / 2u : (uint32_t)left);
    return true;
}

static void enter(ctl_press* press, uint16_t stage)
{
    press->stage = stage;
    press->runs = 0;
}

static void end_stroke(ctl_press* press)
{
    const bool pressed = press->measured && press->stage == CTL_PRESS_STAGE_RETURN;
    if (press->stopped && press->fault == CTL_PRESS_NO_FAULT && !pressed)
        press->now.result = CTL_STROKE_RESULT_STOPPED;
    press->last = press->now;
    press->stage = CTL_PRESS_STAGE_STANDING;
}

void ctl_press_begin(ctl_press* press, const ctl_bank* bank, uint32_t clock_hz,
                     const ctl_press_reading* reading)
{
    const ctl_stroke last = press->last;
    ctl_press_reset(press);
    press->last = last;
    press->bank = bank;
    press->clock_hz = clock_hz;
    press->lifting = whole_pulses(reading->position) > row_of(press, CTL_PRESS_RETURN).end;
    enter(press, press->lifting ? CTL_PRESS_STAGE_RETURN : CTL_PRESS_STAGE_APPROACH);
}

/* No more pulses down: up again from where it comes to stand, then the fault. */
static void break_off(ctl_press* press, uint16_t result, uint16_t fault)
{
    ctl_count_halt(&press->count);
    press->now.result = result;
    press->fault = fault;
    enter(press, CTL_PRESS_STAGE_RETURN);
}

static void watch_force(ctl_press* press, int32_t force)
{
    if (force > press->now.peak)
        press->now.peak = force;
    if (force < 0)
        return;
    const uint32_t pushed = (uint32_t)force;
    if (pushed >= row_of(press, CTL_PRESS_PRESS).force) {
        if (press->stage != CTL_PRESS_STAGE_RETURN) {
            break_off(press, CTL_STROKE_RESULT_FORCE_LIMIT, CTL_FAULT_BIT_FORCE_LIMIT);
        } else if (!press->lifting) { /* on its way up already */
            press->now.result = CTL_STROKE_RESULT_FORCE_LIMIT;
            press->fault = CTL_FAULT_BIT_FORCE_LIMIT;
        }
    } else if (press->stage == CTL_PRESS_STAGE_APPROACH) {
        if (pushed >= row_of(press, CTL_PRESS_APPROACH).force)
            break_off(press, CTL_STROKE_RESULT_TOUCHED_TOO_EARLY, CTL_FAULT_BIT_TOUCHED_TOO_EARLY);
    } else if (press->stage == CTL_PRESS_STAGE_PROBE && !press->felt &&
               pushed >= row_of(press, CTL_PRESS_PROBE).force) {
        press->felt = true;
        ctl_count_halt(&press->count);
    }
}

/* The ram has come to stand since the last pulse. */
static bool at_rest(ctl_press* press, const ctl_press_reading* reading)
{
    if (!reading->fresh)
        return false;
    const int64_t moved = reading->position - press->rest_position;
    if (!press->resting || moved > CTL_PRESS_FINE || moved < -CTL_PRESS_FINE) {
        press->resting = true;
        press->rest_position = reading->position;
        press->rest_since_us = reading->now_us;
    }
    return reading->now_us - press->rest_since_us >= CTL_PRESS_REST_US;
}

/* The header's window of the stop, in the units of the scale: error * feed against tolerance * K. */
static uint16_t judge(const ctl_press* press)
{
    const uint16_t* header = press->bank->registers;
    const uint64_t error = (uint64_t)(press->now.error < 0 ? -press->now.error : press->now.error);
    const uint64_t allowed = (uint64_t)header[CTL_OFFSET_PRESS_POSITION_TOLERANCE] *
                             ctl_get32(&header[CTL_OFFSET_PRESS_PULSES_PER_MOTOR_REV]);
    if (error > allowed / ctl_get32(&header[CTL_OFFSET_PRESS_FEED]))
        return CTL_STROKE_RESULT_POSITION_OUTSIDE;
    if (press->now.force < header[CTL_OFFSET_PRESS_MIN_STOP_FORCE])
        return CTL_STROKE_RESULT_FORCE_TOO_LOW;
    if (press->now.force > header[CTL_OFFSET_PRESS_MAX_STOP_FORCE])
        return CTL_STROKE_RESULT_FORCE_TOO_HIGH;
    return CTL_STROKE_RESULT_OK;
}

static void hold(ctl_press* press, const ctl_press_reading* reading)
{
    if (!press->measured) {
        press->measured = true;
        press->now.error =
            whole_pulses(reading->position - (int64_t)row_of(press, CTL_PRESS_PRESS).end * CTL_PRESS_FINE);
        press->now.force = reading->force;
        press->now.result = judge(press);
    }
    const uint64_t hold_us = (uint64_t)row_of(press, CTL_PRESS_HOLD).time_ms * US_PER_MS;
    if (reading->now_us - press->hold_since_us < hold_us)
        return;
    enter(press, CTL_PRESS_STAGE_RETURN);
    (void)go_on(press, CTL_PRESS_RETURN, reading->position);
}

static void end_probe(ctl_press* press, const ctl_press_reading* reading)
{
    if (press->felt) {
        enter(press, CTL_PRESS_STAGE_PRESS);
        (void)go_on(press, CTL_PRESS_PRESS, reading->position);
    } else if (!go_on(press, CTL_PRESS_PROBE, reading->position)) {
        break_off(press, CTL_STROKE_RESULT_NEVER_TOUCHED, CTL_FAULT_BIT_NEVER_TOUCHED);
    }
}

static void end_return(ctl_press* press, const ctl_press_reading* reading)
{
    if (go_on(press, CTL_PRESS_RETURN, reading->position))
        return;
    if (!press->lifting) {
        end_stroke(press);
        return;
    }
    press->lifting = false;
    enter(press, CTL_PRESS_STAGE_APPROACH);
    (void)go_on(press, CTL_PRESS_APPROACH, reading->position);
}

/* The ram stands after all pulses of the run: what comes next? */
static void end_run(ctl_press* press, const ctl_press_reading* reading)
{
    if (press->stopped) {
        end_stroke(press);
        return;
    }
    switch (press->stage) {
    case CTL_PRESS_STAGE_APPROACH:
        if (go_on(press, CTL_PRESS_APPROACH, reading->position))
            return;
        enter(press, CTL_PRESS_STAGE_PROBE);
        (void)go_on(press, CTL_PRESS_PROBE, reading->position);
        break;
    case CTL_PRESS_STAGE_PROBE:
        end_probe(press, reading);
        break;
    case CTL_PRESS_STAGE_HOLD:
        hold(press, reading);
        break;
    default:
        end_return(press, reading);
        break;
    }
}

int32_t ctl_press_slice(ctl_press* press, const ctl_press_reading* reading, uint32_t ticks,
                        const ctl_pace* pace)
{
    if (press->stage == CTL_PRESS_STAGE_STANDING)
        return 0;
    watch_force(press, reading->force);
    if (!ctl_count_done(&press->count))
        press->resting = false;
    else if (at_rest(press, reading))
        end_run(press, reading);
    if (press->stage == CTL_PRESS_STAGE_STANDING)
        return 0;
    const int32_t pulses =
        press->direction * (int32_t)ctl_count_advance(&press->count, ticks, press->direction, pace);
    if (press->stage == CTL_PRESS_STAGE_PRESS && ctl_count_done(&press->count) && !press->stopped) {
        enter(press, CTL_PRESS_STAGE_HOLD);
        press->hold_since_us = reading->now_us;
    }
    return pulses;
}

void ctl_press_stop(ctl_press* press)
{
    press->stopped = true;
    ctl_count_brake(&press->count);
}

void ctl_press_abandon(ctl_press* press)
{
    press->stopped = true;
    ctl_count_halt(&press->count);
    end_stroke(press);
}

int64_t ctl_press_hz(const ctl_press* press)
{
    return press->direction * (int64_t)ctl_count_hz(&press->count);
}
