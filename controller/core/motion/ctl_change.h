/* SPDX-License-Identifier: Apache-2.0 */
/* The change of program while the machine runs. The film keeps its speed at the boundary, so the new program
 * starts with its own share of full speed. Knife and infeed change their speed at once, in proportion to the
 * share before the boundary: the machine slows down to the share at which no axis exceeds its maximum step,
 * passes the boundary and accelerates again. */
#ifndef CTL_CHANGE_H
#define CTL_CHANGE_H

#include "base/ctl_bank.h"
#include "base/ctl_board.h"
#include "engine/ctl_ramp.h"
#include "packer/ctl_packer.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Minimum share of full speed; below it the program changes at standstill: 1 / 2048. */
#define CTL_CHANGE_MIN_SHARE ((uint64_t)1 << (CTL_RAMP_SHARE_BITS - 11u))

typedef struct {
    uint64_t share;     /* maximum share before the boundary, in 1 / 2^31; */
    uint64_t steps;     /* the same, as far as the steps of the axes demand */
    uint32_t numerator; /* the share after it is share * numerator / denominator */
    uint32_t denominator;
    int32_t direction; /* of the master, and */
    uint32_t writes;   /* board->parameter_writes that it was computed for */
} ctl_change_plan;

/* Computes the change from the active bank `from` to `to`, the master running in this direction. */
ctl_change_plan ctl_change_between(const ctl_board* board, const ctl_packer* packer, const ctl_bank* from,
                                   const ctl_bank* to, int32_t direction);
/* Returns CTL_REFUSAL_..., the reason why the change needs a standstill. */
uint16_t ctl_change_refusal(const ctl_change_plan* plan);
/* Returns the share after the boundary for a share before it; also for remaining ticks. */
uint64_t ctl_change_share_behind(const ctl_change_plan* plan, uint64_t share);

#ifdef __cplusplus
}
#endif

#endif
