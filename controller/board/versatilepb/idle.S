@ SPDX-License-Identifier: Apache-2.0
@ Waits for an interrupt.
    .syntax unified
    .arm
    .text
    .global board_idle
    .type board_idle, %function
board_idle:                        @ waits for an interrupt through CP15; an ARM7TDMI has a register of its chip for that
    mov r0, #0
    mcr p15, 0, r0, c7, c0, 4
    bx lr
