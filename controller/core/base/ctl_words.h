/* SPDX-License-Identifier: Apache-2.0 */
/* Values wider than one register or byte: high word and high byte first, by shifts, whatever the processor.
 */
#ifndef CTL_WORDS_H
#define CTL_WORDS_H

#include <stdint.h>

static inline uint32_t ctl_get32(const uint16_t* registers)
{
    return ((uint32_t)registers[0] << 16) | registers[1];
}

static inline void ctl_put32(uint16_t* registers, uint32_t value)
{
    registers[0] = (uint16_t)(value >> 16);
    registers[1] = (uint16_t)(value & 0xFFFFu);
}

/* The nearest value that a signed register holds. */
static inline uint16_t ctl_saturated16(int64_t value)
{
    if (value > INT16_MAX)
        value = INT16_MAX;
    if (value < INT16_MIN)
        value = INT16_MIN;
    return (uint16_t)(value & 0xFFFF);
}

static inline uint16_t ctl_get_bytes16(const uint8_t* bytes)
{
    return (uint16_t)((uint16_t)(bytes[0] << 8) | bytes[1]);
}

static inline void ctl_put_bytes16(uint8_t* bytes, uint16_t value)
{
    bytes[0] = (uint8_t)(value >> 8);
    bytes[1] = (uint8_t)(value & 0xFFu);
}

#endif
