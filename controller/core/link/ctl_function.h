/* SPDX-License-Identifier: Apache-2.0 */
/* The Modbus functions that the controller knows: 3, 6, 16 and 23, and exceptions 1, 2 and 3. */
#ifndef CTL_FUNCTION_H
#define CTL_FUNCTION_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct ctl_core;

/* Carries out a request (function code and data, `size` >= 1 bytes) and writes the answer, function code
 * first. Returns the answer's size, at most 253 bytes. */
size_t ctl_function(struct ctl_core* core, const uint8_t* request, size_t size, uint8_t* answer);

#ifdef __cplusplus
}
#endif

#endif
