/* SPDX-License-Identifier: Apache-2.0 */
/* Download into the shadow bank: begin, blocks in any order and as often as needed, seal. */
#ifndef CTL_TRANSFER_H
#define CTL_TRANSFER_H

#include "ctl_registers.h"
#include <stdbool.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_TRANSFER_BLOCK_WORDS ((CTL_BANK_REGISTERS / CTL_BLOCK_REGISTERS + 32u) / 32u)

struct ctl_core;

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

/* Carries out the operation that the transfer registers hold. */
void ctl_transfer_operation(struct ctl_core* core);
void ctl_transfer_result(const struct ctl_core* core, uint16_t* registers);
/* Empties the shadow bank; the echo of the last request stays. */
void ctl_transfer_discard(struct ctl_core* core);

#ifdef __cplusplus
}
#endif

#endif
