/* SPDX-License-Identifier: Apache-2.0 */
/* One program of each kind and layout, at 8 MHz and at most 200 kHz, computed in whole numbers. */
#include "base/ctl_words.h"
#include "bench.h"

#include <string.h>

#define CYCLE_TICKS 1600000u /* 0.2 s: 300 a minute */
#define TURN_PULSES 10000u
#define FINE 256
#define FEED_UM 100000u
/* Counts a second of an encoder with 10 000, at the programs' rates: 250 mm each 0.2 s, and 60 r/min. */
#define CUTTER_COUNTS 50000u
#define CAM_COUNTS 10000u
#define FULL_CYCLE 3600000u /* 0.0001 degrees */

static void wide(uint16_t* registers, uint32_t offset, uint32_t value)
{
    ctl_put32(&registers[offset], value);
}

static void begin(uint16_t* registers, uint16_t layout, uint16_t kind, uint32_t rows)
{
    memset(registers, 0, sizeof(ctl_bank));
    registers[CTL_OFFSET_BANK_LAYOUT] = layout;
    registers[CTL_OFFSET_BANK_KIND] = kind;
    registers[CTL_OFFSET_BANK_ROW_COUNT] = (uint16_t)rows;
    wide(registers, CTL_OFFSET_BANK_CYCLE_TICKS, CYCLE_TICKS);
    wide(registers, CTL_OFFSET_BANK_DIVISOR, 1);
}

/* Bags of 250 mm by a full table: even rows, a third of a pulse left over. */
static uint32_t build_cutter(uint16_t* registers)
{
    const uint32_t rows = CTL_ROW_CAPACITY;
    begin(registers, CTL_TABLE_LAYOUT_STEP_TABLE, CTL_PROGRAM_KIND_ROTARY_CUTTER, rows);
    wide(registers, CTL_OFFSET_BANK_CYCLE_PULSES, TURN_PULSES / 3u);
    wide(registers, CTL_OFFSET_BANK_REMAINDER, TURN_PULSES % 3u);
    wide(registers, CTL_OFFSET_BANK_DIVISOR, 3);
    registers[CTL_OFFSET_BANK_CARRY_ROW] = 5;
    registers[CTL_OFFSET_BANK_CUT_ANGLE] = 18000;
    registers[CTL_OFFSET_BANK_SYNC_START] = 14400;
    registers[CTL_OFFSET_BANK_SYNC_END] = 21600;
    wide(registers, CTL_OFFSET_PROGRAM_KNIFE_RADIUS, 60000);
    registers[CTL_OFFSET_PROGRAM_KNIVES] = 3;
    wide(registers, CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV, TURN_PULSES);
    registers[CTL_OFFSET_PROGRAM_GEAR_NUMERATOR] = 1;
    registers[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR] = 1;
    wide(registers, CTL_OFFSET_PROGRAM_BAG_LENGTH, 250000);
    for (uint32_t i = 0; i < rows; ++i) {
        uint16_t* row = &registers[CTL_OFFSET_BANK_ROWS + CTL_ROW_REGISTERS * i];
        const uint32_t pulses = TURN_PULSES / 3u;
        row[0] = (uint16_t)(pulses * (i + 1u) / rows - pulses * i / rows);
        wide(row, 1, (uint32_t)((uint64_t)CYCLE_TICKS * (i + 1u) / rows - (uint64_t)CYCLE_TICKS * i / rows));
    }
    return ctl_bank_length((const ctl_bank*)registers);
}

/* Bags of 260 mm by the same table. */
static uint32_t build_other_cutter(uint16_t* registers)
{
    const uint32_t length = build_cutter(registers);
    wide(registers, CTL_OFFSET_PROGRAM_BAG_LENGTH, 260000);
    return length;
}

static void cam_row(uint16_t* registers, uint32_t index, int64_t position, int64_t slope)
{
    uint16_t* row = &registers[CTL_OFFSET_BANK_ROWS + CTL_CAM_POINT_REGISTERS * index];
    wide(row, 0, (uint32_t)position);
    wide(row, 2, (uint32_t)slope);
}

