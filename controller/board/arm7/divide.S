@ SPDX-License-Identifier: Apache-2.0
@ 64-bit division for ARMv4T. libgcc's takes 600 instructions and more; half of the time of a slice was spent in it. A divisor of at most
@ 32 bits, which is nearly every one of the core, takes four instructions a bit without a loop. Wider ones go to libgcc.
@ AEABI: dividend in r0 (low) and r1, divisor in r2 and r3; quotient in r0 and r1, remainder in r2 and r3.
    .syntax unified
    .arm
    .text

    .global __aeabi_uldivmod
    .type __aeabi_uldivmod, %function
__aeabi_uldivmod:
    cmp r3, #0
    bne divisor_is_wide
    cmp r1, #0
    beq both_are_narrow
    mov ip, r1
    mov r1, #0
    cmp ip, r2
    blo divide_low                  @ the quotient has 32 bits
    push {r0, r2, r4, lr}
    mov r0, ip                      @ the upper word first: its remainder goes down
    mov r1, r2
    bl __aeabi_uidivmod
    mov ip, r1
    mov r1, r0
    pop {r0, r2, r4, lr}
divide_low:                         @ ip:r0 / r2 with ip < r2; the quotient grows into r0 from below
    mov r3, ip, lsl #16
    orr r3, r3, r0, lsr #16
    cmp ip, #0x10000                @ a quotient of 16 bits: half of the way
    cmplo r3, r2
    bhs 1f
    mov ip, r3
    mov r0, r0, lsl #16
    adds r0, r0, r0
    b divide_16
1:  mov r3, ip, lsl #8
    orr r3, r3, r0, lsr #24
    cmp ip, #0x1000000              @ of 24 bits
    cmplo r3, r2
    movlo ip, r3
    movlo r0, r0, lsl #8
    bhs 2f
    adds r0, r0, r0
    b divide_24
2:  adds r0, r0, r0
    .macro divide_bits count
    .rept \count
    adcs ip, ip, ip                 @ one bit down; a carry out means that the divisor fits
    cmpcc ip, r2
    subcs ip, ip, r2
    adcs r0, r0, r0
    .endr
    .endm
    divide_bits 8
divide_24:
    divide_bits 8
divide_16:
    divide_bits 16
    mov r2, ip
    mov r3, #0
    bx lr
both_are_narrow:
    push {r4, lr}
    mov r1, r2
    bl __aeabi_uidivmod
    mov r2, r1
    mov r1, #0
    mov r3, #0
    pop {r4, lr}
    bx lr
divisor_is_wide:                    @ the fifth argument is the place of the remainder
    sub sp, sp, #8
    mov ip, sp
    push {ip, lr}
    bl __udivmoddi4
    ldr lr, [sp, #4]
    add sp, sp, #8
    pop {r2, r3}
    bx lr
    .size __aeabi_uldivmod, . - __aeabi_uldivmod

    .global __aeabi_ldivmod
    .type __aeabi_ldivmod, %function
__aeabi_ldivmod:                    @ truncates; the remainder has the sign of the dividend
    push {r4, lr}
    movs r4, r1, asr #31
    bpl 1f
    rsbs r0, r0, #0
    rsc r1, r1, #0
1:  cmp r3, #0
    bge 2f
    rsbs r2, r2, #0
    rsc r3, r3, #0
    eor r4, r4, #1                  @ bit 0 differs from bit 31 when the divisor is negative
2:  bl __aeabi_uldivmod
    eor ip, r4, r4, asr #31
    and ip, ip, #1
    cmp r4, #0
    bpl 3f
    rsbs r2, r2, #0
    rsc r3, r3, #0
    eor ip, ip, #1
3:  cmp ip, #0
    beq 4f
    rsbs r0, r0, #0
    rsc r1, r1, #0
4:  pop {r4, lr}
    bx lr
    .size __aeabi_ldivmod, . - __aeabi_ldivmod
