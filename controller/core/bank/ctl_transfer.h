/* SPDX-License-Identifier: Apache-2.0 */
/* Download into the shadow bank: begin, blocks in any order and as often as needed, seal. */
#ifndef CTL_TRANSFER_H
#define CTL_TRANSFER_H

#include "bank/ctl_banks.h"

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_TRANSFER_BLOCK_WORDS ((CTL_BANK_REGISTERS / CTL_BLOCK_REGISTERS + 32u) / 32u)

typedef struct {
    uint16_t state;                                     /* CTL_STAGED_STATE_... */
    uint16_t session;                                   /* 0 when there is none */
    uint16_t kind;                                      /* announced */
    uint16_t length;                                    /* registers announced */
    uint32_t received_blocks[CTL_TRANSFER_BLOCK_WORDS]; /* bit n: block n is here */
    uint32_t staged_crc;                                /* 0 until sealed */
    uint16_t operation;                                 /* echo of the last request */
    uint16_t block;
    uint16_t result;
    uint16_t detail;
} ctl_transfer;

/* Carries out an operation: the group `transfer` as the panel wrote it. */
void ctl_transfer_operation(ctl_transfer* transfer, ctl_banks* banks, const ctl_config* config,
                            const uint16_t* request);
/* Fills in the group `transfer_result`. */
void ctl_transfer_result(const ctl_transfer* transfer, uint16_t* registers);
/* Empties the shadow bank; the echo of the last request stays. */
void ctl_transfer_discard(ctl_transfer* transfer);
/* The staged bank becomes the active one, the shadow becomes empty. */
void ctl_transfer_apply(ctl_transfer* transfer, ctl_banks* banks);

#ifdef __cplusplus
}
#endif

#endif
