/* SPDX-License-Identifier: Apache-2.0 */
/* 64-bit quotients, remainders and products of edge values and of random pairs, folded into one line for
 * each: the same on the host, which divides by itself, and on the processors that have our own division. */
#include "bench.h"

#define RANDOM_PAIRS 1000000u

static uint32_t folded;

static void fold(uint64_t value)
{
    folded = (folded << 5 | folded >> 27) ^ (uint32_t)value;
    folded = (folded << 5 | folded >> 27) ^ (uint32_t)(value >> 32);
}

static void try_unsigned(uint64_t one, uint64_t other)
{
    fold(one * other);
    if (other != 0) {
        fold(one / other);
        fold(one % other);
    }
}

static void try_signed(int64_t one, int64_t other)
{
    if (other == 0 || (one == INT64_MIN && other == -1))
        return;
    fold((uint64_t)(one / other));
    fold((uint64_t)(one % other));
}

static const uint64_t edges[] = {0,
                                 1,
                                 2,
                                 3,
                                 10,
                                 255,
                                 256,
                                 32767,
                                 32768,
                                 65535,
                                 65536,
                                 65537,
                                 0x7FFFFFFF,
                                 0x80000000,
                                 0x80000001,
                                 0xFFFF0000,
                                 0xFFFFFFFE,
                                 0xFFFFFFFF,
                                 0x100000000,
                                 0x100000001,
                                 0x1FFFFFFFF,
                                 0xFFFFFFFF0000,
                                 0x7FFFFFFFFFFFFFFF,
                                 0x8000000000000000,
                                 0x8000000000000001,
                                 0x80000000FFFFFFFF,
                                 0xFFFFFFFE00000001,
                                 0xFFFFFFFF00000000,
                                 0xFFFFFFFFFFFFFFFE,
                                 0xFFFFFFFFFFFFFFFF};

static void try_edges(void)
{
    const uint32_t count = sizeof edges / sizeof edges[0];
    for (uint32_t i = 0; i < count; ++i) {
        for (uint32_t k = 0; k < count; ++k) {
            try_unsigned(edges[i], edges[k]);
            try_unsigned(edges[i] - 1u, edges[k]);
            try_unsigned(edges[i] * edges[k] - 1u, edges[k]);
            try_signed((int64_t)edges[i], (int64_t)edges[k]);
            try_signed(-(int64_t)(edges[i] >> 1), (int64_t)(edges[k] >> 1));
        }
    }
}

static uint64_t next_random(uint64_t* seed)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return *seed;
}

/* Tries numbers of any width, so that each way through a division is taken. */
static void try_random(uint32_t pairs)
{
    uint64_t seed = 88172645463325252u;
    for (uint32_t i = 0; i < pairs; ++i) {
        const uint64_t widths = next_random(&seed);
        const uint64_t one = next_random(&seed) >> (widths >> 40 & 63u);
        const uint64_t other = next_random(&seed) >> (widths >> 50 & 63u);
        if (i % 4u == 0)
            try_signed(widths >> 63 != 0 ? (int64_t)one : -(int64_t)(one >> 1), (int64_t)other);
        else
            try_unsigned(one, other);
    }
}

int bench_run(uint32_t number)
{
    folded = 0;
    try_edges();
    bench_print_hex("edges ", folded, "\n");
    try_random(number == 0 ? RANDOM_PAIRS : number);
    bench_print_hex("random ", folded, "\n");
    return 0;
}
