/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_packer.h"

#include "base/ctl_words.h"

#include <stddef.h>
#include <string.h>

#define FULL_CIRCLE 36000u /* 0.01 degrees */
/* The first cut of a changed program is shifted by so much of a bag, in so much of a cycle: as fast as
 * others. */
#define FIRST_SHARE 50
#define FIRST_TIME 5u
#define MAX_TAUGHT 100u

static uint16_t parameter(const ctl_packer* packer, uint32_t address)
{
    return ctl_parameter16(packer->board, address);
}

int64_t ctl_packer_film(const ctl_packer* packer, int64_t um)
{
    const int64_t pulses = ctl_parameter32(packer->board, CTL_REG_PARAMETER_FILM_PULSES);
    return um * pulses * CTL_FINE / ctl_parameter32(packer->board, CTL_REG_PARAMETER_FILM_FEED);
}

int64_t ctl_packer_um(const ctl_packer* packer, int64_t film)
{
    return ctl_feed_um(film, ctl_parameter32(packer->board, CTL_REG_PARAMETER_FILM_FEED),
                       ctl_parameter32(packer->board, CTL_REG_PARAMETER_FILM_PULSES));
}

bool ctl_packer_active(const ctl_packer* packer)
{
    return packer->bank != NULL;
}

bool ctl_packer_has_other_lengths(const ctl_packer* packer)
{
    const int64_t flight =
        (int64_t)ctl_parameter32(packer->board, CTL_REG_PARAMETER_FLIGHT_PULSES) * CTL_FINE;
    return packer->bank != NULL && (packer->flight != flight ||
                                    packer->bag != ctl_packer_film(packer, ctl_bank_bag_um(packer->bank)));
}

uint32_t ctl_packer_revolution(const ctl_packer* packer)
{
    return packer->bank == NULL ? 1u : (uint32_t)ctl_bank_revolution_pulses(packer->bank, 1);
}

uint32_t ctl_packer_ticks_at(const ctl_bank* bank, uint32_t offset)
{
    return (uint32_t)((uint64_t)ctl_bank_cycle_ticks(bank) * bank->registers[offset] / FULL_CIRCLE);
}

bool ctl_packer_drives(const ctl_packer* packer, const ctl_bank* bank)
{
    return packer->board->port.film != NULL && bank != NULL &&
           ctl_bank_kind(bank) == CTL_PROGRAM_KIND_ROTARY_CUTTER;
}

bool ctl_packer_tracks(const ctl_packer* packer)
{
    return parameter(packer, CTL_REG_PARAMETER_MARK_TRACKING) != 0;
}

/* The lag of the film at a cut goes with its speed. */
static void scale_lag(ctl_packer* packer, int64_t bag_before, uint32_t cycle_before)
{
    if (bag_before != 0)
        packer->lag = packer->lag * packer->bag / bag_before * (int64_t)cycle_before / (int64_t)packer->cycle;
}

/* Computes the lengths that are not prepared yet. */
static void take_bank(ctl_packer* packer, const ctl_bank* bank, uint32_t crc)
{
    while (ctl_packer_prepare(packer, bank, crc)) {
    }
    const ctl_packer_lengths* lengths = &packer->lengths;
    const int64_t bag_before = packer->bag;
    const uint32_t cycle_before = packer->cycle;
    packer->bank = bank;
    packer->cycle = lengths->cycle;
    packer->engage = lengths->engage;
    packer->release = lengths->release;
    packer->cut = lengths->cut;
    packer->bag = lengths->bag;
    packer->flight = lengths->flight;
    packer->wheel.per_tick = lengths->per_tick;
    packer->wheel.per_film = lengths->per_film;
    scale_lag(packer, bag_before, cycle_before);
    packer->settings.row = 0;
    packer->settings.ticks = packer->cut;
    packer->cut_pulses = 0;
    ctl_packer_take_settings(packer);
}

