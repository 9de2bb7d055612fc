/* SPDX-License-Identifier: Apache-2.0 */
#include "packer/ctl_gate.h"

#include "ctl_registers.h"

#define ONE_BITS CTL_SMOOTH_BITS
#define ONE (UINT64_C(1) << ONE_BITS)
#define INVERSE_BITS 62u

void ctl_gate_reset(ctl_gate* gate, uint32_t cycle, uint32_t engage, uint32_t release)
{
    gate->cycle = cycle;
    gate->engage = engage;
    gate->release = release;
    gate->state = CTL_GATE_STATE_RUNNING;
    gate->phase = 0;
    gate->passed = 0;
    gate->ramped = 0;
    gate->inverse = 0;
    gate->dwell = 0;
    gate->answered = false;
}

/* Its own way in the ramp of this state: half of what the driver travels meanwhile. */
static uint32_t ramp_way(const ctl_gate* gate)
{
    return gate->state == CTL_GATE_STATE_SLOWING ? gate->cycle - gate->release : gate->engage;
}

/* Driver ticks of this state. */
static uint64_t state_ticks(const ctl_gate* gate)
{
    return gate->state == CTL_GATE_STATE_STANDING ? gate->dwell : 2u * (uint64_t)ramp_way(gate);
}

/* The share of the ramp that has passed, rounded down: by the inverse it may be one too small. */
static uint64_t share_of_ramp(const ctl_gate* gate, uint64_t passed)
{
    const uint64_t whole = 2u * (uint64_t)ramp_way(gate);
    if (gate->inverse == 0)
        return (passed << ONE_BITS) / whole;
    const uint64_t x = passed * gate->inverse >> (INVERSE_BITS - ONE_BITS);
    return (passed << ONE_BITS) - x * whole >= whole ? x + 1u : x;
}

/* Slowing down over the way a takes 2 a of the driver: after the share x of that, 2 a (x - x^3 + x^4 / 2). */
static uint32_t slowed(const ctl_gate* gate, uint64_t passed)
{
    const uint32_t way = ramp_way(gate);
    const uint64_t x = share_of_ramp(gate, passed);
    const uint64_t x2 = x * x >> ONE_BITS;
    uint64_t share = x - (x2 * x >> ONE_BITS) + (x2 * x2 >> (ONE_BITS + 1u));
    if (share > ONE / 2u)
        share = ONE / 2u;
    return (uint32_t)(2u * (uint64_t)way * share >> ONE_BITS);
}

static uint32_t way_travelled(const ctl_gate* gate)
{
    const uint32_t way = ramp_way(gate);
    if (gate->state == CTL_GATE_STATE_SLOWING)
        return slowed(gate, gate->passed);
    return way - slowed(gate, 2u * (uint64_t)way - gate->passed);
}

bool ctl_gate_asks(const ctl_gate* gate)
{
    if (gate->state == CTL_GATE_STATE_RUNNING)
        return gate->phase == gate->release && !gate->answered;
    return gate->state == CTL_GATE_STATE_STANDING && gate->passed == gate->dwell;
}

static void begin(ctl_gate* gate, uint16_t state)
{
    gate->state = state;
    gate->passed = 0;
    gate->ramped = 0;
    gate->inverse = 0;
}

void ctl_gate_stand(ctl_gate* gate)
{
    begin(gate, CTL_GATE_STATE_STANDING);
    gate->dwell = gate->cycle - gate->engage;
}

void ctl_gate_answer(ctl_gate* gate, bool wait)
{
    if (gate->state == CTL_GATE_STATE_STANDING) {
        if (wait)
            gate->dwell += gate->cycle;
        else
            begin(gate, CTL_GATE_STATE_CATCHING_UP);
        return;
    }
    gate->answered = true;
    if (wait)
        begin(gate, CTL_GATE_STATE_SLOWING);
}

uint32_t ctl_gate_piece(const ctl_gate* gate)
{
    if (gate->state != CTL_GATE_STATE_RUNNING) {
        const uint64_t left = state_ticks(gate) - gate->passed;
        return left < UINT32_MAX ? (uint32_t)left : UINT32_MAX;
    }
    if (gate->answered)
        return gate->cycle - gate->phase;
    return gate->release - gate->phase;
}

static void end_state(ctl_gate* gate)
{
    if (gate->state == CTL_GATE_STATE_SLOWING) {
        /* Two ramps take twice their way; the rest of the cycle that is left out is spent standing. */
        gate->dwell = gate->release - gate->engage;
        gate->phase = 0;
        begin(gate, CTL_GATE_STATE_STANDING);
    } else if (gate->state == CTL_GATE_STATE_CATCHING_UP) {
        gate->answered = false;
        begin(gate, CTL_GATE_STATE_RUNNING);
    }
}

uint32_t ctl_gate_advance(ctl_gate* gate, uint32_t ticks)
{
    if (ticks == 0)
        return 0;
    if (gate->state == CTL_GATE_STATE_RUNNING) {
        gate->phase += ticks;
        if (gate->phase == gate->cycle) {
            gate->phase = 0;
            gate->answered = false;
        }
        return ticks;
    }
    uint32_t own = 0;
    if (gate->state == CTL_GATE_STATE_STANDING) {
        gate->passed += ticks;
        return own;
    }
    if (gate->inverse == 0 && gate->passed != 0 && state_ticks(gate) <= UINT32_MAX)
        gate->inverse = ((uint64_t)1 << INVERSE_BITS) / state_ticks(gate);
    gate->passed += ticks;
    const uint32_t ramped = way_travelled(gate);
    if (ramped > gate->ramped) { /* the last bits may say that it went back */
        own = ramped - gate->ramped;
        gate->ramped = ramped;
        gate->phase += own;
    }
    if (gate->passed == state_ticks(gate))
        end_state(gate);
    return own;
}
