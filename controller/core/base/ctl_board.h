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
    const uint16_t* hand;      /* of the group `hand`, */
    const uint16_t* signal;    /* and of the group `signal` */
    uint32_t parameter_writes; /* how often any of them was written */
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

static inline uint16_t ctl_signal16(const ctl_board* board, uint32_t address)
{
    return board->signal[address - CTL_REG_SIGNAL_START_BUTTON_CONTACT];
}

/* The operator's trims: those of the program, and as many of the next one behind them. */
#define CTL_TRIMS (CTL_REG_HAND_NEXT_CUT - CTL_REG_HAND_CUT)

static inline const uint16_t* ctl_trims(const ctl_board* board)
{
    return &board->hand[CTL_REG_HAND_CUT - CTL_REG_HAND_SPEED];
}

/* One of them, um. */
static inline int16_t ctl_trim_um(const ctl_board* board, uint32_t address)
{
    return (int16_t)ctl_trims(board)[address - CTL_REG_HAND_CUT];
}

#endif