void ctl_packer_take_positions(ctl_packer* packer)
{
    const ctl_port* port = &packer->board->port;
    packer->film_actual = port->film(port->context);
    packer->infeed_actual = port->infeed(port->context);
    ctl_past_reset(&packer->film_past, packer->board->now_us, packer->film_actual);
    ctl_past_reset(&packer->infeed_past, packer->board->now_us, packer->infeed_actual);
    packer->film_sent = packer->film_actual / CTL_FINE;
    packer->infeed_sent = packer->infeed_actual / CTL_FINE;
    packer->film_at = packer->film_sent * CTL_FINE;
    packer->infeed_at = packer->infeed_sent * CTL_FINE;
}

void ctl_packer_init(ctl_packer* packer, const ctl_board* board)
{
    memset(packer, 0, sizeof *packer);
    packer->board = board;
    packer->broken_off = true;
    if (packer->board->port.film == NULL)
        return;
    ctl_packer_take_positions(packer);
}

void ctl_packer_break_off(ctl_packer* packer)
{
    packer->broken_off = true;
    packer->cut_known = false;
}

/* The position of the infeed is arbitrary: in the first cycles it is corrected to the nearest product place;
 * at a start only forward. */
static void align_infeed(ctl_packer* packer, int64_t start, bool forward)
{
    packer->product_in_infeed = packer->wheel.on ? 0 : packer->settings.product;
    const int64_t ahead = packer->lengths.ahead + packer->product_in_infeed;
    packer->number = (start + ahead + (forward ? packer->flight - 1 : packer->flight / 2)) / packer->flight;
    ctl_feed_reset(&packer->infeed, packer->cycle, start, packer->flight);
    const int64_t way = packer->number * packer->flight - ahead - start;
    if (way != 0 && !packer->wheel.on)
        ctl_feed_correct(&packer->infeed, way, CTL_INFEED_CYCLES * (uint64_t)packer->cycle);
}

/* It comes before the end of any sealing window, so that it cannot be shifted. */
static void plan_first_cut(ctl_packer* packer)
{
    const ctl_cut cut = {packer->film.start + packer->lengths.way_to_cut, 0, false, false};
    packer->next = cut;
}

void ctl_packer_leave_register(ctl_packer* packer, int64_t bag_before)
{
    packer->in_register = false;
    if (packer->marks.state == CTL_MARK_STATE_TRACKING)
        packer->marks.state = CTL_MARK_STATE_ALIGNING;
    if (bag_before != packer->bag)
        packer->marks.state = CTL_MARK_STATE_OFF;
}

/* Film that somebody else drives has products on it that nobody has seen. */
static bool threads_up(const ctl_packer* packer)
{
    const bool wanted = parameter(packer, CTL_REG_PARAMETER_THREAD_UP) != 0 && ctl_packer_tracks(packer);
    return wanted || packer->wheel.on;
}

static void take_products(ctl_packer* packer)
{
    packer->lengths.products.maximum = packer->products.settings.maximum;
    ctl_products_set(&packer->products, &packer->lengths.products, packer->infeed_actual);
}

/* Knife, film and infeed at the start of a cycle. Film position and tracked marks are kept. */
static void begin_cycle(ctl_packer* packer, const ctl_bank* bank, uint32_t crc)
{
    const int64_t bag_before = packer->bag;
    take_bank(packer, bank, crc);
    packer->master = 0;
    packer->planned = false;
    packer->cut_before = false;
    packer->changed = false;
    packer->skips_in_row = 0;
    packer->threading = packer->threading || packer->broken_off;
    packer->threading = packer->threading && threads_up(packer);
    if (packer->broken_off)
        ctl_knives_reset(&packer->knives, bank->registers[CTL_OFFSET_PROGRAM_KNIVES]);
    packer->broken_off = false;
    ctl_gate_reset(&packer->film_gate, packer->cycle, packer->engage, packer->release);
    ctl_gate_reset(&packer->knife_gate, packer->cycle, packer->engage, packer->release);
    packer->cut_in_film = packer->settings.cut;
    ctl_feed_reset(&packer->film, packer->cycle, packer->film_sent * CTL_FINE, packer->bag);
    align_infeed(packer, packer->infeed_sent * CTL_FINE, true);
    plan_first_cut(packer);
    ctl_packer_leave_register(packer, bag_before);
    take_products(packer);
}

