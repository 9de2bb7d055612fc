/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/ctl_change.h"

#include "base/ctl_words.h"
#include "engine/ctl_table.h"

#define WHOLE ((uint64_t)1 << CTL_RAMP_SHARE_BITS)

static uint64_t master_rate(const ctl_bank* bank)
{
    const int16_t rate = (int16_t)bank->registers[CTL_OFFSET_CAM_MASTER_RATE];
    return (uint64_t)(rate < 0 ? -rate : rate);
}

/* The film's speed goes on over the boundary, the master's of a cam, otherwise the cycles a second. */
static void set_ratio(ctl_change_plan* plan, const ctl_bank* from, const ctl_bank* to)
{
    uint64_t numerator = ctl_bank_cycle_ticks(to);
    uint64_t denominator = ctl_bank_cycle_ticks(from);
    if (ctl_bank_kind(from) == CTL_PROGRAM_KIND_ROTARY_CUTTER) {
        numerator *= ctl_bank_bag_um(from);
        denominator *= ctl_bank_bag_um(to);
    } else if (ctl_bank_follows_master(from)) {
        numerator = master_rate(from);
        denominator = master_rate(to);
    }
    while (numerator > INT32_MAX || denominator > INT32_MAX) {
        numerator >>= 1;
        denominator >>= 1;
    }
    plan->numerator = numerator == 0 ? 1u : (uint32_t)numerator;
    plan->denominator = denominator == 0 ? 1u : (uint32_t)denominator;
}

static uint64_t magnitude(int64_t value)
{
    return (uint64_t)(value < 0 ? -value : value);
}

/* An axis that runs at these frequencies at full speed of the two programs steps by at most `limit`. */
static void limit_step(ctl_change_plan* plan, int64_t before_hz, int64_t behind_hz, uint32_t limit)
{
    const uint64_t step = magnitude(behind_hz * plan->numerator / plan->denominator - before_hz);
    const uint64_t share = step > limit ? ((uint64_t)limit << CTL_RAMP_SHARE_BITS) / step : plan->steps;
    if (share < plan->steps)
        plan->steps = share;
}

ctl_change_plan ctl_change_between(const ctl_board* board, const ctl_packer* packer, const ctl_bank* from,
                                   const ctl_bank* to, int32_t direction)
{
    ctl_change_plan plan = {WHOLE, UINT64_MAX, 1, 1, direction, board->parameter_writes};
    set_ratio(&plan, from, to);
    if (plan.numerator > plan.denominator) /* the new program is not run faster than its own speed */
        plan.share = (WHOLE * plan.denominator) / plan.numerator;

    const int64_t before_hz = ctl_table_boundary_hz(from, &board->config, direction > 0);
    const int64_t behind_hz = ctl_table_boundary_hz(to, &board->config, direction < 0);
    const uint32_t limit = ctl_parameter32(board, CTL_REG_PARAMETER_KNIFE_STEP);
    if (ctl_bank_layout(from) == ctl_bank_layout(to)) {
        limit_step(&plan, before_hz, behind_hz, limit);
    } else { /* the engines do not start at the same time: the axis may stand for an update in between */
        limit_step(&plan, before_hz, 0, limit);
        limit_step(&plan, 0, behind_hz, limit);
    }
    if (ctl_packer_active(packer)) {
        const ctl_line_speed before = ctl_packer_full_speed(packer, from);
        const ctl_line_speed behind = ctl_packer_full_speed(packer, to);
        limit_step(&plan, before.film, behind.film, ctl_parameter32(board, CTL_REG_PARAMETER_FILM_STEP));
        limit_step(&plan, before.infeed, behind.infeed,
                   ctl_parameter32(board, CTL_REG_PARAMETER_INFEED_STEP));
    }
    if (plan.steps < plan.share)
        plan.share = plan.steps;
    return plan;
}

uint16_t ctl_change_refusal(const ctl_change_plan* plan)
{
    return plan->share < CTL_CHANGE_MIN_SHARE ? CTL_REFUSAL_STEP_TOO_LARGE : CTL_REFUSAL_NONE;
}

uint64_t ctl_change_share_behind(const ctl_change_plan* plan, uint64_t share)
{
    return share * plan->numerator / plan->denominator;
}
