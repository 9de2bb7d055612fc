/* SPDX-License-Identifier: Apache-2.0 */
/* A packing machine's line while it runs: gates, sensors, cuts. */
#include "packer/ctl_packer.h"

#include "base/ctl_words.h"

#include <stddef.h>

#define MISPLACED_UM 70
#define SLOWEST_SHARE 32u
#define LAG_CUTS 4
#define MAX_LENGTHS 127u /* in the record of a bag */

void ctl_packer_raise(ctl_packer* packer, uint32_t bit)
{
    packer->alarms = (uint16_t)(packer->alarms | 1u << bit);
}

/* Learns the lag at full speed. Another master may be slow for good, and its ripple must not lead the cuts.
 */
static void learn_lag(ctl_packer* packer, int64_t lag, const ctl_ramp* ramp)
{
    const uint32_t slowest = ramp->full / (ramp->led && !packer->lag_known ? SLOWEST_SHARE : 4u);
    if (lag > packer->bag / 4 || lag < -packer->bag / 4 || ramp->speed < slowest)
        return;
    const int64_t seen = lag * (int64_t)ramp->full / (int64_t)ramp->speed;
    packer->lag += (seen - packer->lag) / (ramp->led && packer->lag_known ? LAG_CUTS : 1);
    packer->lag_known = true;
}

static void count_skip(ctl_packer* packer)
{
    const bool too_long = packer->products.longest + 2 * packer->settings.clearance > packer->bag;
    packer->skipped += 1;
    packer->skips_in_row += 1;
    packer->skips_in_run += 1;
    packer->last_skip = too_long ? CTL_SKIP_CAUSE_PRODUCT_TOO_LONG : CTL_SKIP_CAUSE_PRODUCT_ACROSS;
    if (packer->skips_in_run >= ctl_parameter16(packer->board, CTL_REG_PARAMETER_SKIP_LIMIT))
        ctl_packer_raise(packer, CTL_WARNING_BIT_TOO_MANY_SKIPS);
}

/* Returns true while the film is threaded up: no cut could be at its mark, or a product that nobody has seen
 * is in its path. */
static bool threads_up(ctl_packer* packer)
{
    const bool sees_products = ctl_parameter16(packer->board, CTL_REG_PARAMETER_ANTI_CUT) != 0;
    const bool placed = !packer->wheel.on || ctl_wheel_is_placed(&packer->wheel);
    const bool knows =
        placed && packer->products.known && packer->next.command >= packer->products.known_from;
    const bool marked = packer->next.tracked || !ctl_packer_tracks(packer);
    if (!packer->wheel.on && !ctl_packer_tracks(packer))
        packer->threading = false;
    if (packer->planned && marked && (knows || !sees_products))
        packer->threading = false;
    return packer->threading;
}

/* Returns true when a product is in the path of the next cut, or a change of program needs the knife open. */
static bool knife_must_wait(ctl_packer* packer, const ctl_drive* drive)
{
    if (packer->wheel.on && packer->wheel.opens)
        return true;
    if (packer->threading && threads_up(packer))
        return true;
    if (drive->opens) {
        count_skip(packer);
        return true;
    }
    if (ctl_parameter16(packer->board, CTL_REG_PARAMETER_ANTI_CUT) == 0)
        return false;
    int64_t clearance = packer->settings.clearance;
    int64_t cut = packer->next.command;
    if (!packer->planned) { /* it may still be shifted */
        cut = ctl_packer_uncorrected(packer);
        const bool aligning = packer->marks.state == CTL_MARK_STATE_ALIGNING;
        clearance += ctl_phase_max(&packer->settings.phase, aligning ? CTL_PHASE_FAST : CTL_PHASE_LIMITED);
        clearance += ctl_packer_next_move(packer);
    }
    if (!ctl_products_across(&packer->products, cut + packer->next.lag, clearance))
        return false;
    count_skip(packer);
    return true;
}

void ctl_packer_ask_first_cut(ctl_packer* packer)
{
    if (packer->threading || (packer->wheel.on && packer->wheel.opens)) {
        ctl_gate_stand(&packer->knife_gate);
        return;
    }
    if (ctl_parameter16(packer->board, CTL_REG_PARAMETER_ANTI_CUT) == 0 ||
        !ctl_products_across(&packer->products, packer->next.command + packer->next.lag,
                             packer->settings.clearance))
        return;
    count_skip(packer);
    ctl_gate_stand(&packer->knife_gate);
}