/* The next cut was planned for another speed than that of the run that begins: at standstill the film can be
 * shifted at once, up to the sealing window. */
static void plan_for_start(ctl_packer* packer, const ctl_ramp* ramp)
{
    const uint32_t phase = packer->film.phase;
    if (phase >= packer->engage || packer->knife_gate.state != CTL_GATE_STATE_RUNNING)
        return;
    if (packer->lag == 0 && packer->next.lag == 0)
        return;
    const int64_t lag = ctl_packer_lag(packer, ctl_ramp_speed_after(ramp, packer->cut - phase), ramp);
    ctl_phase_move(&packer->film, &packer->next.command, packer->next.lag - lag, packer->engage - phase);
    packer->next.lag = lag;
}

uint32_t ctl_packer_start_position(const ctl_packer* packer, const ctl_bank* bank)
{
    return packer->broken_off || packer->bank != bank ? 0u : packer->master;
}

void ctl_packer_run(ctl_packer* packer, const ctl_bank* bank, uint32_t crc, const ctl_ramp* ramp)
{
    packer->takes = false;
    packer->alone = false;
    if (!ctl_packer_drives(packer, bank)) {
        packer->bank = NULL;
        return;
    }
    const bool ended_by_limits = (packer->alarms & 1u << CTL_WARNING_BIT_CORRECTION_AT_LIMIT) != 0;
    packer->alarms = 0;
    packer->phase.limited_in_row = 0;
    packer->skips_in_run = 0;
    packer->products.longest = 0;
    if (packer->broken_off || packer->bank != bank)
        begin_cycle(packer, bank, crc);
    else
        ctl_packer_read_settings(packer);
    if (packer->marks.state == CTL_MARK_STATE_TRACKING && ended_by_limits)
        packer->marks.state = CTL_MARK_STATE_ALIGNING;
    ctl_packer_follow_marks(packer);
    plan_for_start(packer, ramp);
    if (packer->film.phase == 0 && packer->knife_gate.state == CTL_GATE_STATE_RUNNING &&
        packer->knife_gate.phase == 0)
        ctl_packer_ask_first_cut(packer);
}

void ctl_packer_begin_by_hand(ctl_packer* packer, const ctl_bank* bank, uint32_t crc)
{
    begin_cycle(packer, bank, crc);
    packer->broken_off = true;
}

/* Plans the first cut of a changed program onto its mark, where that is near enough for the time up to its
 * sealing window. Returns false when it is not. */
static bool plan_onto_mark(ctl_packer* packer, const ctl_ramp* ramp)
{
    if (packer->marks.state != CTL_MARK_STATE_TRACKING || packer->engage < packer->cycle / FIRST_TIME)
        return false;
    const int64_t lag = ctl_packer_lag(packer, ctl_ramp_speed_after(ramp, packer->cut), ramp);
    const ctl_mark* mark = ctl_marks_near(&packer->marks, packer->next.command + lag, packer->bag / 2);
    if (mark == NULL)
        return false;
    const int64_t shift = mark->at - lag - packer->next.command;
    const int64_t limit = packer->bag / FIRST_SHARE;
    if (shift > limit || shift < -limit)
        return false;
    ctl_phase_move(&packer->film, &packer->next.command, shift, packer->engage);
    packer->next = (ctl_cut){packer->next.command, lag, true, mark->seen};
    return true;
}

/* The film goes on as it is. Bags of another length have other marks; those of the same length may be cut at
 * another angle, so that the cuts have to be brought onto their marks again. */
