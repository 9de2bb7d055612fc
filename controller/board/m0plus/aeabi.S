@ SPDX-License-Identifier: Apache-2.0
@ 64-bit multiplication and division of a Cortex-M0+ under the names by which the compiler calls them. Two fifths of the time of a slice were
@ spent in the library's. The RP2040 multiplies 32 by 32 bits to 32 in one cycle; it does not divide.
@ AEABI: operands in r0 (low) and r1, r2 and r3; product or quotient in r0 and r1, remainder in r2 and r3.
    .syntax unified
    .thumb
    .text

    .macro function name
    .section .text.\name, "ax"
    .global \name
    .type \name, %function
    .thumb_func
\name:
    .endm

    function __aeabi_lmul
    push {r4, r5}
    muls r1, r2                     @ the products of which only the lower word counts
    muls r3, r0
    adds r1, r3
    uxth r4, r0                     @ and four of halves
    lsrs r0, r0, #16
    lsrs r3, r2, #16
    uxth r2, r2
    mov r5, r4
    muls r5, r2
    muls r4, r3
    muls r2, r0
    muls r0, r3
    adds r1, r0
    lsls r0, r4, #16
    lsrs r4, r4, #16
    adds r0, r5
    adcs r1, r4
    lsls r3, r2, #16
    lsrs r2, r2, #16
    adds r0, r3
    adcs r1, r2
    pop {r4, r5}
    bx lr

    function __aeabi_uldivmod
    push {r4, lr}
    sub sp, #16
    add r4, sp, #8                  @ the fifth argument is the place of the remainder
    str r4, [sp]
    bl wide_divide
    ldr r2, [sp, #8]
    ldr r3, [sp, #12]
    add sp, #16
    pop {r4, pc}

    .macro negate_if sign, low, high @ sign: 0 or all bits
    eors \low, \sign
    eors \high, \sign
    subs \low, \sign
    sbcs \high, \sign
    .endm

    function __aeabi_ldivmod        @ truncates; the remainder has the sign of the dividend
    push {r4, r5, r6, lr}
    asrs r4, r1, #31
    negate_if r4, r0, r1
    asrs r5, r3, #31
    negate_if r5, r2, r3
    bl __aeabi_uldivmod
    eors r5, r4
    negate_if r5, r0, r1
    negate_if r4, r2, r3
    pop {r4, r5, r6, pc}
