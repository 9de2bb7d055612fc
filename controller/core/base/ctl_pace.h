/* SPDX-License-Identifier: Apache-2.0 */
/* The way of an engine's pulses to the port: an engine counts its own ticks, those of a master that may be
 * slower than time. A pace is a stretch of time in which so many of them pass, evenly. */
#ifndef CTL_PACE_H
#define CTL_PACE_H

#include "base/ctl_port.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    const ctl_port* port;
    uint32_t start;  /* timer tick since power-up, modulo 2^32 */
    uint32_t ticks;  /* that it lasts */
    uint32_t travel; /* the engine's ticks in it */
} ctl_pace;

/* Takes the first `travel` ticks of the engine off and returns them, as a pace in which `inner` ticks of what
 * follows the engine pass. */
ctl_pace ctl_pace_take(ctl_pace* pace, uint32_t travel, uint32_t inner);
/* Gives the pulses of an engine to the port. Their ticks are the engine's from the start of the pace; no
 * pulse of an empty train is given. NULL: nobody wants to know. */
void ctl_pace_give(const ctl_pace* pace, const ctl_train* train);

#ifdef __cplusplus
}
#endif

#endif
