/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/ctl_switches.h"

#include <stddef.h>

#define FULL_CIRCLE 36000u /* 0.01 degrees */
#define LEADS_PER_S 10000u /* parameter.switch1_lead is in 0.1 ms */

enum { MODE = 0, ON_ANGLE = 1, OFF_ANGLE = 2, LEAD = 3, EVERY = 4, STRIDE = 5 };
_Static_assert(CTL_REG_PARAMETER_SWITCH1_EVERY == CTL_REG_PARAMETER_SWITCH1_MODE + EVERY &&
                   CTL_REG_PARAMETER_SWITCH8_MODE ==
                       CTL_REG_PARAMETER_SWITCH1_MODE + (CTL_SWITCH_COUNT - 1u) * STRIDE,
               "the parameters of a switch follow each other");
_Static_assert(CTL_REFUSAL_SWITCH8_LEAD_TOO_LONG == CTL_REFUSAL_SWITCH1_LEAD_TOO_LONG + CTL_SWITCH_COUNT - 1u,
               "so do their refusals");

_Static_assert(CTL_REG_PARAMETER_SWITCH8_EVERY - CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT < CTL_GROUP_PARAMETER,
               "all of them are in the group");

static uint16_t parameter(const ctl_board* board, uint32_t number, uint32_t which)
{
    return ctl_parameter16(board, CTL_REG_PARAMETER_SWITCH1_MODE + STRIDE * number + which);
}

