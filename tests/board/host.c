/* SPDX-License-Identifier: Apache-2.0 */
/* The bench on the host. */
#include "bench.h"

#include <stdio.h>
#include <stdlib.h>

void bench_print(const char* text)
{
    fputs(text, stdout);
}

uint32_t bench_counter(void)
{
    return 0;
}

int main(int argc, char** argv)
{
    return bench_run(argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 0u);
}
