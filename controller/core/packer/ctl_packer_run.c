/* SPDX-License-Identifier: Apache-2.0 */
/* A packing machine's line while it runs: gates, the plan of each cut, sensors, cuts. */
#include "packer/ctl_packer.h"

#include "base/ctl_words.h"

#include <stddef.h>

#define LIMITED_IN_ROW 5u
/* A planned cut is shifted again in no less than this part of a cycle. */
#define SHORTEST_ROOM 10u
/* It is shifted again for a change of another master's speed by this part of full speed. */
#define SPEED_STEPS 32u
/* It starts or stops where it would change by this part in a cycle. */
#define RAMP_STEPS 8u
/* A change by less than this part is taken for a ripple. */
#define RIPPLE_STEPS 50u
#define MEAN_CUTS 4u
#define MISPLACED_UM 70
#define SQUARE_BITS 20u

/* Command of the film motor at the next cut when nothing is corrected; asked behind a sealing window or, with
 * the knife standing, up to a cycle before the window. */
static int64_t uncorrected(const ctl_packer* packer)
{
    const int64_t next = ctl_packer_cycle_length(packer);
    return packer->film.start + packer->film.shift + packer->film.length +
           (int64_t)((uint64_t)next * packer->cut / packer->cycle);
}

int64_t ctl_packer_lag(const ctl_packer* packer, uint32_t speed, const ctl_ramp* ramp)
{
    return packer->lag * (int64_t)speed / (int64_t)ramp->full;
}

/* What another master's speed is off the one that the next cut was planned for. */
static uint32_t speed_off(const ctl_packer* packer, const ctl_ramp* ramp)
{
    return ramp->top > packer->top ? ramp->top - packer->top : packer->top - ramp->top;
}

static bool has_other_speed(const ctl_packer* packer, const ctl_ramp* ramp)
{
    return ramp->led && speed_off(packer, ramp) > ramp->full / SPEED_STEPS;
}

/* Another master starts or stops: by so much in a cycle, its speed changes. */
static bool ramps(const ctl_packer* packer, const ctl_ramp* ramp)
{
    const uint64_t off = ramp->top > packer->top ? ramp->top - packer->top : packer->top - ramp->top;
    return has_other_speed(packer, ramp) &&
           off * packer->cycle > (uint64_t)ramp->full / RAMP_STEPS * packer->since;
}

/* A ripple is another one at the cut: what it is about is planned for, the mean of the last cuts. */
static uint32_t planned_top(const ctl_packer* packer, const ctl_ramp* ramp)
{
    if (speed_off(packer, ramp) > ramp->full / RIPPLE_STEPS)
        return ramp->top;
    return packer->top / MEAN_CUTS * (MEAN_CUTS - 1u) + ramp->top / MEAN_CUTS;
}

/* The speed of another master `way` ticks ahead: where it ramps, it goes on to do so evenly. */
static uint32_t top_ahead(const ctl_packer* packer, const ctl_ramp* ramp, uint32_t way)
{
    if (packer->since == 0 || !ramps(packer, ramp))
        return planned_top(packer, ramp);
    const int64_t square = (int64_t)((uint64_t)ramp->top * ramp->top);
    const int64_t before = (int64_t)((uint64_t)packer->top * packer->top);
    const int64_t gained = (square - before) / (1 << SQUARE_BITS) * way / packer->since * (1 << SQUARE_BITS);
    if (gained <= -square)
        return 0;
    return ctl_square_root((uint64_t)(square + (gained < square ? gained : square)));
}

/* Drives lag in proportion to the speed, and not all by the same time: the lag at a cut that is `way` ticks
 * ahead. */
static int64_t lag_ahead(const ctl_packer* packer, const ctl_drive* drive, uint32_t way)
{
    const ctl_ramp* ramp = drive->ramp;
    ctl_ramp led;
    if (ramp->led) {
        led = *ramp;
        led.top = top_ahead(packer, ramp, way);
        ramp = &led;
    }
    if (!drive->running && drive->end_ticks <= way) /* a cut of the next run, which sees to its lag */
        return 0;
    uint32_t speed = drive->running ? ctl_ramp_speed_after(ramp, way) : ramp->speed;
    if (drive->end_ticks != CTL_DRIVE_NO_END) {
        const uint64_t before_end = drive->end_ticks > way ? drive->end_ticks - way : 0;
        const uint32_t slower = ctl_ramp_speed_before(ramp, before_end, drive->end_speed);
        speed = slower < speed ? slower : speed;
    }
    return ctl_packer_lag(packer, speed, ramp);
}

