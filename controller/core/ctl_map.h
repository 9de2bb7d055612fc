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
#define CTL_PARAMETER_REGISTERS (CTL_REG_PARAMETER_EYE_DISTANCE + 2u - CTL_REG_PARAMETER_HEARTBEAT_TIMEOUT)

struct ctl_core;

/* Writable registers as the panel left them, each group at its address in the map. */
typedef struct {
    uint16_t parameter[CTL_PARAMETER_REGISTERS];
    uint16_t exchange[3];
    uint16_t command[6];
    uint16_t transfer[4 + CTL_BLOCK_REGISTERS];
    uint16_t readback[3];
    uint16_t readback_result[3 + CTL_READBACK_REGISTERS];
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
