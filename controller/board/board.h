/* SPDX-License-Identifier: Apache-2.0 */
/* The functions that a board gives to the firmware's loop (firmware.c). Pulses, encoders, pins and flash go
 * straight to the core: they are the callbacks of ctl_port, which board_connect() fills in. Each function
 * states how long it may take; docs/porting.md explains them in their order. */
#ifndef BOARD_H
#define BOARD_H

#include "ctl_core.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Sets up clock, timer, line and flash. Called once, before everything else. */
void board_init(void);
/* Returns the figures of this board: unit, silence between frames, pulse timer, unique id. */
ctl_config board_config(void);
/* Fills in the callbacks of ctl_port. The context must stay where it is. */
void board_connect(ctl_port* port);

/* Returns the microseconds since power-up, read from a counter that runs by itself: a count of interrupts
 * loses time while they are masked. Never steps back; a hardware counter that wraps is extended here. 2 us.
 */
uint64_t board_now_us(void);
/* Waits for an interrupt: bytes have come, or a slice is due. Returns in at most one slice. */
void board_idle(void);
/* Restarts the watchdog. Called once per turn of the loop while the slices keep up with time. 2 us. */
void board_watchdog(void);

/* Moves received bytes, at most `size`, to `bytes` and returns how many; gives the time when the last of them
 * came, and whether parity, a break, framing or an overrun damaged one. 10 us. */
size_t board_take_bytes(uint8_t* bytes, size_t size, uint64_t* last_us, bool* error);
/* Sends an answer of at most CTL_FRAME_BYTES. Copies it and returns; must not wait for the line. 20 us. */
void board_send(const uint8_t* bytes, size_t size);

/* Called after each slice: what moved in it is moved on, and cuts are given to ctl_on_cut() and
 * ctl_on_bag_cut(). 10 us. */
void board_end_slice(ctl_core* core);

#endif
