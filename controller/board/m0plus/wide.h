/* SPDX-License-Identifier: Apache-2.0 */
/* 64-bit division for a processor whose multiplication has 32 bits and which does not divide. */
#ifndef BOARD_WIDE_H
#define BOARD_WIDE_H

#include <stdint.h>

/* Returns the exact quotient; of a division by 0 all bits, and the dividend remains. */
uint64_t wide_divide(uint64_t dividend, uint64_t divisor, uint64_t* remainder);

#endif
