/* SPDX-License-Identifier: Apache-2.0 */
/* The panel's heartbeat, and the jog keys, which count only while it advances. */
#ifndef CTL_HEARTBEAT_H
#define CTL_HEARTBEAT_H

#include "base/ctl_board.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Jog ends when the heartbeat has not advanced for this long; CTL_JOG_RAMP_MS later the axis stands still. */
#define CTL_JOG_HOLD_US 200000u

typedef struct {
    bool heard; /* a heartbeat was received since power-up */
    uint16_t last;
    uint64_t advanced_us;
    uint16_t permit;  /* bits CTL_PERMIT_BIT_... that came with it */
    uint16_t keys;    /* bits CTL_JOG_BIT_..., as the slice began */
    bool jog_blocked; /* until the keys were seen released */
} ctl_heartbeat;

/* Handles a heartbeat. */
void ctl_heartbeat_receive(ctl_heartbeat* heartbeat, const ctl_board* board, uint16_t value);
/* Starts a slice with these keys pressed; returns true when the heartbeat is lost and motion must stop. */
bool ctl_heartbeat_slice(ctl_heartbeat* heartbeat, const ctl_board* board, uint16_t keys);
bool ctl_heartbeat_lost(const ctl_heartbeat* heartbeat, const ctl_board* board);
/* Returns true when the heartbeat is lost and configured to stop the machine. */
bool ctl_heartbeat_stops(const ctl_heartbeat* heartbeat, const ctl_board* board);
/* Returns which of these bits the permit lacks: none while no permit is needed. */
uint32_t ctl_heartbeat_missing(const ctl_heartbeat* heartbeat, const ctl_board* board, uint32_t bits);
/* Returns the direction in which the axis may jog now: 1, -1 or 0. */
int32_t ctl_jog_request(const ctl_heartbeat* heartbeat);

#ifdef __cplusplus
}
#endif

#endif
