/* SPDX-License-Identifier: Apache-2.0 */
/* The table being executed: the engine of the active bank's layout behind one set of functions. What moves
 * the axis knows this file only; a layout is added by one more engine here and one more row in ctl_bank.c.
 * Ticks are the master's: at full speed a master tick is a timer tick. */
#ifndef CTL_TABLE_H
#define CTL_TABLE_H

#include "base/ctl_bank.h"
#include "engine/ctl_cam.h"
#include "engine/ctl_interval.h"
#include "engine/ctl_ramp.h"
#include "engine/ctl_step.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    const ctl_config* config;
    const ctl_bank* bank; /* NULL until there is one */
    uint16_t layout;      /* of that bank */
    union {
        ctl_step step;
        ctl_cam cam;
        ctl_interval interval;
    };
} ctl_table;

void ctl_table_init(ctl_table* table, const ctl_config* config);
/* Stand between two cycles of `bank` with no fraction owed. */
void ctl_table_reset(ctl_table* table, const ctl_bank* bank);
/* Between two cycles: go on with another bank; what is owed is kept when the layout is the same. */
void ctl_table_change_bank(ctl_table* table, const ctl_bank* bank);
bool ctl_table_between_cycles(const ctl_table* table);
/* Between two cycles: start the next one, where the layout allows it also backwards (-1). */
void ctl_table_begin_cycle(ctl_table* table, int32_t direction);
/* Moves on by *ticks, at most to the end of the cycle, which is not the end where the last speed is held;
 * returns the pulses that leave as the master advances, *ticks becomes what was used. */
int64_t ctl_table_advance(ctl_table* table, int32_t direction, uint32_t* ticks, const ctl_pace* pace);
/* The cycle is over and its last speed is held. */
bool ctl_table_holding(const ctl_table* table);
/* Ticks from the start of the cycle, at most those of a cycle; 0 between two cycles. */
uint32_t ctl_table_position(const ctl_table* table);

/* Most timer ticks that may pass at once. */
uint32_t ctl_table_longest_pass(const ctl_table* table);
/* So many timer ticks pass; returns the pulses that leave by the engine's own pace. */
int64_t ctl_table_pass(ctl_table* table, uint32_t ticks, const ctl_pace* pace);
/* All pulses up to where the master stands have left. */
bool ctl_table_settled(const ctl_table* table);
/* The master runs so fast that the output stage cannot follow. */
bool ctl_table_too_fast(const ctl_table* table);
/* Pulse frequency at full speed of a bank that repeats: where a cycle ends, or where one begins. */
int64_t ctl_table_boundary_hz(const ctl_bank* bank, const ctl_config* config, bool end);
/* Pulse frequency now, with the master at the speed of `ramp`. */
int64_t ctl_table_hz(const ctl_table* table, const ctl_ramp* ramp);

#ifdef __cplusplus
}
#endif

#endif
