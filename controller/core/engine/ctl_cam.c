/* SPDX-License-Identifier: Apache-2.0 */
#include "engine/ctl_cam.h"

#include "base/ctl_words.h"

#define US_PER_S 1000000u
#define UNITS_PER_PULSE CTL_TRAIN_FINE
/* Bits of the way through an interval. */
#define WAY_BITS 24u
/* Bits of a unit in the arithmetic of the cubic: 2^30 units of a row keep it inside 64 bits. */
#define FRACTION_BITS 4u
#define LARGEST_STEP ((int64_t)1 << 30)
/* Keeps slope * intervals * ticks inside 64 bits. */
#define MAX_HELD_TICKS ((uint32_t)1 << 20)

typedef struct {
    int64_t position; /* 1/256 pulse from the first row */
    int64_t slope;    /* 1/256 pulse per interval */
} cam_row;

/* The lower 32 bits of a two's complement, as a number. */
static int64_t signed32(const uint16_t* registers)
{
    const int64_t value = ctl_get32(registers);
    return value > INT32_MAX ? value - ((int64_t)1 << 32) : value;
}

static cam_row row_at(const ctl_bank* bank, uint32_t index)
{
    const uint16_t* registers = ctl_bank_row_at(bank, index, CTL_CAM_POINT_REGISTERS);
    const cam_row row = {signed32(registers), signed32(&registers[2])};
    return row;
}

static int64_t magnitude(int64_t value)
{
    return value < 0 ? -value : value;
}

/* Rounded down, also below zero; the divisor is above zero. */
static int64_t floor_divide(int64_t value, int64_t divisor)
{
    const int64_t quotient = value / divisor;
    return value % divisor < 0 ? quotient - 1 : quotient;
}

static uint64_t update_ticks(const ctl_config* config)
{
    return (uint64_t)config->timer_clock_hz * CTL_CAM_UPDATE_US / US_PER_S;
}

static uint32_t bad_header_offset(const ctl_bank* bank, const ctl_config* config)
{
    const uint16_t* header = bank->registers;
    const uint32_t bad_cycle = ctl_bank_bad_cycle(bank, config);
    if (bad_cycle != CTL_BANK_HEADER_REGISTERS)
        return bad_cycle;
    if (header[CTL_OFFSET_BANK_END_BEHAVIOR] > CTL_END_BEHAVIOR_HOLD_SPEED)
        return CTL_OFFSET_BANK_END_BEHAVIOR;
    if (header[CTL_OFFSET_CAM_RAMP_SHAPE] > CTL_RAMP_SHAPE_SCURVE)
        return CTL_OFFSET_CAM_RAMP_SHAPE;
    const ctl_bank_list list = ctl_bank_list_of(bank);
    if (ctl_bank_list_count(bank) > list.capacity)
        return list.count;
    return CTL_BANK_HEADER_REGISTERS;
}

static int64_t advance_units(const ctl_bank* bank)
{
    return signed32(&bank->registers[CTL_OFFSET_BANK_ADVANCE]) * UNITS_PER_PULSE;
}

/* Most units that the output stage gives in one interval, and one for the rounding of the rows. */
static int64_t max_per_interval(const ctl_bank* bank, const ctl_config* config)
{
    const uint64_t intervals = ctl_bank_row_count(bank) - 1u;
    const uint64_t max_units = (uint64_t)UNITS_PER_PULSE * config->max_pulse_hz * ctl_bank_cycle_ticks(bank) /
                               (intervals * config->timer_clock_hz);
    return max_units < (uint64_t)LARGEST_STEP ? (int64_t)max_units + 1 : LARGEST_STEP;
}

