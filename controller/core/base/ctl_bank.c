/* SPDX-License-Identifier: Apache-2.0 */
#include "base/ctl_bank.h"

#include "base/ctl_crc.h"
#include "base/ctl_words.h"

#include <stddef.h>

/* Keeps every product of the angle arithmetic inside 64 bits. */
#define MAX_PULSES_PER_MOTOR_REV 10000000u
#define FULL_CIRCLE 36000u /* 0.01 degrees */
#define US_PER_S 1000000u
#define NOTHING_BAD CTL_BANK_HEADER_REGISTERS

/* The differences from layout to layout. */
typedef struct {
    uint16_t row_registers;
    uint16_t min_rows;
    uint16_t max_rows;
    uint16_t kinds; /* bit n: program kind n may have it */
} layout_info;

#define KIND(name) (1u << CTL_PROGRAM_KIND_##name)

static const layout_info layouts[] = {
    [CTL_TABLE_LAYOUT_STEP_TABLE] = {CTL_ROW_REGISTERS, 1, CTL_ROW_CAPACITY, KIND(ROTARY_CUTTER)},
    [CTL_TABLE_LAYOUT_CAM_POINTS] = {CTL_CAM_POINT_REGISTERS, 2, CTL_CAM_POINT_CAPACITY,
                                     KIND(POSITION_MOVE) | KIND(SPEED_MOVE) | KIND(POINT_CAM) |
                                         KIND(SEGMENT_CAM)},
    [CTL_TABLE_LAYOUT_INTERVALS] = {CTL_INTERVAL_REGISTERS, 1, CTL_INTERVAL_CAPACITY,
                                    KIND(POSITION_MOVE) | KIND(SPEED_MOVE)},
    [CTL_TABLE_LAYOUT_PRESS_STAGES] = {CTL_STAGE_REGISTERS, CTL_STAGE_COUNT, CTL_STAGE_COUNT, KIND(PRESS)},
};

#define FITS(rows) (CTL_BANK_HEADER_REGISTERS + (rows) <= CTL_BANK_REGISTERS)
_Static_assert(FITS(CTL_ROW_REGISTERS* CTL_ROW_CAPACITY), "the longest step table fits a bank");
_Static_assert(FITS(CTL_CAM_POINT_REGISTERS* CTL_CAM_POINT_CAPACITY + CTL_KNOT_REGISTERS * CTL_KNOT_CAPACITY),
               "the longest cam with its knots fits a bank");
_Static_assert(FITS(CTL_CAM_POINT_REGISTERS* CTL_CAM_POINT_CAPACITY +
                    CTL_SEGMENT_REGISTERS * CTL_SEGMENT_CAPACITY),
               "the longest cam with its segments fits a bank");
_Static_assert(FITS(CTL_INTERVAL_REGISTERS* CTL_INTERVAL_CAPACITY), "the most intervals fit a bank");
_Static_assert(FITS(CTL_STAGE_REGISTERS* CTL_STAGE_COUNT), "the stages of a press fit a bank");

#define LAYOUTS (sizeof layouts / sizeof layouts[0])
_Static_assert(LAYOUTS == CTL_TABLE_LAYOUT_LAST + 1u, "every layout has its row");
_Static_assert(CTL_BANK_STORAGE > CTL_BANK_HEADER_REGISTERS && CTL_BANK_STORAGE <= CTL_BANK_REGISTERS,
               "a smaller bank holds the header at least");

/* NULL when the layout cannot be executed. */
static const layout_info* layout_of(const ctl_bank* bank)
{
    const uint32_t layout = ctl_bank_layout(bank);
    return layout < LAYOUTS && layouts[layout].row_registers != 0 ? &layouts[layout] : NULL;
}

/* Where each kind keeps the data of its machine, and the list behind the rows of a cam. */
typedef struct {
    uint16_t pulses_per_motor_rev;
    uint16_t length; /* knife radius or feed */
    bool needs_homing;
    bool follows_master;
    ctl_bank_list list;
} kind_info;

#define CAM_LIST(name)                                                                                       \
    {                                                                                                        \
        CTL_OFFSET_CAM_##name##_COUNT, CTL_##name##_REGISTERS, CTL_##name##_CAPACITY                         \
    }
