/* SPDX-License-Identifier: Apache-2.0 */
#include "ctl_step.h"

#include "ctl_words.h"

#define LONGEST_EVENT_TICKS 65535u

static void enter_row(ctl_step* step, uint32_t row)
{
    step->row = row;
    step->row_ticks = 0;
    step->row_pulses = 0;
    if (row == ctl_bank_row_count(step->bank))
        return;
    step->current = ctl_bank_row(step->bank, row);
    if (step->carries && row == step->bank->registers[CTL_OFFSET_BANK_CARRY_ROW])
        step->current.pulses += 1;
}

static uint32_t divisor(const ctl_bank* bank)
{
    return ctl_get32(&bank->registers[CTL_OFFSET_BANK_DIVISOR]);
}

void ctl_step_begin_cycle(ctl_step* step)
{
    const uint64_t due = (uint64_t)step->owed + ctl_get32(&step->bank->registers[CTL_OFFSET_BANK_REMAINDER]);
    step->carries = due >= divisor(step->bank);
    step->owed = (uint32_t)(step->carries ? due - divisor(step->bank) : due);
    step->cycle_ticks = 0;
    enter_row(step, 0);
}

void ctl_step_reset(ctl_step* step, const ctl_bank* bank)
{
    step->bank = bank;
    step->owed = 0;
    step->carries = false;
    step->current = ctl_bank_row(bank, 0);
    step->cycle_ticks = 0;
    enter_row(step, ctl_bank_row_count(bank));
}

void ctl_step_change_bank(ctl_step* step, const ctl_bank* bank)
{
    step->owed = (uint32_t)((uint64_t)step->owed * divisor(bank) / divisor(step->bank));
    step->bank = bank;
    step->cycle_ticks = 0;
    enter_row(step, ctl_bank_row_count(bank));
}

bool ctl_step_between_cycles(const ctl_step* step)
{
    return step->row == ctl_bank_row_count(step->bank);
}

/* Ticks from the row's start to its pulse `number`: floor(number * ticks / pulses) in 32-bit arithmetic. */
static uint32_t pulse_ticks(ctl_row row, uint32_t number)
{
    const uint32_t whole = row.ticks / row.pulses;
    const uint32_t rest = row.ticks % row.pulses;
    return number * whole + number * rest / row.pulses;
}

ctl_event ctl_step_next(ctl_step* step)
{
    ctl_event event = {0, false};
    uint32_t target = step->current.ticks;
    if (step->current.pulses != 0) {
        target = pulse_ticks(step->current, step->row_pulses + 1);
        event.pulse = true;
        step->row_pulses += 1;
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

/* Pulses that have come once `ticks` of the row have passed. */
static uint32_t pulses_after(ctl_row row, uint32_t ticks)
{
    if (row.pulses == 0)
        return 0;
    return (uint32_t)((((uint64_t)ticks + 1u) * row.pulses - 1u) / row.ticks);
}

uint32_t ctl_step_advance(ctl_step* step, uint32_t* ticks)
{
    uint32_t left = *ticks;
    uint32_t emitted = 0;
    while (left != 0 && !ctl_step_between_cycles(step)) {
        const uint32_t row_left = step->current.ticks - step->row_ticks;
        if (left >= row_left) {
            emitted += step->current.pulses - step->row_pulses;
            step->cycle_ticks += row_left;
            left -= row_left;
            enter_row(step, step->row + 1);
        } else {
            step->row_ticks += left;
            step->cycle_ticks += left;
            left = 0;
            const uint32_t reached = pulses_after(step->current, step->row_ticks);
            emitted += reached - step->row_pulses;
            step->row_pulses = reached;
        }
    }
    *ticks -= left;
    return emitted;
}
