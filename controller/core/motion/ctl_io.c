/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/ctl_io.h"

#include "base/ctl_words.h"

#include <stddef.h>
#include <string.h>

#define US_PER_MS 1000u
#define ENABLE_HOLD_US (500u * US_PER_MS) /* the drive still follows when the last pulse has left */
#define STOP_HOLD_US (2000u * US_PER_MS)
#define LED_SPEED_STEPS 512u
#define INPUT(name) (1u << CTL_INPUT_BIT_##name)

_Static_assert(CTL_REG_IO_MORE_OUTPUTS - CTL_REG_IO_AVAILABLE + 1u == CTL_GROUP_IO,
               "ctl_io_registers() fills the group");
_Static_assert(CTL_OUTPUT_BIT_DRIVE_ENABLE >= CTL_SWITCH_COUNT && CTL_OUTPUT_BIT_DRIVE_ENABLE < 16u,
               "the drive's enable output is none of the switches");

static void put_outputs(ctl_io* io, const ctl_board* board, uint32_t levels)
{
    if (levels != io->outputs && board->port.outputs != NULL)
        board->port.outputs(board->port.context, levels);
    io->outputs = levels;
}

typedef struct {
    uint16_t mask; /* of its bit */
    uint16_t kind; /* register, followed by that of the filter time */
} contact;

#define CONTACT(name, bit, address) {1u << (bit), address},
static const contact contacts[CTL_CONTACT_COUNT] = {CTL_CONTACTS(CONTACT)};

/* The kind of a contact or its filter time. */
static uint16_t setting(const ctl_board* board, uint32_t address)
{
    return address >= CTL_REG_SIGNAL_START_BUTTON_CONTACT
               ? board->signal[address - CTL_REG_SIGNAL_START_BUTTON_CONTACT]
               : ctl_parameter16(board, address);
}

/* Updates what the parameters say of the contacts. */
static void set_contacts(ctl_io* io, const ctl_board* board)
{
    io->parameter_writes = board->parameter_writes;
    io->closed = 0;
    io->filtered = 0;
    for (uint32_t i = 0; i < CTL_CONTACT_COUNT; ++i) {
        if (setting(board, contacts[i].kind) == CTL_CONTACT_NORMALLY_CLOSED)
            io->closed |= contacts[i].mask;
        if (setting(board, contacts[i].kind + 1u) != 0)
            io->filtered |= contacts[i].mask;
    }
}

/* Returns those of these changes that are still shorter than the filter time of their contact. */
static uint16_t bounces(ctl_io* io, const ctl_board* board, uint32_t changes)
{
    uint16_t shorter = 0;
    for (uint32_t i = 0; i < CTL_CONTACT_COUNT; ++i) {
        const uint16_t mask = contacts[i].mask;
        if ((changes & mask) == 0)
            continue;
        if ((io->bounces & mask) == 0)
            io->changed_us[i] = (uint32_t)board->now_us;
        if ((uint32_t)board->now_us - io->changed_us[i] < US_PER_MS * setting(board, contacts[i].kind + 1u))
            shorter |= mask;
    }
    return shorter;
}

/* Reads the pins: 1 is on, whatever the kind of contact. */
static void read_pins(ctl_io* io, const ctl_board* board, bool filters)
{
    if (io->parameter_writes != board->parameter_writes)
        set_contacts(io, board);
    const uint32_t levels = (uint32_t)board->port.inputs(board->port.context) ^ io->closed;
    const uint32_t changes = filters ? (levels ^ io->inputs) & io->filtered : 0u;
    io->bounces = changes != 0 ? bounces(io, board, changes) : (uint16_t)0;
    io->inputs = (uint16_t)(levels ^ io->bounces);
}

/* Nothing has been filtered at power-up: what is on then counts at once. */
void ctl_io_init(ctl_io* io, const ctl_board* board)
{
    memset(io, 0, sizeof *io);
    set_contacts(io, board);
    if (board->port.inputs != NULL)
        read_pins(io, board, false);
    if (board->port.outputs != NULL)
        board->port.outputs(board->port.context, 0);
}

void ctl_io_try(ctl_io* io, const ctl_board* board, uint32_t outputs)
{
    io->tried = outputs;
    io->tried_until_us = board->now_us + CTL_TRY_HOLD_US;
}

/* Returns the outputs under test: none once their time is over or anything else happens. */
static uint32_t tried(ctl_io* io, const ctl_motion* motion)
{
    const ctl_board* board = motion->board;
    if (io->tried != 0 && (board->now_us >= io->tried_until_us || !ctl_motion_standstill(motion) ||
                           motion->state == CTL_STATE_FAULT || ctl_io_emergency_stop(io, board)))
        io->tried = 0;
    return io->tried;
}

static bool drives_enabled(ctl_io* io, const ctl_motion* motion)
{
    const ctl_board* board = motion->board;
    if (!ctl_motion_standstill(motion)) {
        io->has_moved = true;
        io->moved_us = board->now_us;
    }
    switch (ctl_parameter16(board, CTL_REG_PARAMETER_DRIVE_ENABLE)) {
    case CTL_DRIVE_ENABLE_ON:
        return true;
    case CTL_DRIVE_ENABLE_WHILE_RUNNING:
        return io->has_moved && board->now_us - io->moved_us < ENABLE_HOLD_US;
    default:
        return false;
    }
}

