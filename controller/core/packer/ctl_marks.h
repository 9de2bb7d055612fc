/* SPDX-License-Identifier: Apache-2.0 */
/* The printed marks between their sensor and the knife, in positions of the film axis (1/256 pulse). Each
 * mark gives the place of one cut. What a mark's error says is divided: a share (the phase gain) is taken for
 * film that slipped against its motor, and shifts all marks that wait; a share (the length gain) changes the
 * distance expected to the next. An error that no slip explains is a change of the print or of the film's
 * stretch: it is believed at once, and the marks before it stay where they are; unless another mark comes
 * nearer to where one was expected, then the first was none. */
#ifndef CTL_MARKS_H
#define CTL_MARKS_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_WAITING_MARKS 24u

typedef struct {
    int64_t nominal;        /* between two marks: the bag length */
    int64_t distance;       /* from the sensor to where the mark's cut is at the knife */
    int64_t window;         /* to both sides of where a mark is expected */
    int64_t jump;           /* an error larger than this is not slip */
    int64_t max_difference; /* of the distance between marks from the nominal one */
    uint32_t phase_gain;    /* 0.001 */
    uint32_t length_gain;   /* 0.001 */
    uint32_t missing_limit;
} ctl_mark_settings;

typedef struct {
    int64_t at;    /* film position at which its cut is to be made */
    int64_t pitch; /* from the mark before */
    bool seen;     /* otherwise reckoned from the marks before it */
} ctl_mark;

typedef struct {
    uint16_t wanted; /* marks to measure; 0: none */
    uint16_t count;
    int64_t last;
    int64_t first_gap;
    int64_t sum; /* of the gaps' differences from the first, and of their squares */
    int64_t squares;
} ctl_teaching;

typedef struct {
    ctl_mark_settings settings;
    uint16_t state; /* CTL_MARK_STATE_... */
    int64_t expected;
    int64_t last;  /* the mark before that, as it was seen */
    int64_t pitch; /* filtered distance from mark to mark */
    int64_t error; /* of the last mark */
    bool jumped;   /* which no slip explained; before it there were: */
    int64_t expected_before;
    int64_t last_before;
    int64_t pitch_before;
    bool has_candidate;
    int64_t candidate; /* searching: the mark before; where the search began when there is none */
    uint32_t wrong_gaps;
    uint32_t missing_in_row;
    uint32_t false_in_row;               /* since the last mark that was right */
    uint16_t alarm;                      /* CTL_WARNING_BIT_MARKS_LOST or _MARK_PITCH_WRONG; 0 when neither */
    ctl_mark waiting[CTL_WAITING_MARKS]; /* as a ring, from the knife to the sensor */
    uint32_t first;
    uint32_t count;
    ctl_teaching teaching;
    uint32_t followed; /* since power-up */
    uint32_t missing;
    uint32_t unexpected;
} ctl_marks;

/* Begin to search at this film position. Counts since power-up stay. */
void ctl_marks_search(ctl_marks* marks, const ctl_mark_settings* settings, int64_t film);
/* A mark passed the sensor. */
void ctl_marks_see(ctl_marks* marks, int64_t film);
/* The film stands there now: what should have been seen by then is missing. */
void ctl_marks_pass(ctl_marks* marks, int64_t film);
/* Marks whose cut lies before `film` are done with. */
void ctl_marks_drop(ctl_marks* marks, int64_t film);
/* The waiting mark nearest to `film` within `reach`; NULL when there is none. */
const ctl_mark* ctl_marks_near(const ctl_marks* marks, int64_t film, int64_t reach);
const ctl_mark* ctl_marks_waiting(const ctl_marks* marks, uint32_t index);

void ctl_marks_teach(ctl_marks* marks, uint16_t wanted);
/* Mean distance of the marks measured, and the variance of that; 0 before there are two and three marks. */
int64_t ctl_marks_taught_pitch(const ctl_marks* marks);
uint64_t ctl_marks_taught_variance(const ctl_marks* marks);

#ifdef __cplusplus
}
#endif

#endif