static void learn_lag(ctl_packer* packer, int64_t lag, const ctl_ramp* ramp)
{
    if (lag > packer->bag / 4 || lag < -packer->bag / 4 || ramp->speed < ramp->full / 4u)
        return;
    packer->lag = lag * (int64_t)ramp->full / (int64_t)ramp->speed;
    packer->lag_known = true;
}

static void raise_alarm(ctl_packer* packer, uint32_t bit)
{
    packer->alarms = (uint16_t)(packer->alarms | 1u << bit);
}

/* Returns the shift of the film by which the next cut, `wanted` away from its mark, meets it, within limits.
 */
static int64_t allowed_shift(ctl_packer* packer, const ctl_drive* drive, const ctl_mark* mark, int64_t wanted)
{
    const int64_t length = mark->pitch - packer->bag;
    ctl_phase_mode mode = CTL_PHASE_LIMITED;
    if (packer->marks.state == CTL_MARK_STATE_ALIGNING) {
        if (ctl_phase_reaches(&packer->settings.phase, wanted, length))
            packer->marks.state = CTL_MARK_STATE_TRACKING;
        else
            mode = drive->changes ? CTL_PHASE_FAST_AND_SHORT : CTL_PHASE_FAST;
    }
    const int64_t shift = ctl_phase_allow(&packer->phase, &packer->settings.phase, mode, wanted, length);
    if (packer->phase.limited_in_row >= LIMITED_IN_ROW)
        raise_alarm(packer, CTL_WARNING_BIT_CORRECTION_AT_LIMIT);
    return shift;
}

static void note_speed(ctl_packer* packer, const ctl_ramp* ramp)
{
    packer->top = planned_top(packer, ramp);
    packer->since = 0;
}

/* Behind a sealing window: where the film's next cut is to be, and the correction that brings it there. */
static void plan_cut(ctl_packer* packer, const ctl_drive* drive)
{
    packer->planned = true;
    packer->busy = true;
    ctl_packer_follow_marks(packer);
    ctl_marks_drop(&packer->marks, ctl_feed_position(&packer->film) - packer->bag / 2);
    const int64_t even = uncorrected(packer);
    packer->next.lag = lag_ahead(packer, drive, packer->cycle - packer->film.phase + packer->cut);
    note_speed(packer, drive->ramp);
    const ctl_mark* mark =
        packer->marks.state == CTL_MARK_STATE_OFF || packer->marks.state == CTL_MARK_STATE_SEARCHING
            ? NULL
            : ctl_marks_near(&packer->marks, even + packer->next.lag, packer->bag / 2);
    const int32_t place_um = ctl_knives_next_um(&packer->knives, packer->board);
    const int64_t place = place_um == 0 ? 0 : ctl_packer_film(packer, place_um);
    int64_t shift = 0;
    ctl_phase_none(&packer->phase);
    if (mark != NULL)
        shift = allowed_shift(packer, drive, mark, mark->at - packer->next.lag - even - place);
    else if (place != packer->knives.in_film)
        shift = ctl_phase_allow(&packer->phase, &packer->settings.phase, CTL_PHASE_LIMITED,
                                packer->knives.in_film - place, 0);
    packer->knives.in_film = mark != NULL ? place : packer->knives.in_film - shift;
    packer->next.command = even;
    packer->next.tracked = mark != NULL && packer->marks.state == CTL_MARK_STATE_TRACKING;
    packer->next.seen = mark != NULL && mark->seen;
    const uint64_t before_end = packer->cycle - packer->release;
    if (shift != 0) /* over before a change of program: its half of the way has half the room */
        ctl_phase_move(&packer->film, &packer->next.command, shift,
                       before_end + (drive->changes ? 0u : packer->engage));
}

/* A stop or a change of program was decided on, or is no longer: the planned cut meets its mark at another
 * speed, and so with another lag. Left as it is where the way to its sealing window is short. */