/* A turn in 0.2 s, smoothly from standstill to standstill: x^2 (3 - 2 x). */
static uint32_t build_position_move(uint16_t* registers)
{
    const int64_t n = 1 << 10;
    begin(registers, CTL_TABLE_LAYOUT_CAM_POINTS, CTL_PROGRAM_KIND_POSITION_MOVE, (uint32_t)n + 1u);
    wide(registers, CTL_OFFSET_BANK_ADVANCE, TURN_PULSES);
    registers[CTL_OFFSET_BANK_END_BEHAVIOR] = CTL_END_BEHAVIOR_STOP;
    registers[CTL_OFFSET_POSITION_MOVE_DURATION] = CTL_MOVE_DURATION_FASTEST;
    wide(registers, CTL_OFFSET_POSITION_MOVE_PULSES_PER_MOTOR_REV, TURN_PULSES);
    wide(registers, CTL_OFFSET_POSITION_MOVE_FEED, FEED_UM);
    wide(registers, CTL_OFFSET_POSITION_MOVE_DISTANCE, FEED_UM);
    for (int64_t i = 0; i <= n; ++i)
        cam_row(registers, (uint32_t)i, FINE * (int64_t)TURN_PULSES * i * i * (3 * n - 2 * i) / (n * n * n),
                FINE * (int64_t)TURN_PULSES * 6 * i * (n - i) / (n * n * n));
    return ctl_bank_length((const ctl_bank*)registers);
}

/* To 50 kHz in 0.2 s, held: position x^2 / 2. */
static uint32_t build_speed_move(uint16_t* registers)
{
    const int64_t n = 1 << 10;
    begin(registers, CTL_TABLE_LAYOUT_CAM_POINTS, CTL_PROGRAM_KIND_SPEED_MOVE, (uint32_t)n + 1u);
    wide(registers, CTL_OFFSET_BANK_ADVANCE, TURN_PULSES / 2u);
    registers[CTL_OFFSET_BANK_END_BEHAVIOR] = CTL_END_BEHAVIOR_HOLD_SPEED;
    registers[CTL_OFFSET_SPEED_MOVE_DURATION] = CTL_MOVE_DURATION_FASTEST;
    wide(registers, CTL_OFFSET_SPEED_MOVE_PULSES_PER_MOTOR_REV, TURN_PULSES);
    wide(registers, CTL_OFFSET_SPEED_MOVE_FEED, FEED_UM);
    wide(registers, CTL_OFFSET_SPEED_MOVE_END_SPEED, 5u * FEED_UM);
    for (int64_t i = 0; i <= n; ++i)
        cam_row(registers, (uint32_t)i, FINE * (int64_t)TURN_PULSES * i * i / (2 * n * n),
                FINE * (int64_t)TURN_PULSES * i / (n * n));
    return ctl_bank_length((const ctl_bank*)registers);
}

/* All of a cam's header but its list: a master of 60 r/min makes 0.2 turns, that is a cycle, in 0.2 s. */
static void begin_cam(uint16_t* registers, uint16_t kind)
{
    begin(registers, CTL_TABLE_LAYOUT_CAM_POINTS, kind, CTL_CAM_POINT_CAPACITY);
    wide(registers, CTL_OFFSET_BANK_ADVANCE, TURN_PULSES);
    registers[CTL_OFFSET_BANK_END_BEHAVIOR] = CTL_END_BEHAVIOR_REPEAT;
    registers[CTL_OFFSET_CAM_MASTER_RAMP] = 300;
    registers[CTL_OFFSET_CAM_RAMP_SHAPE] = CTL_RAMP_SHAPE_SCURVE;
    registers[CTL_OFFSET_CAM_MASTER_RATE] = 600;
    wide(registers, CTL_OFFSET_CAM_MASTER_RATIO, 200000);
    wide(registers, CTL_OFFSET_CAM_MASTER_SCALE, 1);
    wide(registers, CTL_OFFSET_CAM_SLAVE_SCALE, 1000);
    wide(registers, CTL_OFFSET_CAM_PULSES_PER_MOTOR_REV, TURN_PULSES);
    wide(registers, CTL_OFFSET_CAM_FEED, FEED_UM);
}

