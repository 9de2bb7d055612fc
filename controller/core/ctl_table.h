/* SPDX-License-Identifier: Apache-2.0 */
/* The table being executed: the engine of the active bank's layout behind one set of functions. What moves
 * the axis knows this file only; a layout is added by one more engine here and one more row in ctl_bank.c.
 * Ticks are the master's: at full speed a master tick is a timer tick. */
#ifndef CTL_TABLE_H
#define CTL_TABLE_H

#include "ctl_bank.h"
#include "ctl_step.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    const ctl_config* config;
    const ctl_bank* bank; /* NULL until there is one */
    union {
        ctl_step step;
    };
} ctl_table;

void ctl_table_init(ctl_table* table, const ctl_config* config);
/* Stand between two cycles of `bank` with no fraction owed. */
void ctl_table_reset(ctl_table* table, const ctl_bank* bank);
/* Between two cycles: go on with another bank; what is owed is kept when the layout is the same. */
void ctl_table_change_bank(ctl_table* table, const ctl_bank* bank);
bool ctl_table_between_cycles(const ctl_table* table);
/* Between two cycles: start the next one. */
void ctl_table_begin_cycle(ctl_table* table);
/* Moves on by *ticks, at most to the end of the cycle; returns the pulses that leave meanwhile, *ticks
 * becomes what was used. */
int64_t ctl_table_advance(ctl_table* table, uint32_t* ticks);
/* Ticks from the start of the cycle, 0 between two cycles. */
uint32_t ctl_table_position(const ctl_table* table);
/* Pulse frequency here if the master ran at full speed. */
int64_t ctl_table_full_speed_hz(const ctl_table* table);

#ifdef __cplusplus
}
#endif

#endif
