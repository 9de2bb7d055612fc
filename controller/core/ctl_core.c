/* SPDX-License-Identifier: Apache-2.0 */
#include "ctl_core.h"

#include "base/ctl_crc.h"
#include "base/ctl_words.h"
#include "link/ctl_command.h"

#include <string.h>

#define US_PER_S 1000000u
/* Registers of the active bank that the background check reads per slice: a full bank in under a second. */
#define CHECKED_PER_SLICE 3u

const ctl_bank* ctl_active_bank(const ctl_core* core)
{
    return &core->banks.bank[core->banks.active];
}

ctl_bank* ctl_staged_bank(ctl_core* core)
{
    return &core->banks.bank[core->banks.active ^ 1u];
}

void ctl_swap_banks(ctl_core* core)
{
    core->banks.active ^= 1u;
    core->banks.has_active = true;
    core->banks.active_crc = core->transfer.staged_crc;
    core->banks.generation += 1;
    core->banks.check_position = 0;
    ctl_transfer_discard(core);
}

bool ctl_active_bank_intact(const ctl_core* core)
{
    return ctl_bank_length(ctl_active_bank(core)) <= CTL_BANK_REGISTERS &&
           ctl_bank_crc(ctl_active_bank(core)) == core->banks.active_crc;
}

uint16_t ctl_parameter16(const ctl_core* core, uint32_t address)
{
    return core->written.parameter[address - CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT];
}

uint32_t ctl_parameter32(const ctl_core* core, uint32_t address)
{
    return ctl_get32(&core->written.parameter[address - CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT]);
}

void ctl_init(ctl_core* core, const ctl_config* config, const ctl_port* port, uint64_t now_us)
{
    memset(core, 0, sizeof *core);
    core->config = *config;
    if (core->config.slice_us == 0)
        core->config.slice_us = CTL_SLICE_US;
    core->port = *port;
    core->started_us = now_us;
    core->now_us = now_us;
    ctl_map_init(core);
    ctl_flash_load(core);
    ctl_packer_init(core);
    ctl_motion_init(core);
}

static void check_active_bank(ctl_core* core)
{
    ctl_banks* banks = &core->banks;
    if (!banks->has_active || core->motion.state == CTL_STATE_FAULT)
        return;
    const ctl_bank* bank = ctl_active_bank(core);
    const uint32_t length = ctl_bank_length(bank);
    if (length > CTL_BANK_REGISTERS) { /* the number of rows itself is damaged */
        ctl_motion_fault(core, CTL_FAULT_BIT_ACTIVE_TABLE_DAMAGED);
        return;
    }
    if (banks->check_position == 0)
        banks->check_crc = CTL_CRC32_START;
    for (uint32_t i = 0; i < CHECKED_PER_SLICE && banks->check_position < length; ++i) {
        banks->check_crc = ctl_crc32_registers(banks->check_crc, &bank->registers[banks->check_position], 1);
        banks->check_position += 1;
    }
    if (banks->check_position < length)
        return;
    banks->check_position = 0;
    if (~banks->check_crc != banks->active_crc)
        ctl_motion_fault(core, CTL_FAULT_BIT_ACTIVE_TABLE_DAMAGED);
}

void ctl_tick(ctl_core* core, uint64_t now_us)
{
    while (core->now_us < now_us) {
        const uint64_t left = now_us - core->now_us;
        const uint32_t slice_us = left < core->config.slice_us ? (uint32_t)left : core->config.slice_us;
        core->now_us += slice_us;
        core->catching_up = core->now_us < now_us;
        const uint64_t sum = (uint64_t)slice_us * core->config.timer_clock_hz + core->tick_rest;
        core->tick_rest = (uint32_t)(sum % US_PER_S);
        ctl_heartbeat_slice(core);
        ctl_motion_slice(core, (uint32_t)(sum / US_PER_S));
        ctl_packer_slice(core);
        check_active_bank(core);
    }
    ctl_rtu_tick(core, now_us);
}

void ctl_on_cut(ctl_core* core, int64_t film)
{
    ctl_packer_on_cut(core, film);
}

void ctl_on_bag_cut(ctl_core* core, uint32_t length_um)
{
    ctl_packer_on_bag(core, length_um);
    core->bags.length_um = length_um;
    core->bags.count += 1;
}
