// SPDX-License-Identifier: Apache-2.0
// The CRC-16 that ends every Modbus RTU frame, low byte first (Modbus over serial line, 2.5.1.2).
#pragma once

#include <cstdint>
#include <span>

namespace campanel::modbus {

[[nodiscard]] constexpr std::uint16_t crc16(std::span<const std::uint8_t> bytes)
{
    std::uint16_t crc = 0xFFFF;
    for (const std::uint8_t byte : bytes) {
        crc = static_cast<std::uint16_t>(crc ^ byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = static_cast<std::uint16_t>((crc & 1u) != 0 ? (crc >> 1) ^ 0xA001u : crc >> 1);
    }
    return crc;
}

// Returns true when the last two of at least four bytes are the CRC-16 of those before them.
[[nodiscard]] constexpr bool endsWithCrc16(std::span<const std::uint8_t> frame)
{
    if (frame.size() < 4)
        return false;
    const std::uint16_t crc = crc16(frame.first(frame.size() - 2));
    return frame[frame.size() - 2] == (crc & 0xFFu) && frame.back() == crc >> 8;
}

} // namespace campanel::modbus
