/* SPDX-License-Identifier: Apache-2.0 */
/* The longest call of the core for every kind of request, by function and by program. */
#ifndef BOARD_CALLS_H
#define BOARD_CALLS_H

#include "bench.h"

/* Powers up, downloads and operates the program; prints one line per call: call_NAME, the program and the
 * instructions. */
void calls_of_program(bench* self, const bench_case* program);

#endif
