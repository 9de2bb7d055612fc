/* SPDX-License-Identifier: Apache-2.0 */
/* A packing machine's knife on film that somebody else drives. */
#include "packer/ctl_packer.h"

#include "base/ctl_words.h"

#include <stddef.h>

#define UM_PER_UNIT 10 /* of the wheel's slip limit */
#define JOIN_SHARE 50  /* of a bag: film that has passed since the last cut was planned */

static uint32_t master_setting(const ctl_packer* packer, uint32_t address)
{
    return ctl_get32(&packer->board->master[address - CTL_REG_MASTER_SOURCE]);
}

/* Edges that were latched before say nothing: their film has passed since. */
static void drop_edges(const ctl_port* port)
{
    int64_t at = 0;
    bool covered = false;
    while (port->mark(port->context, &at, &covered)) {
    }
    while (port->eye(port->context, &at, &covered)) {
    }
}

/* Film and infeed are driven by somebody else from now on, or no longer. */
static void switch_wheel(ctl_packer* packer, bool on)
{
    const ctl_port* port = &packer->board->port;
    port->latch_master(port->context, on);
    drop_edges(port);
    ctl_wheel_switch(&packer->wheel, on);
    if (!on)
        ctl_packer_take_positions(packer);
    ctl_packer_break_off(packer);
    packer->marks.state = CTL_MARK_STATE_OFF;
}

static void set_wheel(ctl_packer* packer, const ctl_bank* bank, int64_t film_at, int64_t infeed_at)
{
    const uint32_t counts = master_setting(packer, CTL_REG_MASTER_COUNTS);
    const uint64_t revolution_um = master_setting(packer, CTL_REG_MASTER_REVOLUTION);
    const uint64_t flight = ctl_parameter32(packer->board, CTL_REG_PARAMETER_FLIGHT_PULSES);
    const uint64_t pulses = ctl_parameter32(packer->board, CTL_REG_PARAMETER_FILM_PULSES);
    const uint64_t feed_um = ctl_parameter32(packer->board, CTL_REG_PARAMETER_FILM_FEED);
    const ctl_wheel_ratio film = {CTL_FINE * pulses * revolution_um, feed_um * counts};
    const ctl_wheel_ratio infeed = {CTL_FINE * flight * revolution_um,
                                    (uint64_t)ctl_bank_bag_um(bank) * counts};
    ctl_wheel_set(&packer->wheel, film, infeed, film_at, infeed_at);
    packer->wheel.limit = ctl_packer_film(
        packer,
        (int64_t)packer->board->master[CTL_REG_MASTER_SLIP_LIMIT - CTL_REG_MASTER_SOURCE] * UM_PER_UNIT);
}

void ctl_packer_go_on_with_wheel(ctl_packer* packer, const ctl_bank* bank)
{
    set_wheel(packer, bank, ctl_wheel_film(&packer->wheel), ctl_wheel_infeed(&packer->wheel));
}

void ctl_packer_take_wheel(ctl_packer* packer, const ctl_bank* bank, bool on)
{
    const bool was_on = packer->wheel.on;
    if (on != was_on)
        switch_wheel(packer, on);
    if (on && was_on)
        ctl_packer_go_on_with_wheel(packer, bank);
    else if (on)
        set_wheel(packer, bank, packer->film_actual, packer->infeed_actual);
}

/* Film that the place of the line is ahead of where it belongs. */
static int64_t beyond(ctl_packer* packer, int64_t ahead)
{
    ctl_wheel* wheel = &packer->wheel;
    const int64_t belongs = ctl_wheel_film(wheel) + ahead * wheel->per_tick / (1 << CTL_WHEEL_FINE);
    return ctl_feed_position(&packer->film) - belongs;
}

/* Film has passed uncut: the next bag is as long as it and that before. */
void ctl_packer_join_film(ctl_packer* packer, int64_t ahead)
{
    const int64_t way = -beyond(packer, ahead);
    packer->film.start += way;
    packer->next.command += way;
    packer->film_at = ctl_feed_position(&packer->film);
    packer->film_sent = ctl_whole_pulses(packer->film_at);
    if (way > packer->bag / JOIN_SHARE || -way > packer->bag / JOIN_SHARE)
        ctl_packer_leave_register(packer, packer->bag);
}

int64_t ctl_packer_wheel_shift(ctl_packer* packer, int64_t ahead)
{
    return -beyond(packer, ahead) * packer->wheel.per_film / (1 << CTL_WHEEL_FINE);
}

void ctl_packer_shift_line(ctl_packer* packer, int64_t ticks)
{
    const int64_t film = ticks * packer->wheel.per_tick / (1 << CTL_WHEEL_FINE);
    packer->film.start -= film;
    packer->next.command -= film;
}