/* Returns true when the next product is missing: the film waits for the one after it. */
static bool film_must_wait(ctl_packer* packer)
{
    if (ctl_parameter16(packer->board, CTL_REG_PARAMETER_EMPTY_BAG) == 0 || packer->wheel.on)
        return false;
    const int64_t seen =
        ctl_past_before(&packer->infeed_past, packer->infeed_actual, ctl_packer_eye_dead_us(packer));
    if (!ctl_products_missing(&packer->products, packer->number + 1, seen))
        return false;
    packer->saved_um += ctl_bank_bag_um(packer->bank);
    packer->last_skip = CTL_SKIP_CAUSE_NO_PRODUCT;
    return true;
}

/* Advances the film by `ticks` of its phase; returns the ticks of the knife. */
static uint32_t move_film(ctl_packer* packer, const ctl_drive* drive, uint32_t ticks)
{
    uint32_t knife = 0;
    while (ticks != 0) {
        if (packer->film.phase >= packer->release && !packer->planned)
            ctl_packer_plan_cut(packer, drive);
        if (ctl_gate_asks(&packer->knife_gate))
            ctl_gate_answer(&packer->knife_gate, knife_must_wait(packer, drive));
        uint32_t part = ctl_gate_piece(&packer->knife_gate);
        const uint32_t end = packer->film.phase < packer->release ? packer->release : packer->cycle;
        if (part > end - packer->film.phase)
            part = end - packer->film.phase;
        if (part > ticks)
            part = ticks;
        knife += ctl_gate_advance(&packer->knife_gate, part);
        ctl_feed_advance(&packer->film, part, packer->bag);
        if (packer->film.phase == 0)
            packer->planned = false;
        ticks -= part;
    }
    return knife;
}

uint32_t ctl_packer_advance(ctl_packer* packer, const ctl_drive* drive, uint32_t* ticks)
{
    const uint32_t to_end = packer->cycle - packer->master;
    uint32_t left = *ticks < to_end ? *ticks : to_end;
    uint32_t knife = 0;
    *ticks = left;
    packer->since += left;
    if (drive->end_ticks != packer->end_ticks || ctl_packer_sees_other_speed(packer, drive->ramp))
        ctl_packer_plan_again(packer, drive);
    packer->end_ticks = drive->end_ticks;
    if (drive->end_ticks != CTL_DRIVE_NO_END)
        packer->end_ticks -= left < drive->end_ticks ? left : drive->end_ticks;
    while (left != 0) {
        if (ctl_gate_asks(&packer->film_gate))
            ctl_gate_answer(&packer->film_gate, film_must_wait(packer));
        const uint32_t piece = ctl_gate_piece(&packer->film_gate);
        const uint32_t part = piece < left ? piece : left;
        knife += move_film(packer, drive, ctl_gate_advance(&packer->film_gate, part));
        left -= part;
    }
    packer->master += *ticks;
    ctl_feed_advance(&packer->infeed, *ticks, packer->flight);
    if (packer->master == packer->cycle) {
        packer->master = 0;
        packer->number += 1;
        if (!drive->changes) /* the change begins at a cycle without a correction */
            ctl_packer_move_products(packer);
    }
    return knife;
}

static void emit(ctl_packer* packer)
{
    const ctl_port* port = &packer->board->port;
    const int64_t film = ctl_feed_position(&packer->film);
    const int64_t infeed = ctl_feed_position(&packer->infeed);
    if (film != packer->film_at && !packer->wheel.on)
        port->feed(port->context, CTL_AXIS_FILM, packer->film_at, film);
    if (infeed != packer->infeed_at && !packer->wheel.on)
        port->feed(port->context, CTL_AXIS_INFEED, packer->infeed_at, infeed);
    packer->film_at = film;
    packer->infeed_at = infeed;
    packer->film_sent = ctl_whole_pulses(film);
    packer->infeed_sent = ctl_whole_pulses(infeed);
}