void ctl_packer_change_bank(ctl_packer* packer, const ctl_bank* bank, uint32_t crc, const ctl_ramp* ramp)
{
    if (packer->bank == NULL)
        return;
    const int64_t bag_before = packer->bag;
    const int64_t film = ctl_feed_position(&packer->film);
    take_bank(packer, bank, crc);
    if (packer->wheel.on)
        ctl_packer_go_on_with_wheel(packer, bank);
    packer->planned = false;
    packer->changed = true;
    packer->top = ramp->top;
    packer->top_then = ramp->top;
    packer->since = 0;
    packer->phase.limited_in_row = 0;
    const bool is_open = packer->knife_gate.state == CTL_GATE_STATE_STANDING;
    ctl_gate_reset(&packer->film_gate, packer->cycle, packer->engage, packer->release);
    ctl_gate_reset(&packer->knife_gate, packer->cycle, packer->engage, packer->release);
    if (is_open)
        ctl_gate_stand(&packer->knife_gate);
    ctl_feed_reset(&packer->film, packer->cycle, film, packer->bag);
    align_infeed(packer, ctl_feed_position(&packer->infeed), false);
    plan_first_cut(packer);
    if (bag_before != packer->bag || !plan_onto_mark(packer, ramp))
        ctl_packer_leave_register(packer, bag_before);
    take_products(packer);
    ctl_packer_follow_marks(packer);
}

void ctl_packer_follow_marks(ctl_packer* packer)
{
    ctl_marks* marks = &packer->marks;
    const ctl_mark_settings* settings = &packer->settings.marks;
    if (!ctl_packer_tracks(packer)) {
        marks->state = CTL_MARK_STATE_OFF;
        marks->settings = *settings;
    } else if (marks->state == CTL_MARK_STATE_OFF || marks->alarm != 0) {
        ctl_marks_search(marks, settings, packer->film_actual);
    } else {
        /* The cuts come to another distance as they are planned. */
        const int64_t distance = ctl_marks_follow(marks) ? marks->settings.distance : settings->distance;
        marks->settings = *settings;
        marks->settings.distance = distance;
    }
}

static bool in_step(const ctl_packer* packer)
{
    return packer->film_gate.state == CTL_GATE_STATE_RUNNING && packer->master == packer->film.phase &&
           packer->film.phase == packer->knife_gate.phase &&
           (packer->knife_gate.state == CTL_GATE_STATE_RUNNING ||
            packer->knife_gate.state == CTL_GATE_STATE_STANDING);
}

bool ctl_packer_correcting(const ctl_packer* packer)
{
    return packer->bank != NULL && (packer->film.span != 0 || packer->infeed.span != 0);
}

bool ctl_packer_must_open(const ctl_packer* packer)
{
    if (packer->bank == NULL || parameter(packer, CTL_REG_PARAMETER_ANTI_CUT) == 0)
        return false;
    /* The cut may still be shifted onto its mark. */
    const int64_t clearance = packer->settings.clearance + packer->bag / FIRST_SHARE;
    const int64_t cut = ctl_feed_position(&packer->film) + packer->lengths.way_to_cut;
    return ctl_products_across(&packer->products, cut, clearance);
}

bool ctl_packer_may_change(const ctl_packer* packer, bool standstill)
{
    if (packer->bank == NULL)
        return true;
    if (!in_step(packer))
        return false;
    if (standstill)
        return true;
    /* A correction across the boundary would end there with a step of the film's or the infeed's speed. */
    return !ctl_packer_correcting(packer) &&
           (packer->knife_gate.state == CTL_GATE_STATE_STANDING || !ctl_packer_must_open(packer));
}

uint32_t ctl_packer_position(const ctl_packer* packer)
{
    return packer->master;
}

uint16_t ctl_packer_teach(ctl_packer* packer, const ctl_bank* bank, uint16_t marks)
{
    if (!ctl_packer_drives(packer, bank))
        return CTL_REFUSAL_NO_ACTIVE_PROGRAM;
    if (marks < 2u || marks > MAX_TAUGHT)
        return CTL_REFUSAL_BAD_ARGUMENT;
    ctl_marks_teach(&packer->marks, marks);
    return CTL_REFUSAL_NONE;
}
