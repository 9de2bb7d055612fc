/* SPDX-License-Identifier: Apache-2.0 */
#include "bank/ctl_kept_trims.h"

#include "base/ctl_kept.h"
#include "base/ctl_limits.h"

#include <string.h>

#define KEPT_VERSION 1u
enum { VERSION, PROGRAM_CRC, TRIMS = PROGRAM_CRC + 2 };
_Static_assert(TRIMS + CTL_TRIMS == CTL_KEPT_TRIMS_REGISTERS &&
                   2u * CTL_KEPT_TRIMS_REGISTERS <= CTL_KEPT_BYTES,
               "the trims fit the record");

void ctl_kept_trims_restore(ctl_kept_trims* kept, const ctl_board* board, const ctl_banks* banks,
                            uint16_t* trims)
{
    uint16_t record[CTL_KEPT_TRIMS_REGISTERS];
    if (!banks->has_active || !ctl_kept(board, CTL_KEPT_TRIMS, record, CTL_KEPT_TRIMS_REGISTERS) ||
        record[VERSION] != KEPT_VERSION || ctl_get32(&record[PROGRAM_CRC]) != banks->active_crc ||
        !ctl_within_limits(&record[TRIMS], CTL_REG_HAND_CUT, CTL_TRIMS))
        return;
    memcpy(trims, &record[TRIMS], CTL_TRIMS * sizeof *trims);
    memcpy(kept->record, record, sizeof record);
}

void ctl_kept_trims_follow(ctl_kept_trims* kept, const ctl_board* board, const ctl_banks* banks,
                           const uint16_t* trims)
{
    uint16_t record[CTL_KEPT_TRIMS_REGISTERS];
    if (!ctl_keeps(board) || !banks->has_active)
        return;
    record[VERSION] = KEPT_VERSION;
    ctl_put32(&record[PROGRAM_CRC], banks->active_crc);
    memcpy(&record[TRIMS], trims, CTL_TRIMS * sizeof *trims);
    if (memcmp(kept->record, record, sizeof record) != 0 &&
        ctl_keep(board, CTL_KEPT_TRIMS, record, CTL_KEPT_TRIMS_REGISTERS))
        memcpy(kept->record, record, sizeof record);
}
