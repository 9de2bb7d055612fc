/* SPDX-License-Identifier: Apache-2.0 */
#include "link/ctl_status.h"

#include "base/ctl_words.h"
#include "link/ctl_parts.h"

#include <string.h>

#define US_PER_S 1000000u

_Static_assert(CTL_REG_IDENTITY_DEVICE_TYPE == 0u &&
                   CTL_REG_IDENTITY_TABLE_LAYOUTS + 1u == CTL_GROUP_IDENTITY,
               "ctl_identity() fills the group, which begins at address 0");
_Static_assert(CTL_REG_STATUS_SAMPLE_TIME - CTL_REG_STATUS_TAG + 1u == CTL_GROUP_STATUS,
               "ctl_status() fills the group");

void ctl_identity(const ctl_core* core, uint16_t* registers)
{
    const ctl_config* config = &core->board.config;
    registers[CTL_REG_IDENTITY_DEVICE_TYPE] = CTL_DEVICE_TYPE;
    registers[CTL_REG_IDENTITY_MAP_MAJOR] = CTL_MAP_MAJOR;
    registers[CTL_REG_IDENTITY_MAP_MINOR] =
        config->map_minor == 0 ? (uint16_t)CTL_MAP_MINOR : config->map_minor;
    registers[CTL_REG_IDENTITY_FIRMWARE_MAJOR] = config->firmware[0];
    registers[CTL_REG_IDENTITY_FIRMWARE_MINOR] = config->firmware[1];
    registers[CTL_REG_IDENTITY_FIRMWARE_PATCH] = config->firmware[2];
    ctl_put32(&registers[CTL_REG_IDENTITY_UNIQUE_ID_HIGH], (uint32_t)(config->unique_id >> 32));
    ctl_put32(&registers[CTL_REG_IDENTITY_UNIQUE_ID_LOW], (uint32_t)(config->unique_id & 0xFFFFFFFFu));
    registers[CTL_REG_IDENTITY_PROGRAM_KINDS] = CTL_PROGRAM_KINDS;
    registers[CTL_REG_IDENTITY_ROW_CAPACITY] =
        config->row_capacity == 0 ? (uint16_t)CTL_ROW_CAPACITY : config->row_capacity;
    registers[CTL_REG_IDENTITY_BANK_REGISTERS] = (uint16_t)ctl_bank_capacity(config);
    registers[CTL_REG_IDENTITY_BLOCK_REGISTERS] = CTL_BLOCK_REGISTERS;
    ctl_put32(&registers[CTL_REG_IDENTITY_TIMER_CLOCK], config->timer_clock_hz);
    registers[CTL_REG_IDENTITY_TIMER_BITS] = config->timer_bits;
    ctl_put32(&registers[CTL_REG_IDENTITY_MAX_PULSE_FREQUENCY], config->max_pulse_hz);
    registers[CTL_REG_IDENTITY_TABLE_LAYOUTS] =
        config->table_layouts == 0 ? (uint16_t)CTL_TABLE_LAYOUTS : config->table_layouts;
}

uint16_t ctl_warnings(const ctl_core* core)
{
    uint32_t bits = 0;
    if (ctl_heartbeat_lost(&core->heartbeat, &core->board))
        bits |= 1u << CTL_WARNING_BIT_HEARTBEAT_LOST;
    const bool any_place_will_do =
        core->banks.has_active && !ctl_bank_needs_homing(ctl_active_bank(&core->banks));
    if (!core->motion.homed && !any_place_will_do)
        bits |= 1u << CTL_WARNING_BIT_NOT_HOMED;
    if (core->flash.slot_invalid)
        bits |= 1u << CTL_WARNING_BIT_FLASH_SLOT_INVALID;
    if (!core->clock.set)
        bits |= 1u << CTL_WARNING_BIT_CLOCK_NOT_SET;
    if (ctl_io_emergency_stop(&core->io, &core->board))
        bits |= 1u << CTL_WARNING_BIT_EMERGENCY_STOP;
    if (ctl_park_is_closed_long(&core->motion.park, &core->board))
        bits |= 1u << CTL_WARNING_BIT_JAWS_CLOSED;
    if (core->master.too_fast)
        bits |= 1u << CTL_WARNING_BIT_MASTER_TOO_FAST;
    if ((core->io.inputs & 1u << CTL_INPUT_BIT_DOOR) != 0)
        bits |= 1u << CTL_WARNING_BIT_DOOR_OPEN;
    if ((core->io.inputs & 1u << CTL_INPUT_BIT_NEXT_MACHINE) != 0)
        bits |= 1u << CTL_WARNING_BIT_NEXT_MACHINE;
    if ((core->io.inputs & 1u << CTL_INPUT_BIT_CODER) != 0)
        bits |= 1u << CTL_WARNING_BIT_CODER;
    bits |= core->packer.alarms;
    return (uint16_t)bits;
}

uint32_t ctl_unix_time(const ctl_core* core)
{
    if (!core->clock.set)
        return 0;
    return core->clock.unix_time + (uint32_t)((core->board.now_us - core->clock.set_us) / US_PER_S);
}

static void put(uint16_t* registers, uint32_t address, uint16_t value)
{
    registers[address - CTL_REG_STATUS_TAG] = value;
}

/* A signed value goes out as the lower 32 bits of its two's complement. */
static void put_wide(uint16_t* registers, uint32_t address, uint64_t value)
{
    ctl_put32(&registers[address - CTL_REG_STATUS_TAG], (uint32_t)(value & 0xFFFFFFFFu));
}

