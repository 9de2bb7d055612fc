// SPDX-License-Identifier: Apache-2.0
// The CRC-32 of Ethernet and zlib (reflected polynomial 0xEDB88320, check value 0xCBF43926), over bytes and
// over registers. The high byte of a register comes first, as in the controller's CRC-32 of a program bank.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace campanel::modbus {

namespace detail {

consteval std::array<std::uint32_t, 256> makeCrc32Table()
{
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        std::uint32_t value = byte;
        for (int bit = 0; bit < 8; ++bit)
            value = (value & 1u) != 0 ? (value >> 1) ^ 0xEDB88320u : value >> 1;
        table[byte] = value;
    }
    return table;
}

inline constexpr std::array<std::uint32_t, 256> crc32Table = makeCrc32Table();

constexpr std::uint32_t crc32Step(std::uint32_t crc, std::uint8_t byte)
{
    return (crc >> 8) ^ crc32Table[(crc ^ byte) & 0xFFu];
}

} // namespace detail

[[nodiscard]] constexpr std::uint32_t crc32(std::span<const std::uint8_t> bytes)
{
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const std::uint8_t byte : bytes)
        crc = detail::crc32Step(crc, byte);
    return ~crc;
}

[[nodiscard]] constexpr std::uint32_t crc32OfRegisters(std::span<const std::uint16_t> registers)
{
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const std::uint16_t value : registers) {
        crc = detail::crc32Step(crc, static_cast<std::uint8_t>(value >> 8));
        crc = detail::crc32Step(crc, static_cast<std::uint8_t>(value & 0xFFu));
    }
    return ~crc;
}

} // namespace campanel::modbus
