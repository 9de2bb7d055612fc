/* SPDX-License-Identifier: Apache-2.0 */
#include "base/ctl_kept.h"

bool ctl_keep(const ctl_board* board, uint32_t record, const uint16_t* registers, uint32_t count)
{
    uint8_t bytes[CTL_KEPT_BYTES];
    if (!ctl_keeps(board))
        return false;
    for (uint32_t i = 0; i < count; ++i)
        ctl_put_bytes16(&bytes[2u * i], registers[i]);
    return board->port.keep(board->port.context, record, bytes, 2u * count);
}

bool ctl_kept(const ctl_board* board, uint32_t record, uint16_t* registers, uint32_t count)
{
    uint8_t bytes[CTL_KEPT_BYTES];
    if (!ctl_keeps(board) || board->port.kept(board->port.context, record, bytes, sizeof bytes) != 2u * count)
        return false;
    for (uint32_t i = 0; i < count; ++i)
        registers[i] = ctl_get_bytes16(&bytes[2u * i]);
    return true;
}
