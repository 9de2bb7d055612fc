/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/ctl_switches.h"

#include <stddef.h>

#define FULL_CIRCLE 36000u /* 0.01 degrees */
#define LEADS_PER_S 10000u /* parameter.switch1_lead is in 0.1 ms */

enum { MODE = 0, ON_ANGLE = 1, OFF_ANGLE = 2, LEAD = 3, EVERY = 4, STRIDE = 5 };
_Static_assert(CTL_REG_PARAMETER_SWITCH1_EVERY == CTL_REG_PARAMETER_SWITCH1_MODE + EVERY &&
                   CTL_REG_PARAMETER_SWITCH8_MODE == CTL_REG_PARAMETER_SWITCH1_MODE + 7u * STRIDE,
               "the parameters of a switch follow each other");
_Static_assert(CTL_REFUSAL_SWITCH8_LEAD_TOO_LONG == CTL_REFUSAL_SWITCH1_LEAD_TOO_LONG + 7u,
               "so do their refusals");

static uint16_t parameter(const ctl_board* board, uint32_t number, uint32_t which)
{
    return ctl_parameter16(board, CTL_REG_PARAMETER_SWITCH1_MODE + STRIDE * number + which);
}

/* The lead in timer ticks, which are those of the cycle at full speed. */
static uint64_t lead_ticks(const ctl_board* board, uint32_t number)
{
    return (uint64_t)parameter(board, number, LEAD) * board->config.timer_clock_hz / LEADS_PER_S;
}

bool ctl_switches_serve(const ctl_bank* bank)
{
    return ctl_bank_at_end(bank) == CTL_END_BEHAVIOR_REPEAT &&
           ctl_bank_layout(bank) != CTL_TABLE_LAYOUT_PRESS_STAGES;
}

uint16_t ctl_switches_refusal(const ctl_board* board, const ctl_bank* bank)
{
    if (!ctl_switches_serve(bank))
        return CTL_REFUSAL_NONE;
    for (uint32_t i = 0; i < CTL_SWITCH_COUNT; ++i) {
        if (parameter(board, i, MODE) != CTL_SWITCH_MODE_OFF &&
            lead_ticks(board, i) > ctl_bank_cycle_ticks(bank))
            return (uint16_t)(CTL_REFUSAL_SWITCH1_LEAD_TOO_LONG + i);
    }
    return CTL_REFUSAL_NONE;
}

void ctl_switches_bag(ctl_switches* switches, bool rejected)
{
    for (uint32_t i = 0; i < CTL_SWITCH_COUNT; ++i)
        switches->each[i].rejects = rejected;
}

static uint32_t share_of_cycle(uint64_t part, uint64_t whole)
{
    return (uint32_t)((part << 32) / whole & 0xFFFFFFFFu);
}

/* The angle of the first or the second edge that the cycle meets in its direction. */
static uint32_t edge(const ctl_switch* one, bool first, int32_t direction)
{
    const uint32_t angle =
        share_of_cycle(first == (direction > 0) ? one->on_angle : one->off_angle, FULL_CIRCLE);
    return direction > 0 ? angle : 0u - angle;
}

/* The part of the cycle that passes during the lead; below the whole cycle, whatever the parameters say now.
 */
static uint32_t present_lead(const ctl_board* board, uint32_t number, const ctl_switch_cycle* cycle)
{
    const uint64_t ticks = lead_ticks(board, number) * cycle->speed >> CTL_SWITCH_SPEED_BITS;
    return ticks >= cycle->cycle ? UINT32_MAX : share_of_cycle(ticks, cycle->cycle);
}

/* It is on in the cycle of this number; asked once, where it would switch on. */
static bool may_switch_on(ctl_switch* one, const ctl_board* board, uint32_t which, uint32_t number)
{
    if (one->mode == CTL_SWITCH_MODE_REJECTED_BAGS) {
        const bool rejects = one->rejects;
        one->rejects = false;
        return rejects;
    }
    return one->mode == CTL_SWITCH_MODE_CYCLES && number % parameter(board, which, EVERY) == 0;
}

/* Nothing moves any more: all are off. A bag that was being rejected is still to be. */
static void end(ctl_switches* switches)
{
    switches->follows = false;
    for (uint32_t i = 0; i < CTL_SWITCH_COUNT; ++i) {
        ctl_switch* one = &switches->each[i];
        one->rejects = one->rejects || (one->on && one->mode == CTL_SWITCH_MODE_REJECTED_BAGS);
        one->on = false;
    }
}

