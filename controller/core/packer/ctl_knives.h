/* SPDX-License-Identifier: Apache-2.0 */
/* The knives of a shaft, which are not quite evenly spaced: as seen from the first one behind the index mark,
 * each has a place of its own, and the film is shifted so that it cuts where it should. */
#ifndef CTL_KNIVES_H
#define CTL_KNIVES_H

#include "base/ctl_board.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_KNIVES 12u

typedef struct {
    uint32_t count;
    uint32_t next;   /* makes the next cut; 0: the first one */
    uint32_t last;   /* made the last one */
    int64_t in_film; /* place of the knife for which the film is shifted now, 1/256 pulse */
} ctl_knives;

/* The shaft stands at its index mark. */
void ctl_knives_reset(ctl_knives* knives, uint32_t count);
/* Handles a cut. */
void ctl_knives_cut(ctl_knives* knives);
/* Returns how far behind its place the next one cuts, um of film. */
int32_t ctl_knives_next_um(const ctl_knives* knives, const ctl_board* board);

#ifdef __cplusplus
}
#endif

#endif
