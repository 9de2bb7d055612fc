/* SPDX-License-Identifier: Apache-2.0 */
/* The encoder on a wheel that runs on the film, where somebody else drives film and infeed: its counts are
 * the positions of both. The marks say whether it slips. */
#ifndef CTL_WHEEL_H
#define CTL_WHEEL_H

#include "master/ctl_gear.h"
#include "packer/ctl_marks.h"

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_WHEEL_FINE 24u

/* Positions per count, as whole numbers. */
typedef struct {
    uint64_t numerator;
    uint64_t denominator;
} ctl_wheel_ratio;

typedef struct {
    bool on;
    bool opens;     /* the knife stands open: the line has not engaged yet, or the run ends */
    bool reversed;  /* the counts of the board fall while the film runs forward */
    int64_t counts; /* present ones, of the line's direction */
    ctl_gear film;  /* 1/256 pulse of the film motor that there would be, per count; */
    ctl_gear infeed;
    int64_t film_from; /* positions at their tick 0 */
    int64_t infeed_from;
    int64_t per_tick; /* film of a tick of the table, and */
    int64_t per_film; /* ticks of its 1/256 pulse, both 1 / 2^CTL_WHEEL_FINE */
    int64_t drift;    /* of the infeed's flights from one product to the next */
    int64_t usual;    /* distance of a product from its place, 0: the places are not known */
    uint32_t placed;  /* products that said where they are */
    uint32_t strays;  /* products in a row far from their places that agree, */
    int64_t stray;    /* and the distance of the last one */
    int64_t slip;     /* film between the last two marks, less that by the wheel */
    int64_t limit;    /* 0: not watched */
    int64_t last;     /* mark that was seen */
    bool doubtful;    /* the last mark was off its place; the right one may still come, up to here */
    int64_t doubtful_to;
    int64_t good_at;     /* the last mark at its place, */
    int64_t good_pitch;  /* and the distance of marks then */
    uint32_t unexpected; /* prints that were no marks, when tracking began, */
    uint32_t prints;     /* and as far as they were seen */
    uint32_t off_in_row; /* prints since the last one at the place of a mark */
    bool slips;          /* until the next start */
} ctl_wheel;

/* By how much the positions of the infeed are smaller from now on: */
typedef struct {
    int64_t found; /* its places were elsewhere, */
    int64_t drift; /* or have moved since the last product */
} ctl_wheel_step;

void ctl_wheel_switch(ctl_wheel* wheel, bool on);
/* Takes the present counts, in the line's direction; where their sign has been changed, film and infeed stay
 * where they are. */
void ctl_wheel_read(ctl_wheel* wheel, int64_t counts, bool reversed);
/* The film is where `film_at` says at the present counts, or goes on from where it was with these ratios. */
void ctl_wheel_set(ctl_wheel* wheel, ctl_wheel_ratio film, ctl_wheel_ratio infeed, int64_t film_at,
                   int64_t infeed_at);
/* Return positions, 1/256 pulse: the present ones, and those at counts as the board gives them. */
int64_t ctl_wheel_film(ctl_wheel* wheel);
int64_t ctl_wheel_infeed(ctl_wheel* wheel);
int64_t ctl_wheel_film_at(ctl_wheel* wheel, int64_t counts);
int64_t ctl_wheel_infeed_at(ctl_wheel* wheel, int64_t counts);
/* A product was so far behind its place on the infeed, whose flights are `flight` apart. */
ctl_wheel_step ctl_wheel_find_flights(ctl_wheel* wheel, int64_t off, int64_t flight);
/* Returns true when some products agree where their places are, or none has come yet. */
bool ctl_wheel_is_placed(const ctl_wheel* wheel);
/* Behind the edges of a slice, with the film here. */
void ctl_wheel_watch(ctl_wheel* wheel, const ctl_marks* marks, int64_t film);

#ifdef __cplusplus
}
#endif

#endif
