// SPDX-License-Identifier: Apache-2.0
// The Modbus functions that the panel uses, and the exception flag. Internal to modbus/.
#pragma once

#include <cstdint>

namespace campanel::modbus {

inline constexpr std::uint8_t functionRead = 3;
inline constexpr std::uint8_t functionWrite = 16;
inline constexpr std::uint8_t functionWriteAndRead = 23;
inline constexpr unsigned exceptionFlag = 0x80; // in the function of an answer

} // namespace campanel::modbus
