/* SPDX-License-Identifier: Apache-2.0 */
/* Light tower and horn: a table says what each condition shows on each of them. Where conditions differ, what
 * blinks goes before what is on. */
#ifndef CTL_TOWER_H
#define CTL_TOWER_H

#include "base/ctl_board.h"

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_TOWER_STEP_US 20000u
#define CTL_TOWER_BLINK_STEPS 25u /* on, and as many off */

typedef struct {
    uint16_t conditions;   /* bits CTL_SIGNAL_BIT_..., as they are now */
    uint16_t acknowledged; /* those of them that somebody has acknowledged */
    uint16_t levels;       /* bits CTL_OUTPUT_BIT_... */
    uint16_t steps;        /* of the blinking */
    uint32_t due_us;       /* time of the next step, modulo 2^32 */
} ctl_tower;

static inline bool ctl_tower_is_due(const ctl_tower* tower, const ctl_board* board)
{
    return (int32_t)((uint32_t)board->now_us - tower->due_us) >= 0;
}
/* Updates the levels when the tower is due. */
void ctl_tower_slice(ctl_tower* tower, const ctl_board* board, uint32_t conditions);
/* Somebody has seen what it shows now. */
void ctl_tower_acknowledge(ctl_tower* tower);

#ifdef __cplusplus
}
#endif

#endif
