/* SPDX-License-Identifier: Apache-2.0 */
#include "ctl_bank.h"

#include "ctl_crc.h"
#include "ctl_words.h"

/* Keeps every product of the angle arithmetic inside 64 bits. */
#define MAX_PULSES_PER_MOTOR_REV 10000000u
#define FULL_CIRCLE 36000u /* 0.01 degrees */

static uint32_t wide(const ctl_bank* bank, uint32_t offset)
{
    return ctl_get32(&bank->registers[offset]);
}

uint32_t ctl_bank_row_count(const ctl_bank* bank)
{
    return bank->registers[CTL_OFFSET_BANK_ROW_COUNT];
}

uint32_t ctl_bank_length(const ctl_bank* bank)
{
    return CTL_BANK_HEADER_REGISTERS + CTL_ROW_REGISTERS * ctl_bank_row_count(bank);
}

uint32_t ctl_bank_crc(const ctl_bank* bank)
{
    return ~ctl_crc32_registers(CTL_CRC32_START, bank->registers, ctl_bank_length(bank));
}

uint32_t ctl_bank_cycle_ticks(const ctl_bank* bank)
{
    return wide(bank, CTL_OFFSET_BANK_CYCLE_TICKS);
}

ctl_row ctl_bank_row(const ctl_bank* bank, uint32_t index)
{
    const uint16_t* registers = &bank->registers[CTL_OFFSET_BANK_ROWS + CTL_ROW_REGISTERS * index];
    const ctl_row row = {registers[0], ctl_get32(&registers[1])};
    return row;
}

/* Pulses of one knife revolution, times the gear's denominator: a whole number. */
static uint64_t scaled_revolution(const ctl_bank* bank)
{
    return (uint64_t)wide(bank, CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV) *
           bank->registers[CTL_OFFSET_PROGRAM_GEAR_NUMERATOR];
}

uint32_t ctl_bank_revolution_pulses(const ctl_bank* bank, uint32_t knife_revolutions)
{
    const uint64_t pulses =
        scaled_revolution(bank) * knife_revolutions / bank->registers[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR];
    return pulses > UINT32_MAX ? UINT32_MAX : (uint32_t)pulses;
}

uint16_t ctl_bank_knife_angle(const ctl_bank* bank, int64_t position)
{
    const int64_t revolution = (int64_t)scaled_revolution(bank);
    if (revolution == 0)
        return 0;
    int64_t rest = position % revolution * bank->registers[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR] % revolution;
    if (rest < 0)
        rest += revolution;
    return (uint16_t)((uint64_t)rest * FULL_CIRCLE / (uint64_t)revolution);
}

static ctl_verdict refuse(uint16_t result, uint32_t detail)
{
    const ctl_verdict verdict = {result, (uint16_t)detail};
    return verdict;
}

/* Offset of the first header register outside its range; CTL_BANK_HEADER_REGISTERS when there is none. */
static uint32_t bad_header_offset(const ctl_bank* bank, uint32_t length)
{
    static const uint8_t angles[] = {CTL_OFFSET_BANK_CUT_ANGLE, CTL_OFFSET_BANK_SYNC_START,
                                     CTL_OFFSET_BANK_SYNC_END};
    const uint16_t* header = bank->registers;
    const uint32_t rows = ctl_bank_row_count(bank);
    if (header[CTL_OFFSET_BANK_LAYOUT] != CTL_TABLE_LAYOUT_STEP_TABLE)
        return CTL_OFFSET_BANK_LAYOUT;
    if (header[CTL_OFFSET_BANK_KIND] != CTL_PROGRAM_KIND_ROTARY_CUTTER)
        return CTL_OFFSET_BANK_KIND;
    if (rows == 0 || rows > CTL_ROW_CAPACITY || ctl_bank_length(bank) != length)
        return CTL_OFFSET_BANK_ROW_COUNT;
    if (ctl_bank_cycle_ticks(bank) == 0)
        return CTL_OFFSET_BANK_CYCLE_TICKS;
    if (wide(bank, CTL_OFFSET_BANK_DIVISOR) == 0)
        return CTL_OFFSET_BANK_DIVISOR;
    if (wide(bank, CTL_OFFSET_BANK_REMAINDER) >= wide(bank, CTL_OFFSET_BANK_DIVISOR))
        return CTL_OFFSET_BANK_REMAINDER;
    if (header[CTL_OFFSET_BANK_CARRY_ROW] >= rows)
        return CTL_OFFSET_BANK_CARRY_ROW;
    for (uint32_t i = 0; i < sizeof angles / sizeof angles[0]; ++i) {
        if (header[angles[i]] > FULL_CIRCLE)
            return angles[i];
    }
    if (header[CTL_OFFSET_PROGRAM_KNIVES] == 0)
        return CTL_OFFSET_PROGRAM_KNIVES;
    const uint32_t per_revolution = wide(bank, CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV);
    if (per_revolution == 0 || per_revolution > MAX_PULSES_PER_MOTOR_REV)
        return CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV;
    if (header[CTL_OFFSET_PROGRAM_GEAR_NUMERATOR] == 0)
        return CTL_OFFSET_PROGRAM_GEAR_NUMERATOR;
    if (header[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR] == 0)
        return CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR;
    return CTL_BANK_HEADER_REGISTERS;
}

