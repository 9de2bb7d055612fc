/* SPDX-License-Identifier: Apache-2.0 */
/* The shaft of the line that a machine stands in, in whole numbers: its encoder, or that of a wheel on the
 * film, which somebody else drives then. Its speed ripples by 1 %. */
#ifndef WHOLE_SHAFT_H
#define WHOLE_SHAFT_H

#include "ctl_core.h"

#include <stdbool.h>
#include <stdint.h>

/* The way of an axis while the shaft turns, 1/256 pulse a count. */
typedef struct {
    uint64_t numerator;
    uint64_t denominator;
    uint64_t inverse; /* counts, 1 / 2^32 */
    uint64_t rest;    /* of the last position, 1 / denominator */
    int64_t at;       /* 1/256 pulse */
} whole_gear;

typedef struct {
    uint32_t counts_per_s; /* of the encoder in the mean; 0: there is no shaft */
    bool drives_film;      /* and the infeed: the encoder is on a wheel */
    bool latches;          /* an edge and a cut latch its counts */
    int32_t faster;        /* than the mean, 1/65536 of it, */
    int32_t change;        /* by so much more in each slice */
    uint32_t part;         /* of a count, 1 / 2^32 */
    int64_t counts;
    uint32_t turn; /* counts from index mark to index mark */
    uint32_t indexes;
    int64_t index_at;
    whole_gear film;
    whole_gear infeed;
} whole_shaft;

void whole_shaft_init(whole_shaft* shaft, uint32_t counts_per_s, bool drives_film);
/* Sets up what its counts mean for the active program, `flight` being the infeed from product to product,
 * 1/256 pulse. */
void whole_shaft_set_up(whole_shaft* shaft, const ctl_core* core, int64_t flight);
void whole_shaft_turn(whole_shaft* shaft, uint32_t us);
/* Returns the counts when the axis was at this position, or the position where none are latched. */
int64_t whole_shaft_latch(const whole_shaft* shaft, const whole_gear* gear, int64_t position);
void whole_shaft_read(const whole_shaft* shaft, ctl_master_input* input);

#endif
