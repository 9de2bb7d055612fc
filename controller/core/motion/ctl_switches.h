/* SPDX-License-Identifier: Apache-2.0 */
/* Cam switches: outputs that are on from one angle of the cycle to another. Each switches earlier by its
 * lead, the delay of what it drives, at the present speed. Angles are shares of the cycle in 1/2^32, so that
 * they wrap as the cycle does. */
#ifndef CTL_SWITCHES_H
#define CTL_SWITCHES_H

#include "base/ctl_bank.h"
#include "base/ctl_board.h"

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_SWITCH_SPEED_BITS 24u
#define CTL_SWITCH_INVERSE_BITS 56u

/* The cycle that the switches follow. */
typedef struct {
    uint32_t position; /* ticks from the start of the cycle */
    uint32_t cycle;    /* ticks */
    int32_t direction; /* 1 or -1 */
    uint32_t speed;    /* against the table's, in 1 / 2^CTL_SWITCH_SPEED_BITS */
} ctl_switch_cycle;

typedef struct {
    bool on;
    bool rejects;  /* the last bag is to be rejected, and was not yet */
    uint32_t lead; /* how far ahead of the cycle the switch is */
    uint32_t hold; /* both edges came at once: stays on for this part of the cycle */
    uint16_t mode; /* the parameters that it follows */
    uint16_t on_angle;
    uint16_t off_angle;
    uint32_t on_part; /* its angles in 1 / 2^32 of the cycle */
    uint32_t off_part;
    uint64_t lead_ticks; /* its lead at full speed */
} ctl_switch;

typedef struct {
    ctl_switch each[CTL_SWITCH_COUNT];
    bool follows; /* a cycle is under way */
    int32_t direction;
    uint32_t angle;           /* of the cycle, counted in its direction */
    uint32_t number;          /* of the cycle */
    uint32_t settings;        /* board->parameter_writes when the parameters were read, and one */
    ctl_switch_cycle present; /* the cycle and the speed that the leads are for */
    uint32_t quiet;           /* no edge comes while the cycle moves by less and the leads stay */
    uint16_t levels;          /* as returned last */
    uint64_t inverse;         /* of present.cycle, 2^CTL_SWITCH_INVERSE_BITS / ticks */
} ctl_switches;

/* Follows the cycle to its present position; NULL: no motion, all are off. Returns the levels, bit n: switch
 * n + 1. */
uint16_t ctl_switches_slice(ctl_switches* switches, const ctl_board* board, const ctl_switch_cycle* cycle);
/* Returns true when one of them is on for rejected bags. */
bool ctl_switches_reject(const ctl_board* board);
/* Handles a cut. */
void ctl_switches_bag(ctl_switches* switches, bool rejected);
/* Returns true when the program has a cycle that switches can follow: it repeats. */
bool ctl_switches_serve(const ctl_bank* bank);
/* Returns CTL_REFUSAL_..., the reason why `bank` cannot be run with the present parameters. */
uint16_t ctl_switches_refusal(const ctl_board* board, const ctl_bank* bank);

#ifdef __cplusplus
}
#endif

#endif
