/* SPDX-License-Identifier: Apache-2.0 */
/* The plan of a packing machine's next cut: at its mark, within limits, with the lag that the drives will
 * have there. */
#include "packer/ctl_packer.h"

#include <stddef.h>

#define LIMITED_IN_ROW 5u
/* A planned cut is shifted again in no less than this part of a cycle. */
#define SHORTEST_ROOM 10u
/* It is shifted again for a change of another master's speed by this part of full speed. */
#define SPEED_STEPS 64u
/* It starts or stops where it would change by this part in a cycle. */
#define RAMP_STEPS 8u
#define MEAN_CUTS 4u
#define SQUARE_BITS 20u

int64_t ctl_packer_uncorrected(const ctl_packer* packer)
{
    return packer->film.start + packer->film.shift + packer->film.length +
           (int64_t)((uint64_t)packer->bag * packer->cut / packer->cycle);
}

int64_t ctl_packer_lag(const ctl_packer* packer, uint32_t speed, const ctl_ramp* ramp)
{
    return packer->lag * (int64_t)speed / (int64_t)ramp->full;
}

/* Returns how far another master's speed is from this one. */
static uint32_t speed_off(const ctl_ramp* ramp, uint32_t top)
{
    return ramp->top > top ? ramp->top - top : top - ramp->top;
}

bool ctl_packer_sees_other_speed(const ctl_packer* packer, const ctl_ramp* ramp)
{
    return ramp->led && speed_off(ramp, packer->top) > ramp->full / SPEED_STEPS;
}

/* Another master starts or stops: by so much in a cycle, its speed changes. */
static bool ramps(const ctl_packer* packer, const ctl_ramp* ramp)
{
    const uint64_t off = speed_off(ramp, packer->top_then);
    return off > ramp->full / SPEED_STEPS &&
           off * packer->cycle > (uint64_t)ramp->full / RAMP_STEPS * packer->since;
}

/* A smaller change is taken for a ripple, which is another one at the cut: what it is about is planned for,
 * the mean of the last cuts. */
static uint32_t planned_top(const ctl_packer* packer, const ctl_ramp* ramp)
{
    if (speed_off(ramp, packer->top) > ramp->full / SPEED_STEPS)
        return ramp->top;
    return packer->top / MEAN_CUTS * (MEAN_CUTS - 1u) + ramp->top / MEAN_CUTS;
}

/* The speed of another master `way` ticks ahead: where it ramps, it goes on to do so evenly. */
static uint32_t top_ahead(const ctl_packer* packer, const ctl_ramp* ramp, uint32_t way)
{
    if (packer->since == 0 || !ramps(packer, ramp))
        return planned_top(packer, ramp);
    const int64_t square = (int64_t)((uint64_t)ramp->top * ramp->top);
    const int64_t before = (int64_t)((uint64_t)packer->top_then * packer->top_then);
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
    uint32_t speed = ramp->speed;
    if (drive->running) {
        speed = ctl_ramp_speed_after(ramp, way);
    } else if (speed < drive->limit) {
        speed = ctl_ramp_speed_after(ramp, way);
        speed = speed < drive->limit ? speed : drive->limit;
    }
    if (drive->end_ticks != CTL_DRIVE_NO_END) {
        const uint64_t before_end = drive->end_ticks > way ? drive->end_ticks - way : 0;
        speed = ctl_ramp_speed_before(ramp, before_end, drive->end_speed, speed);
    }
    return ctl_packer_lag(packer, speed, ramp);
}

/* The film lags differently than at the last cut: that is no slip, but leaves room for one. */
static int64_t lag_shift(const ctl_packer* packer, const ctl_drive* drive, int64_t lag_before)
{
    const ctl_phase_mode fast = drive->changes ? CTL_PHASE_FAST_AND_SHORT : CTL_PHASE_FAST;
    const int64_t limit = ctl_phase_max(&packer->settings.phase, fast) / 2;
    const int64_t shift = lag_before - packer->next.lag;
    return shift > limit ? limit : shift < -limit ? -limit : shift;
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
        ctl_packer_raise(packer, CTL_WARNING_BIT_CORRECTION_AT_LIMIT);
    return shift;
}

static void note_speed(ctl_packer* packer, const ctl_ramp* ramp)
{
    packer->top = planned_top(packer, ramp);
    packer->top_then = ramp->top;
    packer->since = 0;
}

void ctl_packer_plan_cut(ctl_packer* packer, const ctl_drive* drive)
{
    packer->planned = true;
    packer->busy = true;
    ctl_packer_follow_marks(packer);
    const int64_t by_hand = ctl_packer_move_cut(packer) + packer->settings.length;
    ctl_marks_drop(&packer->marks, ctl_feed_position(&packer->film) - packer->bag / 2);
    const int64_t even = ctl_packer_uncorrected(packer);
    const int64_t lag_before = packer->next.lag;
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
    if (mark != NULL) {
        shift = packer->marks.state == CTL_MARK_STATE_TRACKING ? lag_shift(packer, drive, lag_before) : 0;
        shift +=
            allowed_shift(packer, drive, mark, mark->at - packer->next.lag - even - place - by_hand - shift);
    } else if (place != packer->knives.in_film)
        shift = ctl_phase_allow(&packer->phase, &packer->settings.phase, CTL_PHASE_LIMITED,
                                packer->knives.in_film - place, 0);
    packer->knives.in_film = mark != NULL ? place : packer->knives.in_film - shift;
    shift += by_hand;
    packer->next.command = even;
    packer->next.tracked = mark != NULL && packer->marks.state == CTL_MARK_STATE_TRACKING;
    packer->next.seen = mark != NULL && mark->seen;
    const uint64_t before_end = packer->cycle - packer->release;
    if (shift != 0) /* over before a change of program: its half of the way has half the room */
        ctl_phase_move(&packer->film, &packer->next.command, shift,
                       before_end + (drive->changes ? 0u : packer->engage));
}

/* Returns the ticks in which the planned cut can still be shifted, 0: too few; *way becomes those to the cut.
 */
static uint32_t room_to_shift(const ctl_packer* packer, bool changes, uint32_t* way)
{
    const uint32_t phase = packer->film.phase;
    const bool behind = packer->planned && phase >= packer->release;
    if (!behind && phase >= packer->engage)
        return 0;
    *way = behind ? packer->cycle - phase + packer->cut : packer->cut - phase;
    const uint32_t to_window = behind ? packer->cycle - phase + packer->engage : packer->engage - phase;
    const uint32_t room = behind && changes ? to_window - packer->engage : to_window;
    return room < packer->cycle / SHORTEST_ROOM ? 0 : room;
}

bool ctl_packer_takes_other_speed(ctl_packer* packer)
{
    uint32_t way = 0;
    if (ctl_packer_active(packer) && packer->next.tracked && room_to_shift(packer, false, &way) == 0)
        return false;
    packer->end_ticks = 0; /* of no drive: it is planned again */
    return true;
}

void ctl_packer_plan_again(ctl_packer* packer, const ctl_drive* drive)
{
    uint32_t way = 0;
    if (!packer->next.tracked)
        return;
    const uint32_t room = room_to_shift(packer, drive->changes, &way);
    if (room == 0)
        return;
    packer->busy = true;
    const int64_t lag = lag_ahead(packer, drive, way);
    note_speed(packer, drive->ramp);
    if (lag != packer->next.lag)
        ctl_phase_move(&packer->film, &packer->next.command, packer->next.lag - lag, room);
    packer->next.lag = lag;
}
