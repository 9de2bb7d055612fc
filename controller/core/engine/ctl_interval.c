/* SPDX-License-Identifier: Apache-2.0 */
#include "engine/ctl_interval.h"

#include "base/ctl_words.h"

#include <stddef.h>

#define MAX_ITERATIONS 0x80000000u /* in one go */

static int32_t advance_of(const ctl_bank* bank)
{
    return (int32_t)ctl_get32(&bank->registers[CTL_OFFSET_BANK_ADVANCE]);
}

static uint32_t fraction_bits(const ctl_bank* bank)
{
    return bank->registers[CTL_OFFSET_INTERVAL_FRACTION_BITS];
}

ctl_interval_row ctl_interval_bank_row(const ctl_bank* bank, uint32_t index)
{
    const uint16_t* registers = ctl_bank_row_at(bank, index, CTL_INTERVAL_REGISTERS);
    const ctl_interval_row row = {ctl_get32(&registers[0]), ctl_get32(&registers[2]),
                                  ctl_get32(&registers[4]), ctl_get32(&registers[6])};
    return row;
}

/* Keeps the generator one row ahead; a speed that is held is one more row, without end. */
static void feed(ctl_interval* interval)
{
    const uint32_t rows = interval->rows;
    while (interval->next_row < rows && (ctl_dda_status(&interval->dda) & CTL_DDA_WRITABLE) != 0) {
        ctl_interval_row row = ctl_interval_bank_row(interval->bank, interval->next_row);
        interval->next_row += 1;
        if (interval->carries && interval->next_row == rows)
            row.distance += (uint32_t)interval->direction;
        (void)ctl_dda_write(&interval->dda, row);
    }
    const bool holds = ctl_bank_at_end(interval->bank) == CTL_END_BEHAVIOR_HOLD_SPEED;
    if (holds && interval->next_row == rows && (ctl_dda_status(&interval->dda) & CTL_DDA_WRITABLE) != 0) {
        ctl_interval_row row = ctl_interval_bank_row(interval->bank, rows - 1u);
        row.distance = UINT32_MAX;
        row.first_speed = row.last_speed;
        interval->next_row += 1;
        (void)ctl_dda_write(&interval->dda, row);
    }
}

static void stand(ctl_interval* interval, const ctl_bank* bank)
{
    interval->bank = bank;
    interval->rows = ctl_bank_row_count(bank);
    interval->direction = advance_of(bank) < 0 ? -1 : 1;
    interval->in_cycle = false;
    interval->cycle_ticks = 0;
    interval->next_row = 0;
    ctl_dda_reset(&interval->dda, fraction_bits(bank));
}

