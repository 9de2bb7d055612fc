/* SPDX-License-Identifier: Apache-2.0 */
#include "link/ctl_command.h"

#include "base/ctl_words.h"
#include "link/ctl_parts.h"
#include "motion/ctl_start.h"

#include <stddef.h>
#include <string.h>

enum { COUNTER = 0, CODE = 1, ARGUMENT0 = 2, ARGUMENT1 = 3, ARGUMENT2 = 4 };
_Static_assert(CTL_GROUP_COMMAND == ARGUMENT2 + 2, "the wide argument ends the group");
_Static_assert(CTL_GROUP_RESULT == 4u, "ctl_command() fills the group");

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
    if (ctl_motion_standstill(&core->motion)) {
        ctl_motion_change_program(&core->motion);
        return CTL_REFUSAL_NONE;
    }
    if (mode == CTL_APPLY_MODE_WHEN_STOPPED || !ctl_motion_in_cycle(&core->motion))
        return CTL_REFUSAL_NOT_STANDSTILL;
    if (!ctl_bank_same_machine(ctl_active_bank(&core->banks), ctl_staged_bank(&core->banks)))
        return CTL_REFUSAL_MACHINE_DATA_DIFFERS;
    uint16_t refusal = ctl_switches_refusal(&core->board, ctl_staged_bank(&core->banks));
    if (refusal == CTL_REFUSAL_NONE)
        refusal = ctl_motion_change_refusal(&core->motion);
    if (refusal != CTL_REFUSAL_NONE)
        return refusal;
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

/* The refusal that stands for "in pieces, and not done yet"; it is never sent. */
#define IN_WORK UINT16_MAX

static bool works_in_pieces(const ctl_core* core)
{
    return core->board.config.work_registers != 0 || core->board.port.flash_progress != NULL;
}

static uint16_t save_to_flash(ctl_core* core, const uint16_t* request)
{
    if (!core->banks.has_active)
        return CTL_REFUSAL_NO_ACTIVE_PROGRAM;
    if (ctl_get32(&request[ARGUMENT2]) != core->banks.active_crc || !ctl_active_bank_intact(&core->banks))
        return CTL_REFUSAL_WRONG_CHECKSUM;
    ctl_flash_begin_save(&core->flash, &core->board, &core->banks);
    if (works_in_pieces(core)) {
        core->transfer.reader = core->flash.saving.bank;
        core->work.saves = true;
        core->work.save_counter = request[COUNTER];
        return IN_WORK;
    }
    ctl_flash_progress progress = CTL_FLASH_BUSY;
    while (progress == CTL_FLASH_BUSY)
        progress = ctl_flash_save_piece(&core->flash, &core->board);
    return progress == CTL_FLASH_DONE ? CTL_REFUSAL_NONE : CTL_REFUSAL_FLASH_FAILED;
}

static uint16_t set_clock(ctl_core* core, const uint16_t* request)
{
    if (ctl_get32(&request[ARGUMENT2]) == 0)
        return CTL_REFUSAL_BAD_ARGUMENT;
    core->clock.set = true;
    core->clock.unix_time = ctl_get32(&request[ARGUMENT2]);
    core->clock.set_us = core->board.now_us;
    return CTL_REFUSAL_NONE;
}

static const ctl_bank* active_bank(const ctl_core* core)
{
    return core->banks.has_active ? ctl_active_bank(&core->banks) : NULL;
}

static uint16_t take_bag(ctl_core* core)
{
    if (!ctl_packer_drives(&core->packer, active_bank(core)))
        return CTL_REFUSAL_NO_BAGS;
    if (!ctl_motion_in_cycle(&core->motion))
        return CTL_REFUSAL_NOT_RUNNING;
    if (!ctl_switches_reject(&core->board))
        return CTL_REFUSAL_NO_REJECT_GATE;
    ctl_packer_take_next(&core->packer);
    return CTL_REFUSAL_NONE;
}