static bool has_alarms(ctl_packer* packer)
{
    if (packer->marks.alarm != 0 && ctl_packer_tracks(packer))
        ctl_packer_raise(packer, packer->marks.alarm);
    if (ctl_parameter16(packer->board, CTL_REG_PARAMETER_ANTI_CUT) != 0 &&
        packer->products.longest + 2 * packer->settings.clearance > packer->bag)
        ctl_packer_raise(packer, CTL_WARNING_BIT_PRODUCT_TOO_LONG);
    if (ctl_products_joined(&packer->products))
        ctl_packer_raise(packer, CTL_WARNING_BIT_PRODUCTS_JOINED);
    return packer->alarms != 0;
}

bool ctl_packer_slice(ctl_packer* packer, bool in_cycle)
{
    if (packer->bank == NULL)
        return false;
    emit(packer);
    ctl_packer_read_sensors(packer);
    if (!packer->busy && !ctl_packer_refresh_settings(packer)) {
        if (packer->eye_edges.waits)
            ctl_eye_edges_work(&packer->eye_edges, packer->flight);
        else
            ctl_edges_work(&packer->edges, ctl_parameter32(packer->board, CTL_REG_PARAMETER_FILM_FEED),
                           ctl_parameter32(packer->board, CTL_REG_PARAMETER_FILM_PULSES));
    }
    packer->busy = false;
    return in_cycle && has_alarms(packer);
}

/* Returns true when another master's speed has changed so much since the cut was planned that it missed its
 * place by MISPLACED_UM. */
static bool is_misplaced(const ctl_packer* packer, const ctl_ramp* ramp)
{
    if (!ramp->led || !packer->next.tracked)
        return false;
    const int64_t off = ctl_packer_lag(packer, ramp->speed, ramp) - packer->next.lag;
    return (off < 0 ? -off : off) > ctl_packer_film(packer, MISPLACED_UM);
}

/* Bag lengths since the last cut: on film that somebody else drives those that have passed. */
static uint32_t bags_since(const ctl_packer* packer, int64_t film)
{
    const int64_t passed = (film - packer->last_cut.at + packer->bag / 2) / packer->bag;
    if (!packer->wheel.on || packer->last_cut.bags == 0)
        return 1u + packer->skips_in_row;
    return passed < 1 ? 1u : (uint32_t)passed;
}

void ctl_packer_on_cut(ctl_packer* packer, int64_t film, const ctl_ramp* ramp)
{
    packer->no_bag = packer->alone && packer->bank == NULL;
    if (packer->bank == NULL)
        return;
    if (packer->wheel.on)
        film = ctl_wheel_film_at(&packer->wheel, film);
    if (packer->alone) {
        ctl_packer_on_cut_alone(packer, film);
        return;
    }
    ctl_last_cut* last = &packer->last_cut;
    const ctl_mark* mark = ctl_marks_near(&packer->marks, film, packer->bag / 2);
    ctl_knives_cut(&packer->knives);
    /* The place of another knife is no lag. */
    const bool lag_was_known = packer->lag_known;
    /* Nor does a knife that stops on somebody else's film say anything of it, or one that does not follow it.
     */
    const bool left = packer->wheel.on && (ramp == NULL || !ramp->led);
    const bool misplaced = left || (ramp != NULL && is_misplaced(packer, ramp));
    if (ramp != NULL && !left && (packer->cut_before || packer->next.tracked) &&
        (packer->knives.last == 0 || !lag_was_known))
        learn_lag(packer, film - packer->next.command, ramp);
    const uint32_t bags = bags_since(packer, film);
    const int64_t mark_before = last->mark_at;
    ctl_packer_note_bag(packer, film);
    last->at = film;
    last->mark_at = mark == NULL ? film : mark->at;
    last->pitch = packer->cut_before ? last->mark_at - mark_before : packer->bag;
    last->error = mark == NULL ? 0 : film - mark->at;
    last->tracked = packer->next.tracked;
    last->seen = packer->next.seen;
    last->had_products = ctl_products_cut(&packer->products, film) != 0;
    last->bags = bags;
    last->changed = packer->changed && packer->cut_before;
    last->set_um = last->changed ? ctl_packer_um(packer, packer->next.command - last->command)
                                 : (int64_t)last->bags * ctl_packer_bag_um(packer);
    last->burned = packer->burned != 0;
    packer->burned -= packer->burned != 0 ? 1u : 0u;
    last->jammed = packer->jammed != 0;
    packer->jammed -= packer->jammed != 0 ? 1u : 0u;
    last->taken = packer->takes;
    packer->takes = false;
    last->command = packer->next.command;
    packer->changed = false;
    const bool was_in_register = packer->in_register;
    packer->in_register =
        was_in_register || (packer->next.tracked && lag_was_known) || !ctl_packer_tracks(packer);
    packer->in_register = packer->in_register && !misplaced;
    last->scrap = !was_in_register || !packer->in_register || packer->scrapped;
    packer->scrapped = false;
    packer->skips_in_row = 0;
    packer->skips_in_run = 0;
    packer->cut_before = true;
}

