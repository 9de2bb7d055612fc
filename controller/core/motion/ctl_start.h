/* SPDX-License-Identifier: Apache-2.0 */
/* The one gate that every start passes, whoever asks for it. Homing and jogging are no starts. */
#ifndef CTL_START_H
#define CTL_START_H

#include "motion/ctl_io.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Each returns the first reason against it, CTL_REFUSAL_...; with CTL_REFUSAL_NONE the axis has been started. */
uint16_t ctl_start(ctl_motion* motion, const ctl_io* io);
uint16_t ctl_start_home(ctl_motion* motion, const ctl_io* io);

#ifdef __cplusplus
}
#endif

#endif