/* Returns the bits CTL_MEASURED_AXIS_... of the axes that turn the other way by the settings. */
static uint16_t wanted_reversals(const ctl_board* board)
{
    return (uint16_t)(ctl_signal16(board, CTL_REG_SIGNAL_KNIFE_REVERSED) << CTL_MEASURED_AXIS_KNIFE |
                      ctl_signal16(board, CTL_REG_SIGNAL_FILM_REVERSED) << CTL_MEASURED_AXIS_FILM |
                      ctl_signal16(board, CTL_REG_SIGNAL_INFEED_REVERSED) << CTL_MEASURED_AXIS_INFEED);
}

void ctl_machine_data_init(ctl_core* core)
{
    const ctl_port* port = &core->board.port;
    core->reversed = wanted_reversals(&core->board);
    if (port->reverse != NULL)
        port->reverse(port->context, core->reversed);
}

void ctl_machine_data(ctl_core* core)
{
    const ctl_port* port = &core->board.port;
    if (core->machine_writes == core->board.parameter_writes || !ctl_motion_standstill(&core->motion))
        return;
    const uint16_t axes = wanted_reversals(&core->board);
    const bool reverses = axes != core->reversed && port->reverse != NULL;
    core->machine_writes = core->board.parameter_writes;
    core->reversed = axes;
    if (reverses)
        port->reverse(port->context, axes);
    if (reverses || ctl_packer_has_other_lengths(&core->packer))
        ctl_motion_lose_phase(&core->motion);
}

static uint16_t carry_out(ctl_core* core, const uint16_t* request)
{
    switch (request[CODE]) {
    case CTL_COMMAND_START:
        return ctl_start(&core->motion, &core->io);
    case CTL_COMMAND_STOP_AT_CYCLE_END:
        return ctl_motion_stop_at_cycle_end(&core->motion);
    case CTL_COMMAND_STOP_NOW:
        return ctl_motion_stop_now(&core->motion);
    case CTL_COMMAND_HOME:
        return ctl_start_home(&core->motion, &core->io);
    case CTL_COMMAND_RESET_FAULT:
        return ctl_io_drive_alarm(&core->io) && core->motion.state == CTL_STATE_FAULT
                   ? CTL_REFUSAL_FAULT_PERSISTS
                   : ctl_motion_reset_fault(&core->motion);
    case CTL_COMMAND_APPLY_STAGED:
        return apply_staged(core, request);
    case CTL_COMMAND_CANCEL_APPLY:
        return cancel_apply(core);
    case CTL_COMMAND_DISCARD_STAGED:
        ctl_transfer_discard(&core->transfer);
        return CTL_REFUSAL_NONE;
    case CTL_COMMAND_SAVE_TO_FLASH:
        return save_to_flash(core, request);
    case CTL_COMMAND_SET_CLOCK:
        return set_clock(core, request);
    case CTL_COMMAND_TEACH_MARKS:
        return ctl_packer_teach(&core->packer, active_bank(core), request[ARGUMENT0]);
    case CTL_COMMAND_TRY_OUTPUT:
        return ctl_try_output(&core->motion, &core->io, request[ARGUMENT0], request[ARGUMENT1]);
    case CTL_COMMAND_ORDER_START:
        return ctl_order_start(&core->order, &core->packer, request[ARGUMENT0], request[ARGUMENT1],
                               ctl_get32(&request[ARGUMENT2]), core->written.order, active_bank(core));
    case CTL_COMMAND_ORDER_END:
        return ctl_order_end(&core->order, &core->packer, request[ARGUMENT0]);
    case CTL_COMMAND_JOG_BAG:
        return ctl_start_bag(&core->motion, &core->io);
    case CTL_COMMAND_SINGLE_CUT:
        return ctl_start_cut(&core->motion, &core->io);
    case CTL_COMMAND_TAKE_BAG:
        return take_bag(core);
    case CTL_COMMAND_MEASURE:
        return ctl_start_measure(&core->motion, &core->io, request[ARGUMENT0], request[ARGUMENT1]);
    case CTL_COMMAND_ACKNOWLEDGE:
        ctl_tower_acknowledge(&core->tower);
        return CTL_REFUSAL_NONE;
    default:
        return CTL_REFUSAL_UNKNOWN_COMMAND;
    }
}

