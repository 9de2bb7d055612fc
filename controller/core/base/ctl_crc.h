/* SPDX-License-Identifier: Apache-2.0 */
/* The two checksums of the contract: CRC-16 of Modbus RTU frames, CRC-32 (Ethernet, zlib) of program banks.
 */
#ifndef CTL_CRC_H
#define CTL_CRC_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CTL_CRC32_START 0xFFFFFFFFu

#define CTL_CRC16_START 0xFFFFu

uint16_t ctl_crc16(const uint8_t* bytes, size_t size);
/* Continues from CTL_CRC16_START. */
uint16_t ctl_crc16_bytes(uint16_t crc, const uint8_t* bytes, size_t size);

/* Continue from CTL_CRC32_START; the finished checksum is the result inverted. */
uint32_t ctl_crc32_bytes(uint32_t crc, const uint8_t* bytes, size_t size);
/* Each register high byte first. */
uint32_t ctl_crc32_registers(uint32_t crc, const uint16_t* registers, size_t count);

#ifdef __cplusplus
}
#endif

#endif