static void plan_again(ctl_packer* packer, const ctl_drive* drive)
{
    const uint32_t phase = packer->film.phase;
    const bool behind = packer->planned && phase >= packer->release;
    if (!packer->next.tracked || (!behind && phase >= packer->engage))
        return;
    const uint32_t way = behind ? packer->cycle - phase + packer->cut : packer->cut - phase;
    const uint32_t to_window = behind ? packer->cycle - phase + packer->engage : packer->engage - phase;
    const uint32_t room = behind && drive->changes ? to_window - packer->engage : to_window;
    if (room < packer->cycle / SHORTEST_ROOM)
        return;
    const int64_t lag = lag_ahead(packer, drive, way);
    note_speed(packer, drive->ramp);
    if (lag != packer->next.lag)
        ctl_phase_move(&packer->film, &packer->next.command, packer->next.lag - lag, room);
    packer->next.lag = lag;
}

static void count_skip(ctl_packer* packer)
{
    const bool too_long = packer->products.longest + 2 * packer->settings.clearance > packer->bag;
    packer->skipped += 1;
    packer->skips_in_row += 1;
    packer->skips_in_run += 1;
    packer->last_skip = too_long ? CTL_SKIP_CAUSE_PRODUCT_TOO_LONG : CTL_SKIP_CAUSE_PRODUCT_ACROSS;
    if (packer->skips_in_run >= ctl_parameter16(packer->board, CTL_REG_PARAMETER_SKIP_LIMIT))
        raise_alarm(packer, CTL_WARNING_BIT_TOO_MANY_SKIPS);
}

/* Returns true while the film is threaded up: no cut could be at its mark, or a product that nobody has seen
 * is in its path. */
static bool threads_up(ctl_packer* packer)
{
    const bool sees_products = ctl_parameter16(packer->board, CTL_REG_PARAMETER_ANTI_CUT) != 0;
    const bool knows = packer->products.known && packer->next.command >= packer->products.known_from;
    const bool follows = packer->planned && packer->next.tracked && (knows || !sees_products);
    if (follows || !ctl_packer_tracks(packer))
        packer->threading = false;
    return packer->threading;
}

/* Returns true when a product is in the path of the next cut, or a change of program needs the knife open. */
static bool knife_must_wait(ctl_packer* packer, const ctl_drive* drive)
{
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
        cut = uncorrected(packer);
        const bool aligning = packer->marks.state == CTL_MARK_STATE_ALIGNING;
        clearance += ctl_phase_max(&packer->settings.phase, aligning ? CTL_PHASE_FAST : CTL_PHASE_LIMITED);
    }
    if (!ctl_products_across(&packer->products, cut + packer->next.lag, clearance))
        return false;
    count_skip(packer);
    return true;
}

void ctl_packer_ask_first_cut(ctl_packer* packer)
{
    if (packer->threading) {
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
    if (ctl_parameter16(packer->board, CTL_REG_PARAMETER_EMPTY_BAG) == 0)
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
            plan_cut(packer, drive);
        if (ctl_gate_asks(&packer->knife_gate))
            ctl_gate_answer(&packer->knife_gate, knife_must_wait(packer, drive));
        uint32_t part = ctl_gate_piece(&packer->knife_gate);
        const uint32_t end = packer->film.phase < packer->release ? packer->release : packer->cycle;
        if (part > end - packer->film.phase)
            part = end - packer->film.phase;
        if (part > ticks)
            part = ticks;
        knife += ctl_gate_advance(&packer->knife_gate, part);
        ctl_feed_advance(&packer->film, part, ctl_packer_cycle_length(packer));
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
    if (drive->end_ticks != packer->end_ticks || has_other_speed(packer, drive->ramp))
        plan_again(packer, drive);
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
    }
    return knife;
}

static void emit(ctl_packer* packer)
{
    const ctl_port* port = &packer->board->port;
    const int64_t film = ctl_feed_position(&packer->film);
    const int64_t infeed = ctl_feed_position(&packer->infeed);
    if (film != packer->film_at)
        port->feed(port->context, CTL_AXIS_FILM, packer->film_at, film);
    if (infeed != packer->infeed_at)
        port->feed(port->context, CTL_AXIS_INFEED, packer->infeed_at, infeed);
    packer->film_at = film;
    packer->infeed_at = infeed;
    packer->film_sent = ctl_whole_pulses(film);
    packer->infeed_sent = ctl_whole_pulses(infeed);
}

