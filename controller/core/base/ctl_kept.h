/* SPDX-License-Identifier: Apache-2.0 */
/* The records that survive a power cut at any moment, where the board has memory for them. */
#ifndef CTL_KEPT_H
#define CTL_KEPT_H

#include "base/ctl_board.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { CTL_KEPT_COUNTS, CTL_KEPT_LOT, CTL_KEPT_TRIMS };

static inline bool ctl_keeps(const ctl_board* board)
{
    return board->port.keep != NULL && board->port.kept != NULL;
}
/* Replaces a record; returns false when the board failed, or has none. */
bool ctl_keep(const ctl_board* board, uint32_t record, const uint16_t* registers, uint32_t count);
/* Reads a record; returns false when there is none of so many registers. */
bool ctl_kept(const ctl_board* board, uint32_t record, uint16_t* registers, uint32_t count);

#ifdef __cplusplus
}
#endif

#endif
