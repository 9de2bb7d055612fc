/* SPDX-License-Identifier: Apache-2.0 */
/* A clutch between a master and the line that follows it. It engages from standstill over a stretch L of the
 * master by a quintic of the master's position: x the share of the stretch and h the line's way in it, the
 * line is L (x^3 - x^4 / 2) + (h - L / 2) (10 x^3 - 15 x^4 + 6 x^5) on, and goes on as the master does, with
 * its position, slope 1 and no second derivative. It disengages by the same curve backwards. The line is a
 * function of the master's position alone: a master that stands holds it, and one that comes back in the
 * stretch leads it back, at most to where it began; once engaged the line goes back as far as the master. All
 * in ticks of the line's table. */
#ifndef CTL_CLUTCH_H
#define CTL_CLUTCH_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum { CTL_CLUTCH_OFF, CTL_CLUTCH_ENGAGING, CTL_CLUTCH_ON, CTL_CLUTCH_DISENGAGING } ctl_clutch_state;

/* `way` is 0.4 to 0.6 of the stretch, where the line does not go back; half of it is the gentlest. */
typedef struct {
    uint32_t stretch; /* of the master, not 0 */
    uint32_t way;     /* of the line */
} ctl_clutch_curve;

typedef struct {
    ctl_clutch_state state;
    bool ends; /* it disengages */
    ctl_clutch_curve on;
    ctl_clutch_curve off;
    int64_t from;   /* the master where it engages, */
    int64_t line;   /* and the line there */
    int64_t offset; /* of the line from the master while on */
    int64_t end;    /* the line where it has disengaged */
} ctl_clutch;

void ctl_clutch_open(ctl_clutch* clutch, int64_t line);
/* Engages from here. */
void ctl_clutch_engage(ctl_clutch* clutch, int64_t master, int64_t line, ctl_clutch_curve curve);
/* Disengages so that the line comes to rest at `end`, which must be at or behind ctl_clutch_nearest_end(). */
void ctl_clutch_disengage(ctl_clutch* clutch, int64_t end, ctl_clutch_curve curve);
/* Returns the nearest end of the line for this curve, with the line at `line` now. */
int64_t ctl_clutch_nearest_end(const ctl_clutch* clutch, int64_t line, ctl_clutch_curve curve);
/* Puts the line so many ticks further ahead of the master; no step where they are few at a time. */
void ctl_clutch_shift(ctl_clutch* clutch, int64_t ticks);
/* Returns the line with the master at this position. */
int64_t ctl_clutch_follow(ctl_clutch* clutch, int64_t master);

#ifdef __cplusplus
}
#endif

#endif
