/* SPDX-License-Identifier: Apache-2.0 */
/* Every check that a bank must pass before a press executes it. */
#include "ctl_press.h"

#include "ctl_words.h"

/* Keeps every distance of a stroke inside 31 bits. */
#define FARTHEST_PULSES (INT32_MAX / 2)

/* Offset of the first header register outside its range; CTL_BANK_HEADER_REGISTERS when there is none. */
static uint32_t bad_header_offset(const ctl_bank* bank)
{
    const uint16_t* header = bank->registers;
    if (header[CTL_OFFSET_PRESS_MIN_STOP_FORCE] > header[CTL_OFFSET_PRESS_MAX_STOP_FORCE])
        return CTL_OFFSET_PRESS_MIN_STOP_FORCE;
    if (ctl_get32(&header[CTL_OFFSET_PRESS_FEED]) == 0)
        return CTL_OFFSET_PRESS_FEED;
    return ctl_bank_bad_cycle(bank);
}

static bool moves_well(ctl_press_row row, const ctl_config* config)
{
    return row.frequency_hz != 0 && row.frequency_hz <= config->max_pulse_hz &&
           row.time_ms <= CTL_COUNT_MAX_RAMP_MS && row.end >= -FARTHEST_PULSES && row.end <= FARTHEST_PULSES;
}

/* The row that cannot be executed; CTL_PRESS_ROWS when there is none. */
static uint32_t bad_row(const ctl_bank* bank, const ctl_config* config)
{
    ctl_press_row rows[CTL_PRESS_ROWS];
    for (uint32_t i = 0; i < CTL_PRESS_ROWS; ++i) {
        rows[i] = ctl_press_row_of(bank, i);
        if (i != CTL_PRESS_HOLD && !moves_well(rows[i], config))
            return i;
    }
    if (rows[CTL_PRESS_APPROACH].end < rows[CTL_PRESS_RETURN].end || rows[CTL_PRESS_APPROACH].force == 0)
        return CTL_PRESS_APPROACH;
    if (rows[CTL_PRESS_PROBE].end <= rows[CTL_PRESS_APPROACH].end || rows[CTL_PRESS_PROBE].force == 0)
        return CTL_PRESS_PROBE;
    if (rows[CTL_PRESS_PRESS].end < rows[CTL_PRESS_PROBE].end ||
        rows[CTL_PRESS_PRESS].force <= rows[CTL_PRESS_PROBE].force)
        return CTL_PRESS_PRESS;
    return CTL_PRESS_ROWS;
}

ctl_verdict ctl_press_check(const ctl_bank* bank, const ctl_config* config)
{
    const uint32_t offset = bad_header_offset(bank);
    if (offset != CTL_BANK_HEADER_REGISTERS)
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_HEADER, offset);
    const uint32_t row = bad_row(bank, config);
    if (row != CTL_PRESS_ROWS)
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_ROW, row);
    return ctl_refuse(CTL_TRANSFER_RESULT_ACCEPTED, 0);
}
