/* SPDX-License-Identifier: Apache-2.0 */
/* A bank of constant-acceleration intervals: feeds its rows to the pulse generator, always one ahead, and
 * keeps the generator's iterations against the ticks of the timer, exactly. Stops at the end of the cycle, as
 * the step-table engine does. */
#ifndef CTL_INTERVAL_H
#define CTL_INTERVAL_H

#include "base/ctl_bank.h"
#include "base/ctl_pace.h"
#include "engine/ctl_dda.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    const ctl_bank* bank;
    uint32_t rows; /* when it was checked: a bank damaged later must not lead out of itself */
    ctl_dda dda;
    uint32_t next_row; /* to be written to the generator */
    bool in_cycle;
    int32_t direction;        /* 1 or -1 */
    uint32_t cycle_ticks;     /* passed in the cycle */
    uint32_t owed;            /* fraction of a pulse owed, numerator over the bank's divisor */
    bool carries;             /* this cycle ends one pulse further forward */
    uint32_t iterations;      /* iterations / ticks is the ratio of the two clocks */
    uint32_t ticks;           /* both without a common divisor */
    uint64_t iterations_rest; /* of an iteration that passed, in 1 / ticks */
} ctl_interval;

ctl_interval_row ctl_interval_bank_row(const ctl_bank* bank, uint32_t index);

/* Stand between two cycles of `bank` with no fraction owed. */
void ctl_interval_reset(ctl_interval* interval, const ctl_bank* bank, uint32_t timer_clock_hz);
/* Between two cycles: go on with another bank; what is owed is kept. */
void ctl_interval_change_bank(ctl_interval* interval, const ctl_bank* bank);
bool ctl_interval_between_cycles(const ctl_interval* interval);
/* Between two cycles: start the next one; the bank's remainder becomes due. A whole pulse owed makes the last
 * row one longer, backwards one shorter. */
void ctl_interval_begin_cycle(ctl_interval* interval);
/* Moves on by *ticks, at most to the end of the cycle; returns the pulses, negative in reverse. *ticks
 * becomes what was used: a cycle ends with the tick in or at the end of which its last pulse came. */
int32_t ctl_interval_advance(ctl_interval* interval, uint32_t* ticks, const ctl_pace* pace);

/* The table is over and its last speed is held, as bank.end_behavior says; such a cycle ends with a reset or
 * a change of bank only. */
bool ctl_interval_holding(const ctl_interval* interval);
/* Pulse frequency now, negative in reverse, 0 between two cycles. */
int64_t ctl_interval_hz(const ctl_interval* interval);

/* Checks what ctl_bank_check() leaves to the engine: the rest of the header, every row, their sum. No table
 * may repeat. */
ctl_verdict ctl_interval_check(const ctl_bank* bank, const ctl_config* config);
/* The same, at most `rows` rows in this call; CTL_TRANSFER_RESULT_BUSY while there are more. */
ctl_verdict ctl_interval_check_some(const ctl_bank* bank, const ctl_config* config, ctl_row_check* check,
                                    uint32_t rows);

#ifdef __cplusplus
}
#endif

#endif
