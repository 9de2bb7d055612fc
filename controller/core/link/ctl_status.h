/* SPDX-License-Identifier: Apache-2.0 */
/* The registers that describe the controller: the identity, the status block and the clock. */
#ifndef CTL_STATUS_H
#define CTL_STATUS_H

#include "ctl_registers.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct ctl_core;

void ctl_identity(const struct ctl_core* core, uint16_t* registers);
void ctl_status(const struct ctl_core* core, uint16_t* registers);
uint16_t ctl_warnings(const struct ctl_core* core);
/* Seconds since 1970-01-01 UTC, 0 until set. */
uint32_t ctl_unix_time(const struct ctl_core* core);

#ifdef __cplusplus
}
#endif

#endif
