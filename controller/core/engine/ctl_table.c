/* SPDX-License-Identifier: Apache-2.0 */
#include "engine/ctl_table.h"

#include <stddef.h>

void ctl_table_init(ctl_table* table, const ctl_config* config)
{
    table->config = config;
    table->bank = NULL;
    table->layout = CTL_TABLE_LAYOUT_NONE;
}

void ctl_table_reset(ctl_table* table, const ctl_bank* bank)
{
    table->bank = bank;
    table->layout = ctl_bank_layout(bank);
    switch (table->layout) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        ctl_step_reset(&table->step, bank);
        break;
    case CTL_TABLE_LAYOUT_CAM_POINTS:
        ctl_cam_reset(&table->cam, bank, table->config);
        break;
    case CTL_TABLE_LAYOUT_INTERVALS:
        ctl_interval_reset(&table->interval, bank, table->config->timer_clock_hz);
        break;
    default:
        break;
    }
}

void ctl_table_change_bank(ctl_table* table, const ctl_bank* bank)
{
    if (ctl_bank_layout(bank) != table->layout) {
        ctl_table_reset(table, bank);
        return;
    }
    table->bank = bank;
    switch (table->layout) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        ctl_step_change_bank(&table->step, bank);
        break;
    case CTL_TABLE_LAYOUT_CAM_POINTS:
        ctl_cam_change_bank(&table->cam, bank);
        break;
    case CTL_TABLE_LAYOUT_INTERVALS:
        ctl_interval_change_bank(&table->interval, bank);
        break;
    default:
        break;
    }
}

bool ctl_table_between_cycles(const ctl_table* table)
{
    switch (table->layout) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        return ctl_step_between_cycles(&table->step);
    case CTL_TABLE_LAYOUT_CAM_POINTS:
        return !table->cam.in_cycle;
    case CTL_TABLE_LAYOUT_INTERVALS:
        return ctl_interval_between_cycles(&table->interval);
    default:
        return true;
    }
}

void ctl_table_begin_cycle(ctl_table* table, int32_t direction)
{
    switch (table->layout) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        ctl_step_begin_cycle(&table->step);
        break;
    case CTL_TABLE_LAYOUT_CAM_POINTS:
        ctl_cam_begin_cycle(&table->cam, direction);
        break;
    case CTL_TABLE_LAYOUT_INTERVALS:
        ctl_interval_begin_cycle(&table->interval);
        break;
    default:
        break;
    }
}

int64_t ctl_table_advance(ctl_table* table, int32_t direction, uint32_t* ticks, const ctl_pace* pace)
{
    switch (table->layout) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        return ctl_step_advance(&table->step, ticks, pace);
    case CTL_TABLE_LAYOUT_CAM_POINTS:
        ctl_cam_advance(&table->cam, direction, ticks);
        return 0;
    case CTL_TABLE_LAYOUT_INTERVALS:
        return ctl_interval_advance(&table->interval, ticks, pace);
    default:
        return 0;
    }
}

bool ctl_table_holding(const ctl_table* table)
{
    switch (table->layout) {
    case CTL_TABLE_LAYOUT_CAM_POINTS:
        return table->cam.holding;
    case CTL_TABLE_LAYOUT_INTERVALS:
        return ctl_interval_holding(&table->interval);
    default:
        return false;
    }
}

/* The accumulators take some ticks more or fewer than the header says. */
static uint32_t interval_position(const ctl_table* table)
{
    const uint32_t whole = ctl_bank_cycle_ticks(table->bank);
    const uint32_t passed = table->interval.cycle_ticks;
    return passed > whole || ctl_interval_holding(&table->interval) ? whole : passed;
}

uint32_t ctl_table_position(const ctl_table* table)
{
    if (ctl_table_between_cycles(table))
        return 0;
    switch (table->layout) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        return table->step.cycle_ticks;
    case CTL_TABLE_LAYOUT_CAM_POINTS:
        return (uint32_t)table->cam.position;
    case CTL_TABLE_LAYOUT_INTERVALS:
        return interval_position(table);
    default:
        return 0;
    }
}

uint32_t ctl_table_longest_pass(const ctl_table* table)
{
    return table->layout == CTL_TABLE_LAYOUT_CAM_POINTS ? ctl_cam_until_update(&table->cam) : UINT32_MAX;
}

int64_t ctl_table_pass(ctl_table* table, uint32_t ticks, const ctl_pace* pace)
{
    return table->layout == CTL_TABLE_LAYOUT_CAM_POINTS ? ctl_cam_pass(&table->cam, ticks, pace) : 0;
}

bool ctl_table_settled(const ctl_table* table)
{
    return table->layout != CTL_TABLE_LAYOUT_CAM_POINTS || ctl_cam_settled(&table->cam);
}

bool ctl_table_too_fast(const ctl_table* table)
{
    return table->layout == CTL_TABLE_LAYOUT_CAM_POINTS && ctl_cam_too_fast(&table->cam, table->config);
}

static int64_t row_hz(ctl_row row, const ctl_config* config)
{
    return (int64_t)((uint64_t)row.pulses * config->timer_clock_hz / row.ticks);
}

int64_t ctl_table_boundary_hz(const ctl_bank* bank, const ctl_config* config, bool end)
{
    switch (ctl_bank_layout(bank)) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        return row_hz(ctl_step_row(bank, end ? ctl_bank_row_count(bank) - 1u : 0u), config);
    case CTL_TABLE_LAYOUT_CAM_POINTS:
        return ctl_cam_boundary_hz(bank, config, end);
    default:
        return 0;
    }
}

int64_t ctl_table_hz(const ctl_table* table, const ctl_ramp* ramp)
{
    switch (table->layout) {
    case CTL_TABLE_LAYOUT_STEP_TABLE:
        return ctl_ramp_share(ramp, (uint32_t)row_hz(table->step.current, table->config));
    case CTL_TABLE_LAYOUT_CAM_POINTS:
        return ctl_cam_hz(&table->cam, table->config);
    case CTL_TABLE_LAYOUT_INTERVALS: {
        const int64_t full_speed_hz = ctl_interval_hz(&table->interval);
        const uint32_t share =
            ctl_ramp_share(ramp, (uint32_t)(full_speed_hz < 0 ? -full_speed_hz : full_speed_hz));
        return full_speed_hz < 0 ? -(int64_t)share : share;
    }
    default:
        return 0;
    }
}
