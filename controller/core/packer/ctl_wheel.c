/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_wheel.h"

#include "ctl_registers.h"

/* So many prints in a row off their place, none of them at it: the wheel stands, or all but. */
#define PRINTS_IN_ROW 4u
/* So many marks that did not come, while prints were seen elsewhere. */
#define MISSING_IN_ROW 2u
/* A product farther from its place than so many times the usual is no sign of where the places are, but so
 * many in a row that agree are at new places. */
#define STRAY_TIMES 4
#define STRAYS_IN_ROW 4u
/* No product moves the places as if it were farther off than this. */
#define USED_TIMES 2
/* The usual distance is the median: it grows by this part of itself with each product that is farther off,
 * and falls with each that is nearer. Parts of a flight: as it begins, and its limits. */
#define USUAL_SHARE 8
#define USUAL_FIRST 128
#define USUAL_MIN 512
#define USUAL_MAX 32
/* The places follow the products by these parts of what they are off, and their drift, critically damped: the
 * more of them have been seen, the less. */
typedef struct {
    uint32_t products;
    int64_t place;
    int64_t drift;
} follow_share;
static const follow_share shares[] = {{8u, 2, 12}, {24u, 4, 28}, {UINT32_MAX, 8, 120}};
#define PLACES_SURE 2u

static int64_t size_of(int64_t value)
{
    return value < 0 ? -value : value;
}

static void forget_flights(ctl_wheel* wheel)
{
    wheel->usual = 0;
    wheel->placed = 0;
    wheel->drift = 0;
}

void ctl_wheel_switch(ctl_wheel* wheel, bool on)
{
    wheel->on = on;
    forget_flights(wheel);
}

/* Goes on from `at`, where the ratio is another one; returns true then. */
static bool set_gear(ctl_gear* gear, ctl_wheel_ratio ratio, int64_t counts, int64_t at, int64_t* from)
{
    if (gear->numerator == ratio.numerator && gear->denominator == ratio.denominator &&
        at == *from + ctl_gear_ticks(gear, counts, 0))
        return false;
    ctl_gear_set(gear, ratio.numerator, ratio.denominator, counts);
    *from = at;
    return true;
}

void ctl_wheel_set(ctl_wheel* wheel, ctl_wheel_ratio film, ctl_wheel_ratio infeed, int64_t film_at,
                   int64_t infeed_at)
{
    (void)set_gear(&wheel->film, film, wheel->counts, film_at, &wheel->film_from);
    if (set_gear(&wheel->infeed, infeed, wheel->counts, infeed_at, &wheel->infeed_from))
        forget_flights(wheel);
    wheel->slips = false;
    wheel->doubtful = false;
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

static int64_t within(int64_t value, int64_t limit)
{
    return value > limit ? limit : value < -limit ? -limit : value;
}

/* The flights begin at this product. */
static int64_t place_anew(ctl_wheel* wheel, int64_t off, int64_t flight)
{
    wheel->strays = 0;
    wheel->placed = 0;
    wheel->usual = flight / USUAL_FIRST;
    return off;
}

/* Returns true when it is far off its place; so many in a row may agree. */
static bool is_stray(ctl_wheel* wheel, int64_t off)
{
    const int64_t limit = wheel->usual * STRAY_TIMES;
    if (size_of(off) <= limit) {
        wheel->strays = 0;
        return false;
    }
    const bool agrees = wheel->strays != 0 && size_of(off - wheel->stray) <= limit;
    wheel->strays = agrees ? wheel->strays + 1u : 1u;
    wheel->stray = off;
    return true;
}

static void follow_usual(ctl_wheel* wheel, int64_t off, int64_t flight)
{
    const int64_t step = wheel->usual / USUAL_SHARE;
    wheel->usual += size_of(off) > wheel->usual ? step : -step;
    if (wheel->usual < flight / USUAL_MIN)
        wheel->usual = flight / USUAL_MIN;
    if (wheel->usual > flight / USUAL_MAX)
        wheel->usual = flight / USUAL_MAX;
}

static int64_t follow_product(ctl_wheel* wheel, int64_t off)
{
    const follow_share* share = shares;
    while (wheel->placed >= share->products)
        ++share;
    const int64_t used = within(off, wheel->usual * USED_TIMES);
    wheel->placed += 1;
    wheel->drift += used / share->drift;
    return used / share->place;
}

ctl_wheel_step ctl_wheel_find_flights(ctl_wheel* wheel, int64_t off, int64_t flight)
{
    ctl_wheel_step step = {0, 0};
    if (wheel->usual == 0) {
        step.found = place_anew(wheel, off, flight);
    } else if (!is_stray(wheel, off)) {
        step.found = follow_product(wheel, off);
        step.drift = wheel->drift;
    } else if (wheel->strays > STRAYS_IN_ROW) {
        step.found = place_anew(wheel, off, flight);
    } else {
        step.drift = wheel->drift;
    }
    follow_usual(wheel, off, flight);
    wheel->infeed_from -= step.found + step.drift;
    return step;
}

bool ctl_wheel_is_placed(const ctl_wheel* wheel)
{
    return wheel->usual == 0 || wheel->placed >= PLACES_SURE;
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
