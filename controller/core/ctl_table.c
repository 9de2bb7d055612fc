/* SPDX-License-Identifier: Apache-2.0 */
#include "ctl_table.h"

#include <stddef.h>

void ctl_table_init(ctl_table* table, const ctl_config* config)
{
    table->config = config;
    table->bank = NULL;
}

void ctl_table_reset(ctl_table* table, const ctl_bank* bank)
{
    table->bank = bank;
    switch (ctl_bank_layout(bank)) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        ctl_step_reset(&table->step, bank);
        break;
    default:
        break;
    }
}

void ctl_table_change_bank(ctl_table* table, const ctl_bank* bank)
{
    if (ctl_bank_layout(bank) != ctl_bank_layout(table->bank)) {
        ctl_table_reset(table, bank);
        return;
    }
    table->bank = bank;
    switch (ctl_bank_layout(bank)) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        ctl_step_change_bank(&table->step, bank);
        break;
    default:
        break;
    }
}

bool ctl_table_between_cycles(const ctl_table* table)
{
    switch (ctl_bank_layout(table->bank)) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        return ctl_step_between_cycles(&table->step);
    default:
        return true;
    }
}

void ctl_table_begin_cycle(ctl_table* table)
{
    switch (ctl_bank_layout(table->bank)) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        ctl_step_begin_cycle(&table->step);
        break;
    default:
        break;
    }
}

int64_t ctl_table_advance(ctl_table* table, uint32_t* ticks)
{
    switch (ctl_bank_layout(table->bank)) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        return ctl_step_advance(&table->step, ticks);
    default:
        return 0;
    }
}

uint32_t ctl_table_position(const ctl_table* table)
{
    if (ctl_table_between_cycles(table))
        return 0;
    switch (ctl_bank_layout(table->bank)) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        return table->step.cycle_ticks;
    default:
        return 0;
    }
}

int64_t ctl_table_full_speed_hz(const ctl_table* table)
{
    switch (ctl_bank_layout(table->bank)) {
    case CTL_TABLE_LAYOUT_STEP_TABLE: {
        const ctl_row row = table->step.current;
        return (int64_t)((uint64_t)row.pulses * table->config->timer_clock_hz / row.ticks);
    }
    default:
        return 0;
    }
}
