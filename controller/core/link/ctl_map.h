/* SPDX-License-Identifier: Apache-2.0 */
/* Registers by address: where each lies in the core, what may be written, within which limits, and what a
 * write sets off. */
#ifndef CTL_MAP_H
#define CTL_MAP_H

#include "ctl_registers.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Exception codes of Modbus. */
#define CTL_ILLEGAL_FUNCTION 1u
#define CTL_ILLEGAL_ADDRESS 2u
#define CTL_ILLEGAL_VALUE 3u

/* Up to map 1.1 there were ten parameters; a flash of then holds those. */
#define CTL_OLD_PARAMETER_REGISTERS 10u

struct ctl_core;

/* Writable registers as the panel left them, each group at its address in the map. */
typedef struct {
    uint16_t parameter[CTL_GROUP_PARAMETER];
    uint16_t exchange[CTL_GROUP_EXCHANGE];
    uint16_t command[CTL_GROUP_COMMAND];
    uint16_t transfer[CTL_GROUP_TRANSFER];
    uint16_t readback[CTL_GROUP_READBACK];
    uint16_t readback_result[CTL_GROUP_READBACK_RESULT];
} ctl_written;

void ctl_map_init(struct ctl_core* core);
/* Both return 0 or the exception code; a write that is refused has changed nothing. */
uint8_t ctl_map_read(struct ctl_core* core, uint32_t address, uint16_t* values, uint32_t count);
uint8_t ctl_map_write(struct ctl_core* core, uint32_t address, const uint16_t* values, uint32_t count);
/* The parameter registers hold values within their limits. */
int ctl_map_parameters_valid(const uint16_t* parameter);

#ifdef __cplusplus
}
#endif

#endif
