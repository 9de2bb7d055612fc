/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/ctl_start.h"

#include <stddef.h>

#define ALL_PERMITS ((2u << CTL_PERMIT_BIT_LAST) - 1u)

_Static_assert(CTL_REFUSAL_CODER - CTL_REFUSAL_STOP_BUTTON == CTL_INPUT_BIT_CODER - CTL_INPUT_BIT_STOP_BUTTON,
               "each input that refuses has its refusal, in the same order");
_Static_assert(CTL_REFUSAL_PANEL_DISAGREES - CTL_REFUSAL_NOT_WARM == CTL_PERMIT_BIT_LAST,
               "each bit of a permit has its refusal, in the same order");

/* Returns the refusal for want of the panel's heartbeat or permit; `permits`: the bits that this motion
 * needs. */
static uint16_t panel_refusal(const ctl_heartbeat* heartbeat, const ctl_board* board, uint32_t permits)
{
    const bool needs_panel = ctl_parameter16(board, CTL_REG_PARAMETER_PERMIT_NEEDED) != 0;
    if (needs_panel ? ctl_heartbeat_lost(heartbeat, board) : ctl_heartbeat_stops(heartbeat, board))
        return CTL_REFUSAL_HEARTBEAT_LOST;
    const uint32_t missing = ctl_heartbeat_missing(heartbeat, board, permits);
    for (uint32_t bit = 0; missing != 0 && bit <= CTL_PERMIT_BIT_LAST; ++bit) {
        if ((missing & 1u << bit) != 0)
            return (uint16_t)(CTL_REFUSAL_NOT_WARM + bit);
    }
    return CTL_REFUSAL_NONE;
}

/* Returns the refusal for an input that is on. */
static uint16_t input_refusal(const ctl_io* io)
{
    uint32_t bit = CTL_INPUT_BIT_STOP_BUTTON;
    while (bit <= CTL_INPUT_BIT_CODER && (io->inputs & 1u << bit) == 0)
        ++bit;
    return bit > CTL_INPUT_BIT_CODER ? CTL_REFUSAL_NONE
                                     : (uint16_t)(CTL_REFUSAL_STOP_BUTTON + bit - CTL_INPUT_BIT_STOP_BUTTON);
}

/* Returns what speaks against anything at all that acts on the machine. */
static uint16_t refusal_to_act(const ctl_motion* motion, const ctl_io* io, uint16_t when_moving,
                               uint32_t permits)
{
    if (motion->state == CTL_STATE_FAULT)
        return (motion->fault & 1u << CTL_FAULT_BIT_DRIVE_ALARM) != 0 ? CTL_REFUSAL_DRIVE_ALARM
                                                                      : CTL_REFUSAL_IN_FAULT;
    if (!ctl_motion_standstill(motion))
        return when_moving;
    if (ctl_io_emergency_stop(io, motion->board))
        return CTL_REFUSAL_EMERGENCY_STOP;
    return panel_refusal(motion->heartbeat, motion->board, permits);
}

static uint16_t refusal_to_begin(const ctl_motion* motion, const ctl_io* io, uint16_t when_moving,
                                 uint32_t permits)
{
    if (motion->state != CTL_STATE_FAULT && !motion->banks->has_active)
        return CTL_REFUSAL_NO_ACTIVE_PROGRAM;
    return refusal_to_act(motion, io, when_moving, permits);
}

static uint16_t refusal_to_move(ctl_motion* motion, const ctl_io* io, uint16_t when_moving, uint32_t permits)
{
    const uint16_t refusal = refusal_to_begin(motion, io, when_moving, permits);
    if (refusal != CTL_REFUSAL_NONE)
        return refusal;
    if (!ctl_active_bank_intact(motion->banks)) {
        ctl_motion_fault(motion, CTL_FAULT_BIT_ACTIVE_TABLE_DAMAGED);
        return CTL_REFUSAL_IN_FAULT;
    }
    return CTL_REFUSAL_NONE;
}

/* Returns what inputs, parameters and program say against a run. */
static uint16_t refusal_to_run(const ctl_motion* motion, const ctl_io* io)
{
    uint16_t refusal = input_refusal(io);
    /* A switch with too long a lead would be on in the wrong cycle. */
    if (refusal == CTL_REFUSAL_NONE)
        refusal = ctl_switches_refusal(motion->board, ctl_active_bank(motion->banks));
    if (refusal == CTL_REFUSAL_NONE)
        refusal = ctl_packer_refusal(motion->packer, ctl_active_bank(motion->banks));
    if (refusal == CTL_REFUSAL_NONE)
        refusal = ctl_master_refusal(motion->master, ctl_active_bank(motion->banks));
    return refusal;
}

static uint16_t refusal_to_start(ctl_motion* motion, const ctl_io* io)
{
    const uint16_t refusal = refusal_to_move(motion, io, CTL_REFUSAL_ALREADY_RUNNING, ALL_PERMITS);
    return refusal == CTL_REFUSAL_NONE ? refusal_to_run(motion, io) : refusal;
}

bool ctl_may_start(const ctl_motion* motion, const ctl_io* io)
{
    return refusal_to_begin(motion, io, CTL_REFUSAL_ALREADY_RUNNING, ALL_PERMITS) == CTL_REFUSAL_NONE &&
           refusal_to_run(motion, io) == CTL_REFUSAL_NONE;
}

uint16_t ctl_start(ctl_motion* motion, const ctl_io* io)
{
    const uint16_t refusal = refusal_to_start(motion, io);
    if (refusal == CTL_REFUSAL_NONE)
        ctl_motion_start(motion);
    return refusal;
}

