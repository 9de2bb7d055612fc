/* SPDX-License-Identifier: Apache-2.0 */
/* The board, its time and the panel's parameters: every part of the controller reads them, none writes them.
 */
#ifndef CTL_BOARD_H
#define CTL_BOARD_H

#include "base/ctl_port.h"
#include "base/ctl_words.h"
#include "ctl_registers.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    ctl_config config;
    ctl_port port;
    const uint16_t* parameter; /* registers of the group `parameter`, as the panel left them */
    const uint16_t* master;    /* those of the group `master`, */
    const uint16_t* hand;      /* and of the group `hand` */
    uint32_t parameter_writes; /* how often the panel has written any of both */
    uint64_t started_us;
    uint64_t now_us;
    uint32_t tick;        /* timer ticks since power-up at the start of the slice, modulo 2^32 */
    uint32_t slice_ticks; /* timer ticks of the slice */
    bool catching_up; /* the slice is not the last one of its call: what is measured is newer than now_us */
} ctl_board;

/* The parameter at this address of the register map. */
static inline uint16_t ctl_parameter16(const ctl_board* board, uint32_t address)
{
    return board->parameter[address - CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT];
}

static inline uint32_t ctl_parameter32(const ctl_board* board, uint32_t address)
{
    return ctl_get32(&board->parameter[address - CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT]);
}

#endif
