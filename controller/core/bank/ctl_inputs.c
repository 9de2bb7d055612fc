/* SPDX-License-Identifier: Apache-2.0 */
#include "bank/ctl_inputs.h"

#include "base/ctl_words.h"

#include <stddef.h>

#define US_PER_S 1000000u
#define NM_PER_UM 1000u
#define SLAVE_OFFSET 2u     /* in a knot or a segment */
#define FULL_CYCLE 3600000u /* 0.0001 degrees */

static uint32_t wide(const ctl_bank* bank, uint32_t offset)
{
    return ctl_get32(&bank->registers[offset]);
}

static int64_t signed_wide(const ctl_bank* bank, uint32_t offset)
{
    return (int32_t)wide(bank, offset);
}

/* A cycle turns the shaft from one knife to the next, by K Z / N pulses exactly: a knife that came short of
 * it would slip from bag to bag. */
static uint32_t wrong_cutter(const ctl_bank* bank, const ctl_config* config)
{
    (void)config;
    const uint64_t parts = (uint64_t)bank->registers[CTL_OFFSET_PROGRAM_KNIVES] *
                           bank->registers[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR];
    const uint64_t turn = (uint64_t)wide(bank, CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV) *
                          bank->registers[CTL_OFFSET_PROGRAM_GEAR_NUMERATOR];
    const bool is_one_knife = wide(bank, CTL_OFFSET_BANK_CYCLE_PULSES) == turn / parts &&
                              ctl_bank_remainder(bank) * parts == turn % parts * ctl_bank_divisor(bank);
    return is_one_knife ? CTL_NO_WRONG_INPUT : CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV;
}

static bool advances_by(const ctl_bank* bank, int64_t length_um)
{
    return ctl_bank_is_distance(bank, signed_wide(bank, CTL_OFFSET_BANK_ADVANCE), length_um);
}

/* The accumulators say how long intervals take, not their header. */
static bool takes_given_time(const ctl_bank* bank, const ctl_config* config, uint32_t duration, uint32_t time)
{
    if (ctl_bank_layout(bank) != CTL_TABLE_LAYOUT_CAM_POINTS ||
        bank->registers[duration] != CTL_MOVE_DURATION_GIVEN_TIME)
        return true;
    const uint64_t wanted = (uint64_t)wide(bank, time) * config->timer_clock_hz;
    const uint64_t taken = (uint64_t)ctl_bank_cycle_ticks(bank) * US_PER_S;
    return (taken > wanted ? taken - wanted : wanted - taken) <= US_PER_S;
}

static uint32_t wrong_position_move(const ctl_bank* bank, const ctl_config* config)
{
    if (!advances_by(bank, signed_wide(bank, CTL_OFFSET_POSITION_MOVE_DISTANCE)))
        return CTL_OFFSET_POSITION_MOVE_DISTANCE;
    return takes_given_time(bank, config, CTL_OFFSET_POSITION_MOVE_DURATION, CTL_OFFSET_POSITION_MOVE_TIME)
               ? CTL_NO_WRONG_INPUT
               : CTL_OFFSET_POSITION_MOVE_TIME;
}

/* A move that is never slower than one of its speeds and never faster than the other goes as far as one of
 * them at least, and as the other at most. */
static uint32_t wrong_speed_move(const ctl_bank* bank, const ctl_config* config)
{
    const int64_t cycle_ticks = ctl_bank_cycle_ticks(bank);
    const int64_t start_um =
        signed_wide(bank, CTL_OFFSET_SPEED_MOVE_START_SPEED) * cycle_ticks / config->timer_clock_hz;
    const int64_t end_um =
        signed_wide(bank, CTL_OFFSET_SPEED_MOVE_END_SPEED) * cycle_ticks / config->timer_clock_hz;
    const int64_t feed_um = wide(bank, CTL_OFFSET_SPEED_MOVE_FEED);
    const int64_t per_revolution = wide(bank, CTL_OFFSET_SPEED_MOVE_PULSES_PER_MOTOR_REV);
    const int64_t moved_um = signed_wide(bank, CTL_OFFSET_BANK_ADVANCE) * feed_um / per_revolution;
    const int64_t pulse_um = feed_um / per_revolution + 2;
    if (moved_um < (start_um < end_um ? start_um : end_um) - pulse_um)
        return CTL_OFFSET_SPEED_MOVE_START_SPEED;
    if (moved_um > (start_um < end_um ? end_um : start_um) + pulse_um)
        return CTL_OFFSET_SPEED_MOVE_END_SPEED;
    if (bank->registers[CTL_OFFSET_SPEED_MOVE_DURATION] == CTL_MOVE_DURATION_OVER_DISTANCE &&
        !advances_by(bank, signed_wide(bank, CTL_OFFSET_SPEED_MOVE_DISTANCE)))
        return CTL_OFFSET_SPEED_MOVE_DISTANCE;
    return takes_given_time(bank, config, CTL_OFFSET_SPEED_MOVE_DURATION, CTL_OFFSET_SPEED_MOVE_TIME)
               ? CTL_NO_WRONG_INPUT
               : CTL_OFFSET_SPEED_MOVE_TIME;
}