static bool has_alarms(ctl_packer* packer)
{
    if (packer->marks.alarm != 0 && ctl_packer_tracks(packer))
        raise_alarm(packer, packer->marks.alarm);
    if (ctl_parameter16(packer->board, CTL_REG_PARAMETER_ANTI_CUT) != 0 &&
        packer->products.longest + 2 * packer->settings.clearance > packer->bag)
        raise_alarm(packer, CTL_WARNING_BIT_PRODUCT_TOO_LONG);
    if (ctl_products_joined(&packer->products))
        raise_alarm(packer, CTL_WARNING_BIT_PRODUCTS_JOINED);
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

void ctl_packer_on_cut(ctl_packer* packer, int64_t film, const ctl_ramp* ramp)
{
    if (packer->bank == NULL)
        return;
    ctl_last_cut* last = &packer->last_cut;
    const ctl_mark* mark = ctl_marks_near(&packer->marks, film, packer->bag / 2);
    ctl_knives_cut(&packer->knives);
    /* The place of another knife is no lag. */
    const bool lag_was_known = packer->lag_known;
    const bool misplaced = is_misplaced(packer, ramp);
    if ((packer->cut_before || packer->next.tracked) && (packer->knives.last == 0 || !lag_was_known))
        learn_lag(packer, film - packer->next.command, ramp);
    const int64_t mark_before = last->mark_at;
    last->at = film;
    last->mark_at = mark == NULL ? film : mark->at;
    last->pitch = packer->cut_before ? last->mark_at - mark_before : packer->bag;
    last->error = mark == NULL ? 0 : film - mark->at;
    last->tracked = packer->next.tracked;
    last->seen = packer->next.seen;
    last->had_products = ctl_products_cut(&packer->products, film) != 0;
    last->bags = 1u + packer->skips_in_row;
    last->changed = packer->changed && packer->cut_before;
    last->set_um = last->changed ? ctl_packer_um(packer, packer->next.command - last->command)
                                 : (int64_t)last->bags * ctl_bank_bag_um(packer->bank);
    last->burned = packer->burned != 0;
    packer->burned -= packer->burned != 0 ? 1u : 0u;
    last->jammed = packer->jammed != 0;
    packer->jammed -= packer->jammed != 0 ? 1u : 0u;
    last->command = packer->next.command;
    packer->changed = false;
    const bool was_in_register = packer->in_register;
    packer->in_register =
        was_in_register || (packer->next.tracked && lag_was_known) || !ctl_packer_tracks(packer);
    packer->in_register = packer->in_register && !misplaced;
    last->scrap = !was_in_register || !packer->in_register;
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
    return bits;
}

bool ctl_packer_rejects(const ctl_packer* packer)
{
    const uint32_t bad = 1u << CTL_BAG_BIT_PRODUCT_ACROSS | 1u << CTL_BAG_BIT_EMPTY |
                         1u << CTL_BAG_BIT_START_UP | 1u << CTL_BAG_BIT_CHANGE_OVER |
                         1u << CTL_BAG_BIT_BURNED | 1u << CTL_BAG_BIT_JAMMED;
    if (!ctl_packer_active(packer))
        return false;
    return (bag_bits(packer) & bad) != 0 || (ctl_packer_tracks(packer) && !packer->last_cut.tracked);
}

/* Two bags are spoiled; behind the cut the first of them is recorded already. */
void ctl_packer_burn(ctl_packer* packer, bool before_cut)
{
    packer->burned = before_cut ? 2u : 1u;
}

void ctl_packer_spoil(ctl_packer* packer, bool before_cut)
{
    packer->jammed = before_cut ? 2u : 1u;
}

void ctl_packer_on_bag(ctl_packer* packer, uint32_t length_um)
{
    if (packer->bank == NULL)
        return;
    const ctl_last_cut* last = &packer->last_cut;
    const uint32_t flags = (last->bags < 255u ? last->bags : 255u) << 8 | bag_bits(packer);
    packer->bags += 1;
    packer->empty += last->had_products ? 0u : 1u;
    uint16_t* record = &packer->records[CTL_BAG_REGISTERS * (packer->bags % CTL_BAG_RECORDS)];
    record[0] = ctl_saturated16((int64_t)length_um - last->set_um);
    record[1] = ctl_saturated16(ctl_packer_um(packer, last->error));
    record[2] = ctl_saturated16(ctl_packer_um(packer, last->pitch - (int64_t)last->bags * packer->bag));
    record[3] = (uint16_t)flags;
}

int64_t ctl_packer_set_um(const ctl_packer* packer, uint32_t bag_um)
{
    return packer->bank == NULL || packer->last_cut.bags == 0 ? (int64_t)bag_um : packer->last_cut.set_um;
}
