/* SPDX-License-Identifier: Apache-2.0 */
/* Program and parameters over a power loss: two slots, each with a sequence number and a CRC-32. A save
 * writes the slot that does not hold the newest valid one, so that a power cut at any byte leaves that one.
 */
#ifndef CTL_FLASH_H
#define CTL_FLASH_H

#include "bank/ctl_banks.h"
#include "base/ctl_board.h"

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_FLASH_GROUPS 4u /* parameter, master, the trims of `hand`, signal */
#define CTL_FLASH_HEAD_REGISTERS                                                                             \
    (6u + CTL_FLASH_GROUPS + CTL_GROUP_PARAMETER + CTL_GROUP_MASTER + CTL_TRIMS + CTL_GROUP_SIGNAL)

/* A save under way. */
typedef struct {
    bool busy;
    const ctl_bank* bank;
    uint32_t bank_crc;
    uint16_t head[CTL_FLASH_HEAD_REGISTERS]; /* all before the bank, as it was when the save began */
    uint32_t slot;
    uint32_t written; /* registers of head and bank */
    uint32_t crc;
} ctl_flash_saving;

typedef struct {
    ctl_flash_saving saving;
    bool any_valid;
    bool slot_invalid;  /* at power-up a slot that is not blank had a wrong CRC-32 */
    uint8_t newest;     /* slot, when any is valid */
    uint32_t sequence;  /* of that slot */
    uint32_t saved_crc; /* of the bank in that slot, 0 when there is none */
} ctl_flash;

/* Loads the newest valid slot: active bank, generation, and each group into its `values`. */
void ctl_flash_load(ctl_flash* flash, const ctl_board* board, ctl_banks* banks,
                    uint16_t* const values[CTL_FLASH_GROUPS]);
/* Begins to save the active bank and the groups, which may change meanwhile; the bank may not. */
void ctl_flash_begin_save(ctl_flash* flash, const ctl_board* board, const ctl_banks* banks);
/* Returns whether the save under way saves all this as it is now. */
bool ctl_flash_saves(const ctl_flash* flash, const ctl_board* board, const ctl_banks* banks);
/* Goes on with the save by one piece of at most 32 registers. CTL_FLASH_FAILED: the flash refused, and what
 * was saved before is still valid. */
ctl_flash_progress ctl_flash_save_piece(ctl_flash* flash, const ctl_board* board);

#ifdef __cplusplus
}
#endif

#endif
