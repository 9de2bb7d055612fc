/* SPDX-License-Identifier: Apache-2.0 */
#include "ctl_core.h"

#include "link/ctl_command.h"
#include "link/ctl_function.h"
#include "link/ctl_map.h"
#include "link/ctl_status.h"
#include "link/ctl_work.h"
#include "motion/ctl_start.h"

#include <string.h>

#define US_PER_S 1000000u
/* Adding one byte to the CRC-16 takes a quarter of the work on a register. */
#define ANSWER_BYTES_PER_REGISTER 4u
#define NAME_BYTES ((CTL_BANK_HEADER_REGISTERS - CTL_OFFSET_PROGRAM_RECIPE_NAME) * sizeof(uint16_t))

enum { TRIMS = CTL_REG_HAND_CUT - CTL_REG_HAND_SPEED };

_Static_assert(TRIMS + 2u * CTL_TRIMS == CTL_GROUP_HAND, "the next program's trims follow those of this one");

/* Tells each part which others it works with. */
static void compose(ctl_core* core)
{
    core->board.parameter = core->written.parameter;
    core->board.master = core->written.master;
    core->board.hand = core->written.hand;
    core->board.signal = core->written.signal;
    core->motion.board = &core->board;
    core->motion.banks = &core->banks;
    core->motion.transfer = &core->transfer;
    core->motion.packer = &core->packer;
    core->motion.master = &core->master;
    core->motion.heartbeat = &core->heartbeat;
    core->motion.inputs = &core->io.inputs;
}

void ctl_init(ctl_core* core, const ctl_config* config, const ctl_port* port, uint64_t now_us)
{
    memset(core, 0, sizeof *core);
    core->board.config = *config;
    if (core->board.config.slice_us == 0)
        core->board.config.slice_us = CTL_SLICE_US;
    core->board.port = *port;
    core->board.started_us = now_us;
    core->board.now_us = now_us;
    compose(core);
    ctl_map_init(core);
    uint16_t* const saved[CTL_FLASH_GROUPS] = {core->written.parameter, core->written.master,
                                               &core->written.hand[TRIMS], core->written.signal};
    ctl_flash_load(&core->flash, &core->board, &core->banks, saved);
    ctl_kept_trims_restore(&core->kept_trims, &core->board, &core->banks, &core->written.hand[TRIMS]);
    ctl_machine_data_init(core);
    core->trims_of = core->banks.generation;
    ctl_master_init(&core->master, &core->board);
    ctl_packer_init(&core->packer, &core->board);
    ctl_order_init(&core->order, &core->board);
    ctl_motion_init(&core->motion);
    ctl_io_init(&core->io, &core->board);
    ctl_actions_init(&core->actions, &core->io);
}

/* A program of another name brings its own trims; a change of the same one leaves the operator's. */
static void change_trims(ctl_core* core)
{
    const ctl_banks* banks = &core->banks;
    uint16_t* trims = &core->written.hand[TRIMS];
    const uint16_t* name = &ctl_active_bank(banks)->registers[CTL_OFFSET_PROGRAM_RECIPE_NAME];
    const uint16_t* before = &banks->bank[banks->active ^ 1u].registers[CTL_OFFSET_PROGRAM_RECIPE_NAME];
    core->trims_of = banks->generation;
    if (memcmp(name, before, NAME_BYTES) != 0) {
        memcpy(trims, &trims[CTL_TRIMS], CTL_TRIMS * sizeof *trims);
        core->board.parameter_writes += 1;
        ctl_kept_trims_follow(&core->kept_trims, &core->board, banks, trims);
    }
    memset(&trims[CTL_TRIMS], 0, CTL_TRIMS * sizeof *trims);
}

/* The newest bag of the order is past the jaws, and the run ends with the order. */
static void follow_order(ctl_core* core)
{
    ctl_order* order = &core->order;
    const bool stops = ctl_order_stops(order);
    if (ctl_order_waits(order) && ctl_motion_jaws_are_open(&core->motion))
        ctl_order_pass(order, &core->packer);
    if (stops)
        ctl_motion_end_after(&core->motion, ctl_order_left(order));
}

static bool shows_order(ctl_core* core, bool runs)
{
    ctl_order_sign* sign = &core->order_sign;
    const bool complete = core->order.state == CTL_ORDER_STATE_COMPLETE;
    sign->shown = complete && (sign->shown || sign->counted) && !(runs && !sign->ran);
    sign->counted = core->order.state == CTL_ORDER_STATE_ACTIVE;
    sign->ran = runs;
    return sign->shown;
}