#define NO_LIST                                                                                              \
    {                                                                                                        \
        CTL_OFFSET_BANK_LAYOUT, 0, 0                                                                         \
    }

static const kind_info kinds[] = {
    [CTL_PROGRAM_KIND_ROTARY_CUTTER] = {CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV,
                                        CTL_OFFSET_PROGRAM_KNIFE_RADIUS, true, false, NO_LIST},
    [CTL_PROGRAM_KIND_POSITION_MOVE] = {CTL_OFFSET_POSITION_MOVE_PULSES_PER_MOTOR_REV,
                                        CTL_OFFSET_POSITION_MOVE_FEED, false, false, NO_LIST},
    [CTL_PROGRAM_KIND_SPEED_MOVE] = {CTL_OFFSET_SPEED_MOVE_PULSES_PER_MOTOR_REV, CTL_OFFSET_SPEED_MOVE_FEED,
                                     false, false, NO_LIST},
    [CTL_PROGRAM_KIND_POINT_CAM] = {CTL_OFFSET_CAM_PULSES_PER_MOTOR_REV, CTL_OFFSET_CAM_FEED, true, true,
                                    CAM_LIST(KNOT)},
    [CTL_PROGRAM_KIND_PRESS] = {CTL_OFFSET_PRESS_PULSES_PER_MOTOR_REV, CTL_OFFSET_PRESS_FEED, false, false,
                                NO_LIST},
    [CTL_PROGRAM_KIND_SEGMENT_CAM] = {CTL_OFFSET_CAM_PULSES_PER_MOTOR_REV, CTL_OFFSET_CAM_FEED, true, true,
                                      CAM_LIST(SEGMENT)},
};

_Static_assert(sizeof kinds / sizeof kinds[0] == CTL_PROGRAM_KIND_LAST + 1u, "every kind has its row");

/* A bank that was damaged after its check may name any kind. */
static const kind_info* kind_of(const ctl_bank* bank)
{
    const uint32_t kind = ctl_bank_kind(bank);
    return &kinds[kind <= CTL_PROGRAM_KIND_LAST ? kind : CTL_PROGRAM_KIND_NONE];
}

static uint32_t wide(const ctl_bank* bank, uint32_t offset)
{
    return ctl_get32(&bank->registers[offset]);
}

uint16_t ctl_bank_kind(const ctl_bank* bank)
{
    return bank->registers[CTL_OFFSET_BANK_KIND];
}

uint16_t ctl_bank_layout(const ctl_bank* bank)
{
    return bank->registers[CTL_OFFSET_BANK_LAYOUT];
}

uint16_t ctl_bank_at_end(const ctl_bank* bank)
{
    const uint16_t layout = ctl_bank_layout(bank);
    if (layout == CTL_TABLE_LAYOUT_CAM_POINTS || layout == CTL_TABLE_LAYOUT_INTERVALS)
        return bank->registers[CTL_OFFSET_BANK_END_BEHAVIOR];
    return CTL_END_BEHAVIOR_REPEAT;
}

static bool has_cam_points(const ctl_bank* bank)
{
    return ctl_bank_layout(bank) == CTL_TABLE_LAYOUT_CAM_POINTS;
}

uint16_t ctl_bank_master_ramp_ms(const ctl_bank* bank)
{
    return has_cam_points(bank) ? bank->registers[CTL_OFFSET_CAM_MASTER_RAMP] : (uint16_t)0;
}

uint16_t ctl_bank_ramp_shape(const ctl_bank* bank)
{
    return has_cam_points(bank) ? bank->registers[CTL_OFFSET_CAM_RAMP_SHAPE] : CTL_RAMP_SHAPE_TRAPEZOID;
}

bool ctl_bank_follows_master(const ctl_bank* bank)
{
    return kind_of(bank)->follows_master;
}

ctl_bank_list ctl_bank_list_of(const ctl_bank* bank)
{
    return kind_of(bank)->list;
}

uint32_t ctl_bank_list_count(const ctl_bank* bank)
{
    const ctl_bank_list list = kind_of(bank)->list;
    return list.registers == 0 ? 0u : bank->registers[list.count];
}

