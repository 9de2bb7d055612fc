/* SPDX-License-Identifier: Apache-2.0 */
/* The operator's trims over a power cut, saved or not. They belong to the program with the CRC-32 in their
 * record: with another one those stay that were saved with it. */
#ifndef CTL_KEPT_TRIMS_H
#define CTL_KEPT_TRIMS_H

#include "bank/ctl_banks.h"
#include "base/ctl_board.h"

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_KEPT_TRIMS_REGISTERS (3u + CTL_TRIMS)

typedef struct {
    uint16_t record[CTL_KEPT_TRIMS_REGISTERS]; /* as it was kept last */
} ctl_kept_trims;

/* Power-up: the active program's trims as they were. */
void ctl_kept_trims_restore(ctl_kept_trims* kept, const ctl_board* board, const ctl_banks* banks,
                            uint16_t* trims);
/* Keeps the trims of the active program when they or the program have changed. */
void ctl_kept_trims_follow(ctl_kept_trims* kept, const ctl_board* board, const ctl_banks* banks,
                           const uint16_t* trims);

#ifdef __cplusplus
}
#endif

#endif
