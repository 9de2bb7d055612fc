/* SPDX-License-Identifier: Apache-2.0 */
/* Every check that a bank must pass before a press executes it. */
#include "engine/ctl_press.h"

#include "base/ctl_words.h"

/* Keeps every distance of a stroke inside 31 bits. */
#define FARTHEST_PULSES (INT32_MAX / 2)

/* Offset of the first header register outside its range; CTL_BANK_HEADER_REGISTERS when there is none. */
static uint32_t bad_header_offset(const ctl_bank* bank, const ctl_config* config)
{
    const uint16_t* header = bank->registers;
    if (header[CTL_OFFSET_PRESS_MIN_STOP_FORCE] > header[CTL_OFFSET_PRESS_MAX_STOP_FORCE])
        return CTL_OFFSET_PRESS_MIN_STOP_FORCE;
    return ctl_bank_bad_cycle(bank, config);
}

static bool moves_well(ctl_press_row row, const ctl_config* config)
{
    return row.frequency_hz != 0 && row.frequency_hz <= config->max_pulse_hz &&
           row.time_ms <= CTL_COUNT_MAX_RAMP_MS && row.end >= -FARTHEST_PULSES && row.end <= FARTHEST_PULSES;
}

/* The row that cannot be executed; CTL_STAGE_COUNT when there is none. */
static uint32_t bad_row(const ctl_bank* bank, const ctl_config* config)
{
    ctl_press_row rows[CTL_STAGE_COUNT];
    for (uint32_t i = 0; i < CTL_STAGE_COUNT; ++i) {
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
    return CTL_STAGE_COUNT;
}

/* Offset of the first position in the header that its row does not end at; CTL_BANK_HEADER_REGISTERS when
 * there is none. */
static uint32_t other_position(const ctl_bank* bank)
{
    static const uint8_t positions[][2] = {{CTL_PRESS_APPROACH, CTL_OFFSET_PRESS_APPROACH_POSITION},
                                           {CTL_PRESS_PROBE, CTL_OFFSET_PRESS_PROBE_END},
                                           {CTL_PRESS_PRESS, CTL_OFFSET_PRESS_PRESS_POSITION}};
    for (uint32_t i = 0; i < sizeof positions / sizeof positions[0]; ++i) {
        const uint32_t offset = positions[i][1];
        if (!ctl_bank_is_distance(bank, ctl_press_row_of(bank, positions[i][0]).end,
                                  ctl_get32(&bank->registers[offset])))
            return offset;
    }
    return CTL_BANK_HEADER_REGISTERS;
}

ctl_verdict ctl_press_check(const ctl_bank* bank, const ctl_config* config)
{
    const uint32_t offset = bad_header_offset(bank, config);
    if (offset != CTL_BANK_HEADER_REGISTERS)
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_HEADER, offset);
    const uint32_t row = bad_row(bank, config);
    if (row != CTL_STAGE_COUNT)
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_ROW, row);
    const uint32_t other = other_position(bank);
    if (other != CTL_BANK_HEADER_REGISTERS)
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_SUM, other);
    return ctl_refuse(CTL_TRANSFER_RESULT_ACCEPTED, 0);
}
