/* SPDX-License-Identifier: Apache-2.0 */
#include "engine/ctl_step.h"

#include "base/ctl_words.h"

#define LONGEST_EVENT_TICKS 65535u
#define FULL_CIRCLE 36000u /* 0.01 degrees */
#define US_PER_S 1000000u

ctl_row ctl_step_row(const ctl_bank* bank, uint32_t index)
{
    const uint16_t* registers = ctl_bank_row_at(bank, index, CTL_ROW_REGISTERS);
    const ctl_row row = {registers[0], ctl_get32(&registers[1])};
    return row;
}

/* Offset of the first header register outside its range; CTL_BANK_HEADER_REGISTERS when there is none. */
static uint32_t bad_header_offset(const ctl_bank* bank, const ctl_config* config)
{
    static const uint8_t angles[] = {CTL_OFFSET_BANK_CUT_ANGLE, CTL_OFFSET_BANK_SYNC_START,
                                     CTL_OFFSET_BANK_SYNC_END};
    static const uint8_t not_zero[] = {CTL_OFFSET_PROGRAM_KNIVES, CTL_OFFSET_PROGRAM_GEAR_NUMERATOR,
                                       CTL_OFFSET_PROGRAM_GEAR_DENOMINATOR};
    const uint32_t bad_cycle = ctl_bank_bad_cycle(bank, config);
    if (bad_cycle != CTL_BANK_HEADER_REGISTERS)
        return bad_cycle;
    if (bank->registers[CTL_OFFSET_BANK_CARRY_ROW] >= ctl_bank_row_count(bank))
        return CTL_OFFSET_BANK_CARRY_ROW;
    for (uint32_t i = 0; i < sizeof angles / sizeof angles[0]; ++i) {
        if (bank->registers[angles[i]] > FULL_CIRCLE)
            return angles[i];
    }
    for (uint32_t i = 0; i < sizeof not_zero / sizeof not_zero[0]; ++i) {
        if (bank->registers[not_zero[i]] == 0)
            return not_zero[i];
    }
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

/* Shorter than the distance of two pulses. Rows with pulses never are, and of pauses in a row only the first
 * may be: a slice meets at most two rows for each pulse that the output stage gives in it, and one more. */
static bool is_too_short(ctl_row row, const ctl_config* config)
{
    return (uint64_t)row.ticks * config->max_pulse_hz < config->timer_clock_hz;
}

/* Rows of which as many as these last a slice at least, so that it meets at most two more; 0: no bound. */
static uint32_t window_rows(const ctl_bank* bank, const ctl_config* config)
{
    const uint32_t most = config->max_rows_per_slice;
    return most < 2u || ctl_bank_row_count(bank) < most ? 0u : most - 1u;
}

/* The last rows up to this one, over the boundary of the cycle too, are too many for a slice. */
static bool crowds_slice(const ctl_bank* bank, const ctl_config* config, ctl_row_check* check, ctl_row row)
{
    const uint32_t window = window_rows(bank, config);
    if (window == 0)
        return false;
    check->window += row.ticks;
    if (check->row >= window)
        check->window -= ctl_step_row(bank, check->row - window).ticks;
    const uint32_t slice_us = config->slice_us == 0 ? CTL_SLICE_US : config->slice_us;
    return check->row + 1u >= window &&
           check->window * US_PER_S < (uint64_t)slice_us * config->timer_clock_hz;
}

static ctl_verdict check_sums(const ctl_bank* bank, const ctl_config* config, const ctl_row_check* check)
{
    const uint32_t carry = bank->registers[CTL_OFFSET_BANK_CARRY_ROW];
    ctl_row longer = ctl_step_row(bank, carry);
    longer.pulses += 1;
    if (ctl_bank_remainder(bank) != 0 && !row_fits(longer, config))
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_ROW, carry);
    if (check->ticks != ctl_bank_cycle_ticks(bank))
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_SUM, CTL_OFFSET_BANK_CYCLE_TICKS);
    if (check->pulses != ctl_get32(&bank->registers[CTL_OFFSET_BANK_CYCLE_PULSES]))
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_SUM, CTL_OFFSET_BANK_CYCLE_PULSES);
    return ctl_refuse(CTL_TRANSFER_RESULT_ACCEPTED, 0);
}