/* Returns the bits CTL_BAG_BIT_... of the bag that ended with the last cut. */
static uint32_t bag_bits(const ctl_packer* packer)
{
    const ctl_last_cut* last = &packer->last_cut;
    uint32_t bits = 0;
    if (last->tracked)
        bits |= 1u << CTL_BAG_BIT_TRACKED;
    if (last->tracked && !last->seen)
        bits |= 1u << CTL_BAG_BIT_MARK_MISSED;
    if (last->bags > 1u)
        bits |= 1u << CTL_BAG_BIT_PRODUCT_ACROSS;
    if (!last->had_products)
        bits |= 1u << CTL_BAG_BIT_EMPTY;
    if (last->scrap)
        bits |= 1u << CTL_BAG_BIT_START_UP;
    if (last->changed)
        bits |= 1u << CTL_BAG_BIT_CHANGE_OVER;
    if (last->burned)
        bits |= 1u << CTL_BAG_BIT_BURNED;
    if (last->jammed)
        bits |= 1u << CTL_BAG_BIT_JAMMED;
    if (last->taken)
        bits |= 1u << CTL_BAG_BIT_TAKEN;
    return bits;
}

ctl_bag_class ctl_packer_bag_class(const ctl_packer* packer)
{
    const uint32_t bad = 1u << CTL_BAG_BIT_PRODUCT_ACROSS | 1u << CTL_BAG_BIT_START_UP |
                         1u << CTL_BAG_BIT_CHANGE_OVER | 1u << CTL_BAG_BIT_BURNED | 1u << CTL_BAG_BIT_JAMMED |
                         1u << CTL_BAG_BIT_TAKEN;
    if (!ctl_packer_active(packer))
        return CTL_BAG_GOOD;
    const uint32_t bits = bag_bits(packer);
    if ((bits & bad) != 0 || (ctl_packer_tracks(packer) && !packer->last_cut.tracked))
        return CTL_BAG_REJECTED;
    return (bits & 1u << CTL_BAG_BIT_EMPTY) != 0 ? CTL_BAG_EMPTY : CTL_BAG_GOOD;
}

/* Two bags are spoiled; behind the cut the first of them is recorded already. */
void ctl_packer_burn(ctl_packer* packer, bool before_cut)
{
    packer->burned = before_cut ? 2u : 1u;
    packer->spoiled_behind = packer->spoiled_behind || !before_cut;
}

void ctl_packer_spoil(ctl_packer* packer, bool before_cut)
{
    packer->jammed = before_cut ? 2u : 1u;
    packer->spoiled_behind = packer->spoiled_behind || !before_cut;
}

bool ctl_packer_on_bag(ctl_packer* packer, uint32_t length_um)
{
    if (packer->bank == NULL || packer->no_bag)
        return !packer->no_bag;
    const ctl_last_cut* last = &packer->last_cut;
    const uint32_t flags = (last->bags < MAX_LENGTHS ? last->bags : MAX_LENGTHS) << 8 | bag_bits(packer);
    packer->spoiled_behind = false;
    packer->bags += 1;
    packer->empty += last->had_products ? 0u : 1u;
    uint16_t* record = &packer->records[CTL_BAG_REGISTERS * (packer->bags % CTL_BAG_RECORDS)];
    record[0] = ctl_saturated16((int64_t)length_um - last->set_um);
    record[1] = ctl_saturated16(ctl_packer_um(packer, last->error));
    record[2] = ctl_saturated16(ctl_packer_um(packer, last->pitch - (int64_t)last->bags * packer->bag));
    record[3] = (uint16_t)flags;
    return true;
}

int64_t ctl_packer_set_um(const ctl_packer* packer, uint32_t bag_um)
{
    return packer->bank == NULL || packer->last_cut.bags == 0 ? (int64_t)bag_um : packer->last_cut.set_um;
}