/* A turn in 0.2 s with 16 a x^2 (1 - x)^2 on top of it, by the most rows that there may be. */
static uint32_t build_point_cam(uint16_t* registers)
{
    const int64_t n = CTL_CAM_POINT_CAPACITY - 1;
    const int64_t top = 3000;
    begin_cam(registers, CTL_PROGRAM_KIND_POINT_CAM);
    for (int64_t i = 0; i <= n; ++i) {
        const int64_t bump = FINE * top * 16 * (i * i * (n - i) * (n - i) / n) / (n * n * n);
        const int64_t rise = FINE * top * 32 * i * (n - i) * (n - 2 * i) / (n * n * n * n);
        cam_row(registers, (uint32_t)i, FINE * (int64_t)TURN_PULSES * i / n + bump,
                FINE * (int64_t)TURN_PULSES / n + rise);
    }
    return ctl_bank_length((const ctl_bank*)registers);
}

/* A quarter at standstill, a turn by x^2 (3 - 2 x) in half of the cycle, a quarter at standstill: by the most
 * rows and the most segments, of which the controller executes the rows alone. */
static uint32_t build_segment_cam(uint16_t* registers)
{
    const int64_t n = CTL_CAM_POINT_CAPACITY - 1;
    const int64_t half = n / 2;
    begin_cam(registers, CTL_PROGRAM_KIND_SEGMENT_CAM);
    registers[CTL_OFFSET_CAM_SEGMENT_COUNT] = CTL_SEGMENT_CAPACITY;
    for (int64_t i = 0; i <= n; ++i) {
        const int64_t at = i < half / 2 ? 0 : i > n - half / 2 ? half : i - half / 2;
        cam_row(registers, (uint32_t)i,
                FINE * (int64_t)TURN_PULSES * at * at * (3 * half - 2 * at) / (half * half * half),
                FINE * (int64_t)TURN_PULSES * 6 * at * (half - at) / (half * half * half));
    }
    uint32_t offset = ctl_bank_list_offset((const ctl_bank*)registers);
    for (uint32_t i = 1; i <= CTL_SEGMENT_CAPACITY; ++i) {
        wide(registers, offset, FULL_CYCLE / CTL_SEGMENT_CAPACITY * i);
        wide(registers, offset + 2u, FEED_UM / CTL_SEGMENT_CAPACITY * i);
        offset += CTL_SEGMENT_REGISTERS;
    }
    return ctl_bank_length((const ctl_bank*)registers);
}

/* Many short intervals, each faster than the one before up to the middle: two or three of them in a slice. */
static uint32_t build_intervals(uint16_t* registers)
{
    const uint32_t rows = CTL_INTERVAL_CAPACITY;
    const uint32_t unit = 258; /* 256 x 1.00663296: the generator's clock */
    begin(registers, CTL_TABLE_LAYOUT_INTERVALS, CTL_PROGRAM_KIND_POSITION_MOVE, rows);
    wide(registers, CTL_OFFSET_BANK_ADVANCE, 10u * rows);
    wide(registers, CTL_OFFSET_BANK_CYCLE_TICKS, 4u * CYCLE_TICKS);
    registers[CTL_OFFSET_BANK_END_BEHAVIOR] = CTL_END_BEHAVIOR_STOP;
    registers[CTL_OFFSET_INTERVAL_FRACTION_BITS] = 8;
    registers[CTL_OFFSET_POSITION_MOVE_DURATION] = CTL_MOVE_DURATION_FASTEST;
    wide(registers, CTL_OFFSET_POSITION_MOVE_PULSES_PER_MOTOR_REV, TURN_PULSES);
    wide(registers, CTL_OFFSET_POSITION_MOVE_FEED, FEED_UM);
    wide(registers, CTL_OFFSET_POSITION_MOVE_DISTANCE, 10u * rows * (FEED_UM / TURN_PULSES));
    for (uint32_t i = 0; i < rows; ++i) {
        const uint32_t from_end = i < rows / 2u ? i : rows - i;
        const uint32_t to_end = i < rows / 2u ? i + 1u : rows - 1u - i;
        const uint64_t first = (1000u + 100u * from_end) * (uint64_t)unit;
        const uint64_t last = (1000u + 100u * to_end) * (uint64_t)unit;
        const uint64_t squares = first > last ? first * first - last * last : last * last - first * first;
        uint16_t* row = &registers[CTL_OFFSET_BANK_ROWS + CTL_INTERVAL_REGISTERS * i];
        wide(row, 0, 10);
        wide(row, 2, (uint32_t)first);
        wide(row, 4, (uint32_t)last);
        wide(row, 6, (uint32_t)(squares / (2u * 256u * 10u) + 1u));
    }
    return ctl_bank_length((const ctl_bank*)registers);
}

