/* SPDX-License-Identifier: Apache-2.0 */
/* The pins of the machine beside its axes. */
#ifndef CTL_IO_H
#define CTL_IO_H

#include "motion/ctl_motion.h"
#include "motion/ctl_switches.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    uint16_t outputs; /* bits CTL_OUTPUT_BIT_..., as they are now */
    ctl_switches switches;
} ctl_io;

void ctl_io_init(ctl_io* io, const ctl_board* board);
/* Ends a slice: the cam switches follow what has moved. */
void ctl_io_slice(ctl_io* io, const ctl_motion* motion);

#ifdef __cplusplus
}
#endif

#endif
