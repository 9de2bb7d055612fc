/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_wheel.h"

#include "ctl_registers.h"

/* So many prints in a row off their place, none of them at it: the wheel stands, or all but. */
#define PRINTS_IN_ROW 4u
/* So many marks that did not come, while prints were seen elsewhere. */
#define MISSING_IN_ROW 2u
/* A product farther from its place than this part of a flight says nothing about the flights, but so many in
 * a row are at new places. */
#define STRAY_SHARE 8
#define STRAYS_IN_ROW 4u
/* The places follow the products by these parts of their error, so that one of them does not move them far.
 */
#define OFF_SHARE 4
#define FIRST_PRODUCTS 8u
#define FIRST_SOONER 2 /* times */
#define MOST_SHARE 64  /* of a flight, of that error */
#define DRIFT_SHARE 24

static int64_t size_of(int64_t value)
{
    return value < 0 ? -value : value;
}

void ctl_wheel_switch(ctl_wheel* wheel, bool on)
{
    wheel->on = on;
    wheel->strays = STRAYS_IN_ROW;
    wheel->drift = 0;
}

/* Goes on from `at`, where the ratio is another one. */
static void set_gear(ctl_gear* gear, ctl_wheel_ratio ratio, int64_t counts, int64_t at, int64_t* from)
{
    if (gear->numerator == ratio.numerator && gear->denominator == ratio.denominator &&
        at == *from + ctl_gear_ticks(gear, counts, 0))
        return;
    ctl_gear_set(gear, ratio.numerator, ratio.denominator, counts);
    *from = at;
}

void ctl_wheel_set(ctl_wheel* wheel, ctl_wheel_ratio film, ctl_wheel_ratio infeed, int64_t film_at,
                   int64_t infeed_at)
{
    set_gear(&wheel->film, film, wheel->counts, film_at, &wheel->film_from);
    set_gear(&wheel->infeed, infeed, wheel->counts, infeed_at, &wheel->infeed_from);
    wheel->slips = false;
    wheel->doubtful = false;
}

void ctl_wheel_set_bag(ctl_wheel* wheel, int64_t bag, uint32_t cycle)
{
    wheel->per_tick = (bag << CTL_WHEEL_FINE) / cycle;
    wheel->per_film = ((int64_t)cycle << CTL_WHEEL_FINE) / bag;
}

static int64_t forward(const ctl_wheel* wheel, int64_t counts)
{
    return wheel->reversed ? -counts : counts;
}

int64_t ctl_wheel_film(ctl_wheel* wheel)
{
    return wheel->film_from + ctl_gear_ticks(&wheel->film, wheel->counts, 0);
}

int64_t ctl_wheel_infeed(ctl_wheel* wheel)
{
    return wheel->infeed_from + ctl_gear_ticks(&wheel->infeed, wheel->counts, 0);
}

int64_t ctl_wheel_film_at(ctl_wheel* wheel, int64_t counts)
{
    return wheel->film_from + ctl_gear_ticks(&wheel->film, forward(wheel, counts), 0);
}

int64_t ctl_wheel_infeed_at(ctl_wheel* wheel, int64_t counts)
{
    return wheel->infeed_from + ctl_gear_ticks(&wheel->infeed, forward(wheel, counts), 0);
}

/* Film and infeed stay where they are. */
static void reverse(ctl_wheel* wheel, int64_t counts)
{
    wheel->film_from = ctl_wheel_film(wheel);
    wheel->infeed_from = ctl_wheel_infeed(wheel);
    wheel->reversed = !wheel->reversed;
    ctl_gear_set(&wheel->film, wheel->film.numerator, wheel->film.denominator, counts);
    ctl_gear_set(&wheel->infeed, wheel->infeed.numerator, wheel->infeed.denominator, counts);
}

void ctl_wheel_read(ctl_wheel* wheel, int64_t counts, bool reversed)
{
    if (reversed != wheel->reversed)
        reverse(wheel, counts);
    wheel->counts = counts;
}