static uint32_t build_press(uint16_t* registers)
{
    /* pulses/s, pulses, N, ms: 80 mm/s to 60 mm, 4 mm/s until 200 N, 10 mm/s to 100 mm, 0.1 s, 80 mm/s up. */
    static const uint32_t stages[CTL_STAGE_COUNT][4] = {{8000, 6000, 200, 20},
                                                        {400, 9000, 200, 5},
                                                        {1000, 10000, 8000, 5},
                                                        {0, 10000, 8000, 100},
                                                        {8000, 0, 8000, 20}};
    begin(registers, CTL_TABLE_LAYOUT_PRESS_STAGES, CTL_PROGRAM_KIND_PRESS, CTL_STAGE_COUNT);
    wide(registers, CTL_OFFSET_BANK_CYCLE_TICKS, 80000000);
    registers[CTL_OFFSET_PRESS_POSITION_TOLERANCE] = 20;
    registers[CTL_OFFSET_PRESS_MIN_STOP_FORCE] = 1000;
    registers[CTL_OFFSET_PRESS_MAX_STOP_FORCE] = 6000;
    wide(registers, CTL_OFFSET_PRESS_APPROACH_POSITION, 60000);
    wide(registers, CTL_OFFSET_PRESS_PROBE_END, 90000);
    wide(registers, CTL_OFFSET_PRESS_PRESS_POSITION, 100000);
    wide(registers, CTL_OFFSET_PRESS_FEED, FEED_UM);
    wide(registers, CTL_OFFSET_PRESS_PULSES_PER_MOTOR_REV, TURN_PULSES);
    for (uint32_t stage = 0; stage < CTL_STAGE_COUNT; ++stage) {
        for (uint32_t i = 0; i < 4u; ++i)
            wide(registers, CTL_OFFSET_BANK_ROWS + CTL_STAGE_REGISTERS * stage + 2u * i, stages[stage][i]);
    }
    return ctl_bank_length((const ctl_bank*)registers);
}

const bench_case bench_cases[] = {
    {"cutter", CTL_PROGRAM_KIND_ROTARY_CUTTER, build_cutter, 0, false},
    {"cutter_on_shaft", CTL_PROGRAM_KIND_ROTARY_CUTTER, build_cutter, CUTTER_COUNTS, false},
    {"cutter_on_wheel", CTL_PROGRAM_KIND_ROTARY_CUTTER, build_cutter, CUTTER_COUNTS, true},
    {"position_move", CTL_PROGRAM_KIND_POSITION_MOVE, build_position_move, 0, false},
    {"speed_move", CTL_PROGRAM_KIND_SPEED_MOVE, build_speed_move, 0, false},
    {"point_cam", CTL_PROGRAM_KIND_POINT_CAM, build_point_cam, 0, false},
    {"point_cam_on_shaft", CTL_PROGRAM_KIND_POINT_CAM, build_point_cam, CAM_COUNTS, false},
    {"segment_cam", CTL_PROGRAM_KIND_SEGMENT_CAM, build_segment_cam, 0, false},
    {"press", CTL_PROGRAM_KIND_PRESS, build_press, 0, false},
    {"intervals", CTL_PROGRAM_KIND_POSITION_MOVE, build_intervals, 0, false},
};
const bench_case bench_other_cutter = {"other_cutter", CTL_PROGRAM_KIND_ROTARY_CUTTER, build_other_cutter, 0,
                                       false};
const uint32_t bench_case_count = sizeof bench_cases / sizeof bench_cases[0];
