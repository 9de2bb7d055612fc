/* SPDX-License-Identifier: Apache-2.0 */
/* Functions of a bench in QEMU besides bench.h. */
#ifndef BENCH_TARGET_H
#define BENCH_TARGET_H

#include "bench.h"

/* Opens the line that bench_print() writes to, and starts the counter of SP804 at 0x101E3000: 1 MHz, down
 * from UINT32_MAX. */
void bench_open(void);
/* Returns the number behind the program's name in QEMU's command line; 0 when there is none. */
uint32_t bench_number(void);
/* Ends QEMU. */
void bench_exit(bool good);

#endif