/* The conditions of the light tower, bits CTL_SIGNAL_BIT_... */
static uint32_t conditions(ctl_core* core)
{
    const uint32_t notices = 1u << CTL_WARNING_BIT_NOT_HOMED | 1u << CTL_WARNING_BIT_FLASH_SLOT_INVALID |
                             1u << CTL_WARNING_BIT_CLOCK_NOT_SET;
    const ctl_motion* motion = &core->motion;
    const uint32_t warnings = ctl_warnings(core) & ~notices;
    const bool runs = ctl_motion_in_cycle(motion);
    const bool waits =
        core->packer.film_gate.state == CTL_GATE_STATE_STANDING || (motion->follows && !core->master.leads);
    uint32_t bits = shows_order(core, runs) ? 1u << CTL_SIGNAL_BIT_ORDER : 0u;
    if (motion->state == CTL_STATE_FAULT || ctl_io_emergency_stop(&core->io, &core->board))
        bits |= 1u << CTL_SIGNAL_BIT_FAULT;
    if (warnings != 0)
        bits |= 1u << CTL_SIGNAL_BIT_WARNING;
    if (runs)
        bits |= waits ? 1u << CTL_SIGNAL_BIT_WAITING : 1u << CTL_SIGNAL_BIT_RUNNING;
    if (motion->state == CTL_STATE_READY && (bits & ~(1u << CTL_SIGNAL_BIT_ORDER)) == 0)
        bits |= 1u << CTL_SIGNAL_BIT_READY;
    return bits;
}

static void switch_signal(ctl_core* core, uint32_t bit, bool on)
{
    const uint32_t others = core->io.around & ~(1u << bit);
    core->io.around = on ? others | 1u << bit : others;
}

/* A product that comes now is packed: the run goes on, and nothing has come to the place at the eye. */
static bool wants_product(const ctl_core* core)
{
    const ctl_motion* motion = &core->motion;
    return motion->state == CTL_STATE_RUNNING && ctl_packer_active(&core->packer) &&
           (!motion->follows || core->master.leads) &&
           ctl_products_place_free(&core->packer.products, core->packer.infeed_actual);
}

/* The lengths of the program that may begin next are ready before it does; returns true where there was
 * something to do. */
static bool prepares_program(ctl_core* core)
{
    const bool changes = ctl_motion_in_cycle(&core->motion);
    const ctl_bank* bank = changes ? ctl_staged_bank(&core->banks) : ctl_active_bank(&core->banks);
    const uint32_t crc = changes ? core->transfer.staged_crc : core->banks.active_crc;
    return crc != 0 && ctl_packer_drives(&core->packer, bank) && ctl_packer_prepare(&core->packer, bank, crc);
}

/* Does what can wait for a slice without much other work. */
static void use_quiet_slice(ctl_core* core)
{
    if (prepares_program(core))
        return;
    if (!ctl_coder_is_aimed(&core->coder, &core->packer)) {
        ctl_coder_aim(&core->coder, &core->packer);
    } else if (ctl_tower_is_due(&core->tower, &core->board)) {
        ctl_tower_slice(&core->tower, &core->board, conditions(core));
        core->io.tower = core->tower.levels;
        core->asks_start = true;
    } else if (core->asks_start) {
        core->asks_start = false;
        ctl_machine_data(core);
        switch_signal(core, CTL_OUTPUT_BIT_READY, ctl_may_start(&core->motion, &core->io));
        switch_signal(core, CTL_OUTPUT_BIT_REQUEST, wants_product(core));
    } else if (core->order.state == CTL_ORDER_STATE_ACTIVE) {
        follow_order(core);
    }
}

