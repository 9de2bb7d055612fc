/* SPDX-License-Identifier: Apache-2.0 */
/* The controller as one value: fill a ctl_config and a ctl_port, ctl_init(), feed it bytes with
 * ctl_receive(), call ctl_tick() often, send what ctl_take_answer() gives. Not reentrant: one context calls
 * all of it. */
#ifndef CTL_CORE_H
#define CTL_CORE_H

#include "bank/ctl_flash.h"
#include "bank/ctl_transfer.h"
#include "base/ctl_bank.h"
#include "base/ctl_port.h"
#include "link/ctl_map.h"
#include "link/ctl_rtu.h"
#include "motion/ctl_motion.h"
#include "packer/ctl_packer.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    ctl_bank bank[2]; /* one is executed, the other is the shadow that a download fills */
    uint8_t active;
    bool has_active;
    uint32_t active_crc; /* 0 while there is none */
    uint32_t generation;
    uint32_t check_crc; /* the active bank is read over and over in the background */
    uint32_t check_position;
} ctl_banks;

typedef struct {
    bool heard; /* a heartbeat came since power-up */
    uint16_t last;
    uint64_t advanced_us;
    bool jog_blocked; /* until the keys were seen released */
} ctl_heartbeat;

typedef struct {
    uint32_t length_um; /* last one, 0 until measured */
    uint32_t count;
} ctl_bags;

typedef struct {
    bool set;
    uint32_t unix_time; /* when it was set */
    uint64_t set_us;
} ctl_clock;

typedef struct ctl_core {
    ctl_config config;
    ctl_port port;
    uint64_t started_us;
    uint64_t now_us;
    bool catching_up;   /* the slice is not the last one of its call: what is measured is newer than now_us */
    uint32_t tick_rest; /* of the timer ticks since power-up, in 1 / 1 000 000 */
    ctl_rtu rtu;
    ctl_written written;
    uint16_t command_result[CTL_GROUP_RESULT];
    ctl_banks banks;
    ctl_transfer transfer;
    ctl_flash flash;
    ctl_motion motion;
    ctl_heartbeat heartbeat;
    ctl_bags bags;
    ctl_packer packer;
    ctl_clock clock;
} ctl_core;

/* Power-up: loads the newest valid flash slot. The port's context must outlive the core. */
void ctl_init(ctl_core* core, const ctl_config* config, const ctl_port* port, uint64_t now_us);
/* The only clock: moves everything on to now_us, in slices of at most config.slice_us. */
void ctl_tick(ctl_core* core, uint64_t now_us);

/* The knife closed over the film when the film motor stood there, 1/256 pulse. */
void ctl_on_cut(ctl_core* core, int64_t film);
/* The bag that ended with the last cut was measured. */
void ctl_on_bag_cut(ctl_core* core, uint32_t length_um);

const ctl_bank* ctl_active_bank(const ctl_core* core);
ctl_bank* ctl_staged_bank(ctl_core* core);
/* The staged bank becomes the active one, the shadow becomes empty. */
void ctl_swap_banks(ctl_core* core);
/* The active bank still has its CRC-32. */
bool ctl_active_bank_intact(const ctl_core* core);

uint16_t ctl_parameter16(const ctl_core* core, uint32_t address);
uint32_t ctl_parameter32(const ctl_core* core, uint32_t address);

#ifdef __cplusplus
}
#endif

#endif