/* A cycle takes 60 s ratio scale / rate: 3 clock ratio scale = 5000 ticks rate in the registers' units. */
static uint32_t wrong_master(const ctl_bank* bank, const ctl_config* config)
{
    const int32_t rate = (int16_t)bank->registers[CTL_OFFSET_CAM_MASTER_RATE];
    const uint64_t per_tick = 5000u * (uint64_t)(rate < 0 ? -rate : rate);
    const uint64_t ratio = wide(bank, CTL_OFFSET_CAM_MASTER_RATIO);
    const uint64_t scale = wide(bank, CTL_OFFSET_CAM_MASTER_SCALE);
    const uint64_t per_ratio = 3u * (uint64_t)config->timer_clock_hz;
    const uint64_t taken = per_tick * ctl_bank_cycle_ticks(bank);
    if (per_tick == 0)
        return CTL_OFFSET_CAM_MASTER_RATE;
    if (scale != 0 && ratio > (taken + per_tick) / per_ratio / scale)
        return CTL_OFFSET_CAM_MASTER_RATIO;
    if (ratio * scale * per_ratio + per_tick < taken)
        return CTL_OFFSET_CAM_MASTER_RATIO;
    return CTL_NO_WRONG_INPUT;
}

/* A cycle advances by the net way of its curve, scaled. */
static uint32_t wrong_advance(const ctl_bank* bank, int64_t net_um)
{
    /* A pulse may be less than a micrometre. */
    const int64_t length_nm = net_um * signed_wide(bank, CTL_OFFSET_CAM_SLAVE_SCALE);
    const int64_t feed_nm = (int64_t)NM_PER_UM * wide(bank, CTL_OFFSET_CAM_FEED);
    const int64_t per_revolution = wide(bank, CTL_OFFSET_CAM_PULSES_PER_MOTOR_REV);
    const int64_t max_nm = INT64_MAX / 4 / per_revolution;
    const int64_t max_pulses = INT64_MAX / 4 / feed_nm;
    const int64_t pulses = signed_wide(bank, CTL_OFFSET_BANK_ADVANCE);
    if (length_nm > max_nm || length_nm < -max_nm || pulses > max_pulses || pulses < -max_pulses)
        return CTL_OFFSET_CAM_SLAVE_SCALE;
    const int64_t difference = pulses * feed_nm - length_nm * per_revolution;
    return difference <= feed_nm && -difference <= feed_nm ? CTL_NO_WRONG_INPUT : CTL_OFFSET_CAM_SLAVE_SCALE;
}

static uint32_t wrong_point_cam(const ctl_bank* bank, const ctl_config* config)
{
    const uint32_t wrong = wrong_master(bank, config);
    const uint32_t knots = ctl_bank_list_count(bank);
    if (wrong != CTL_NO_WRONG_INPUT || knots < 2)
        return wrong;
    const uint32_t first = ctl_bank_list_offset(bank) + SLAVE_OFFSET;
    return wrong_advance(bank, signed_wide(bank, first + (knots - 1u) * CTL_KNOT_REGISTERS) -
                                   signed_wide(bank, first));
}

/* Segments follow each other to the end of the cycle; the last one ends where the cycle does. */
static uint32_t wrong_segment_cam(const ctl_bank* bank, const ctl_config* config)
{
    const uint32_t wrong = wrong_master(bank, config);
    if (wrong != CTL_NO_WRONG_INPUT)
        return wrong;
    uint32_t offset = ctl_bank_list_offset(bank);
    uint32_t last_end = 0;
    int64_t net_um = 0;
    for (uint32_t i = 0; i < ctl_bank_list_count(bank); ++i) {
        if (wide(bank, offset) <= last_end)
            return CTL_OFFSET_CAM_SEGMENT_COUNT;
        last_end = wide(bank, offset);
        net_um = signed_wide(bank, offset + SLAVE_OFFSET);
        offset += CTL_SEGMENT_REGISTERS;
    }
    return last_end == FULL_CYCLE ? wrong_advance(bank, net_um) : CTL_OFFSET_CAM_SEGMENT_COUNT;
}

static uint32_t nothing_wrong(const ctl_bank* bank, const ctl_config* config)
{
    (void)bank;
    (void)config;
    return CTL_NO_WRONG_INPUT;
}

typedef uint32_t (*input_check)(const ctl_bank* bank, const ctl_config* config);

static const input_check checks[] = {
    [CTL_PROGRAM_KIND_NONE] = nothing_wrong,
    [CTL_PROGRAM_KIND_ROTARY_CUTTER] = wrong_cutter,
    [CTL_PROGRAM_KIND_POSITION_MOVE] = wrong_position_move,
    [CTL_PROGRAM_KIND_SPEED_MOVE] = wrong_speed_move,
    [CTL_PROGRAM_KIND_POINT_CAM] = wrong_point_cam,
    [CTL_PROGRAM_KIND_PRESS] = nothing_wrong,
    [CTL_PROGRAM_KIND_SEGMENT_CAM] = wrong_segment_cam,
};

_Static_assert(sizeof checks / sizeof checks[0] == CTL_PROGRAM_KIND_LAST + 1u, "every kind has its check");

uint32_t ctl_wrong_input(const ctl_bank* bank, const ctl_config* config)
{
    const uint32_t kind = ctl_bank_kind(bank);
    return checks[kind <= CTL_PROGRAM_KIND_LAST ? kind : CTL_PROGRAM_KIND_NONE](bank, config);
}
