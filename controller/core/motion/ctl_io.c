/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/ctl_io.h"

#include <stddef.h>
#include <string.h>

static void put_outputs(ctl_io* io, const ctl_board* board, uint16_t levels)
{
    io->outputs = levels;
    if (board->port.outputs != NULL)
        board->port.outputs(board->port.context, levels);
}

void ctl_io_init(ctl_io* io, const ctl_board* board)
{
    memset(io, 0, sizeof *io);
    put_outputs(io, board, 0);
}

/* The cycle of a cutter's film, of any other program's master. Film that waits for a product has no speed. */
static ctl_switch_cycle switch_cycle(const ctl_motion* motion)
{
    const uint32_t speed = ctl_ramp_share(&motion->ramp, 1u << CTL_SWITCH_SPEED_BITS);
    const ctl_packer* packer = motion->packer;
    if (ctl_packer_active(packer)) {
        const bool waits = packer->film_gate.state == CTL_GATE_STATE_STANDING;
        const ctl_switch_cycle cycle = {packer->film.phase, packer->film.cycle, 1, waits ? 0u : speed};
        return cycle;
    }
    const ctl_table* table = &motion->table;
    const ctl_switch_cycle cycle = {ctl_table_position(table), ctl_bank_cycle_ticks(table->bank),
                                    motion->direction, speed};
    return cycle;
}

void ctl_io_slice(ctl_io* io, const ctl_motion* motion)
{
    const bool follows = ctl_motion_in_cycle(motion) && ctl_switches_serve(ctl_active_bank(motion->banks));
    const ctl_switch_cycle cycle = follows ? switch_cycle(motion) : (ctl_switch_cycle){0};
    const uint16_t levels = ctl_switches_slice(&io->switches, motion->board, follows ? &cycle : NULL);
    if (levels != io->outputs)
        put_outputs(io, motion->board, levels);
}
