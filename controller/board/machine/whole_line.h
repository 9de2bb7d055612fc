/* SPDX-License-Identifier: Apache-2.0 */
/* Film, infeed and knife of the whole-number machine. Positions of film and infeed in 1/256 pulse. */
#ifndef WHOLE_LINE_H
#define WHOLE_LINE_H

#include "machine/whole_shaft.h"

#include <stdbool.h>
#include <stdint.h>

/* The disturbances of film and products; all 0: there are none. */
typedef struct {
    int32_t stretch_ppm;      /* of the print on the film */
    uint32_t missing_every;   /* products from one that is missing to the next */
    uint32_t misplaced_every; /* products from one that lies 0.35 bags late to the next */
} whole_disturbance;

typedef struct {
    whole_disturbance disturbance;
    whole_shaft shaft;
    bool has_knife;
    int64_t film; /* pulses */
    int64_t film_before;
    int64_t infeed;    /* pulses */
    int64_t bag;       /* film */
    int64_t next_mark; /* where it begins: the one at the sensor or the next */
    bool mark_there;
    int64_t mark_length;
    int64_t flight;  /* infeed from product to product */
    int64_t product; /* length of a product on it */
    int64_t first_product;
    uint32_t number; /* of the next product */
    int64_t edge;    /* of it, that comes to the eye next */
    bool covered;
    uint64_t stroke; /* pulses of the main drive from knife to knife, times parts */
    uint32_t parts;
    int64_t first_cut;  /* of the main drive */
    int64_t cut_film;   /* where the last cut was made */
    int64_t fresh_film; /* where this slice's cut was made; -1: none */
    bool cut_before;
} whole_line;

void whole_line_init(whole_line* line, whole_disturbance disturbance);
void whole_line_connect(ctl_port* port);
/* The same for the encoder of the line's shaft. */
void whole_line_connect_shaft(ctl_port* port);
/* Before a slice: the shaft, if there is one, has turned for this time meanwhile. */
void whole_line_turn_shaft(whole_line* line, uint32_t us);
/* Sets the line up for the active program; `mark` is the index mark of the knife's shaft, pulses. */
void whole_line_set_up(whole_line* line, const ctl_core* core, int64_t mark);
/* The main drive moved from `before` to `now`: makes the cut that lies between. */
void whole_line_follow(whole_line* line, ctl_core* core, int64_t before, int64_t now);
/* Returns the levels of mark sensor and eye. */
uint16_t whole_line_inputs(const whole_line* line);

/* Rounds down. */
int64_t whole_floor(int64_t value, int64_t divisor);

#endif
