/* SPDX-License-Identifier: Apache-2.0 */
/* A follower that can wait for whole cycles of its driver: the knife behind the film (electronic anti-cut),
 * film and knife behind the infeed (no product, no bag). It starts to decelerate at the end of the sealing
 * window, stops at the boundary of its cycle, and is in phase and at full speed again at the start of a later
 * window; nothing is sealed at another speed. Both its ramps are 1 - 3 x^2 + 2 x^3 of the driver's speed, x
 * the share of the ramp's time. Ticks of the master's table. */
#ifndef CTL_GATE_H
#define CTL_GATE_H

#include "base/ctl_smooth.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    uint32_t cycle;
    uint32_t engage; /* the sealing window, 0 < engage < release < cycle */
    uint32_t release;
    uint16_t state;   /* CTL_GATE_STATE_... */
    uint32_t phase;   /* position in its cycle, 0..cycle-1 */
    uint64_t passed;  /* ticks of the driver since this state began; not while running */
    uint32_t ramped;  /* its own ticks of the present ramp */
    uint64_t inverse; /* 2^62 / the ticks of the ramp, from its second slice on; 0: not yet */
    uint64_t dwell;   /* duration of its standstill */
    bool answered;    /* running: the question of this cycle was answered */
} ctl_gate;

/* Sets the gate in phase with a driver at the start of its cycle. */
void ctl_gate_reset(ctl_gate* gate, uint32_t cycle, uint32_t engage, uint32_t release);
/* At the start of a cycle of gate and driver: waits until the next question, one cycle behind. */
void ctl_gate_stand(ctl_gate* gate);
/* Returns true when it needs an answer whether to wait: at the end of a sealing window, and at standstill at
 * the last possible tick. */
bool ctl_gate_asks(const ctl_gate* gate);
void ctl_gate_answer(ctl_gate* gate, bool wait);
/* Returns the ticks of the driver to the next question or change of state; 0 while it asks. */
uint32_t ctl_gate_piece(const ctl_gate* gate);
/* Advances the driver by `ticks`, at most a piece; returns the ticks of the gate. */
uint32_t ctl_gate_advance(ctl_gate* gate, uint32_t ticks);

#ifdef __cplusplus
}
#endif

#endif