ctl_verdict ctl_step_check(const ctl_bank* bank, const ctl_config* config, ctl_row_check* check,
                           uint32_t rows)
{
    const uint32_t bad_offset = check->row == 0 ? bad_header_offset(bank, config) : CTL_BANK_HEADER_REGISTERS;
    if (bad_offset != CTL_BANK_HEADER_REGISTERS)
        return ctl_refuse(CTL_TRANSFER_RESULT_BAD_HEADER, bad_offset);

    const uint32_t count = ctl_bank_row_count(bank);
    const uint32_t window = window_rows(bank, config);
    const uint32_t end = count + (window == 0 ? 0u : window - 1u);
    for (uint32_t i = 0; i < rows && check->row < end; ++i, ++check->row) {
        const bool again = check->row >= count; /* the window goes on over the boundary of the cycle */
        const uint32_t index = again ? check->row - count : check->row;
        const ctl_row row = ctl_step_row(bank, index);
        const bool is_pause = row.pulses == 0;
        const bool crowds = is_pause && check->after_pause && !again && is_too_short(row, config);
        check->after_pause = is_pause;
        if (crowds || !row_fits(row, config) || crowds_slice(bank, config, check, row))
            return ctl_refuse(CTL_TRANSFER_RESULT_BAD_ROW, index);
        check->ticks += again ? 0u : row.ticks;
        check->pulses += again ? 0u : row.pulses;
    }
    return check->row < end ? ctl_refuse(CTL_TRANSFER_RESULT_BUSY, 0) : check_sums(bank, config, check);
}

static void enter_row(ctl_step* step, uint32_t row)
{
    step->row = row;
    step->row_ticks = 0;
    if (row == ctl_bank_row_count(step->bank)) {
        step->train.count = step->current.pulses; /* none was emitted */
        return;
    }
    step->current = ctl_step_row(step->bank, row);
    if (step->carries && row == step->bank->registers[CTL_OFFSET_BANK_CARRY_ROW])
        step->current.pulses += 1;
    step->train = ctl_train_even(step->current.pulses, step->current.ticks);
}

void ctl_step_begin_cycle(ctl_step* step)
{
    const uint64_t due = (uint64_t)step->owed + ctl_bank_remainder(step->bank);
    step->carries = due >= ctl_bank_divisor(step->bank);
    step->owed = (uint32_t)(step->carries ? due - ctl_bank_divisor(step->bank) : due);
    step->cycle_ticks = 0;
    enter_row(step, 0);
}

void ctl_step_reset(ctl_step* step, const ctl_bank* bank)
{
    step->bank = bank;
    step->owed = 0;
    step->carries = false;
    step->current = ctl_step_row(bank, 0);
    step->cycle_ticks = 0;
    enter_row(step, ctl_bank_row_count(bank));
}

void ctl_step_change_bank(ctl_step* step, const ctl_bank* bank)
{
    step->owed = (uint32_t)((uint64_t)step->owed * ctl_bank_divisor(bank) / ctl_bank_divisor(step->bank));
    step->bank = bank;
    step->cycle_ticks = 0;
    enter_row(step, ctl_bank_row_count(bank));
}

bool ctl_step_between_cycles(const ctl_step* step)
{
    return step->row == ctl_bank_row_count(step->bank);
}

ctl_event ctl_step_next(ctl_step* step)
{
    ctl_event event = {0, false};
    uint32_t target = step->current.ticks;
    if (step->current.pulses != 0) {
        target = ctl_train_next(&step->train);
        event.pulse = true;
    } else if (target - step->row_ticks > LONGEST_EVENT_TICKS) {
        target = step->row_ticks + LONGEST_EVENT_TICKS;
    }
    event.ticks = (uint16_t)(target - step->row_ticks);
    step->cycle_ticks += event.ticks;
    step->row_ticks = target;
    if (target == step->current.ticks)
        enter_row(step, step->row + 1);
    return event;
}

uint32_t ctl_step_row_pulses(const ctl_step* step)
{
    return step->current.pulses - step->train.count;
}

uint32_t ctl_step_advance(ctl_step* step, uint32_t* ticks, const ctl_pace* pace)
{
    uint32_t passed = 0;
    uint32_t emitted = 0;
    while (passed != *ticks && !ctl_step_between_cycles(step)) {
        const uint32_t row_left = step->current.ticks - step->row_ticks;
        const uint32_t left = *ticks - passed;
        const bool ends = left >= row_left;
        const uint32_t part = ends ? row_left : left;
        ctl_train train = ends ? step->train : ctl_train_until(&step->train, step->row_ticks + part);
        emitted += train.count;
        train.tick += passed - step->row_ticks;
        ctl_pace_give(pace, &train);
        passed += part;
        step->cycle_ticks += part;
        if (ends)
            enter_row(step, step->row + 1);
        else
            step->row_ticks += part;
    }
    *ticks = passed;
    return emitted;
}
