/* SPDX-License-Identifier: Apache-2.0 */
/* The one gate that every start passes, whoever asks for it. Homing, jogging and the test of an output are no
 * starts. */
#ifndef CTL_START_H
#define CTL_START_H

#include "motion/ctl_io.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Each returns the first reason against it, CTL_REFUSAL_...; with CTL_REFUSAL_NONE the axis has been started.
 */
uint16_t ctl_start(ctl_motion* motion, const ctl_io* io);
/* Returns true while nothing speaks against ctl_start(), which also checks the active bank. */
bool ctl_may_start(const ctl_motion* motion, const ctl_io* io);
/* The line makes one bag. */
uint16_t ctl_start_bag(ctl_motion* motion, const ctl_io* io);
/* The knife alone makes one cut. */
uint16_t ctl_start_cut(ctl_motion* motion, const ctl_io* io);
/* Measures an axis, see ctl_motion_measure(). */
uint16_t ctl_start_measure(ctl_motion* motion, const ctl_io* io, uint16_t axis, uint16_t turns);
uint16_t ctl_start_home(ctl_motion* motion, const ctl_io* io);
/* Switches one output on at standstill, for CTL_TRY_HOLD_US, or off; returns CTL_REFUSAL_... */
uint16_t ctl_try_output(const ctl_motion* motion, ctl_io* io, uint16_t output, uint16_t on);

#ifdef __cplusplus
}
#endif

#endif
