@ SPDX-License-Identifier: Apache-2.0
@ Vectors, stacks, cleared memory; then main(). QEMU loads the program at 0x10000; the vectors belong at 0.
    .syntax unified
    .arm
    .section .vectors, "ax"
    .global _start
_start:
    ldr pc, =reset
    ldr pc, =trap
    ldr pc, =trap
    ldr pc, =trap
    ldr pc, =trap
    nop
    ldr pc, =interrupt
    ldr pc, =trap
    .ltorg
vectors_end:

    .text
reset:
    ldr r0, =_start
    mov r1, #0
    ldr r2, =vectors_end
1:  ldr r3, [r0], #4
    str r3, [r1], #4
    cmp r0, r2
    blo 1b
    mrc p15, 0, r0, c1, c0, 0      @ an ARM7TDMI would rotate an unaligned word; this processor is to trap it
    orr r0, r0, #2
    mcr p15, 0, r0, c1, c0, 0
    msr cpsr_c, #0xD2              @ interrupt mode, masked
    ldr sp, =interrupt_stack_top
    msr cpsr_c, #0xD3              @ supervisor mode
    ldr sp, =stack_top
    ldr r0, =stack_bottom          @ painted, so that its use can be measured
    ldr r1, =stack_top
    ldr r2, =0xA5A5A5A5
2:  str r2, [r0], #4
    cmp r0, r1
    blo 2b
    ldr r0, =bss_start
    ldr r1, =bss_end
    mov r2, #0
3:  cmp r0, r1
    strlo r2, [r0], #4
    blo 3b
    msr cpsr_c, #0x53              @ interrupts on
    ldr r0, =main
    mov lr, pc
    bx r0
    b trap

interrupt:
    sub lr, lr, #4
    push {r0-r3, ip, lr}
    ldr r0, =board_interrupt
    mov lr, pc
    bx r0
    ldm sp!, {r0-r3, ip, pc}^

trap:                              @ a fault: one byte on the line, then silence, as a real board stops for its watchdog
    ldr r0, =0x101F1000
    mov r1, #'!'
    str r1, [r0]
4:  b 4b

    .global interrupts_mask
    .type interrupts_mask, %function
interrupts_mask:
    mrs r0, cpsr
    orr r1, r0, #0x80
    msr cpsr_c, r1
    bx lr

    .global interrupts_restore
    .type interrupts_restore, %function
interrupts_restore:
    msr cpsr_c, r0
    bx lr
