// SPDX-License-Identifier: Apache-2.0
// The register table: every holding register that panel and controller share. It is the source of the
// controller's C header, REGISTERS.md, `campanelctl registers` and the limits of fields that are registers.
// Values of two registers are sent high word first; text is UTF-8, two bytes a register, padded with zeros.
#pragma once

#include "modbus/map/protocol.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace campanel::modbus {

enum class Access : std::uint8_t { ReadOnly, ReadWrite };
enum class RegisterType : std::uint8_t { U16, I16, U32, I32, Text, Block };

struct RegisterInfo {
    std::string_view name;     // "status.state": group and name, stable
    std::uint16_t address = 0; // absolute; within a bank: offset from the bank's base
    RegisterType type = RegisterType::U16;
    std::uint16_t count = 1; // number of registers
    Access access = Access::ReadOnly;
    double scale = 1.0;    // physical value = raw * scale
    std::string_view unit; // unit of the physical value, empty for none
    double minimum = 0.0;  // physical limits of writable values; equal for none
    double maximum = 0.0;
    double defaultValue = 0.0;
    std::string_view enumName; // enumeration of protocol.h for the values; bits when it ends in "Bit"
    std::string_view text;
    // The program kinds or table layouts that have the register (bit n: kind or layout n); 0: all.
    std::uint16_t kinds = 0;
    std::uint16_t layouts = 0;
    // The first minor map version that has the register; 0: older than any controller that a panel may meet.
    std::uint16_t minor = 0;

    [[nodiscard]] constexpr bool appliesTo(ProgramKind kind, TableLayout layout) const
    {
        return (kinds == 0 || contains(kinds, kind)) && (layouts == 0 || contains(layouts, layout));
    }
    template <typename E> [[nodiscard]] static constexpr std::uint16_t bitOf(E value)
    {
        return static_cast<std::uint16_t>(1u << static_cast<unsigned>(value));
    }
    // The value may be any word from the line.
    template <typename E> [[nodiscard]] static constexpr bool contains(std::uint16_t set, E value)
    {
        return static_cast<unsigned>(value) < 16 && (set & bitOf(value)) != 0;
    }
};

// The first address of the two program banks; both have the layout of bankFields().
inline constexpr std::uint16_t activeBankBase = 0x4000;
inline constexpr std::uint16_t stagedBankBase = 0x8000;
inline constexpr std::uint16_t bankHeaderRegisters = 64;
inline constexpr std::uint16_t rowRegisters = 3;      // step table: pulses u16, ticks u32
inline constexpr std::uint16_t rowCapacity = 2048;    // step table
inline constexpr std::uint16_t camPointRegisters = 4; // position i32, slope i32
inline constexpr std::uint16_t camPointCapacity = 2001;
inline constexpr std::uint16_t knotRegisters = 4; // master u32, slave i32
inline constexpr std::uint16_t knotCapacity = 100;
// A segment: end u32, slave i32, motion u16, speed and acceleration i32 at both ends, two parameters u32.
inline constexpr std::uint16_t segmentRegisters = 17;
inline constexpr std::uint16_t segmentCapacity = 40;
inline constexpr std::uint16_t intervalRegisters = 8; // distance, first speed, last speed, acceleration u32
inline constexpr std::uint16_t intervalCapacity = 1024;
inline constexpr std::uint16_t stageRegisters = 8; // speed u32, position i32, force u32, time u32
inline constexpr std::uint16_t stageCount = 5;
inline constexpr std::uint16_t bankRegisters =
    bankHeaderRegisters + camPointRegisters * camPointCapacity + segmentRegisters * segmentCapacity;
static_assert(knotRegisters * knotCapacity <= segmentRegisters * segmentCapacity);
inline constexpr std::uint16_t blockRegisters =
    116; // payload of one transfer block: the maximum of one FC23 request
inline constexpr std::uint16_t readbackRegisters = 122; // payload of one read-back answer
// The sizes in the group `packer`: recorded bags (four registers each), and objects on the film before the
// knife.
inline constexpr std::uint16_t bagRecords = 8;
inline constexpr std::uint16_t edgeRecords = 12;
// Parts of the learned band of the knife's torque.
inline constexpr std::uint16_t jamBins = 32;
inline constexpr std::uint16_t eyeRecords = 6;
inline constexpr std::uint16_t viewCuts = 6;
inline constexpr std::uint16_t viewMarks = 12;
inline constexpr std::uint16_t viewProducts = 8;

// Returns the registers at absolute addresses, ascending.
[[nodiscard]] std::span<const RegisterInfo> registers();
// Returns the name of the registers of an input that is a contact, without _contact and _filter, such as
// "parameter.drive_alarm".
[[nodiscard]] std::string contactName(const InputRow& row);
// Returns true for a register of the machine data: it is written alone, and saved with the program.
[[nodiscard]] bool isMachineData(const RegisterInfo& row);
// Returns true for a value that is written by itself: machine data, and what an operator sets while the
// machine runs. All other writable registers belong to protocols of their own.
[[nodiscard]] bool isWrittenAlone(const RegisterInfo& row);
// Returns the fields of a bank's header, as offsets from its base, ascending.
[[nodiscard]] std::span<const RegisterInfo> bankFields();
// Returns a row by its name in either table; nullptr when there is none.
[[nodiscard]] const RegisterInfo* findRegister(std::string_view name);

} // namespace campanel::modbus
