/* SPDX-License-Identifier: Apache-2.0 */
/* All parts of the controller in one value: what the registers show. ctl_core.c composes them. */
#ifndef CTL_PARTS_H
#define CTL_PARTS_H

#include "bank/ctl_flash.h"
#include "bank/ctl_kept_trims.h"
#include "link/ctl_rtu.h"
#include "motion/ctl_io.h"
#include "motion/ctl_motion.h"
#include "packer/ctl_order.h"
#include "signal/ctl_actions.h"
#include "signal/ctl_coder.h"
#include "signal/ctl_tower.h"

/* Writable registers as the panel left them. Groups of an odd length are the last ones: copies from an
 * address that is no multiple of four take twice as long. */
typedef struct {
    uint16_t exchange[CTL_GROUP_EXCHANGE];
    uint16_t order[CTL_GROUP_ORDER];
    uint16_t command[CTL_GROUP_COMMAND];
    uint16_t transfer[CTL_GROUP_TRANSFER];
    uint16_t readback[CTL_GROUP_READBACK];
    uint16_t readback_result[CTL_GROUP_READBACK_RESULT];
    uint16_t parameter[CTL_GROUP_PARAMETER];
    uint16_t master[CTL_GROUP_MASTER];
    uint16_t hand[CTL_GROUP_HAND];
    uint16_t signal[CTL_GROUP_SIGNAL];
} ctl_written;

typedef struct {
    uint32_t length_um; /* last one, 0 until measured */
    uint32_t count;
} ctl_bags;

typedef struct {
    bool set;
    uint32_t unix_time; /* when it was set */
    uint64_t set_us;
} ctl_clock;

/* The end of an order, until the next start of an order or of a run. */
typedef struct {
    bool shown;
    bool counted; /* the order was under way when it was looked at last, */
    bool ran;     /* and so was a run */
} ctl_order_sign;

/* The command that waits for a check of the active bank or for the end of a save. */
typedef struct {
    bool waits;                          /* for the end of the save under way */
    bool checks;                         /* for the check */
    bool by_button;                      /* it is the Start button */
    uint16_t request[CTL_GROUP_COMMAND]; /* as it came */
    uint32_t generation;                 /* of the bank that is being checked */
    uint32_t position;                   /* registers that are in the sum */
    uint32_t crc;
    bool saves;            /* a save is to be answered: */
    uint16_t save_counter; /* counter of its command */
} ctl_work;

typedef struct ctl_core {
    ctl_board board;
    uint32_t tick_rest; /* of the timer ticks since power-up, in 1 / 1 000 000 */
    ctl_rtu rtu;
    ctl_written written;
    uint16_t command_result[CTL_GROUP_RESULT];
    ctl_banks banks;
    uint32_t trims_of; /* generation of the program that has the present trims */
    ctl_kept_trims kept_trims;
    ctl_transfer transfer;
    ctl_work work;
    ctl_flash flash;
    ctl_master master;
    ctl_motion motion;
    ctl_heartbeat heartbeat;
    ctl_io io;
    ctl_actions actions;
    ctl_tower tower;
    bool asks_start; /* the outputs to the machines around are due, behind the tower */
    ctl_coder coder;
    ctl_bags bags;
    ctl_packer packer;
    ctl_order order;
    ctl_order_sign order_sign;
    ctl_clock clock;
    uint16_t reversed;       /* axes that turn the other way, as the board was told */
    uint32_t machine_writes; /* writes of parameters when the machine data were taken over */
} ctl_core;

#endif