static void put_link(const ctl_core* core, uint16_t* registers)
{
    put(registers, CTL_REG_STATUS_COMMAND_COUNTER, core->command_result[0]);
    put(registers, CTL_REG_STATUS_LINK_CRC_ERRORS, core->rtu.crc_errors);
    put(registers, CTL_REG_STATUS_LINK_FRAME_ERRORS, core->rtu.frame_errors);
    put(registers, CTL_REG_STATUS_LINK_EXCEPTIONS, core->rtu.exceptions);
    put(registers, CTL_REG_STATUS_LINK_REQUESTS, core->rtu.requests);
}

static void put_program(const ctl_core* core, uint16_t* registers)
{
    const ctl_banks* banks = &core->banks;
    const ctl_bank* bank = ctl_active_bank(&core->banks);
    put(registers, CTL_REG_STATUS_PROGRAM_KIND,
        banks->has_active ? bank->registers[CTL_OFFSET_BANK_KIND] : CTL_PROGRAM_KIND_NONE);
    put(registers, CTL_REG_STATUS_STAGED_STATE, core->transfer.state);
    put_wide(registers, CTL_REG_STATUS_GENERATION, banks->generation);
    put_wide(registers, CTL_REG_STATUS_ACTIVE_CRC, banks->active_crc);
    put_wide(registers, CTL_REG_STATUS_SAVED_CRC, core->flash.saved_crc);
}

static void put_knife(const ctl_core* core, uint16_t* registers)
{
    const ctl_bank* bank = ctl_active_bank(&core->banks);
    put(registers, CTL_REG_STATUS_KNIFE_ANGLE,
        ctl_bank_knife_angle(bank, core->motion.actual - core->motion.origin));
    put_wide(registers, CTL_REG_STATUS_BAG_LENGTH, core->bags.length_um);
    put_wide(registers, CTL_REG_STATUS_BAG_COUNT, core->bags.count);
    if (core->bags.length_um != 0)
        put(registers, CTL_REG_STATUS_BAG_DEVIATION,
            ctl_saturated16((int64_t)core->bags.length_um -
                            ctl_packer_set_um(&core->packer, ctl_bank_bag_um(bank))));
}

static uint16_t saturated_force(int32_t force)
{
    if (force < 0)
        return 0;
    return force > UINT16_MAX ? UINT16_MAX : (uint16_t)force;
}

static void put_press(const ctl_core* core, uint16_t* registers)
{
    const ctl_press* press = &core->motion.press;
    put(registers, CTL_REG_STATUS_PRESS_STAGE, press->stage);
    put(registers, CTL_REG_STATUS_PRESS_FORCE, saturated_force(ctl_motion_press_force(&core->motion)));
    put(registers, CTL_REG_STATUS_STOP_ERROR, ctl_saturated16(press->last.error));
    put(registers, CTL_REG_STATUS_STOP_FORCE, saturated_force(press->last.force));
    put(registers, CTL_REG_STATUS_STROKE_RESULT, press->last.result);
    put(registers, CTL_REG_STATUS_PEAK_FORCE, saturated_force(press->last.peak));
}

/* Values of one kind only lie at the same addresses as those of another. */
static void put_kind(const ctl_core* core, uint16_t* registers)
{
    if (!core->banks.has_active)
        return;
    switch (ctl_bank_kind(ctl_active_bank(&core->banks))) {
    case CTL_PROGRAM_KIND_ROTARY_CUTTER:
        put_knife(core, registers);
        break;
    case CTL_PROGRAM_KIND_PRESS:
        put_press(core, registers);
        break;
    default:
        break;
    }
}

static void put_motion(const ctl_core* core, uint16_t* registers)
{
    const ctl_motion* motion = &core->motion;
    put_wide(registers, CTL_REG_STATUS_CYCLE_COUNT, motion->cycle_count);
    put(registers, CTL_REG_STATUS_MASTER_ANGLE, ctl_motion_master_angle(&core->motion));
    put(registers, CTL_REG_STATUS_MASTER_SPEED, ctl_motion_master_speed(&core->motion));
    put_wide(registers, CTL_REG_STATUS_COMMANDED_FREQUENCY, (uint64_t)ctl_motion_commanded_hz(&core->motion));
    put_wide(registers, CTL_REG_STATUS_ACTUAL_FREQUENCY, (uint64_t)motion->actual_hz);
    put_wide(registers, CTL_REG_STATUS_COMMANDED_POSITION, (uint64_t)(motion->commanded - motion->origin));
    put_wide(registers, CTL_REG_STATUS_AXIS_POSITION, (uint64_t)(motion->actual - motion->origin));
    put(registers, CTL_REG_STATUS_FOLLOWING_ERROR, ctl_saturated16(motion->commanded - motion->actual));
}

void ctl_status(const ctl_core* core, uint16_t* registers)
{
    const uint64_t up_us = core->board.now_us - core->board.started_us;
    memset(registers, 0, CTL_GROUP_STATUS * sizeof registers[0]);
    put(registers, CTL_REG_STATUS_TAG, core->written.exchange[0]);
    put(registers, CTL_REG_STATUS_HEARTBEAT, core->written.exchange[1]);
    put(registers, CTL_REG_STATUS_STATE, core->motion.state);
    put(registers, CTL_REG_STATUS_FAULT, core->motion.fault);
    put(registers, CTL_REG_STATUS_WARNING, ctl_warnings(core));
    put_wide(registers, CTL_REG_STATUS_UPTIME, up_us / US_PER_S);
    put(registers, CTL_REG_STATUS_SAMPLE_TIME, (uint16_t)(up_us / 1000u & 0xFFFFu));
    put_program(core, registers);
    put_motion(core, registers);
    put_kind(core, registers);
    put_link(core, registers);
}
