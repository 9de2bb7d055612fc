/* SPDX-License-Identifier: Apache-2.0 */
/* The printed marks between their sensor and the knife, in positions of the film axis (1/256 pulse). Each
 * mark sets the position of one cut. The error of a mark is divided: a share (the phase gain) counts as slip
 * of the film against its motor and shifts all waiting marks; a share (the length gain) changes the expected
 * distance to the next mark. An error too large for slip is a change of the print or of the film's stretch:
 * it is applied at once and the waiting marks are unchanged. If another mark is seen nearer to the expected
 * position, the first one was a false mark. */
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
    int64_t distance;       /* from the sensor to the position at which the mark's cut is at the knife */
    int64_t window;         /* around the expected position of a mark, plus and minus */
    int64_t jump;           /* an error larger than this is not slip */
    int64_t masking;        /* prints nearer to a mark than this are ignored; 0: none */
    int64_t max_difference; /* of the distance between marks from the nominal one */
    uint32_t phase_gain;    /* 0.001 */
    uint32_t length_gain;   /* 0.001 */
    uint32_t missing_limit;
} ctl_mark_settings;

typedef struct {
    int64_t at;    /* film position of its cut */
    int64_t pitch; /* from the previous mark */
    bool seen;     /* otherwise estimated from the previous marks */
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
    int64_t last;  /* the previous mark, as seen */
    int64_t pitch; /* filtered distance from mark to mark */
    int64_t error; /* of the last mark */
    int64_t off;   /* of the last edge, valid or not, from the nearest expected mark */
    bool jumped;   /* too large for slip; the values before it: */
    int64_t expected_before;
    int64_t last_before;
    int64_t pitch_before;
    bool has_candidate;
    int64_t candidate; /* searching: the previous mark, or the start of the search */
    uint32_t wrong_gaps;
    uint32_t missing_in_row;
    uint32_t false_in_row;               /* since the last valid mark */
    uint16_t alarm;                      /* CTL_WARNING_BIT_MARKS_LOST or _MARK_PITCH_WRONG; 0: neither */
    ctl_mark waiting[CTL_WAITING_MARKS]; /* as a ring, from the knife to the sensor */
    uint32_t first;
    uint32_t count;
    ctl_teaching teaching;
    uint32_t followed; /* since power-up */
    uint32_t missing;
    uint32_t unexpected;
} ctl_marks;

/* Starts a search at this film position. The counts since power-up are kept. */
void ctl_marks_search(ctl_marks* marks, const ctl_mark_settings* settings, int64_t film);
/* Handles a mark at the sensor; returns CTL_MARK_VERDICT_..., what became of it. */
uint16_t ctl_marks_see(ctl_marks* marks, int64_t film);
/* Handles a print that is no mark for this reason; returns it. */
uint16_t ctl_marks_reject(ctl_marks* marks, int64_t film, uint16_t verdict);
/* Returns true while marks are expected at their places. */
bool ctl_marks_follow(const ctl_marks* marks);
/* All cuts are so much later from now on, those of the waiting marks, too. */
void ctl_marks_move(ctl_marks* marks, int64_t by);
/* Returns false as long as ctl_marks_pass() has nothing to do at this film position. */
bool ctl_marks_due(const ctl_marks* marks, int64_t film);
/* Handles a film position: expected marks that were not seen by then are missing. */
void ctl_marks_pass(ctl_marks* marks, int64_t film);
/* Removes marks whose cut is before `film`. */
void ctl_marks_drop(ctl_marks* marks, int64_t film);
/* Returns the waiting mark nearest to `film` within `reach`, or NULL. */
const ctl_mark* ctl_marks_near(const ctl_marks* marks, int64_t film, int64_t reach);
const ctl_mark* ctl_marks_waiting(const ctl_marks* marks, uint32_t index);

void ctl_marks_teach(ctl_marks* marks, uint16_t wanted);
/* Return the mean distance of the measured marks, and its variance; 0 before two and three marks. */
int64_t ctl_marks_taught_pitch(const ctl_marks* marks);
uint64_t ctl_marks_taught_variance(const ctl_marks* marks);

#ifdef __cplusplus
}
#endif

#endif
