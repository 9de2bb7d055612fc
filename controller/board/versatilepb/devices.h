/* SPDX-License-Identifier: Apache-2.0 */
/* The devices of QEMU's versatilepb that the board uses: PL011 (line), SP804 (time), PL190 (interrupts), CFI
 * flash. */
#ifndef VERSATILEPB_DEVICES_H
#define VERSATILEPB_DEVICES_H

#include "base/ctl_port.h"

#include <stdbool.h>
#include <stdint.h>

#define DEVICE(address) (*(volatile uint32_t*)(address))

/* Microseconds since power-up. */
uint64_t clock_now_us(void);
void clock_init(void);
void clock_interrupt(void);

void uart_init(void);
/* Sends a line feed to the second UART: from here on no byte of the line is lost. */
void uart_announce(void);
void uart_interrupt(void);

void interrupts_init(void);
/* Masks interrupts and returns the state before, which interrupts_restore() brings back. */
uint32_t interrupts_mask(void);
void interrupts_restore(uint32_t state);

/* The flash as the callbacks of ctl_port. */
bool flash_read(void* context, uint32_t slot, uint32_t offset, uint8_t* bytes, uint32_t size);
bool flash_erase(void* context, uint32_t slot);
bool flash_write(void* context, uint32_t slot, uint32_t offset, const uint8_t* bytes, uint32_t size);
ctl_flash_progress flash_progress(void* context);

#endif
