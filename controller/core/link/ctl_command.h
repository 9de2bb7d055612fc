/* SPDX-License-Identifier: Apache-2.0 */
/* What the panel asks for: commands with their echoed counter, and the heartbeat with the held jog keys. */
#ifndef CTL_COMMAND_H
#define CTL_COMMAND_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Jog ends when the heartbeat has not advanced for this long; CTL_JOG_RAMP_MS later the axis stands still. */
#define CTL_JOG_HOLD_US 200000u

struct ctl_core;

/* Carries out the command in the command registers unless its counter is that of the last one. Refuses it
 * when its code was not in the same frame. */
void ctl_command(struct ctl_core* core, bool has_code);

void ctl_exchange_heartbeat(struct ctl_core* core);
void ctl_heartbeat_slice(struct ctl_core* core);
bool ctl_heartbeat_lost(const struct ctl_core* core);
/* 1, -1 or 0: the direction in which the axis may jog now. */
int32_t ctl_jog_request(const struct ctl_core* core);

#ifdef __cplusplus
}
#endif

#endif
