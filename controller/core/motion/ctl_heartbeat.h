/* SPDX-License-Identifier: Apache-2.0 */
/* The panel's heartbeat, and the jog keys that are held as long as it goes on. */
#ifndef CTL_HEARTBEAT_H
#define CTL_HEARTBEAT_H

#include "base/ctl_board.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Jog ends when the heartbeat has not advanced for this long; CTL_JOG_RAMP_MS later the axis stands still. */
#define CTL_JOG_HOLD_US 200000u

typedef struct {
    bool heard; /* a heartbeat came since power-up */
    uint16_t last;
    uint64_t advanced_us;
    uint16_t permit;  /* bits CTL_PERMIT_BIT_... that came with it */
    uint16_t keys;    /* bits CTL_JOG_BIT_..., as the slice began */
    bool jog_blocked; /* until the keys were seen released */
} ctl_heartbeat;

/* A heartbeat came. */
void ctl_heartbeat_receive(ctl_heartbeat* heartbeat, const ctl_board* board, uint16_t value);
/* Begins a slice with these keys held; returns true when it is lost and nothing may go on unattended. */
bool ctl_heartbeat_slice(ctl_heartbeat* heartbeat, const ctl_board* board, uint16_t keys);
bool ctl_heartbeat_lost(const ctl_heartbeat* heartbeat, const ctl_board* board);
/* It is lost, and the panel wants its loss to stop the machine. */
bool ctl_heartbeat_stops(const ctl_heartbeat* heartbeat, const ctl_board* board);
/* Which of these bits are missing of the permit: none while no permit is needed. */
uint32_t ctl_heartbeat_missing(const ctl_heartbeat* heartbeat, const ctl_board* board, uint32_t bits);
/* 1, -1 or 0: the direction in which the axis may jog now. */
int32_t ctl_jog_request(const ctl_heartbeat* heartbeat);

#ifdef __cplusplus
}
#endif

#endif
