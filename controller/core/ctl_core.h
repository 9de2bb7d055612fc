/* SPDX-License-Identifier: Apache-2.0 */
/* The controller as one value: fill a ctl_config and a ctl_port, ctl_init(), feed it bytes with
 * ctl_receive(), call ctl_tick() often, send what ctl_take_answer() gives. Not reentrant: one context calls
 * all of it. */
#ifndef CTL_CORE_H
#define CTL_CORE_H

#include "link/ctl_parts.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Power-up: loads the newest valid flash slot. The port's context must outlive the core. */
void ctl_init(ctl_core* core, const ctl_config* config, const ctl_port* port, uint64_t now_us);
/* Bytes off the line; the last of them ended at now_us. */
void ctl_receive(ctl_core* core, const uint8_t* bytes, size_t size, uint64_t now_us);
/* The receiver saw a parity, framing or overrun error: the frame under way will be dropped. */
void ctl_receive_error(ctl_core* core, uint64_t now_us);
/* The answer that is ready, to be sent now; at most CTL_FRAME_BYTES. Returns its size, 0 when there is none.
 * With config.work_registers a long one needs several calls; a slice in between keeps the pulses in time. */
size_t ctl_take_answer(ctl_core* core, uint8_t* bytes);
/* Ends the frame under way when the line has been silent for long enough; ctl_tick() does it too. */
void ctl_receive_silence(ctl_core* core, uint64_t now_us);
/* The only clock: moves everything on to now_us, in slices of at most config.slice_us. */
void ctl_tick(ctl_core* core, uint64_t now_us);

/* The knife closed over the film when the film motor stood there, 1/256 pulse. */
void ctl_on_cut(ctl_core* core, int64_t film);
/* The bag that ended with the last cut was measured. */
void ctl_on_bag_cut(ctl_core* core, uint32_t length_um);

#ifdef __cplusplus
}
#endif

#endif
