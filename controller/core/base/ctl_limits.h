/* SPDX-License-Identifier: Apache-2.0 */
/* The limits and defaults of the registers that the panel writes, from the register table. */
#ifndef CTL_LIMITS_H
#define CTL_LIMITS_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Returns true when the registers `values` at `base` are within their limits. */
bool ctl_within_limits(const uint16_t* values, uint32_t base, uint32_t count);
/* The same of the whole group `parameter`. */
bool ctl_parameters_valid(const uint16_t* parameter);
/* Sets the registers `values` at `base` to their defaults. */
void ctl_reset_to_defaults(uint16_t* values, uint32_t base, uint32_t count);
/* The same of the whole group `parameter`. */
void ctl_parameters_reset(uint16_t* parameter);

#ifdef __cplusplus
}
#endif

#endif
