/* SPDX-License-Identifier: Apache-2.0 */
#include "link/ctl_command.h"

#include "base/ctl_words.h"
#include "ctl_core.h"

#define US_PER_MS 1000u

enum { COUNTER = 0, CODE = 1, ARGUMENT0 = 2, ARGUMENT1 = 3, ARGUMENT2 = 4 };

static uint16_t apply_staged(ctl_core* core, const uint16_t* request)
{
    ctl_transfer* transfer = &core->transfer;
    const uint16_t mode = request[ARGUMENT0];
    if (mode > CTL_APPLY_MODE_NEXT_CYCLE)
        return CTL_REFUSAL_BAD_ARGUMENT;
    if (transfer->state != CTL_STAGED_STATE_SEALED && transfer->state != CTL_STAGED_STATE_ARMED)
        return CTL_REFUSAL_NOTHING_SEALED;
    if (request[ARGUMENT1] != transfer->session)
        return CTL_REFUSAL_WRONG_SESSION;
    if (ctl_get32(&request[ARGUMENT2]) != transfer->staged_crc)
        return CTL_REFUSAL_WRONG_CHECKSUM;
    if (ctl_motion_standstill(core)) {
        ctl_motion_change_program(core);
        return CTL_REFUSAL_NONE;
    }
    if (mode == CTL_APPLY_MODE_WHEN_STOPPED || !ctl_motion_in_cycle(core))
        return CTL_REFUSAL_NOT_STANDSTILL;
    if (!ctl_bank_same_machine(ctl_active_bank(core), ctl_staged_bank(core)))
        return CTL_REFUSAL_MACHINE_DATA_DIFFERS;
    transfer->state = CTL_STAGED_STATE_ARMED;
    return CTL_REFUSAL_NONE;
}

static uint16_t cancel_apply(ctl_core* core)
{
    if (core->transfer.state != CTL_STAGED_STATE_ARMED)
        return CTL_REFUSAL_NOT_ARMED;
    core->transfer.state = CTL_STAGED_STATE_SEALED;
    return CTL_REFUSAL_NONE;
}

static uint16_t save_to_flash(ctl_core* core, const uint16_t* request)
{
    if (!core->banks.has_active)
        return CTL_REFUSAL_NO_ACTIVE_PROGRAM;
    if (ctl_get32(&request[ARGUMENT2]) != core->banks.active_crc || !ctl_active_bank_intact(core))
        return CTL_REFUSAL_WRONG_CHECKSUM;
    return ctl_flash_save(core) ? CTL_REFUSAL_NONE : CTL_REFUSAL_FLASH_FAILED;
}

static uint16_t set_clock(ctl_core* core, const uint16_t* request)
{
    if (ctl_get32(&request[ARGUMENT2]) == 0)
        return CTL_REFUSAL_BAD_ARGUMENT;
    core->clock.set = true;
    core->clock.unix_time = ctl_get32(&request[ARGUMENT2]);
    core->clock.set_us = core->now_us;
    return CTL_REFUSAL_NONE;
}

static uint16_t carry_out(ctl_core* core, const uint16_t* request)
{
    switch (request[CODE]) {
    case CTL_COMMAND_START:
        return ctl_motion_start(core);
    case CTL_COMMAND_STOP_AT_CYCLE_END:
        return ctl_motion_stop_at_cycle_end(core);
    case CTL_COMMAND_STOP_NOW:
        return ctl_motion_stop_now(core);
    case CTL_COMMAND_HOME:
        return ctl_motion_home(core);
    case CTL_COMMAND_RESET_FAULT:
        return ctl_motion_reset_fault(core);
    case CTL_COMMAND_APPLY_STAGED:
        return apply_staged(core, request);
    case CTL_COMMAND_CANCEL_APPLY:
        return cancel_apply(core);
    case CTL_COMMAND_DISCARD_STAGED:
        ctl_transfer_discard(core);
        return CTL_REFUSAL_NONE;
    case CTL_COMMAND_SAVE_TO_FLASH:
        return save_to_flash(core, request);
    case CTL_COMMAND_SET_CLOCK:
        return set_clock(core, request);
    case CTL_COMMAND_TEACH_MARKS:
        return ctl_packer_teach(core, request[ARGUMENT0]);
    default:
        return CTL_REFUSAL_UNKNOWN_COMMAND;
    }
}

void ctl_command(ctl_core* core, bool has_code)
{
    const uint16_t* request = core->written.command;
    uint16_t* result = core->command_result;
    if (request[COUNTER] == result[0])
        return;
    /* Register by register, in either order, the code of another command may be there. */
    const uint16_t refusal = has_code ? carry_out(core, request) : CTL_REFUSAL_COMMAND_INCOMPLETE;
    result[0] = request[COUNTER];
    result[1] = request[CODE];
    result[2] = refusal == CTL_REFUSAL_NONE ? CTL_COMMAND_STATUS_DONE : CTL_COMMAND_STATUS_REFUSED;
    result[3] = refusal;
}

void ctl_exchange_heartbeat(ctl_core* core)
{
    const uint16_t value = core->written.exchange[1];
    if (core->heartbeat.heard && value == core->heartbeat.last)
        return;
    core->heartbeat.heard = true;
    core->heartbeat.last = value;
    core->heartbeat.advanced_us = core->now_us;
}

static bool heartbeat_older_than(const ctl_core* core, uint64_t age_us)
{
    const uint64_t last_us = core->heartbeat.heard ? core->heartbeat.advanced_us : core->started_us;
    return core->now_us - last_us >= age_us;
}

bool ctl_heartbeat_lost(const ctl_core* core)
{
    const uint32_t timeout_ms = ctl_parameter16(core, CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT);
    return heartbeat_older_than(core, (uint64_t)timeout_ms * US_PER_MS);
}

/* Direction of the one key that is held. */
static int32_t held_key(const ctl_core* core)
{
    const uint32_t keys = core->written.exchange[2];
    if (keys == 1u << CTL_JOG_BIT_FORWARD)
        return 1;
    return keys == 1u << CTL_JOG_BIT_REVERSE ? -1 : 0;
}

int32_t ctl_jog_request(const ctl_core* core)
{
    return core->heartbeat.jog_blocked ? 0 : held_key(core);
}

void ctl_heartbeat_slice(ctl_core* core)
{
    /* A jog that died does not come back by itself: the key must be let go first. */
    if (core->written.exchange[2] == 0)
        core->heartbeat.jog_blocked = false;
    else if (!core->heartbeat.heard || heartbeat_older_than(core, CTL_JOG_HOLD_US))
        core->heartbeat.jog_blocked = true;
    if (ctl_parameter16(core, CTL_REG_PARAMETER_HEARTBEAT_LOST_ACTION) ==
            CTL_HEARTBEAT_LOST_ACTION_STOP_AT_CYCLE_END &&
        ctl_heartbeat_lost(core))
        ctl_motion_stop_unattended(core);
}
