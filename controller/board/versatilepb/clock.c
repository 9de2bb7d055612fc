/* SPDX-License-Identifier: Apache-2.0 */
/* Time and interrupts. One SP804 timer runs freely and is the clock; another wakes the loop. */
#include "board.h"
#include "versatilepb/devices.h"

#define WAKE_TIMER 0x101E2000u
#define CLOCK_TIMER 0x101E3000u
#define LOAD 0x00u
#define VALUE 0x04u
#define CONTROL 0x08u
#define CLEAR 0x0Cu
#define FREE_RUNNING 0x82u /* enabled, 32 bits, 1 MHz */
#define PERIODIC 0xE2u     /* and with interrupt */
/* The host would spend itself on waking an emulated processor every slice: four slices are made up for at a
 * time. A real board wakes once per slice. */
#define WAKE_US 1000u

/* The counter at power-up; a test begins shortly before it wraps. */
#ifndef CLOCK_START
#define CLOCK_START 0u
#endif

#define INTERRUPTS 0x10140000u
#define STATUS 0x00u
#define ENABLE 0x10u
#define TIMER_INTERRUPT (1u << 4)
#define UART_INTERRUPT (1u << 12)

/* The upper half of the clock and the lower half at the last look. Looked at every WAKE_US, and the counter
 * wraps every 71 minutes. */
static uint32_t clock_high;
static uint32_t clock_low;

void clock_init(void)
{
    DEVICE(CLOCK_TIMER + LOAD) = UINT32_MAX;
    clock_low = CLOCK_START;
    DEVICE(CLOCK_TIMER + CONTROL) = FREE_RUNNING;
    DEVICE(WAKE_TIMER + LOAD) = WAKE_US - 1u;
    DEVICE(WAKE_TIMER + CONTROL) = PERIODIC;
}

uint64_t clock_now_us(void)
{
    const uint32_t state = interrupts_mask();
    const uint32_t low = CLOCK_START + ~DEVICE(CLOCK_TIMER + VALUE); /* it counts down */
    if (low < clock_low)
        clock_high += 1u;
    clock_low = low;
    const uint64_t now_us = (uint64_t)clock_high << 32 | low;
    interrupts_restore(state);
    return now_us;
}

void clock_interrupt(void)
{
    DEVICE(WAKE_TIMER + CLEAR) = 1u;
}

void interrupts_init(void)
{
    DEVICE(INTERRUPTS + ENABLE) = TIMER_INTERRUPT | UART_INTERRUPT;
}

/* Called from start.S. */
void board_interrupt(void);
void board_interrupt(void)
{
    const uint32_t status = DEVICE(INTERRUPTS + STATUS);
    if ((status & TIMER_INTERRUPT) != 0)
        clock_interrupt();
    if ((status & UART_INTERRUPT) != 0)
        uart_interrupt();
}