uint32_t ctl_bank_list_offset(const ctl_bank* bank)
{
    return CTL_BANK_HEADER_REGISTERS + CTL_CAM_POINT_REGISTERS * ctl_bank_row_count(bank);
}

int32_t ctl_bank_direction(const ctl_bank* bank)
{
    const bool turns_back =
        ctl_bank_follows_master(bank) && (bank->registers[CTL_OFFSET_CAM_MASTER_RATE] & 0x8000u) != 0;
    return turns_back ? -1 : 1;
}

uint32_t ctl_bank_row_count(const ctl_bank* bank)
{
    return bank->registers[CTL_OFFSET_BANK_ROW_COUNT];
}

uint32_t ctl_bank_length(const ctl_bank* bank)
{
    const layout_info* layout = layout_of(bank);
    uint32_t length = CTL_BANK_HEADER_REGISTERS;
    if (layout != NULL)
        length += layout->row_registers * ctl_bank_row_count(bank);
    return length + kind_of(bank)->list.registers * ctl_bank_list_count(bank);
}

uint32_t ctl_bank_crc(const ctl_bank* bank)
{
    return ~ctl_crc32_registers(CTL_CRC32_START, bank->registers, ctl_bank_length(bank));
}

uint32_t ctl_bank_cycle_ticks(const ctl_bank* bank)
{
    return wide(bank, CTL_OFFSET_BANK_CYCLE_TICKS);
}

uint32_t ctl_bank_bag_um(const ctl_bank* bank)
{
    return wide(bank, CTL_OFFSET_PROGRAM_BAG_LENGTH);
}

uint32_t ctl_bank_remainder(const ctl_bank* bank)
{
    return wide(bank, CTL_OFFSET_BANK_REMAINDER);
}

uint32_t ctl_bank_divisor(const ctl_bank* bank)
{
    return wide(bank, CTL_OFFSET_BANK_DIVISOR);
}

bool ctl_bank_needs_homing(const ctl_bank* bank)
{
    return kind_of(bank)->needs_homing;
}

static bool has_knife(const ctl_bank* bank)
{
    return ctl_bank_kind(bank) == CTL_PROGRAM_KIND_ROTARY_CUTTER;
}

static uint32_t gear(const ctl_bank* bank, uint32_t offset)
{
    return has_knife(bank) ? bank->registers[offset] : 1u;
}

/* Pulses from mark to mark, times the gear's denominator: a whole number. */
static uint64_t scaled_revolution(const ctl_bank* bank)
{
    return (uint64_t)wide(bank, kind_of(bank)->pulses_per_motor_rev) *
           gear(bank, CTL_OFFSET_PROGRAM_GEAR_NUMERATOR);
}

uint32_t ctl_bank_revolution_pulses(const ctl_bank* bank, uint32_t revolutions)
{
    const uint64_t pulses =
        scaled_revolution(bank) * revolutions / gear(bank, CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR);
    return pulses > UINT32_MAX ? UINT32_MAX : (uint32_t)pulses;
}

static int64_t rounded_down(int64_t value, int64_t by)
{
    return value / by - (value % by < 0 ? 1 : 0);
}

int64_t ctl_bank_nearest_turn(const ctl_bank* bank, int64_t position)
{
    const int64_t revolution = (int64_t)scaled_revolution(bank);
    const int64_t divisor = gear(bank, CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR);
    if (revolution == 0)
        return position;
    const int64_t turns = rounded_down(position * divisor + revolution / 2, revolution);
    return rounded_down(turns * revolution + divisor / 2, divisor);
}

uint16_t ctl_bank_knife_angle(const ctl_bank* bank, int64_t position)
{
    const int64_t revolution = (int64_t)scaled_revolution(bank);
    if (revolution == 0)
        return 0;
    int64_t rest = position % revolution * gear(bank, CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR) % revolution;
    if (rest < 0)
        rest += revolution;
    return (uint16_t)((uint64_t)rest * FULL_CIRCLE / (uint64_t)revolution);
}

