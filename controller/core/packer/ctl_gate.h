/* SPDX-License-Identifier: Apache-2.0 */
/* A follower that goes with its driver cycle by cycle and can let it run on alone for whole cycles: the knife
 * behind the film (electronic anti-cut), film and knife behind the infeed (no product, no bag). It leaves
 * where the sealing window ends, comes to stand at the boundary of its cycle, and is back in phase and at
 * full speed where the next window begins; so nothing is ever sealed at another speed. Both its ramps are
 * 1 - 3 x^2 + 2 x^3 of the driver's speed, x the share of the ramp's time. Ticks of the master's table. */
#ifndef CTL_GATE_H
#define CTL_GATE_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    uint32_t cycle;
    uint32_t engage; /* the sealing window, 0 < engage < release < cycle */
    uint32_t release;
    uint16_t state;  /* CTL_GATE_STATE_... */
    uint32_t phase;  /* where it stands in its cycle, 0..cycle-1 */
    uint64_t passed; /* ticks of the driver since this state began; not while running */
    uint32_t ramped; /* its own ticks of the ramp under way */
    uint64_t dwell;  /* that it stands */
    bool answered;   /* running: the question of this cycle */
} ctl_gate;

/* In phase with a driver at the start of its cycle. */
void ctl_gate_reset(ctl_gate* gate, uint32_t cycle, uint32_t engage, uint32_t release);
/* At the start of a cycle, the driver too: stand until it is asked again, one cycle behind. */
void ctl_gate_stand(ctl_gate* gate);
/* It must be told whether to wait: at the end of a sealing window, and while standing at the last moment. */
bool ctl_gate_asks(const ctl_gate* gate);
void ctl_gate_answer(ctl_gate* gate, bool wait);
/* Ticks of the driver up to the next question or change of state; 0 while it asks. */
uint32_t ctl_gate_piece(const ctl_gate* gate);
/* The driver moves on by `ticks`, at most a piece; returns the gate's own. */
uint32_t ctl_gate_advance(ctl_gate* gate, uint32_t ticks);

/* Share 3 x^2 - 2 x^3 of `amount` at x = part / whole; part <= whole, whole not 0. */
int64_t ctl_smooth_share(int64_t amount, uint64_t part, uint64_t whole);
/* The same for a share x = part / whole, in 1 / 2^CTL_SMOOTH_BITS, below 1. */
int64_t ctl_smooth_at(int64_t amount, uint64_t x);
#define CTL_SMOOTH_BITS 30u

#ifdef __cplusplus
}
#endif

#endif
