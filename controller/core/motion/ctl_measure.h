/* SPDX-License-Identifier: Apache-2.0 */
/* The measurement of an axis: the pulses between its index marks, or a small move that shows its direction.
 */
#ifndef CTL_MEASURE_H
#define CTL_MEASURE_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_MEASURE_MAX_TURNS 20u

typedef struct {
    uint16_t state;   /* CTL_MEASURE_STATE_... */
    uint16_t axis;    /* CTL_MEASURED_AXIS_... */
    uint16_t reason;  /* CTL_REFUSAL_..., why it ended before its turns */
    uint16_t wanted;  /* turns, 0: a quarter of one, not counted */
    uint16_t turns;   /* counted */
    bool marked;      /* the first mark has passed */
    bool on;          /* the index mark's input, in the last slice */
    uint64_t rest;    /* of 1/256 pulse of a feed, in 1 / timer clock */
    int64_t turn;     /* by the settings, 1/256 pulse as all that follows */
    int64_t left;     /* to the end of the small move, or until the next mark is missing */
    int64_t first;    /* position at the first mark, */
    int64_t last;     /* and at the last one */
    int64_t shortest; /* turn */
    int64_t longest;
} ctl_measure;

/* `turn`: a turn by the settings. */
void ctl_measure_begin(ctl_measure* measure, uint16_t axis, uint16_t turns, int64_t turn);
/* A mark passed at this position. */
void ctl_measure_mark(ctl_measure* measure, int64_t at);
/* The axis has moved by so much. */
void ctl_measure_move(ctl_measure* measure, int64_t way);
/* Ends it; nothing when it is over. */
void ctl_measure_end(ctl_measure* measure, uint16_t reason);
bool ctl_measure_moves(const ctl_measure* measure);

#ifdef __cplusplus
}
#endif

#endif
