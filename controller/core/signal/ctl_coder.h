/* SPDX-License-Identifier: Apache-2.0 */
/* The pulses of a date coder: one for each product on the film, when the cut behind its bag is so much film
 * away as `signal.coder_place` says. A product has its pulse once, whatever becomes of its bag; an empty
 * place has none. Positions in 1/256 pulse of the film motor. */
#ifndef CTL_CODER_H
#define CTL_CODER_H

#include "packer/ctl_packer.h"

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_CODER_PRODUCTS 32u /* a power of two: a ring */
/* The shortest pulse, which another one waits for, and the shortest time between two. */
#define CTL_CODER_SHORTEST_US 5000u

typedef struct {
    int64_t film; /* at the last slice */
    /* The products that wait for their pulse: the cuts behind the first `passed` of them, which are over, and
     * the middles of the others. */
    int64_t at[CTL_CODER_PRODUCTS];
    uint32_t first;
    uint32_t count;
    uint32_t passed;
    uint32_t seen;    /* products since power-up */
    bool aimed;       /* `end` is the cut behind the first of the others, */
    int64_t end;      /* by what was known then: */
    int64_t cut;      /* the next cut, */
    int64_t expected; /* the next mark, */
    uint32_t writes;  /* and the parameters */
    int64_t place;
    uint32_t owed; /* pulses that are due */
    bool on;
    bool rested;       /* no pulse for as long as must be between two */
    uint32_t since_us; /* modulo 2^32 */
    uint32_t pulses;   /* since power-up */
} ctl_coder;

/* Returns true when ctl_coder_aim() has nothing to do. */
bool ctl_coder_is_aimed(const ctl_coder* coder, const ctl_packer* packer);
/* Finds the cut behind the next product. */
void ctl_coder_aim(ctl_coder* coder, const ctl_packer* packer);
/* Ends a slice of a cutter's program; returns true when the output changes. */
bool ctl_coder_slice(ctl_coder* coder, const ctl_packer* packer);

#ifdef __cplusplus
}
#endif

#endif
