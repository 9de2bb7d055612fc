/* SPDX-License-Identifier: Apache-2.0 */
/* Download into the shadow bank: begin, blocks in any order and as often as needed, seal. */
#ifndef CTL_TRANSFER_H
#define CTL_TRANSFER_H

#include "bank/ctl_banks.h"
#include "bank/ctl_check.h"

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
    const ctl_bank* reader;                             /* the bank that is being saved; NULL: none */
    bool sealing;                                       /* the bank is being checked in pieces: */
    bool checked;                                       /* its rows are good, the CRC-32 is under way */
    ctl_verdict refused;                                /* why the bank as it is cannot be sealed */
    ctl_row_check check;
    uint32_t crc;
    uint32_t crc_position; /* registers that are in it */
    uint16_t operation;    /* echo of the last request */
    uint16_t block;
    uint16_t result;
    uint16_t detail;
} ctl_transfer;

/* Carries out an operation: the group `transfer` as the panel wrote it. */
void ctl_transfer_operation(ctl_transfer* transfer, ctl_banks* banks, const ctl_config* config,
                            const uint16_t* request);
/* Goes on with a seal that is under way by at most `registers` registers. */
void ctl_transfer_work(ctl_transfer* transfer, ctl_banks* banks, const ctl_config* config,
                       uint32_t registers);
/* Copies registers of the staged bank; those that were not received are 0. */
void ctl_transfer_read(const ctl_transfer* transfer, const ctl_bank* shadow, uint32_t first, uint16_t* values,
                       uint32_t count);
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
