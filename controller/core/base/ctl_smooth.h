/* SPDX-License-Identifier: Apache-2.0 */
/* A movement without a step of its speed. */
#ifndef CTL_SMOOTH_H
#define CTL_SMOOTH_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_SMOOTH_BITS 30u

/* Returns the share 3 x^2 - 2 x^3 of `amount` at x = part / whole; part <= whole, whole not 0. */
int64_t ctl_smooth_share(int64_t amount, uint64_t part, uint64_t whole);
/* The same for a share x = part / whole, in 1 / 2^CTL_SMOOTH_BITS, below 1. */
int64_t ctl_smooth_at(int64_t amount, uint64_t x);

#ifdef __cplusplus
}
#endif

#endif