/* One slice of so many timer ticks: every part in its turn, and what one of them wants of another. */
static void slice(ctl_core* core, uint32_t ticks)
{
    ctl_motion* motion = &core->motion;
    const uint16_t keys = core->written.exchange[CTL_REG_EXCHANGE_JOG - CTL_REG_EXCHANGE_TAG];
    ctl_io_begin(&core->io, motion);
    if (ctl_io_drive_alarm(&core->io) && (motion->fault & 1u << CTL_FAULT_BIT_DRIVE_ALARM) == 0)
        ctl_motion_fault(motion, CTL_FAULT_BIT_DRIVE_ALARM);
    if (core->io.inputs != core->actions.inputs)
        ctl_actions_slice(&core->actions, &core->io, motion);
    if (core->actions.wants != CTL_COMMAND_NONE)
        ctl_command_button(core);
    if (ctl_heartbeat_slice(&core->heartbeat, &core->board, keys))
        ctl_motion_stop_unattended(motion);
    ctl_master_slice(&core->master);
    if (core->packer.wheel.on)
        ctl_wheel_read(&core->packer.wheel, core->master.tracker.count, core->master.reversed);
    ctl_motion_slice(motion, ticks);
    const bool quiet = !core->packer.busy;
    if (quiet)
        use_quiet_slice(core);
    if (core->trims_of != core->banks.generation)
        change_trims(core);
    if (ctl_packer_slice(&core->packer, ctl_motion_in_cycle(motion)) && motion->state == CTL_STATE_RUNNING)
        (void)ctl_motion_stop_at_cycle_end(motion);
    if (core->banks.has_active && motion->state != CTL_STATE_FAULT && !ctl_banks_check(&core->banks))
        ctl_motion_fault(motion, CTL_FAULT_BIT_ACTIVE_TABLE_DAMAGED);
    if ((core->packer.bank != NULL || core->coder.on) && ctl_coder_slice(&core->coder, &core->packer))
        core->io.around ^= 1u << CTL_OUTPUT_BIT_CODER_PULSE;
    ctl_io_slice(&core->io, motion);
    if (quiet)
        ctl_work_slice(core);
}

/* Timer ticks of so many microseconds; what is left of one is kept. */
static uint32_t ticks_of(ctl_core* core, uint32_t slice_us)
{
    const uint64_t sum = (uint64_t)slice_us * core->board.config.timer_clock_hz + core->tick_rest;
    /* The shorter division where it does: up to half a millisecond at 8 MHz. */
    const uint32_t ticks = sum <= UINT32_MAX ? (uint32_t)sum / US_PER_S : (uint32_t)(sum / US_PER_S);
    core->tick_rest = (uint32_t)(sum - (uint64_t)ticks * US_PER_S);
    return ticks;
}

void ctl_tick(ctl_core* core, uint64_t now_us)
{
    ctl_board* board = &core->board;
    while (board->now_us < now_us) {
        const uint64_t left = now_us - board->now_us;
        const uint32_t slice_us = left < board->config.slice_us ? (uint32_t)left : board->config.slice_us;
        board->now_us += slice_us;
        board->catching_up = board->now_us < now_us;
        board->slice_ticks = ticks_of(core, slice_us);
        slice(core, board->slice_ticks);
        board->tick += board->slice_ticks;
    }
    ctl_receive_silence(core, now_us);
}

void ctl_receive_silence(ctl_core* core, uint64_t now_us)
{
    ctl_rtu* rtu = &core->rtu;
    const size_t size = ctl_rtu_request(rtu, &core->board.config, now_us);
    if (size != 0)
        ctl_rtu_answer(rtu, ctl_function(core, &rtu->request[1], size, &rtu->answer[1]));
}

void ctl_receive(ctl_core* core, const uint8_t* bytes, size_t size, uint64_t now_us)
{
    ctl_receive_silence(core, now_us);
    ctl_rtu_receive(&core->rtu, bytes, size, now_us);
}

void ctl_receive_error(ctl_core* core, uint64_t now_us)
{
    ctl_receive_silence(core, now_us);
    ctl_rtu_receive_error(&core->rtu, now_us);
}

size_t ctl_take_answer(ctl_core* core, uint8_t* bytes)
{
    const uint32_t registers = core->board.config.work_registers;
    return ctl_rtu_take_answer(&core->rtu, bytes,
                               registers == 0 ? CTL_FRAME_BYTES : ANSWER_BYTES_PER_REGISTER * registers);
}

void ctl_on_cut(ctl_core* core, int64_t film)
{
    /* A knife that a jam stops, or that returns to its place, does not follow the film. */
    const ctl_motion* motion = &core->motion;
    const bool follows = ctl_motion_in_cycle(motion) && !motion->park.jam;
    if (!core->packer.alone)
        ctl_master_on_cut(&core->master, core->packer.cut);
    ctl_packer_on_cut(&core->packer, film, follows ? &motion->ramp : NULL);
    if (!core->packer.no_bag)
        ctl_switches_bag(&core->io.switches, ctl_packer_bag_class(&core->packer) != CTL_BAG_GOOD);
}

void ctl_on_bag_cut(ctl_core* core, uint32_t length_um)
{
    if (!ctl_packer_on_bag(&core->packer, length_um))
        return;
    core->bags.length_um = length_um;
    core->bags.count += 1;
    ctl_order_bag(&core->order, &core->packer);
}