ctl_verdict ctl_cam_check(const ctl_bank* bank, const ctl_config* config, ctl_row_check* check, uint32_t rows)
{
    const uint32_t bad_offset = check->row == 0 ? bad_header_offset(bank, config) : CTL_BANK_HEADER_REGISTERS;
    if (bad_offset != CTL_BANK_HEADER_REGISTERS)
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_HEADER, bad_offset);

    const uint32_t count = ctl_bank_row_count(bank);
    const int64_t max_step = max_per_interval(bank, config);
    for (uint32_t i = 0; i < rows && check->row < count; ++i, ++check->row) {
        const cam_row row = row_at(bank, check->row);
        const bool first_is_zero = check->row != 0 || row.position == 0;
        if (!first_is_zero || magnitude(row.slope) > max_step ||
            magnitude(row.position - check->last) > max_step)
            return ctl_refuse(CTL_TRANSFER_RESULT_BAD_ROW, check->row);
        check->last = row.position;
    }
    if (check->row < count)
        return ctl_refuse(CTL_TRANSFER_RESULT_BUSY, 0);
    const uint64_t fraction = (uint64_t)UNITS_PER_PULSE * ctl_bank_remainder(bank) / ctl_bank_divisor(bank);
    if (magnitude(check->last - advance_units(bank) - (int64_t)fraction) > 1)
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_SUM, CTL_OFFSET_BANK_ADVANCE);
    return ctl_refuse(CTL_TRANSFER_RESULT_ACCEPTED, 0);
}

int64_t ctl_cam_boundary_hz(const ctl_bank* bank, const ctl_config* config, bool end)
{
    const uint32_t intervals = ctl_bank_row_count(bank) - 1u;
    const int64_t slope = row_at(bank, end ? intervals : 0u).slope;
    return slope * (int64_t)intervals / UNITS_PER_PULSE * (int64_t)config->timer_clock_hz /
           (int64_t)ctl_bank_cycle_ticks(bank);
}

static void take_bank(ctl_cam* cam, const ctl_bank* bank)
{
    cam->bank = bank;
    cam->intervals = ctl_bank_row_count(bank) - 1u;
    cam->cycle_ticks = ctl_bank_cycle_ticks(bank);
    cam->position = 0;
    cam->in_cycle = false;
    cam->holding = false;
}

void ctl_cam_reset(ctl_cam* cam, const ctl_bank* bank, const ctl_config* config)
{
    take_bank(cam, bank);
    cam->update_ticks = (uint32_t)update_ticks(config);
    cam->base = 0;
    cam->owed = 0;
    cam->hold_rest = 0;
    cam->line_from = 0;
    cam->line_to = 0;
    cam->line_ticks = 0;
    cam->sent = 0;
    cam->train = ctl_train_line(0, 0, cam->update_ticks);
}

void ctl_cam_change_bank(ctl_cam* cam, const ctl_bank* bank)
{
    cam->owed = cam->owed * ctl_bank_divisor(bank) / ctl_bank_divisor(cam->bank);
    take_bank(cam, bank);
}

/* To the start of the next cycle, or back (-1) to that of the one before. */
static void move_base(ctl_cam* cam, int32_t direction)
{
    const uint64_t divisor = ctl_bank_divisor(cam->bank);
    const uint64_t fraction = (uint64_t)UNITS_PER_PULSE * ctl_bank_remainder(cam->bank);
    const int64_t whole = advance_units(cam->bank) + (int64_t)(fraction / divisor);
    cam->base += direction * whole;
    cam->owed += direction > 0 ? fraction % divisor : divisor - fraction % divisor;
    if (direction < 0)
        cam->base -= 1;
    if (cam->owed >= divisor) {
        cam->owed -= divisor;
        cam->base += 1;
    }
}

void ctl_cam_begin_cycle(ctl_cam* cam, int32_t direction)
{
    cam->in_cycle = true;
    cam->position = 0;
    if (direction < 0) {
        move_base(cam, -1);
        cam->position = cam->cycle_ticks;
    }
}

static void hold(ctl_cam* cam, uint32_t ticks)
{
    const int64_t per_tick = row_at(cam->bank, cam->intervals).slope * (int64_t)cam->intervals;
    while (ticks != 0) {
        const uint32_t part = ticks < MAX_HELD_TICKS ? ticks : MAX_HELD_TICKS;
        const int64_t sum = per_tick * part + (int64_t)cam->hold_rest;
        const int64_t units = floor_divide(sum, cam->cycle_ticks);
        cam->hold_rest = (uint64_t)(sum - units * cam->cycle_ticks);
        cam->base += units;
        ticks -= part;
    }
}

