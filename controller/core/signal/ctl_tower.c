/* SPDX-License-Identifier: Apache-2.0 */
#include "signal/ctl_tower.h"

enum { LIGHTS = CTL_OUTPUT_BIT_HORN - CTL_OUTPUT_BIT_TOWER_RED + 1 };
enum { TABLE = CTL_REG_SIGNAL_FAULT_RED - CTL_REG_SIGNAL_START_BUTTON_CONTACT };

_Static_assert(LIGHTS == 4, "red, yellow, green and horn, in this order in outputs and table");
_Static_assert(CTL_REG_SIGNAL_ORDER_HORN - CTL_REG_SIGNAL_FAULT_RED + 1 == LIGHTS * (CTL_SIGNAL_BIT_LAST + 1),
               "the table has a row for each condition, in the order of their bits");
_Static_assert(CTL_OUTPUT_BIT_RUNNING < 16, "the levels are one word");

/* Adds what one condition shows to what is on and what blinks. */
static void add(const ctl_tower* tower, const ctl_board* board, uint32_t condition, uint32_t* on,
                uint32_t* blinks)
{
    const bool seen = (tower->acknowledged & 1u << condition) != 0;
    const uint16_t* modes = &board->signal[TABLE + LIGHTS * condition];
    for (uint32_t light = 0; light < LIGHTS; ++light) {
        const uint32_t bit = 1u << (CTL_OUTPUT_BIT_TOWER_RED + light);
        const uint16_t mode = modes[light];
        if (mode == CTL_SIGNAL_MODE_BLINK || (mode == CTL_SIGNAL_MODE_BLINK_THEN_ON && !seen))
            *blinks |= bit;
        else if (mode == CTL_SIGNAL_MODE_ON || mode == CTL_SIGNAL_MODE_BLINK_THEN_ON ||
                 (mode == CTL_SIGNAL_MODE_ON_THEN_OFF && !seen))
            *on |= bit;
    }
}

void ctl_tower_slice(ctl_tower* tower, const ctl_board* board, uint32_t conditions)
{
    uint32_t on = 0;
    uint32_t blinks = 0;
    const uint32_t late_us = (uint32_t)board->now_us - tower->due_us;
    tower->due_us += late_us < CTL_TOWER_STEP_US ? CTL_TOWER_STEP_US : late_us + CTL_TOWER_STEP_US;
    tower->conditions = (uint16_t)conditions;
    tower->acknowledged &= tower->conditions;
    for (uint32_t condition = 0; condition <= CTL_SIGNAL_BIT_LAST; ++condition) {
        if ((conditions & 1u << condition) != 0)
            add(tower, board, condition, &on, &blinks);
    }
    tower->steps = tower->steps < 2u * CTL_TOWER_BLINK_STEPS - 1u ? (uint16_t)(tower->steps + 1u) : 0u;
    const uint32_t levels = (on & ~blinks) | (tower->steps < CTL_TOWER_BLINK_STEPS ? blinks : 0u);
    const bool runs = (conditions & (1u << CTL_SIGNAL_BIT_RUNNING | 1u << CTL_SIGNAL_BIT_WAITING)) != 0;
    tower->levels = (uint16_t)(levels | (runs ? 1u << CTL_OUTPUT_BIT_RUNNING : 0u));
}

void ctl_tower_acknowledge(ctl_tower* tower)
{
    tower->acknowledged = tower->conditions;
}