void ctl_io_begin(ctl_io* io, ctl_motion* motion)
{
    const ctl_board* board = motion->board;
    if (board->port.inputs != NULL)
        read_pins(io, board, true);
    if ((io->inputs & INPUT(EMERGENCY_STOP)) != 0) {
        io->was_stopped = true;
        io->stopped_us = board->now_us;
        motion->heartbeat->jog_blocked = true; /* a key that is held then must be let go first */
        ctl_motion_emergency_stop(motion);
    }
    motion->torque_limited = (io->inputs & INPUT(TORQUE_LIMIT)) != 0;
    const uint32_t enable = 1u << CTL_OUTPUT_BIT_DRIVE_ENABLE;
    const uint32_t others = io->outputs & ~enable;
    const uint32_t enabled = drives_enabled(io, motion) ? enable : tried(io, motion) & enable;
    put_outputs(io, board, others | enabled);
}

bool ctl_io_drive_alarm(const ctl_io* io)
{
    return (io->inputs & INPUT(DRIVE_ALARM)) != 0;
}

bool ctl_io_emergency_stop(const ctl_io* io, const ctl_board* board)
{
    return io->was_stopped && board->now_us - io->stopped_us < STOP_HOLD_US;
}

/* The ripple of an encoder's line moves no lead: a change below a 512th of full speed is none. */
static uint32_t switch_speed(ctl_switch_speed* last, const ctl_ramp* ramp)
{
    if (!ramp->led)
        return ctl_ramp_share(ramp, 1u << CTL_SWITCH_SPEED_BITS);
    const uint32_t off =
        ramp->speed > last->ramp_speed ? ramp->speed - last->ramp_speed : last->ramp_speed - ramp->speed;
    if (ramp->full == last->ramp_full && off <= ramp->full / LED_SPEED_STEPS)
        return last->speed;
    *last = (ctl_switch_speed){ctl_ramp_share(ramp, 1u << CTL_SWITCH_SPEED_BITS), ramp->full, ramp->speed};
    return last->speed;
}

/* The cycle of a cutter's film, of any other program's master. Film that waits for a product has no speed. */
static ctl_switch_cycle switch_cycle(const ctl_motion* motion, ctl_switch_speed* last)
{
    const uint32_t speed = switch_speed(last, &motion->ramp);
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

/* A slice that begins a run or a program has much else to do: the next one makes up for it. */
static uint32_t switch_levels(ctl_io* io, const ctl_motion* motion)
{
    if (motion->begins)
        return io->switch_levels;
    const bool follows = ctl_motion_in_cycle(motion) && ctl_switches_serve(ctl_active_bank(motion->banks));
    const ctl_switch_cycle cycle = follows ? switch_cycle(motion, &io->switch_speed) : (ctl_switch_cycle){0};
    io->switch_levels = ctl_switches_slice(&io->switches, motion->board, follows ? &cycle : NULL);
    return io->switch_levels;
}

void ctl_io_slice(ctl_io* io, const ctl_motion* motion)
{
    const uint32_t switches = switch_levels(io, motion);
    const uint32_t enable = io->outputs & 1u << CTL_OUTPUT_BIT_DRIVE_ENABLE;
    const uint32_t line = ctl_motion_follows(motion) ? 1u << CTL_OUTPUT_BIT_LINE_MAY_RUN : 0u;
    put_outputs(io, motion->board, enable | line | switches | io->tower | io->around | tried(io, motion));
}

static int64_t infeed_um(const ctl_board* board, int64_t fine)
{
    const int64_t pitch_um = ctl_parameter32(board, CTL_REG_PARAMETER_FLIGHT_PITCH);
    const int64_t flight = (int64_t)ctl_parameter32(board, CTL_REG_PARAMETER_FLIGHT_PULSES) * CTL_FINE;
    return fine / flight * pitch_um + fine % flight * pitch_um / flight;
}

static void put(uint16_t* registers, uint32_t address, uint16_t value)
{
    registers[address - CTL_REG_IO_AVAILABLE] = value;
}

void ctl_io_registers(const ctl_io* io, const ctl_motion* motion, uint16_t* registers)
{
    const ctl_board* board = motion->board;
    const ctl_packer* packer = motion->packer;
    uint32_t available = board->config.kept_positions;
    memset(registers, 0, CTL_GROUP_IO * sizeof registers[0]);
    if (board->port.inputs != NULL)
        available |= 1u << CTL_IO_BIT_INPUTS;
    if (board->port.outputs != NULL)
        available |= 1u << CTL_IO_BIT_OUTPUTS;
    put(registers, CTL_REG_IO_INPUTS, io->inputs);
    put(registers, CTL_REG_IO_OUTPUTS, (uint16_t)(io->outputs & 0xFFFFu));
    put(registers, CTL_REG_IO_MORE_OUTPUTS, (uint16_t)(io->outputs >> 16u));
    if (board->port.reverse != NULL)
        available |= 1u << CTL_IO_BIT_REVERSAL;
    if (board->port.torque != NULL) {
        available |= 1u << CTL_IO_BIT_TORQUE;
        put(registers, CTL_REG_IO_TORQUE, ctl_saturated16(board->port.torque(board->port.context)));
        put(registers, CTL_REG_IO_TORQUE_ANGLE, ctl_motion_master_angle(motion));
    }
    if (ctl_packer_active(packer)) {
        available |= 1u << CTL_IO_BIT_INFEED;
        const int64_t position = infeed_um(board, packer->infeed_actual);
        const int64_t error = infeed_um(board, packer->infeed_sent * CTL_FINE - packer->infeed_actual);
        ctl_put32(&registers[CTL_REG_IO_INFEED_POSITION - CTL_REG_IO_AVAILABLE],
                  (uint32_t)((uint64_t)position & 0xFFFFFFFFu));
        put(registers, CTL_REG_IO_INFEED_FOLLOWING_ERROR, ctl_saturated16(error));
    }
    put(registers, CTL_REG_IO_AVAILABLE, (uint16_t)available);
}