static uint32_t common_divisor(uint32_t a, uint32_t b)
{
    while (b != 0) {
        const uint32_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

void ctl_interval_reset(ctl_interval* interval, const ctl_bank* bank, uint32_t timer_clock_hz)
{
    const uint32_t ticks = 3u * timer_clock_hz;
    const uint32_t common = common_divisor(CTL_DDA_ITERATIONS_PER_3S, ticks);
    interval->iterations = CTL_DDA_ITERATIONS_PER_3S / common;
    interval->ticks = ticks / common;
    interval->iterations_rest = 0;
    interval->owed = 0;
    interval->carries = false;
    stand(interval, bank);
}

void ctl_interval_change_bank(ctl_interval* interval, const ctl_bank* bank)
{
    interval->owed =
        (uint32_t)((uint64_t)interval->owed * ctl_bank_divisor(bank) / ctl_bank_divisor(interval->bank));
    stand(interval, bank);
}

bool ctl_interval_between_cycles(const ctl_interval* interval)
{
    return !interval->in_cycle;
}

void ctl_interval_begin_cycle(ctl_interval* interval)
{
    const uint32_t divisor = ctl_bank_divisor(interval->bank);
    const uint64_t due = (uint64_t)interval->owed + ctl_bank_remainder(interval->bank);
    interval->carries = due >= divisor;
    interval->owed = (uint32_t)(interval->carries ? due - divisor : due);
    stand(interval, interval->bank);
    interval->in_cycle = true;
    feed(interval);
}

bool ctl_interval_holding(const ctl_interval* interval)
{
    return interval->next_row > interval->rows && !interval->dda.has_loaded;
}

/* Gives the pulse that came with the iteration at `time`, counted as iterations_rest is, at the end of its
 * tick. */
static void give_pulse(const ctl_interval* interval, uint64_t time, const ctl_pace* pace)
{
    const ctl_train train = {.count = 1,
                             .direction = interval->direction,
                             .tick = (uint32_t)((time + interval->iterations - 1u) / interval->iterations),
                             .divisor = 1};
    ctl_pace_give(pace, &train);
}

int32_t ctl_interval_advance(ctl_interval* interval, uint32_t* ticks, const ctl_pace* pace)
{
    if (!interval->in_cycle) {
        *ticks = 0;
        return 0;
    }
    const bool held = ctl_interval_holding(interval);
    const uint64_t given = (uint64_t)*ticks * interval->iterations;
    uint64_t time = interval->iterations_rest + given;
    uint32_t emitted = 0;
    while (interval->in_cycle && time >= interval->ticks) {
        const uint64_t whole = time / interval->ticks;
        uint32_t iterations = whole < MAX_ITERATIONS ? (uint32_t)whole : MAX_ITERATIONS;
        if (pace != NULL)
            iterations = ctl_dda_to_pulse(&interval->dda, iterations);
        const uint32_t pulses = ctl_dda_iterate(&interval->dda, &iterations);
        emitted += pulses;
        time -= (uint64_t)iterations * interval->ticks;
        if (pulses != 0 && pace != NULL)
            give_pulse(interval, given - time, pace);
        if (ctl_interval_holding(interval))
            interval->dda.emitted = 0; /* without end */
        feed(interval);
        interval->in_cycle = interval->dda.moves;
    }
    interval->iterations_rest = time;
    if (!interval->in_cycle) {
        const uint32_t unused = (uint32_t)(time / interval->iterations);
        interval->iterations_rest = time % interval->iterations;
        *ticks -= unused;
    }
    if (!held)
        interval->cycle_ticks += *ticks;
    return interval->direction * (int32_t)emitted;
}

int64_t ctl_interval_hz(const ctl_interval* interval)
{
    if (!interval->in_cycle)
        return 0;
    const uint64_t per_3s = (uint64_t)interval->dda.velocity * CTL_DDA_ITERATIONS_PER_3S;
    return interval->direction * (int64_t)((per_3s >> interval->dda.position_bits) / 3u);
}

static bool speed_fits(uint32_t speed, uint32_t position_bits, const ctl_config* config)
{
    /* One unit above is the rounding of the largest frequency. */
    return speed != 0 && speed >> position_bits == 0 &&
           (uint64_t)(speed - 1u) * CTL_DDA_ITERATIONS_PER_3S <= ((uint64_t)config->max_pulse_hz * 3u)
                                                                     << position_bits;
}

/* The speeds are in range and the whole pulses of |V1^2 - V0^2| / (2 Acc) fit into the distance. */
static bool row_fits(ctl_interval_row row, uint32_t fraction, const ctl_config* config)
{
    const uint32_t bits = CTL_DDA_CAPACITY_BITS + fraction;
    if (row.distance == 0 || !speed_fits(row.first_speed, bits, config) ||
        !speed_fits(row.last_speed, bits, config))
        return false;
    if (row.first_speed == row.last_speed)
        return true;
    if (row.acceleration == 0)
        return false;
    const uint64_t sum = (uint64_t)row.first_speed + row.last_speed;
    const uint32_t change = row.first_speed > row.last_speed ? row.first_speed - row.last_speed
                                                             : row.last_speed - row.first_speed;
    return sum * change / (((uint64_t)row.acceleration * 2u) << fraction) <= row.distance;
}

/* Offset of the first header register outside its range; CTL_BANK_HEADER_REGISTERS when there is none. */
static uint32_t bad_header_offset(const ctl_bank* bank, const ctl_config* config)
{
    const uint32_t bad_cycle = ctl_bank_bad_cycle(bank, config);
    if (bad_cycle != CTL_BANK_HEADER_REGISTERS)
        return bad_cycle;
    if (advance_of(bank) == 0 || advance_of(bank) == INT32_MIN)
        return CTL_OFFSET_BANK_ADVANCE;
    /* The accumulators say how long a cycle takes, not the header: no stop could land on its boundary. */
    const uint32_t at_end = bank->registers[CTL_OFFSET_BANK_END_BEHAVIOR];
    if (at_end != CTL_END_BEHAVIOR_STOP && at_end != CTL_END_BEHAVIOR_HOLD_SPEED)
        return CTL_OFFSET_BANK_END_BEHAVIOR;
    if (fraction_bits(bank) > CTL_DDA_MAX_FRACTION_BITS)
        return CTL_OFFSET_INTERVAL_FRACTION_BITS;
    return CTL_BANK_HEADER_REGISTERS;
}

ctl_verdict ctl_interval_check_some(const ctl_bank* bank, const ctl_config* config, ctl_row_check* check,
                                    uint32_t rows)
{
    const uint32_t bad_offset = check->row == 0 ? bad_header_offset(bank, config) : CTL_BANK_HEADER_REGISTERS;
    if (bad_offset != CTL_BANK_HEADER_REGISTERS)
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_HEADER, bad_offset);
    const uint32_t count = ctl_bank_row_count(bank);
    const bool backwards = advance_of(bank) < 0;
    const bool owes = ctl_bank_remainder(bank) != 0;
    for (uint32_t i = 0; i < rows && check->row < count; ++i, ++check->row) {
        ctl_interval_row row = ctl_interval_bank_row(bank, check->row);
        check->pulses += row.distance;
        if (owes && backwards && check->row + 1u == count && row.distance != 0)
            row.distance -= 1u;
        if (!row_fits(row, fraction_bits(bank), config))
            return ctl_refuse(CTL_TRANSFER_RESULT_BAD_ROW, check->row);
    }
    if (check->row < count)
        return ctl_refuse(CTL_TRANSFER_RESULT_BUSY, 0);
    if (check->pulses != (uint64_t)(backwards ? -(int64_t)advance_of(bank) : advance_of(bank)))
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_SUM, CTL_OFFSET_BANK_ADVANCE);
    return ctl_refuse(CTL_TRANSFER_RESULT_ACCEPTED, 0);
}

ctl_verdict ctl_interval_check(const ctl_bank* bank, const ctl_config* config)
{
    ctl_row_check check = {0};
    return ctl_interval_check_some(bank, config, &check, UINT32_MAX);
}