static void end_cycle(ctl_cam* cam, int32_t direction)
{
    if (direction > 0)
        move_base(cam, 1);
    if (direction > 0 && ctl_bank_at_end(cam->bank) == CTL_END_BEHAVIOR_HOLD_SPEED) {
        cam->holding = true;
        cam->hold_rest = 0;
        cam->position = cam->cycle_ticks;
    } else {
        cam->in_cycle = false;
        cam->position = 0;
    }
}

void ctl_cam_advance(ctl_cam* cam, int32_t direction, uint32_t* ticks)
{
    if (cam->holding) {
        hold(cam, *ticks);
        return;
    }
    const uint64_t left = direction > 0 ? cam->cycle_ticks - cam->position : cam->position;
    if (*ticks < left) {
        cam->position = direction > 0 ? cam->position + *ticks : cam->position - *ticks;
        return;
    }
    *ticks = (uint32_t)left;
    end_cycle(cam, direction);
}

/* Times the way through the interval. */
static int64_t times_way(int64_t value, int64_t way)
{
    return floor_divide(value * way, (int64_t)1 << WAY_BITS);
}

int64_t ctl_cam_target(const ctl_cam* cam)
{
    if (!cam->in_cycle || cam->holding)
        return cam->base;
    const uint64_t scaled = cam->position * cam->intervals;
    const uint32_t interval = (uint32_t)(scaled / cam->cycle_ticks);
    const cam_row from = row_at(cam->bank, interval);
    if (interval == cam->intervals)
        return cam->base + from.position;
    const cam_row to = row_at(cam->bank, interval + 1u);
    const int64_t way = (int64_t)((scaled % cam->cycle_ticks << WAY_BITS) / cam->cycle_ticks);
    const int64_t fraction = (int64_t)1 << FRACTION_BITS;
    const int64_t step = (to.position - from.position) * fraction;
    const int64_t slope = from.slope * fraction;
    const int64_t end_slope = to.slope * fraction;
    /* Hermite's cubic: slope u + (3 step - 2 slope - end) u^2 + (slope + end - 2 step) u^3. */
    int64_t sum = times_way(slope + end_slope - 2 * step, way);
    sum = times_way(3 * step - 2 * slope - end_slope + sum, way);
    sum = times_way(slope + sum, way);
    return cam->base + from.position + floor_divide(sum + fraction / 2, fraction);
}

uint32_t ctl_cam_until_update(const ctl_cam* cam)
{
    return cam->update_ticks - cam->line_ticks;
}

int64_t ctl_cam_pass(ctl_cam* cam, uint32_t ticks, const ctl_pace* pace)
{
    const uint32_t before = cam->line_ticks;
    cam->line_ticks += ticks;
    const bool ends = cam->line_ticks == cam->update_ticks;
    ctl_train train = ends ? cam->train : ctl_train_until(&cam->train, cam->line_ticks);
    const int64_t pulses = train.direction * (int64_t)train.count;
    train.tick -= before;
    ctl_pace_give(pace, &train);
    cam->sent += pulses;
    if (ends) {
        cam->line_ticks = 0;
        cam->line_from = cam->line_to;
        cam->line_to = ctl_cam_target(cam);
        cam->train = ctl_train_line(cam->line_from + UNITS_PER_PULSE / 2, cam->line_to + UNITS_PER_PULSE / 2,
                                    cam->update_ticks);
    }
    return pulses;
}

bool ctl_cam_settled(const ctl_cam* cam)
{
    return cam->line_from == cam->line_to && cam->line_to == ctl_cam_target(cam);
}

bool ctl_cam_too_fast(const ctl_cam* cam, const ctl_config* config)
{
    const uint64_t max_units =
        (uint64_t)UNITS_PER_PULSE * config->max_pulse_hz * CTL_CAM_UPDATE_US / US_PER_S;
    return magnitude(cam->line_to - cam->line_from) > (int64_t)max_units + UNITS_PER_PULSE;
}

int64_t ctl_cam_hz(const ctl_cam* cam, const ctl_config* config)
{
    return (cam->line_to - cam->line_from) * (int64_t)config->timer_clock_hz /
           ((int64_t)UNITS_PER_PULSE * cam->update_ticks);
}
