/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_marks.h"

#include "ctl_registers.h"

#include <stddef.h>

#define GAIN_ONE 1000
/* Searching: this number of consecutive distances that are not a bag length means a wrong film. */
#define MAX_WRONG_GAPS 8u

static int64_t size_of(int64_t value)
{
    return value < 0 ? -value : value;
}

static int64_t limited(int64_t value, int64_t limit)
{
    if (value > limit)
        return limit;
    return value < -limit ? -limit : value;
}

void ctl_marks_search(ctl_marks* marks, const ctl_mark_settings* settings, int64_t film)
{
    marks->settings = *settings;
    marks->state = CTL_MARK_STATE_SEARCHING;
    marks->pitch = settings->nominal;
    marks->error = 0;
    marks->jumped = false;
    marks->has_candidate = false;
    marks->candidate = film;
    marks->wrong_gaps = 0;
    marks->missing_in_row = 0;
    marks->false_in_row = 0;
    marks->alarm = 0;
    marks->first = 0;
    marks->count = 0;
}

const ctl_mark* ctl_marks_waiting(const ctl_marks* marks, uint32_t index)
{
    return &marks->waiting[(marks->first + index) % CTL_WAITING_MARKS];
}

static void push(ctl_marks* marks, int64_t at, int64_t pitch, bool seen)
{
    const ctl_mark mark = {at, pitch, seen};
    if (marks->count == CTL_WAITING_MARKS) {
        marks->first = (marks->first + 1u) % CTL_WAITING_MARKS;
        marks->count -= 1;
    }
    marks->waiting[(marks->first + marks->count) % CTL_WAITING_MARKS] = mark;
    marks->count += 1;
}

static void shift_waiting(ctl_marks* marks, int64_t by)
{
    for (uint32_t i = 0; i < marks->count; ++i)
        marks->waiting[(marks->first + i) % CTL_WAITING_MARKS].at += by;
}

/* Handles two marks one bag length apart: estimates the unseen marks between them and the knife. */
static void found(ctl_marks* marks, int64_t film)
{
    const int64_t cut = film + marks->settings.distance;
    const int64_t back = (cut - film) / marks->pitch;
    const int64_t max_back = (int64_t)CTL_WAITING_MARKS - 1;
    for (int64_t i = back < max_back ? back : max_back; i > 0; --i)
        push(marks, cut - i * marks->pitch, marks->pitch, false);
    push(marks, cut, marks->pitch, true);
    marks->last = film;
    marks->expected = film + marks->pitch;
    marks->missing_in_row = 0;
    marks->false_in_row = 0;
    marks->followed += 1;
    marks->state = CTL_MARK_STATE_ALIGNING;
}

static void search(ctl_marks* marks, int64_t film)
{
    const ctl_mark_settings* settings = &marks->settings;
    const int64_t gap = film - marks->candidate;
    if (marks->has_candidate &&
        size_of(gap - settings->nominal) <= settings->max_difference + settings->window) {
        marks->pitch = settings->nominal + limited(gap - settings->nominal, settings->max_difference);
        found(marks, film);
        return;
    }
    if (marks->has_candidate) {
        marks->unexpected += 1;
        marks->wrong_gaps += 1;
        if (marks->wrong_gaps >= MAX_WRONG_GAPS)
            marks->alarm = CTL_WARNING_BIT_MARK_PITCH_WRONG;
    }
    marks->has_candidate = true;
    marks->candidate = film;
}

/* Handles a false last mark: this one is nearer to the expected position. */
static void take_back(ctl_marks* marks, int64_t film)
{
    const int64_t from = size_of(film - marks->expected_before);
    if (!marks->jumped || marks->count == 0 || from >= size_of(marks->last - marks->expected_before))
        return;
    marks->count -= 1;
    marks->expected = marks->expected_before;
    marks->last = marks->last_before;
    marks->pitch = marks->pitch_before;
    marks->followed -= 1;
    marks->unexpected += 1;
}

/* A print that came a little late is nearer to the mark before the one that is expected now. */
static int64_t from_nearest(const ctl_marks* marks, int64_t film)
{
    const int64_t error = film - marks->expected;
    return error < -marks->pitch / 2 ? error + marks->pitch : error;
}

static uint16_t follow(ctl_marks* marks, int64_t film)
{
    take_back(marks, film);
    marks->off = from_nearest(marks, film);
    const ctl_mark_settings* settings = &marks->settings;
    const int64_t error = film - marks->expected;
    if (size_of(error) > settings->window) {
        marks->unexpected += 1;
        marks->false_in_row += 1;
        return CTL_MARK_VERDICT_OUTSIDE_WINDOW;
    }
    int64_t place = film;
    int64_t pitch = film - marks->last;
    marks->jumped = size_of(error) > settings->jump;
    marks->expected_before = marks->expected;
    marks->last_before = marks->last;
    marks->pitch_before = marks->pitch;
    if (!marks->jumped) {
        const int64_t slip = error * (int64_t)settings->phase_gain / GAIN_ONE;
        shift_waiting(marks, slip);
        place = marks->expected + slip;
        pitch = marks->pitch + error * (int64_t)settings->length_gain / GAIN_ONE;
    }
    marks->error = error;
    marks->last = film;
    marks->pitch = settings->nominal + limited(pitch - settings->nominal, settings->max_difference);
    marks->expected = place + marks->pitch;
    marks->missing_in_row = 0;
    marks->false_in_row = 0;
    marks->followed += 1;
    push(marks, place + settings->distance, pitch, true);
    return CTL_MARK_VERDICT_TAKEN;
}