int64_t ctl_wheel_find_flights(ctl_wheel* wheel, int64_t off, int64_t flight)
{
    int64_t by = off;
    if (wheel->strays < STRAYS_IN_ROW && size_of(off) > flight / STRAY_SHARE) {
        wheel->strays += 1;
        by = wheel->drift;
    } else if (wheel->strays < STRAYS_IN_ROW) {
        const int64_t most = flight / MOST_SHARE;
        const int64_t limited = off > most ? most : off < -most ? -most : off;
        const int64_t sooner = wheel->placed < FIRST_PRODUCTS ? FIRST_SOONER : 1;
        wheel->drift += limited * sooner / DRIFT_SHARE;
        wheel->strays = 0;
        wheel->placed += 1;
        by = limited * sooner / OFF_SHARE + wheel->drift;
    } else {
        wheel->drift = 0;
        wheel->strays = 0;
        wheel->placed = 0;
    }
    wheel->infeed_from -= by;
    return by;
}

/* How far a print is from the place of a mark, by those before it that were at theirs. */
static int64_t from_place(const ctl_wheel* wheel, int64_t at)
{
    const int64_t pitch = wheel->good_pitch;
    const int64_t rest = (at - wheel->good_at) % pitch;
    if (2 * size_of(rest) <= pitch)
        return rest;
    return rest < 0 ? rest + pitch : rest - pitch;
}

static bool same_sign(int64_t value, int64_t other)
{
    return (value < 0) == (other < 0);
}

/* A mark off its place may be another print: then the mark itself comes still, or the next one is at its
 * place. */
static void take_mark(ctl_wheel* wheel, const ctl_marks* marks)
{
    const int64_t off = from_place(wheel, marks->last);
    const bool is_off = size_of(off) > wheel->limit;
    wheel->slips = wheel->slips || (is_off && wheel->doubtful && same_sign(off, -wheel->slip));
    wheel->slip = -off;
    wheel->doubtful = is_off;
    wheel->doubtful_to = marks->last - off + marks->settings.window;
    if (is_off)
        return;
    wheel->off_in_row = 0;
    wheel->good_at = marks->last;
    wheel->good_pitch = marks->pitch;
}

/* Another print, or a mark that is farther off than the window of marks; or a second one where the wheel has
 * not moved on. */
static void take_print(ctl_wheel* wheel, const ctl_marks* marks, int64_t film)
{
    const bool moved = 2 * (film - wheel->good_at) > wheel->good_pitch;
    const bool is_off = !moved || size_of(from_place(wheel, marks->expected + marks->off)) > wheel->limit;
    wheel->off_in_row = is_off ? wheel->off_in_row + 1u : 0u;
}

static void follow_marks(ctl_wheel* wheel, const ctl_marks* marks)
{
    wheel->last = marks->last;
    wheel->unexpected = marks->unexpected;
    wheel->prints = marks->unexpected;
    wheel->good_at = marks->last;
    wheel->good_pitch = marks->pitch;
    wheel->doubtful = false;
    wheel->off_in_row = 0;
}

/* On film without other prints a mark off its place is none: it is sure as soon as no other comes. */
void ctl_wheel_watch(ctl_wheel* wheel, const ctl_marks* marks, int64_t film)
{
    if (marks->state != CTL_MARK_STATE_TRACKING || wheel->limit == 0) {
        follow_marks(wheel, marks);
        return;
    }
    if (marks->unexpected != wheel->prints)
        take_print(wheel, marks, film);
    if (marks->last != wheel->last && marks->missing_in_row == 0)
        take_mark(wheel, marks);
    wheel->prints = marks->unexpected;
    wheel->last = marks->last;
    const bool stands = wheel->off_in_row >= PRINTS_IN_ROW;
    const bool misses = marks->missing_in_row >= MISSING_IN_ROW && wheel->off_in_row >= MISSING_IN_ROW;
    const bool sure = wheel->doubtful && marks->unexpected == wheel->unexpected && film > wheel->doubtful_to;
    wheel->slips = wheel->slips || stands || misses || sure;
}