/* The command reads the whole active bank before it does anything. */
static bool needs_check(const ctl_core* core, uint16_t code)
{
    if (core->board.config.work_registers == 0 || !core->banks.has_active)
        return false;
    const bool moves = code == CTL_COMMAND_START || code == CTL_COMMAND_HOME ||
                       code == CTL_COMMAND_RESET_FAULT || code == CTL_COMMAND_JOG_BAG ||
                       code == CTL_COMMAND_SINGLE_CUT || code == CTL_COMMAND_MEASURE;
    return code == CTL_COMMAND_SAVE_TO_FLASH || (moves && ctl_motion_standstill(&core->motion));
}

static void answer(ctl_core* core, uint16_t refusal)
{
    uint16_t* result = core->command_result;
    const bool done = refusal == CTL_REFUSAL_NONE;
    result[2] = done ? CTL_COMMAND_STATUS_DONE : CTL_COMMAND_STATUS_REFUSED;
    result[3] = refusal;
    if (refusal != IN_WORK)
        return;
    result[2] = CTL_COMMAND_STATUS_BUSY;
    result[3] = CTL_REFUSAL_NONE;
}

/* The save under way saves what this command wants saved. */
static bool joins_save(const ctl_core* core, const uint16_t* request)
{
    return ctl_get32(&request[ARGUMENT2]) == core->banks.active_crc &&
           ctl_flash_saves(&core->flash, &core->board, &core->banks);
}

/* Begins with a command: at once, after the check of the active bank, or after the save under way. */
static void begin(ctl_core* core, const uint16_t* request)
{
    ctl_work* work = &core->work;
    ctl_machine_data(core);
    const bool saving = request[CODE] == CTL_COMMAND_SAVE_TO_FLASH && core->flash.saving.busy;
    if (saving && joins_save(core, request)) {
        work->saves = true;
        work->save_counter = request[COUNTER];
        answer(core, IN_WORK);
    } else if (saving && ctl_get32(&request[ARGUMENT2]) != core->banks.active_crc) {
        answer(core, CTL_REFUSAL_WRONG_CHECKSUM);
    } else if (saving || needs_check(core, request[CODE])) {
        work->waits = saving;
        work->checks = !saving;
        work->position = 0;
        memmove(work->request, request, sizeof work->request);
        answer(core, IN_WORK);
    } else {
        answer(core, carry_out(core, request));
    }
}

void ctl_command(ctl_core* core, bool has_code)
{
    const uint16_t* request = core->written.command;
    uint16_t* result = core->command_result;
    if (request[COUNTER] == result[0])
        return;
    result[0] = request[COUNTER];
    result[1] = request[CODE];
    core->work.checks = false; /* the command that waits is overtaken, and not carried out */
    core->work.by_button = false;
    core->actions.wants = CTL_COMMAND_NONE;
    core->work.waits = false;
    if (!has_code || request[CODE] != CTL_COMMAND_TRY_OUTPUT)
        ctl_io_try(&core->io, &core->board, 0); /* whoever asks for something else has let go */
    if (has_code)
        begin(core, request);
    else /* register by register, in either order, the code of another command may be there */
        answer(core, CTL_REFUSAL_COMMAND_INCOMPLETE);
}

void ctl_command_checked(ctl_core* core, const uint16_t* request)
{
    if (!core->work.by_button) {
        answer(core, carry_out(core, request));
        return;
    }
    core->work.by_button = false;
    if (core->actions.wants != CTL_COMMAND_NONE)
        core->actions.refusal = carry_out(core, request);
    core->actions.wants = CTL_COMMAND_NONE;
}

void ctl_command_button(ctl_core* core)
{
    ctl_work* work = &core->work;
    const uint16_t start[CTL_GROUP_COMMAND] = {[CODE] = core->actions.wants};
    if (work->checks || work->waits)
        return;
    work->by_button = true;
    if (needs_check(core, core->actions.wants)) {
        work->checks = true;
        work->position = 0;
        memcpy(work->request, start, sizeof start);
    } else {
        ctl_command_checked(core, start);
    }
}

void ctl_command_saved(ctl_core* core, uint16_t counter, bool done)
{
    if (core->command_result[0] == counter)
        answer(core, done ? CTL_REFUSAL_NONE : CTL_REFUSAL_FLASH_FAILED);
}

void ctl_command_waited(ctl_core* core)
{
    core->work.waits = false;
    begin(core, core->work.request);
}
