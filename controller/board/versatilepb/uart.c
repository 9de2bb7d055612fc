/* SPDX-License-Identifier: Apache-2.0 */
/* The line. QEMU's PL011 has no timing: 16 bytes come at once, the next ones when the host has time, so 3.5
 * characters of silence end no request here. A request is handed on when it is whole by its function, its
 * count and its CRC-16; anything else after a silence that no host needs within a request. */
#include "base/ctl_crc.h"
#include "board.h"
#include "versatilepb/devices.h"

#define UART 0x101F1000u
#define CONSOLE 0x101F2000u
#define DATA 0x00u
#define FLAGS 0x18u
#define LINE 0x2Cu
#define CONTROL 0x30u
#define MASK 0x38u
#define CLEAR 0x44u
#define RX_EMPTY 0x10u
#define TX_FULL 0x20u
#define DATA_ERRORS 0xF00u    /* overrun, break, parity, framing */
#define EIGHT_BITS_FIFO 0x70u /* 8N1 */
#define ENABLED 0x301u
#define RECEIVE_INTERRUPTS 0x50u /* half full; a byte waits while nothing comes */
#define ALL_INTERRUPTS 0x7FFu

#define RING_BYTES 1024u
#define LONG_SILENCE_US 50000u
#define UNKNOWN (RING_BYTES + 1u)

enum { READ = 3, WRITE_ONE = 6, WRITE = 16, READ_WRITE = 23 };

static volatile uint8_t ring[RING_BYTES];
static volatile uint32_t ring_end;
static uint32_t ring_start;
static volatile uint64_t last_byte_us;
static volatile bool line_error;

void uart_init(void)
{
    DEVICE(UART + LINE) = EIGHT_BITS_FIFO;
    DEVICE(UART + CONTROL) = ENABLED;
    DEVICE(UART + MASK) = RECEIVE_INTERRUPTS;
}

void uart_announce(void)
{
    DEVICE(CONSOLE + CONTROL) = ENABLED;
    DEVICE(CONSOLE + DATA) = '\n';
}

void uart_interrupt(void)
{
    DEVICE(UART + CLEAR) = ALL_INTERRUPTS; /* first: a byte that comes behind the last look raises it again */
    while ((DEVICE(UART + FLAGS) & RX_EMPTY) == 0) {
        const uint32_t data = DEVICE(UART + DATA);
        if ((data & DATA_ERRORS) != 0 || ring_end - ring_start == RING_BYTES) {
            line_error = true;
        } else {
            ring[ring_end % RING_BYTES] = (uint8_t)data;
            ring_end += 1u;
        }
    }
    last_byte_us = clock_now_us();
}

static uint8_t peek(uint32_t index)
{
    return ring[(ring_start + index) % RING_BYTES];
}

/* Bytes of the request that begins here; UNKNOWN while that cannot be said. */
static uint32_t request_bytes(uint32_t waiting)
{
    if (waiting < 2u)
        return UNKNOWN;
    switch (peek(1)) {
    case READ:
    case WRITE_ONE:
        return 8u;
    case WRITE:
        return waiting < 7u ? UNKNOWN : 9u + peek(6);
    case READ_WRITE:
        return waiting < 11u ? UNKNOWN : 13u + peek(10);
    default:
        return UNKNOWN;
    }
}

size_t board_take_bytes(uint8_t* bytes, size_t size, uint64_t* last_us, bool* error)
{
    const uint32_t state = interrupts_mask();
    const uint32_t waiting = ring_end - ring_start;
    *last_us = last_byte_us;
    const bool silent = clock_now_us() - last_byte_us >= LONG_SILENCE_US;
    const bool damaged = line_error;
    *error = damaged && silent;
    if (silent)
        line_error = false;
    interrupts_restore(state);

    uint32_t count = damaged ? UNKNOWN : request_bytes(waiting); /* what was damaged ends with a silence */
    if (count > waiting || count > size)
        count = silent ? (waiting < size ? waiting : (uint32_t)size) : 0u;
    for (uint32_t i = 0; i < count; ++i)
        bytes[i] = peek(i);
    if (count == 0 || (!silent && ctl_crc16(bytes, count) != 0))
        return 0;
    ring_start += count;
    return count;
}

void board_send(const uint8_t* bytes, size_t size)
{
    for (size_t i = 0; i < size; ++i) {
        while ((DEVICE(UART + FLAGS) & TX_FULL) != 0) { /* never: QEMU's transmitter takes no time */
        }
        DEVICE(UART + DATA) = bytes[i];
    }
}
