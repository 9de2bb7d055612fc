// SPDX-License-Identifier: Apache-2.0
// The one register table: every holding register that panel and controller share. The controller's C header,
// REGISTERS.md, `campanelctl registers` and the limits of fields that are registers all come from here.
// Values of two registers are sent high word first; text is UTF-8, two bytes a register, padded with zeros.
#pragma once

#include "modbus/protocol.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace campanel::modbus {

enum class Access : std::uint8_t { ReadOnly, ReadWrite };
enum class RegisterType : std::uint8_t { U16, I16, U32, I32, Text, Block };

struct RegisterInfo {
    std::string_view name;     // "status.state": group and name, stable
    std::uint16_t address = 0; // absolute; within a bank: offset from the bank's base
    RegisterType type = RegisterType::U16;
    std::uint16_t count = 1; // registers occupied
    Access access = Access::ReadOnly;
    double scale = 1.0;    // physical value = raw * scale
    std::string_view unit; // unit of the physical value, empty when it has none
    double minimum = 0.0;  // physical limits of writable values; equal when there is none
    double maximum = 0.0;
    double defaultValue = 0.0;
    std::string_view
        enumName; // enumeration of protocol.h that explains the values; bits when it ends in "Bit"
    std::string_view text;
};

// First address of the two program banks; both have the layout of bankFields().
inline constexpr std::uint16_t activeBankBase = 0x4000;
inline constexpr std::uint16_t stagedBankBase = 0x8000;
inline constexpr std::uint16_t bankHeaderRegisters = 64;
inline constexpr std::uint16_t rowRegisters = 3; // pulses u16, ticks u32
inline constexpr std::uint16_t rowCapacity = 2048;
inline constexpr std::uint16_t bankRegisters = bankHeaderRegisters + rowRegisters * rowCapacity;
inline constexpr std::uint16_t blockRegisters =
    116; // payload of one transfer block: the most that one FC23 request holds
inline constexpr std::uint16_t readbackRegisters = 122; // payload of one read-back answer

// Registers at absolute addresses, ascending.
[[nodiscard]] std::span<const RegisterInfo> registers();
// Fields of a bank's header, as offsets from its base, ascending.
[[nodiscard]] std::span<const RegisterInfo> bankFields();
// By name in either table; nullptr when there is none.
[[nodiscard]] const RegisterInfo* findRegister(std::string_view name);

} // namespace campanel::modbus