/* Every distance between two of the row's pulses lies in the timer's and the output stage's range. */
static bool row_fits(ctl_row row, const ctl_config* config)
{
    const uint32_t longest_gap = (1u << config->timer_bits) - 1u;
    if (row.ticks == 0)
        return false;
    if (row.pulses == 0)
        return true;
    return (uint64_t)row.ticks * config->max_pulse_hz >= (uint64_t)row.pulses * config->timer_clock_hz &&
           row.ticks <= (uint64_t)row.pulses * longest_gap;
}

ctl_verdict ctl_bank_check(const ctl_bank* bank, const ctl_config* config, uint32_t length)
{
    const uint32_t bad_offset = bad_header_offset(bank, length);
    if (bad_offset != CTL_BANK_HEADER_REGISTERS)
        return refuse(CTL_TRANSFER_RESULT_BAD_HEADER, bad_offset);

    uint64_t ticks = 0;
    uint64_t pulses = 0;
    const uint32_t rows = ctl_bank_row_count(bank);
    for (uint32_t i = 0; i < rows; ++i) {
        const ctl_row row = ctl_bank_row(bank, i);
        if (!row_fits(row, config))
            return refuse(CTL_TRANSFER_RESULT_BAD_ROW, i);
        ticks += row.ticks;
        pulses += row.pulses;
    }
    const uint32_t carry = bank->registers[CTL_OFFSET_BANK_CARRY_ROW];
    ctl_row longer = ctl_bank_row(bank, carry);
    longer.pulses += 1;
    if (wide(bank, CTL_OFFSET_BANK_REMAINDER) != 0 && !row_fits(longer, config))
        return refuse(CTL_TRANSFER_RESULT_BAD_ROW, carry);
    if (ticks != ctl_bank_cycle_ticks(bank))
        return refuse(CTL_TRANSFER_RESULT_BAD_SUM, CTL_OFFSET_BANK_CYCLE_TICKS);
    if (pulses != wide(bank, CTL_OFFSET_BANK_CYCLE_PULSES))
        return refuse(CTL_TRANSFER_RESULT_BAD_SUM, CTL_OFFSET_BANK_CYCLE_PULSES);
    return refuse(CTL_TRANSFER_RESULT_ACCEPTED, 0);
}

bool ctl_bank_same_machine(const ctl_bank* one, const ctl_bank* other)
{
    return wide(one, CTL_OFFSET_PROGRAM_KNIFE_RADIUS) == wide(other, CTL_OFFSET_PROGRAM_KNIFE_RADIUS) &&
           one->registers[CTL_OFFSET_PROGRAM_KNIVES] == other->registers[CTL_OFFSET_PROGRAM_KNIVES] &&
           wide(one, CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV) ==
               wide(other, CTL_OFFSET_PROGRAM_PULSES_PER_MOTOR_REV) &&
           one->registers[CTL_OFFSET_PROGRAM_GEAR_NUMERATOR] ==
               other->registers[CTL_OFFSET_PROGRAM_GEAR_NUMERATOR] &&
           one->registers[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR] ==
               other->registers[CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR];
}