static void teach(ctl_marks* marks, int64_t film)
{
    ctl_teaching* teaching = &marks->teaching;
    if (teaching->count >= teaching->wanted)
        return;
    if (teaching->count != 0) {
        const int64_t gap = film - teaching->last;
        if (teaching->count == 1u)
            teaching->first_gap = gap;
        const int64_t difference = gap - teaching->first_gap;
        teaching->sum += difference;
        teaching->squares += difference * difference;
    }
    teaching->last = film;
    teaching->count += 1;
}

bool ctl_marks_follow(const ctl_marks* marks)
{
    return marks->state == CTL_MARK_STATE_ALIGNING || marks->state == CTL_MARK_STATE_TRACKING;
}

void ctl_marks_move(ctl_marks* marks, int64_t by)
{
    marks->settings.distance += by;
    shift_waiting(marks, by);
}

/* Missing marks before this print are passed, so that the next one is expected. */
static void arrive(ctl_marks* marks, int64_t film)
{
    ctl_marks_pass(marks, film);
    marks->off = ctl_marks_follow(marks) ? from_nearest(marks, film) : 0;
}

static bool is_masked(const ctl_marks* marks, int64_t film)
{
    const int64_t masking = marks->settings.masking;
    if (masking == 0)
        return false;
    if (marks->state == CTL_MARK_STATE_OFF)
        return marks->teaching.count != 0 && film - marks->teaching.last < masking;
    if (marks->state == CTL_MARK_STATE_SEARCHING)
        return marks->has_candidate && film - marks->candidate < masking;
    /* A print may have been taken for the mark that comes now. */
    if (marks->jumped && size_of(film - marks->expected_before) <= marks->settings.window)
        return false;
    return film - marks->last < masking;
}

uint16_t ctl_marks_see(ctl_marks* marks, int64_t film)
{
    arrive(marks, film);
    if (is_masked(marks, film))
        return CTL_MARK_VERDICT_MASKED;
    teach(marks, film);
    if (marks->state == CTL_MARK_STATE_OFF)
        return CTL_MARK_VERDICT_NOT_USED;
    if (marks->state != CTL_MARK_STATE_SEARCHING)
        return follow(marks, film);
    search(marks, film);
    return CTL_MARK_VERDICT_SEARCHED;
}

uint16_t ctl_marks_reject(ctl_marks* marks, int64_t film, uint16_t verdict)
{
    arrive(marks, film);
    if (marks->state != CTL_MARK_STATE_OFF)
        marks->unexpected += 1;
    return verdict;
}

bool ctl_marks_due(const ctl_marks* marks, int64_t film)
{
    return marks->state == CTL_MARK_STATE_SEARCHING || film - marks->expected > marks->settings.window;
}

void ctl_marks_pass(ctl_marks* marks, int64_t film)
{
    const ctl_mark_settings* settings = &marks->settings;
    if (marks->state == CTL_MARK_STATE_SEARCHING) {
        const int64_t longest = (int64_t)(settings->missing_limit + 1u) * settings->nominal;
        if (film - marks->candidate > longest)
            marks->alarm = CTL_WARNING_BIT_MARKS_LOST;
        return;
    }
    while (marks->state != CTL_MARK_STATE_OFF && film - marks->expected > settings->window) {
        marks->missing += 1;
        marks->missing_in_row += 1;
        marks->jumped = false;
        push(marks, marks->expected + settings->distance, marks->pitch, false);
        marks->last = marks->expected;
        marks->expected += marks->pitch;
        if (marks->missing_in_row < settings->missing_limit)
            continue;
        marks->alarm = marks->false_in_row + 1u >= marks->missing_in_row ? CTL_WARNING_BIT_MARK_PITCH_WRONG
                                                                         : CTL_WARNING_BIT_MARKS_LOST;
        return;
    }
}

void ctl_marks_drop(ctl_marks* marks, int64_t film)
{
    while (marks->count != 0 && marks->waiting[marks->first].at < film) {
        marks->first = (marks->first + 1u) % CTL_WAITING_MARKS;
        marks->count -= 1;
    }
}

const ctl_mark* ctl_marks_near(const ctl_marks* marks, int64_t film, int64_t reach)
{
    const ctl_mark* nearest = NULL;
    for (uint32_t i = 0; i < marks->count; ++i) {
        const ctl_mark* mark = ctl_marks_waiting(marks, i);
        const int64_t away = size_of(mark->at - film);
        if (away <= reach && (nearest == NULL || away < size_of(nearest->at - film)))
            nearest = mark;
    }
    return nearest;
}

void ctl_marks_teach(ctl_marks* marks, uint16_t wanted)
{
    const ctl_teaching teaching = {wanted, 0, 0, 0, 0, 0};
    marks->teaching = teaching;
}

int64_t ctl_marks_taught_pitch(const ctl_marks* marks)
{
    const ctl_teaching* teaching = &marks->teaching;
    if (teaching->count < 2u)
        return 0;
    return teaching->first_gap + teaching->sum / (int64_t)(teaching->count - 1u);
}

uint64_t ctl_marks_taught_variance(const ctl_marks* marks)
{
    const ctl_teaching* teaching = &marks->teaching;
    if (teaching->count < 3u)
        return 0;
    const int64_t gaps = (int64_t)teaching->count - 1;
    return (uint64_t)((teaching->squares - teaching->sum * teaching->sum / gaps) / (gaps - 1));
}
