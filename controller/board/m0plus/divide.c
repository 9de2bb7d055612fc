/* SPDX-License-Identifier: Apache-2.0 */
/* Division by digits of 16 bits (Knuth, The Art of Computer Programming 2, 4.3.1, algorithm D): each digit is
 * estimated by a multiplication with the reciprocal of the divisor's upper half, never too large, and
 * corrected. The library's division divides for each digit and takes 300 to 500 cycles on a Cortex-M0+. */
#include "wide.h"

#define DIGIT_BITS 16u
#define DIGIT ((uint32_t)1 << DIGIT_BITS)

/* A divisor whose highest bit is set, and its halves. */
typedef struct {
    uint32_t whole;
    uint32_t high;
    uint32_t low;
    uint32_t reciprocal; /* at most 2^32 / high - 2^16 */
} normal;

/* Newton's steps from a straight line (48 - 32 x) / 17: each doubles the right bits and stays below. */
static uint32_t reciprocal_of(uint32_t high)
{
    uint32_t inverse = 185043u - ((high * 30840u) >> 14);
    int32_t error = (int32_t)(0u - high * inverse);
    inverse += (uint32_t)(((int32_t)(inverse >> 6) * (error >> 9)) >> 17);
    error = (int32_t)(0u - high * inverse);
    inverse += (uint32_t)(((int32_t)(inverse >> 2) * (error >> 8)) >> 22);
    return inverse - DIGIT;
}

/* Returns the next digit of the quotient; `rest` is below the divisor before and after. */
static uint32_t next_digit(const normal* by, uint32_t* rest, uint32_t next)
{
    const uint32_t above = *rest >> DIGIT_BITS;
    uint32_t digit = above + ((above * by->reciprocal) >> DIGIT_BITS);
    uint32_t left = *rest - digit * by->high;
    while (left >= by->high) {
        left -= by->high;
        ++digit;
    }
    while (digit >= DIGIT || digit * by->low > (left << DIGIT_BITS | next)) {
        --digit;
        left += by->high;
        if (left >= DIGIT)
            break;
    }
    *rest = (*rest << DIGIT_BITS | next) - digit * by->whole;
    return digit;
}

static uint32_t leading_zeros(uint32_t value)
{
    uint32_t zeros = 0;
    if (value < DIGIT) {
        zeros = 16;
        value <<= 16;
    }
    if (value < (uint32_t)1 << 24) {
        zeros += 8;
        value <<= 8;
    }
    if (value < (uint32_t)1 << 28) {
        zeros += 4;
        value <<= 4;
    }
    if (value < (uint32_t)1 << 30) {
        zeros += 2;
        value <<= 2;
    }
    return zeros + (value >> 31 ^ 1u);
}

/* Divides high:low by a divisor above `high`, which leaves a quotient of 32 bits. */
static uint32_t divide_long(uint32_t high, uint32_t low, uint32_t divisor, uint32_t* remainder)
{
    const uint32_t shift = leading_zeros(divisor);
    normal by;
    by.whole = divisor << shift;
    by.high = by.whole >> DIGIT_BITS;
    by.low = by.whole & (DIGIT - 1u);
    by.reciprocal = reciprocal_of(by.high);
    uint32_t rest = high;
    if (shift != 0) {
        rest = high << shift | low >> (32u - shift);
        low <<= shift;
    }
    uint32_t quotient = 0;
    if (rest >=
        by.high) /* else the first digit is 0: the rest has at most one digit more than the quotient */
        quotient = next_digit(&by, &rest, low >> DIGIT_BITS) << DIGIT_BITS;
    else
        rest = rest << DIGIT_BITS | low >> DIGIT_BITS;
    quotient |= next_digit(&by, &rest, low & (DIGIT - 1u));
    *remainder = rest >> shift;
    return quotient;
}

/* The quotient has 32 bits: the estimate by the upper 32 bits of the divisor is at most one too small. */
static uint64_t divide_by_wide(uint64_t dividend, uint64_t divisor, uint64_t* remainder)
{
    const uint32_t shift = leading_zeros((uint32_t)(divisor >> 32));
    const uint32_t upper = (uint32_t)((divisor << shift) >> 32);
    const uint64_t half = dividend >> 1;
    uint32_t ignored;
    uint32_t quotient = divide_long((uint32_t)(half >> 32), (uint32_t)half, upper, &ignored) >> (31u - shift);
    if (quotient != 0)
        --quotient;
    uint64_t rest = dividend - quotient * divisor;
    if (rest >= divisor) {
        rest -= divisor;
        ++quotient;
    }
    *remainder = rest;
    return quotient;
}

uint64_t wide_divide(uint64_t dividend, uint64_t divisor, uint64_t* remainder)
{
    if (divisor >> 32 != 0)
        return divide_by_wide(dividend, divisor, remainder);
    const uint32_t by = (uint32_t)divisor;
    const uint32_t low = (uint32_t)dividend;
    uint32_t high = (uint32_t)(dividend >> 32);
    if (by == 0) {
        *remainder = dividend;
        return UINT64_MAX;
    }
    if (high == 0) {
        *remainder = low % by;
        return low / by;
    }
    uint32_t above = 0;
    if (high >= by) {
        above = high / by;
        high %= by;
    }
    uint32_t rest;
    const uint32_t quotient = divide_long(high, low, by, &rest);
    *remainder = rest;
    return (uint64_t)above << 32 | quotient;
}
