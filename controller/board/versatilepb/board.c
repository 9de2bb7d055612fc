/* SPDX-License-Identifier: Apache-2.0 */
/* The board that QEMU emulates, with the whole-number machine in place of drives. */
#include "board.h"

#include "machine/whole_machine.h"
#include "versatilepb/devices.h"

/* The memory of a test's board is smaller. */
#ifndef BANK_REGISTERS
#define BANK_REGISTERS 0u
#endif

static whole_machine machine;

void board_init(void)
{
    clock_init();
    uart_init();
    interrupts_init();
    uart_announce();
    whole_machine_init(&machine, (whole_disturbance){0});
}

ctl_config board_config(void)
{
    return (ctl_config){
        .unit = 1,
        .frame_gap_us = 1, /* uart.c hands on whole requests */
        .firmware = {CAMPANEL_VERSION_MAJOR, CAMPANEL_VERSION_MINOR, CAMPANEL_VERSION_PATCH},
        .unique_id = 0x41524D3754444D49u, /* "ARM7TDMI" */
        .timer_clock_hz = 8000000,
        .timer_bits = 16,
        .max_pulse_hz = 200000,
        .table_layouts = 1u << CTL_TABLE_LAYOUT_STEP_TABLE | 1u << CTL_TABLE_LAYOUT_CAM_POINTS |
                         1u << CTL_TABLE_LAYOUT_PRESS_STAGES, /* intervals do not fit 60 MHz */
        .bank_registers = BANK_REGISTERS,
        .max_rows_per_slice = 16,
        .work_registers = 24,
    };
}

void board_connect(ctl_port* port)
{
    whole_machine_connect(&machine, port);
    port->flash_read = flash_read;
    port->flash_erase = flash_erase;
    port->flash_write = flash_write;
    port->flash_progress = flash_progress;
}

uint64_t board_now_us(void)
{
    return clock_now_us();
}

void board_watchdog(void)
{
    /* QEMU 7.2's versatilepb has no watchdog. */
}

void board_end_slice(ctl_core* core)
{
    whole_machine_follow(&machine, core);
}