static uint16_t unless_in_phase(const ctl_motion* motion, uint16_t refusal)
{
    return refusal == CTL_REFUSAL_NONE && !motion->in_phase ? CTL_REFUSAL_NOT_IN_PHASE : refusal;
}

/* Returns true where somebody else drives the film. */
static bool has_wheel(const ctl_motion* motion)
{
    return ctl_master_is_wheel(motion->master, ctl_active_bank(motion->banks));
}

uint16_t ctl_start_bag(ctl_motion* motion, const ctl_io* io)
{
    uint16_t refusal = refusal_to_start(motion, io);
    if (refusal == CTL_REFUSAL_NONE && !ctl_packer_drives(motion->packer, ctl_active_bank(motion->banks)))
        refusal = CTL_REFUSAL_NO_BAGS;
    if (refusal == CTL_REFUSAL_NONE && has_wheel(motion))
        refusal = CTL_REFUSAL_FILM_NOT_OURS;
    refusal = unless_in_phase(motion, refusal);
    if (refusal == CTL_REFUSAL_NONE)
        ctl_motion_start_bag(motion);
    return refusal;
}

uint16_t ctl_start_cut(ctl_motion* motion, const ctl_io* io)
{
    uint16_t refusal = refusal_to_start(motion, io);
    if (refusal == CTL_REFUSAL_NONE)
        refusal = ctl_packer_cut_refusal(motion->packer, ctl_active_bank(motion->banks));
    refusal = unless_in_phase(motion, refusal);
    if (refusal == CTL_REFUSAL_NONE && has_wheel(motion) && !ctl_tracker_stands(&motion->master->tracker))
        refusal = CTL_REFUSAL_FILM_MOVES;
    if (refusal == CTL_REFUSAL_NONE)
        ctl_motion_start_cut(motion);
    return refusal;
}

uint16_t ctl_start_home(ctl_motion* motion, const ctl_io* io)
{
    const uint16_t refusal =
        refusal_to_move(motion, io, CTL_REFUSAL_NOT_STANDSTILL, 1u << CTL_PERMIT_BIT_CLEAN);
    if (refusal == CTL_REFUSAL_NONE)
        ctl_motion_home(motion);
    return refusal;
}

/* Returns what film and infeed need. */
static uint16_t refusal_to_feed(const ctl_motion* motion, uint16_t axis)
{
    if (!ctl_packer_drives(motion->packer, ctl_active_bank(motion->banks)))
        return CTL_REFUSAL_NO_BAGS;
    if (has_wheel(motion))
        return CTL_REFUSAL_FILM_NOT_OURS;
    return axis == CTL_MEASURED_AXIS_FILM && !ctl_motion_jaws_are_open(motion) ? CTL_REFUSAL_JAWS_CLOSED
                                                                               : CTL_REFUSAL_NONE;
}

static bool has_index(const ctl_motion* motion, uint16_t axis)
{
    if (axis == CTL_MEASURED_AXIS_KNIFE)
        return !ctl_motion_is_press(motion);
    const uint32_t contact = axis == CTL_MEASURED_AXIS_FILM ? CTL_REG_SIGNAL_FILM_INDEX_CONTACT
                                                            : CTL_REG_SIGNAL_INFEED_INDEX_CONTACT;
    return motion->board->port.inputs != NULL &&
           ctl_signal16(motion->board, contact) != CTL_INDEX_CONTACT_NOT_CONNECTED;
}

uint16_t ctl_start_measure(ctl_motion* motion, const ctl_io* io, uint16_t axis, uint16_t turns)
{
    uint16_t refusal = refusal_to_move(motion, io, CTL_REFUSAL_NOT_STANDSTILL, 1u << CTL_PERMIT_BIT_CLEAN);
    if (refusal == CTL_REFUSAL_NONE && (axis > CTL_MEASURED_AXIS_INFEED || turns > CTL_MEASURE_MAX_TURNS))
        refusal = CTL_REFUSAL_BAD_ARGUMENT;
    if (refusal == CTL_REFUSAL_NONE && ctl_heartbeat_lost(motion->heartbeat, motion->board))
        refusal = CTL_REFUSAL_HEARTBEAT_LOST;
    if (refusal == CTL_REFUSAL_NONE && (io->inputs & 1u << CTL_INPUT_BIT_DOOR) != 0)
        refusal = CTL_REFUSAL_DOOR_OPEN;
    if (refusal == CTL_REFUSAL_NONE && axis != CTL_MEASURED_AXIS_KNIFE)
        refusal = refusal_to_feed(motion, axis);
    if (refusal == CTL_REFUSAL_NONE && turns != 0 && !has_index(motion, axis))
        refusal = CTL_REFUSAL_NO_INDEX;
    if (refusal == CTL_REFUSAL_NONE)
        ctl_motion_measure(motion, axis, turns);
    return refusal;
}

static uint16_t refusal_to_try(const ctl_motion* motion, const ctl_io* io, uint16_t output, uint16_t on)
{
    if (output > CTL_OUTPUT_BIT_LAST || on > 1u || motion->board->port.outputs == NULL)
        return CTL_REFUSAL_BAD_ARGUMENT;
    if (on == 0)
        return CTL_REFUSAL_NONE;
    return refusal_to_act(motion, io, CTL_REFUSAL_NOT_STANDSTILL, 1u << CTL_PERMIT_BIT_CLEAN);
}

uint16_t ctl_try_output(const ctl_motion* motion, ctl_io* io, uint16_t output, uint16_t on)
{
    const uint16_t refusal = refusal_to_try(motion, io, output, on);
    ctl_io_try(io, motion->board, refusal == CTL_REFUSAL_NONE && on != 0 ? 1u << output : 0u);
    return refusal;
}
