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

typedef struct {
    bool any_valid;
    bool slot_invalid;  /* at power-up a slot that is not blank had a wrong CRC-32 */
    uint8_t newest;     /* slot, when any is valid */
    uint32_t sequence;  /* of that slot */
    uint32_t saved_crc; /* of the bank in that slot, 0 when there is none */
} ctl_flash;

/* Loads the newest valid slot: active bank, generation, and the parameters into `parameter`. */
void ctl_flash_load(ctl_flash* flash, const ctl_board* board, ctl_banks* banks, uint16_t* parameter);
/* Saves the active bank and the parameters. False when the flash refused; what was saved before is still
 * valid. */
bool ctl_flash_save(ctl_flash* flash, const ctl_board* board, const ctl_banks* banks);

#ifdef __cplusplus
}
#endif

#endif
