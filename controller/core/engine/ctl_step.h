/* SPDX-License-Identifier: Apache-2.0 */
/* The step-table engine. A row is `pulses` pulses over `ticks` timer ticks; pulse j (1..pulses) comes
 * floor(j * ticks / pulses) ticks after the row's start, so the last one comes at the row's end. Two ways
 * through a table give the same pulses at the same ticks: ctl_step_next() one event at a time, as a timer
 * interrupt does, and ctl_step_advance() by a number of ticks at once. Both stop at the end of the cycle. */
#ifndef CTL_STEP_H
#define CTL_STEP_H

#include "base/ctl_bank.h"
#include "base/ctl_pace.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    uint32_t pulses;
    uint32_t ticks;
} ctl_row;

typedef struct {
    const ctl_bank* bank;
    uint32_t row;         /* being executed; the number of rows between two cycles */
    ctl_row current;      /* that row, with this cycle's carry in it */
    uint32_t row_ticks;   /* passed in the row */
    ctl_train train;      /* pulses left in the row, at ticks of the row */
    uint32_t cycle_ticks; /* passed in the cycle */
    uint32_t owed;        /* fraction of a pulse owed, numerator over the bank's divisor */
    bool carries;         /* this cycle has one pulse more */
} ctl_step;

typedef struct {
    uint16_t ticks; /* until the event */
    bool pulse;     /* a pulse is due then; otherwise only a stretch of a pause is over */
} ctl_event;

ctl_row ctl_step_row(const ctl_bank* bank, uint32_t index);
/* Checks what ctl_bank_check() leaves to the engine: the rest of the header, every row, their sums; at most
 * `rows` rows in this call, CTL_TRANSFER_RESULT_BUSY while there are more. */
ctl_verdict ctl_step_check(const ctl_bank* bank, const ctl_config* config, ctl_row_check* check,
                           uint32_t rows);

/* Stand between two cycles of `bank` with no fraction owed. */
void ctl_step_reset(ctl_step* step, const ctl_bank* bank);
/* Between two cycles: go on with another bank; what is owed is kept. */
void ctl_step_change_bank(ctl_step* step, const ctl_bank* bank);
bool ctl_step_between_cycles(const ctl_step* step);
/* Between two cycles: start the next one; the bank's remainder becomes due. */
void ctl_step_begin_cycle(ctl_step* step);

/* Moves to the next event of the cycle begun. */
ctl_event ctl_step_next(ctl_step* step);
/* Moves on by *ticks, at most to the end of the cycle; returns the pulses emitted, *ticks becomes what was
 * used. */
uint32_t ctl_step_advance(ctl_step* step, uint32_t* ticks, const ctl_pace* pace);
/* Pulses emitted in the row. */
uint32_t ctl_step_row_pulses(const ctl_step* step);

#ifdef __cplusplus
}
#endif

#endif