/* The lead in timer ticks, which are those of the cycle at full speed. */
static uint64_t lead_ticks(const ctl_board* board, uint32_t number)
{
    const uint64_t scaled = (uint64_t)parameter(board, number, LEAD) * board->config.timer_clock_hz;
    /* The shorter division where it does: up to 53 ms at 8 MHz. */
    return scaled <= UINT32_MAX ? (uint32_t)scaled / LEADS_PER_S : scaled / LEADS_PER_S;
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

bool ctl_switches_reject(const ctl_board* board)
{
    uint32_t i = 0;
    while (i < CTL_SWITCH_COUNT && parameter(board, i, MODE) != CTL_SWITCH_MODE_REJECTED_BAGS)
        ++i;
    return i < CTL_SWITCH_COUNT;
}

void ctl_switches_bag(ctl_switches* switches, bool rejected)
{
    for (uint32_t i = 0; i < CTL_SWITCH_COUNT; ++i)
        switches->each[i].rejects = rejected;
}

/* Returns a part of the cycle, shorter than the cycle, in 1 / 2^32. A division would cost more
 * than all else that a switch does in a slice; this is off by at most 2^-24 ticks per tick. */
static uint32_t share_of_cycle(const ctl_switches* switches, uint32_t ticks)
{
    return (uint32_t)(switches->inverse * ticks >> (CTL_SWITCH_INVERSE_BITS - 32u));
}

/* An angle below the full circle in 1 / 2^32 of it, rounded down, by divisions of 32 bits. */
static uint32_t share_of_circle(uint32_t angle)
{
    const uint32_t whole = UINT32_MAX / FULL_CIRCLE;
    const uint32_t rest = UINT32_MAX % FULL_CIRCLE + 1u;
    return angle * whole + angle * rest / FULL_CIRCLE;
}

/* The angle of the first or the second edge that the cycle meets in its direction. */
static uint32_t edge(const ctl_switch* one, bool first, int32_t direction)
{
    const uint32_t angle = first == (direction > 0) ? one->on_part : one->off_part;
    return direction > 0 ? angle : 0u - angle;
}

/* The part of the cycle that passes during the lead; below the whole cycle, whatever the parameters say now.
 */
static uint32_t present_lead(const ctl_switches* switches, const ctl_switch* one)
{
    const uint64_t ticks = one->lead_ticks * switches->present.speed >> CTL_SWITCH_SPEED_BITS;
    return ticks >= switches->present.cycle ? UINT32_MAX : share_of_cycle(switches, (uint32_t)ticks);
}

/* Returns true when the switch is on in the cycle of this number; called once, at its on angle. */
static bool may_switch_on(ctl_switch* one, const ctl_board* board, uint32_t which, uint32_t number)
{
    if (one->mode == CTL_SWITCH_MODE_REJECTED_BAGS) {
        const bool rejects = one->rejects;
        one->rejects = false;
        return rejects;
    }
    return one->mode == CTL_SWITCH_MODE_CYCLES && number % parameter(board, which, EVERY) == 0;
}

/* Switches all off at standstill. A bag that was being rejected is still to be rejected. */
static void end(ctl_switches* switches)
{
    switches->follows = false;
    for (uint32_t i = 0; i < CTL_SWITCH_COUNT; ++i) {
        ctl_switch* one = &switches->each[i];
        one->rejects = one->rejects || (one->on && one->mode == CTL_SWITCH_MODE_REJECTED_BAGS);
        one->on = false;
    }
}

/* Starts to follow the cycle at its present position. */
static void begin(ctl_switches* switches, const ctl_board* board, const ctl_switch_cycle* cycle,
                  uint32_t angle)
{
    switches->follows = true;
    switches->quiet = 0;
    switches->direction = cycle->direction;
    switches->angle = angle;
    for (uint32_t i = 0; i < CTL_SWITCH_COUNT; ++i) {
        ctl_switch* one = &switches->each[i];
        one->lead = 0;
        one->hold = 0;
        const uint32_t first = edge(one, true, cycle->direction);
        const uint32_t width = edge(one, false, cycle->direction) - first;
        const uint32_t number = first > angle ? switches->number - 1u : switches->number;
        one->on = angle - first < width && may_switch_on(one, board, i, number);
    }
}

/* Another setting counts from its next on angle; another lead at once. */
static void take_settings(ctl_switch* one, const ctl_board* board, uint32_t number)
{
    const uint16_t mode = parameter(board, number, MODE);
    const uint16_t on_angle = parameter(board, number, ON_ANGLE);
    const uint16_t off_angle = parameter(board, number, OFF_ANGLE);
    one->lead_ticks = lead_ticks(board, number);
    if (mode == one->mode && on_angle == one->on_angle && off_angle == one->off_angle)
        return;
    one->mode = mode;
    one->on_angle = on_angle;
    one->off_angle = off_angle;
    one->on_part = share_of_circle(on_angle);
    one->off_part = share_of_circle(off_angle);
    one->on = false;
    one->hold = 0;
}

/* Reads the parameters when the panel has written any. */
static void read_settings(ctl_switches* switches, const ctl_board* board)
{
    if (switches->settings == board->parameter_writes + 1u)
        return;
    switches->settings = board->parameter_writes + 1u;
    switches->quiet = 0;
    for (uint32_t i = 0; i < CTL_SWITCH_COUNT; ++i)
        take_settings(&switches->each[i], board, i);
}

/* The leads are those of this cycle at this speed from now on. */
static void take_cycle(ctl_switches* switches, const ctl_switch_cycle* cycle)
{
    if (cycle->cycle != switches->present.cycle)
        switches->inverse = ((uint64_t)1 << CTL_SWITCH_INVERSE_BITS) / cycle->cycle;
    if (cycle->cycle != switches->present.cycle || cycle->speed != switches->present.speed)
        switches->quiet = 0;
    switches->present = *cycle;
}

/* Moves one switch on while the cycle moves by `travelled`. It is ahead of the cycle by its lead, never goes
 * back when the lead shrinks, and keeps a window that it jumps over when the lead grows. */
static void follow(ctl_switches* switches, uint32_t which, const ctl_board* board, uint32_t travelled)
{
    ctl_switch* one = &switches->each[which];
    const int32_t direction = switches->direction;
    if (one->mode == CTL_SWITCH_MODE_OFF)
        return;
    const uint32_t lead = present_lead(switches, one);
    const uint64_t reach = (uint64_t)lead + travelled;
    const uint64_t ahead = reach > one->lead ? reach - one->lead : 0;
    const uint32_t step = ahead < UINT32_MAX ? (uint32_t)ahead : UINT32_MAX; /* a cycle at most */
    const uint64_t from = (uint64_t)switches->angle + one->lead;
    one->lead = step != 0 ? lead : one->lead - travelled;

    const uint32_t first = edge(one, true, direction);
    const uint32_t second = edge(one, false, direction);
    /* The way to each edge, less one: an edge at hand lies a cycle ahead. */
    const uint32_t to_on = first - (uint32_t)from - 1u;
    const uint32_t to_off = second - (uint32_t)from - 1u;
    if (one->hold != 0) {
        one->hold = one->hold > travelled ? one->hold - travelled : 0;
        one->on = one->hold != 0;
    } else if (to_off < step) {
        one->on = false;
    }
    const uint32_t next = to_on < to_off ? to_on : to_off;
    const bool stays = one->hold == 0 && one->lead == lead && next >= step;
    const uint32_t quiet = stays ? next - step : 0;
    if (quiet < switches->quiet)
        switches->quiet = quiet;
    if (to_on >= step || first == second)
        return;
    if (!may_switch_on(one, board, which, switches->number + (uint32_t)((from + to_on + 1u) >> 32)))
        return;
    one->on = true;
    one->hold = to_off > to_on && to_off < step ? second - first : 0;
}

uint16_t ctl_switches_slice(ctl_switches* switches, const ctl_board* board, const ctl_switch_cycle* cycle)
{
    read_settings(switches, board);
    if (cycle == NULL) {
        end(switches);
        return 0;
    }
    take_cycle(switches, cycle);
    const uint32_t position = share_of_cycle(switches, cycle->position);
    const uint32_t angle = cycle->direction > 0 ? position : 0u - position;
    if (!switches->follows || switches->direction != cycle->direction)
        begin(switches, board, cycle, angle);
    const uint32_t travelled = angle - switches->angle;
    if (travelled < switches->quiet) {
        switches->quiet -= travelled;
    } else {
        uint32_t levels = 0;
        switches->quiet = UINT32_MAX;
        for (uint32_t i = 0; i < CTL_SWITCH_COUNT; ++i) {
            follow(switches, i, board, travelled);
            levels |= (switches->each[i].on ? 1u : 0u) << i;
        }
        switches->levels = (uint16_t)levels;
    }
    if (angle < switches->angle)
        switches->number += 1u;
    switches->angle = angle;
    return switches->levels;
}
