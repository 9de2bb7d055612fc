/* SPDX-License-Identifier: Apache-2.0 */
/* The change of program while the machine runs. At the boundary the film's speed goes on as it is, so the new
 * program begins with its own share of full speed. Knife and infeed then change their speed at once, in
 * proportion to the share before the boundary: the machine slows down to the share at which each axis keeps
 * its largest step, meets the boundary with it and gains speed again. */
#ifndef CTL_CHANGE_H
#define CTL_CHANGE_H

#include "base/ctl_bank.h"
#include "base/ctl_board.h"
#include "engine/ctl_ramp.h"
#include "packer/ctl_packer.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A smaller share of full speed is no change but a standstill: 1 / 2048. */
#define CTL_CHANGE_MIN_SHARE ((uint64_t)1 << (CTL_RAMP_SHARE_BITS - 11u))

typedef struct {
    uint64_t share;     /* largest one before the boundary, in 1 / 2^31 */
    uint32_t numerator; /* the share behind it is that times numerator / denominator */
    uint32_t denominator;
} ctl_change_plan;

/* Computes the change from the active bank `from` to `to`, the master running in this direction. */
ctl_change_plan ctl_change_between(const ctl_board* board, const ctl_packer* packer, const ctl_bank* from,
                                   const ctl_bank* to, int32_t direction);
/* Returns CTL_REFUSAL_..., the reason why that cannot be done without a standstill. */
uint16_t ctl_change_refusal(const ctl_change_plan* plan);
/* The share behind the boundary of one before it; of ticks that are left just as well. */
uint64_t ctl_change_share_behind(const ctl_change_plan* plan, uint64_t share);

#ifdef __cplusplus
}
#endif

#endif
