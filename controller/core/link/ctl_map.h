/* SPDX-License-Identifier: Apache-2.0 */
/* Registers by address: where each lies in the core, what may be written, within which limits, and what a
 * write sets off. */
#ifndef CTL_MAP_H
#define CTL_MAP_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Exception codes of Modbus. */
#define CTL_ILLEGAL_FUNCTION 1u
#define CTL_ILLEGAL_ADDRESS 2u
#define CTL_ILLEGAL_VALUE 3u

struct ctl_core;

/* Sets the writable registers to their defaults. */
void ctl_map_init(struct ctl_core* core);
/* All return 0 or the exception code; a write that is refused has changed nothing. The first one only tells
 * what a read would return. */
uint8_t ctl_map_readable(const struct ctl_core* core, uint32_t address, uint32_t count);
uint8_t ctl_map_read(struct ctl_core* core, uint32_t address, uint16_t* values, uint32_t count);
uint8_t ctl_map_write(struct ctl_core* core, uint32_t address, const uint16_t* values, uint32_t count);

#ifdef __cplusplus
}
#endif

#endif