/* The cycle begins to be followed where it stands. */
static void begin(ctl_switches* switches, const ctl_board* board, const ctl_switch_cycle* cycle,
                  uint32_t angle)
{
    switches->follows = true;
    switches->direction = cycle->direction;
    switches->angle = angle;
    for (uint32_t i = 0; i < CTL_SWITCH_COUNT; ++i) {
        ctl_switch* one = &switches->each[i];
        one->mode = parameter(board, i, MODE);
        one->on_angle = parameter(board, i, ON_ANGLE);
        one->off_angle = parameter(board, i, OFF_ANGLE);
        one->lead = 0;
        one->hold = 0;
        const uint32_t first = edge(one, true, cycle->direction);
        const uint32_t width = edge(one, false, cycle->direction) - first;
        const uint32_t number = first > angle ? switches->number - 1u : switches->number;
        one->on = angle - first < width && may_switch_on(one, board, i, number);
    }
}

/* Another setting counts from its next on angle. */
static void take_settings(ctl_switch* one, const ctl_board* board, uint32_t number)
{
    const uint16_t mode = parameter(board, number, MODE);
    const uint16_t on_angle = parameter(board, number, ON_ANGLE);
    const uint16_t off_angle = parameter(board, number, OFF_ANGLE);
    if (mode == one->mode && on_angle == one->on_angle && off_angle == one->off_angle)
        return;
    one->mode = mode;
    one->on_angle = on_angle;
    one->off_angle = off_angle;
    one->on = false;
    one->hold = 0;
}

/* Moves one switch on while the cycle moves by `travelled`. It is ahead of the cycle by its lead, never goes
 * back when the lead shrinks, and keeps a window that it jumps over when the lead grows. */
static void follow(ctl_switches* switches, uint32_t which, const ctl_board* board,
                   const ctl_switch_cycle* cycle, uint32_t travelled)
{
    ctl_switch* one = &switches->each[which];
    take_settings(one, board, which);
    if (one->mode == CTL_SWITCH_MODE_OFF)
        return;
    const uint32_t lead = present_lead(board, which, cycle);
    const uint64_t reach = (uint64_t)lead + travelled;
    const uint64_t step = reach > one->lead ? reach - one->lead : 0;
    const uint64_t from = (uint64_t)switches->angle + one->lead;
    one->lead = step != 0 ? lead : one->lead - travelled;

    const uint32_t first = edge(one, true, cycle->direction);
    const uint32_t second = edge(one, false, cycle->direction);
    /* One more than the way to each edge is 0 .. 2^32 - 1: an edge behind lies a cycle ahead. */
    const uint64_t to_on = (uint64_t)(uint32_t)(first - (uint32_t)from - 1u) + 1u;
    const uint64_t to_off = (uint64_t)(uint32_t)(second - (uint32_t)from - 1u) + 1u;
    if (one->hold != 0) {
        one->hold = one->hold > travelled ? one->hold - travelled : 0;
        one->on = one->hold != 0;
    } else if (to_off <= step) {
        one->on = false;
    }
    if (to_on > step || first == second)
        return;
    if (!may_switch_on(one, board, which, switches->number + (uint32_t)((from + to_on) >> 32)))
        return;
    one->on = true;
    one->hold = to_off > to_on && to_off <= step ? second - first : 0;
}

uint16_t ctl_switches_slice(ctl_switches* switches, const ctl_board* board, const ctl_switch_cycle* cycle)
{
    if (cycle == NULL) {
        end(switches);
        return 0;
    }
    const uint32_t position = share_of_cycle(cycle->position, cycle->cycle);
    const uint32_t angle = cycle->direction > 0 ? position : 0u - position;
    if (!switches->follows || switches->direction != cycle->direction)
        begin(switches, board, cycle, angle);
    const uint32_t travelled = angle - switches->angle;
    uint32_t levels = 0;
    for (uint32_t i = 0; i < CTL_SWITCH_COUNT; ++i) {
        follow(switches, i, board, cycle, travelled);
        levels |= (switches->each[i].on ? 1u : 0u) << i;
    }
    if (angle < switches->angle)
        switches->number += 1u;
    switches->angle = angle;
    return (uint16_t)levels;
}
