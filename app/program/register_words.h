// SPDX-License-Identifier: Apache-2.0
// Values of two registers, the high word first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace campanel::program {

inline void append32(std::vector<std::uint16_t>& registers, std::uint32_t value)
{
    registers.push_back(static_cast<std::uint16_t>(value >> 16));
    registers.push_back(static_cast<std::uint16_t>(value & 0xFFFFu));
}

inline void append32(std::vector<std::uint16_t>& registers, std::int32_t value)
{
    append32(registers, static_cast<std::uint32_t>(value));
}

[[nodiscard]] inline std::uint32_t get32(std::span<const std::uint16_t> registers, std::size_t at)
{
    return static_cast<std::uint32_t>(registers[at]) << 16 | registers[at + 1];
}

} // namespace campanel::program