bool ctl_bank_is_distance(const ctl_bank* bank, int64_t pulses, int64_t length_um)
{
    const uint64_t feed_um = wide(bank, kind_of(bank)->length);
    const uint64_t per_revolution = wide(bank, kind_of(bank)->pulses_per_motor_rev);
    const uint64_t moved = (uint64_t)(pulses < 0 ? -pulses : pulses) * feed_um;
    const uint64_t wanted = (uint64_t)(length_um < 0 ? -length_um : length_um) * per_revolution;
    const bool same_way = pulses == 0 || length_um == 0 || (pulses < 0) == (length_um < 0);
    return same_way ? (moved > wanted ? moved - wanted : wanted - moved) <= feed_um
                    : moved <= feed_um && wanted <= feed_um;
}

uint32_t ctl_bank_bad_cycle(const ctl_bank* bank, const ctl_config* config)
{
    if ((uint64_t)ctl_bank_cycle_ticks(bank) * US_PER_S < (uint64_t)config->timer_clock_hz * CTL_MIN_CYCLE_US)
        return CTL_OFFSET_BANK_CYCLE_TICKS;
    if (ctl_bank_divisor(bank) == 0)
        return CTL_OFFSET_BANK_DIVISOR;
    if (ctl_bank_remainder(bank) >= ctl_bank_divisor(bank))
        return CTL_OFFSET_BANK_REMAINDER;
    return NOTHING_BAD;
}

uint32_t ctl_bank_capacity(const ctl_config* config)
{
    const uint32_t wanted = config->bank_registers;
    return wanted == 0 || wanted > CTL_BANK_STORAGE ? CTL_BANK_STORAGE : wanted;
}

uint32_t ctl_bank_row_registers(const ctl_bank* bank)
{
    const layout_info* layout = layout_of(bank);
    return layout == NULL ? 0 : layout->row_registers;
}

static bool fits_board(const ctl_bank* bank, const ctl_config* config)
{
    return ctl_bank_layout(bank) != CTL_TABLE_LAYOUT_STEP_TABLE || config->row_capacity == 0 ||
           ctl_bank_row_count(bank) <= config->row_capacity;
}

uint32_t ctl_bank_bad_header(const ctl_bank* bank, const ctl_config* config, uint32_t length)
{
    const layout_info* layout = layout_of(bank);
    if (layout == NULL)
        return CTL_OFFSET_BANK_LAYOUT;
    if (config->table_layouts != 0 && (config->table_layouts >> ctl_bank_layout(bank) & 1u) == 0)
        return CTL_OFFSET_BANK_LAYOUT;
    const uint32_t kind = ctl_bank_kind(bank);
    if (kind > CTL_PROGRAM_KIND_LAST || (layout->kinds & CTL_PROGRAM_KINDS & 1u << kind) == 0)
        return CTL_OFFSET_BANK_KIND;
    const uint32_t rows = ctl_bank_row_count(bank);
    if (rows < layout->min_rows || rows > layout->max_rows || ctl_bank_length(bank) != length ||
        !fits_board(bank, config))
        return CTL_OFFSET_BANK_ROW_COUNT;
    const uint32_t per_revolution = wide(bank, kind_of(bank)->pulses_per_motor_rev);
    if (per_revolution == 0 || per_revolution > MAX_PULSES_PER_MOTOR_REV)
        return kind_of(bank)->pulses_per_motor_rev;
    /* The knife's radius or the feed. */
    if (wide(bank, kind_of(bank)->length) == 0 || wide(bank, kind_of(bank)->length) > INT32_MAX)
        return kind_of(bank)->length;
    return NOTHING_BAD;
}

bool ctl_bank_same_machine(const ctl_bank* one, const ctl_bank* other)
{
    if (ctl_bank_kind(one) != ctl_bank_kind(other))
        return false;
    const kind_info* kind = kind_of(one);
    if (wide(one, kind->length) != wide(other, kind->length) ||
        wide(one, kind->pulses_per_motor_rev) != wide(other, kind->pulses_per_motor_rev))
        return false;
    return !has_knife(one) ||
           (one->registers[CTL_OFFSET_PROGRAM_KNIVES] == other->registers[CTL_OFFSET_PROGRAM_KNIVES] &&
            one->registers[CTL_OFFSET_PROGRAM_GEAR_NUMERATOR] ==
                other->registers[CTL_OFFSET_PROGRAM_GEAR_NUMERATOR] &&
            one->registers[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR] ==
                other->registers[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR]);
}
