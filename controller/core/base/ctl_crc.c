/* SPDX-License-Identifier: Apache-2.0 */
/* Half-byte tables: 96 bytes of constants, a fair middle between a 1 KB table and a loop over bits. */
#include "base/ctl_crc.h"

uint16_t ctl_crc16(const uint8_t* bytes, size_t size)
{
    return ctl_crc16_bytes(CTL_CRC16_START, bytes, size);
}

uint16_t ctl_crc16_bytes(uint16_t crc, const uint8_t* bytes, size_t size)
{
    static const uint16_t table[16] = {0x0000, 0xCC01, 0xD801, 0x1400, 0xF001, 0x3C00, 0x2800, 0xE401,
                                       0xA001, 0x6C00, 0x7800, 0xB401, 0x5000, 0x9C01, 0x8801, 0x4400};
    uint32_t sum = crc;
    for (size_t i = 0; i < size; ++i) {
        sum ^= bytes[i];
        sum = sum >> 4 ^ table[sum & 0xFu];
        sum = sum >> 4 ^ table[sum & 0xFu];
    }
    return (uint16_t)sum;
}

static uint32_t half_byte(uint32_t crc)
{
    static const uint32_t table[16] = {0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu,
                                       0x76DC4190u, 0x6B6B51F4u, 0x4DB26158u, 0x5005713Cu,
                                       0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
                                       0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu};
    return (crc >> 4) ^ table[crc & 0xFu];
}

uint32_t ctl_crc32_bytes(uint32_t crc, const uint8_t* bytes, size_t size)
{
    for (size_t i = 0; i < size; ++i)
        crc = half_byte(half_byte(crc ^ bytes[i]));
    return crc;
}

uint32_t ctl_crc32_registers(uint32_t crc, const uint16_t* registers, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const uint32_t swapped = (uint32_t)registers[i] >> 8 | ((uint32_t)registers[i] & 0xFFu) << 8;
        crc = half_byte(half_byte(half_byte(half_byte(crc ^ swapped))));
    }
    return crc;
}
