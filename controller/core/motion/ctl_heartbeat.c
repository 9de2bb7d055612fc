/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/ctl_heartbeat.h"

#define US_PER_MS 1000u

void ctl_heartbeat_receive(ctl_heartbeat* heartbeat, const ctl_board* board, uint16_t value)
{
    if (heartbeat->heard && value == heartbeat->last)
        return;
    heartbeat->heard = true;
    heartbeat->last = value;
    heartbeat->advanced_us = board->now_us;
}

static bool older_than(const ctl_heartbeat* heartbeat, const ctl_board* board, uint64_t age_us)
{
    const uint64_t last_us = heartbeat->heard ? heartbeat->advanced_us : board->started_us;
    return board->now_us - last_us >= age_us;
}

bool ctl_heartbeat_lost(const ctl_heartbeat* heartbeat, const ctl_board* board)
{
    const uint32_t timeout_ms = ctl_parameter16(board, CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT);
    return older_than(heartbeat, board, (uint64_t)timeout_ms * US_PER_MS);
}

bool ctl_heartbeat_stops(const ctl_heartbeat* heartbeat, const ctl_board* board)
{
    return ctl_parameter16(board, CTL_REG_PARAMETER_HEARTBEAT_LOST_ACTION) ==
               CTL_HEARTBEAT_LOST_ACTION_STOP_AT_CYCLE_END &&
           ctl_heartbeat_lost(heartbeat, board);
}

uint32_t ctl_heartbeat_missing(const ctl_heartbeat* heartbeat, const ctl_board* board, uint32_t bits)
{
    return ctl_parameter16(board, CTL_REG_PARAMETER_PERMIT_NEEDED) != 0 ? bits & ~(uint32_t)heartbeat->permit
                                                                        : 0u;
}

bool ctl_heartbeat_slice(ctl_heartbeat* heartbeat, const ctl_board* board, uint16_t keys)
{
    heartbeat->keys = keys;
    /* A stopped jog does not resume: the key must be released first. */
    if (keys == 0)
        heartbeat->jog_blocked = false;
    else if (!heartbeat->heard || older_than(heartbeat, board, CTL_JOG_HOLD_US) ||
             ctl_heartbeat_missing(heartbeat, board, 1u << CTL_PERMIT_BIT_CLEAN) != 0)
        heartbeat->jog_blocked = true;
    return ctl_heartbeat_stops(heartbeat, board);
}

int32_t ctl_jog_request(const ctl_heartbeat* heartbeat)
{
    if (heartbeat->jog_blocked)
        return 0;
    if (heartbeat->keys == 1u << CTL_JOG_BIT_FORWARD)
        return 1;
    return heartbeat->keys == 1u << CTL_JOG_BIT_REVERSE ? -1 : 0;
}
