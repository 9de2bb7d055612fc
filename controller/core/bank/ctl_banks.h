/* SPDX-License-Identifier: Apache-2.0 */
/* The two program banks: one is executed, the other is the shadow that a download fills. */
#ifndef CTL_BANKS_H
#define CTL_BANKS_H

#include "base/ctl_bank.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The answer of a check of the whole active bank that was made in pieces. */
typedef enum { CTL_PROOF_NONE, CTL_PROOF_INTACT, CTL_PROOF_DAMAGED } ctl_proof;

typedef struct {
    ctl_bank bank[2];
    uint8_t active;
    bool has_active;
    uint32_t active_crc; /* 0 while there is none */
    uint32_t generation;
    uint32_t check_crc; /* the active bank is read over and over in the background */
    uint32_t check_position;
    uint32_t check_length; /* registers, as they were when the check began */
    uint16_t check_rows;   /* the same of the number of rows */
    ctl_proof proof;       /* instead of a check, while a command is carried out */
} ctl_banks;

static inline const ctl_bank* ctl_active_bank(const ctl_banks* banks)
{
    return &banks->bank[banks->active];
}

static inline ctl_bank* ctl_staged_bank(ctl_banks* banks)
{
    return &banks->bank[banks->active ^ 1u];
}

/* The staged bank, which has this CRC-32, becomes the active one. */
void ctl_banks_swap(ctl_banks* banks, uint32_t crc);
/* Returns true while the active bank still has its CRC-32. */
bool ctl_active_bank_intact(const ctl_banks* banks);
/* Reads a little more of the active bank; returns false when it is damaged. */
bool ctl_banks_check(ctl_banks* banks);

#ifdef __cplusplus
}
#endif

#endif
