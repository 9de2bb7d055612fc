/* SPDX-License-Identifier: Apache-2.0 */
/* The jaws of a packing machine's knife after a stop: where they touch the film, the knife goes on to where
 * they do not, as a part of the stop, and back to its place before the next run, so that film and knife stay
 * in phase. Positions in pulses of the main axis. */
#ifndef CTL_PARK_H
#define CTL_PARK_H

#include "base/ctl_board.h"
#include "packer/ctl_packer.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    CTL_PARK_OFF,
    CTL_PARK_WAITING,
    CTL_PARK_OPENING,
    CTL_PARK_OPEN,
    CTL_PARK_RETURNING,
    CTL_PARK_CUTTING
} ctl_park_phase;

typedef struct {
    bool known; /* the knife's place in its cycle, since the table moved it */
    ctl_park_phase phase;
    bool given_up;    /* stopped while it opened: it stays until the next start */
    bool away;        /* from `place`, where the table stands */
    bool emergency;   /* the emergency stop has ended the run, */
    bool jam;         /* or a jam: the knife goes back from it */
    bool line;        /* the run goes on when the line does, which stands */
    bool to_boundary; /* it returns there, not to `place` */
    bool stands;      /* it does, since waits_us */
    bool closed;      /* at standstill, since closed_us */
    bool told;        /* the bags at the knife are marked */
    bool before_cut;  /* a cut at standstill began before that of the knife's cycle */
    int64_t cycle_at; /* where the knife's present cycle began */
    int64_t place;
    int64_t turn;      /* pulses of a cut at standstill */
    uint64_t waits_us; /* since then */
    uint64_t closed_us;
} ctl_park;

/* The axis is moved by hand, or has another program. */
void ctl_park_forget(ctl_park* park);
/* A start brings the knife back to its place. */
void ctl_park_return(ctl_park* park);
/* A run begins or goes on. */
void ctl_park_run(ctl_park* park);
/* Returns true while the knife at `here` may touch the film. */
bool ctl_park_touches(const ctl_park* park, const ctl_packer* packer, int64_t here);
/* Returns the way from the cut of the knife's present cycle to `here`, negative before it. */
int64_t ctl_park_from_cut(const ctl_park* park, const ctl_packer* packer, int64_t here);
void ctl_park_begin_cycle(ctl_park* park, int64_t here);
/* The knife at `here` moves on by a cycle of so many pulses while the film stands, and has done so. Both know
 * its cuts meanwhile. */
void ctl_park_begin_cut(ctl_park* park, const ctl_packer* packer, int64_t here, int64_t cycle);
void ctl_park_end_cut(ctl_park* park);
/* A run has come to rest here. Returns true when the knife is to be opened. */
bool ctl_park_begin(ctl_park* park, const ctl_board* board, const ctl_packer* packer, int64_t here);
/* In a run that follows a line which stands, or does not: returns true when the knife is to be opened. */
bool ctl_park_begin_under_line(ctl_park* park, const ctl_board* board, const ctl_packer* packer, int64_t here,
                               bool stands);
/* A stop now: a knife that waits or opens stays where it is. */
void ctl_park_stop(ctl_park* park);
/* Returns true when it has waited for `parameter.park_delay`; a jam does not wait. */
bool ctl_park_is_due(const ctl_park* park, const ctl_board* board);
/* Returns where the knife at `here` is open, the way there not leading through the cut, or so far back
 * from a jam as is set. */
int64_t ctl_park_target(const ctl_park* park, const ctl_packer* packer, int64_t here);
/* Returns the boundary of the knife's cycle to which the way does not lead through the cut. */
int64_t ctl_park_boundary(const ctl_park* park, const ctl_packer* packer, int64_t here);
/* At standstill: watches the jaws with the axis at `here`, and marks the bags at a knife that was closed for
 * too long. */
void ctl_park_watch(ctl_park* park, const ctl_board* board, ctl_packer* packer, int64_t here);
/* Returns true while they have been closed for more than `parameter.jaws_closed_max`. */
bool ctl_park_is_closed_long(const ctl_park* park, const ctl_board* board);

#ifdef __cplusplus
}
#endif

#endif
