/* SPDX-License-Identifier: Apache-2.0 */
/* The inputs of the machine that act on a run. Each acts by its edge, never by its level at power-up: a start
 * needs a new press behind everything that ended a run. What is on also refuses a start (ctl_start.c). */
#ifndef CTL_ACTIONS_H
#define CTL_ACTIONS_H

#include "motion/ctl_io.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    uint16_t inputs;  /* as they were when any had changed */
    uint16_t wants;   /* CTL_COMMAND_START or _JOG_BAG: that button was pressed and has not been answered;
                         what ends a run ends this, too */
    uint16_t presses; /* of both since power-up */
    uint16_t refusal; /* CTL_REFUSAL_... of the last one */
} ctl_actions;

/* Takes over the levels at power-up. */
void ctl_actions_init(ctl_actions* actions, const ctl_io* io);
/* Acts on what has changed; called when any input has. */
void ctl_actions_slice(ctl_actions* actions, const ctl_io* io, ctl_motion* motion);

#ifdef __cplusplus
}
#endif

#endif
