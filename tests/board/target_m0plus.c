/* SPDX-License-Identifier: Apache-2.0 */
/* The bench on cortex_m0plus.cpp, whose memory is cleared: its devices, and the entry. */
#include "bench.h"

#define DEVICE(offset) (*(volatile uint32_t*)(0x40000000u + (offset)))
#define CONSOLE DEVICE(0u)
#define CYCLES DEVICE(4u)
#define NUMBER DEVICE(8u)
#define END DEVICE(12u)

void bench_print(const char* text)
{
    while (*text != 0)
        CONSOLE = (uint8_t)*text++;
}

uint32_t bench_counter(void)
{
    return CYCLES;
}

int main(void)
{
    END = (uint32_t)bench_run(NUMBER);
    return 0;
}
