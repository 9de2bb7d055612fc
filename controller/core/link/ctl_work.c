/* SPDX-License-Identifier: Apache-2.0 */
#include "link/ctl_work.h"

#include "base/ctl_crc.h"
#include "link/ctl_command.h"
#include "link/ctl_parts.h"

/* The active bank's next registers; another bank is checked from its beginning. */
static void check_piece(ctl_core* core)
{
    ctl_work* work = &core->work;
    ctl_banks* banks = &core->banks;
    const ctl_bank* bank = ctl_active_bank(banks);
    const uint32_t length = ctl_bank_length(bank);
    if (work->position == 0 || work->generation != banks->generation) {
        work->generation = banks->generation;
        work->position = 0;
        work->crc = CTL_CRC32_START;
    }
    const uint32_t left = length <= CTL_BANK_STORAGE ? length - work->position : 0u;
    const uint32_t most = core->board.config.work_registers;
    const uint32_t part = left < most ? left : most;
    work->crc = ctl_crc32_registers(work->crc, &bank->registers[work->position], part);
    work->position += part;
    if (part != 0)
        return; /* the command itself is a piece of its own */
    work->checks = false;
    banks->proof =
        work->position == length && ~work->crc == banks->active_crc ? CTL_PROOF_INTACT : CTL_PROOF_DAMAGED;
    ctl_command_checked(core, work->request);
    banks->proof = CTL_PROOF_NONE;
}

static void save_piece(ctl_core* core)
{
    ctl_work* work = &core->work;
    const ctl_flash_progress progress = ctl_flash_save_piece(&core->flash, &core->board);
    if (progress == CTL_FLASH_BUSY)
        return;
    core->transfer.reader = NULL;
    if (work->saves)
        ctl_command_saved(core, work->save_counter, progress == CTL_FLASH_DONE);
    work->saves = false;
    if (work->waits)
        ctl_command_waited(core);
}

void ctl_work_slice(ctl_core* core)
{
    if (core->transfer.sealing)
        ctl_transfer_work(&core->transfer, &core->banks, &core->board.config,
                          core->board.config.work_registers);
    else if (core->work.checks)
        check_piece(core);
    else if (core->flash.saving.busy)
        save_piece(core);
}
