// SPDX-License-Identifier: Apache-2.0
// The header of a program bank as a value: the figures of the table and the parameters of its recipe. The
// rows follow the header in the bank.
#pragma once

#include "modbus/map/codec.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace campanel::modbus {

struct TableRow {
    std::uint16_t pulses = 0; // 0: a pause
    std::uint32_t ticks = 0;

    bool operator==(const TableRow&) const = default;
};

struct BankHeader {
    std::uint16_t layout = static_cast<std::uint16_t>(TableLayout::StepTable);
    ProgramKind kind = ProgramKind::RotaryCutter;
    std::uint16_t rowCount = 0;
    std::uint32_t cycleTicks = 0;
    std::uint32_t cyclePulses = 0;
    std::uint32_t remainder = 0;
    std::uint32_t divisor = 1;
    std::uint16_t carryRow = 0;
    double cutAngleDeg = 0.0;
    double syncStartDeg = 0.0;
    double syncEndDeg = 0.0;

    double knifeRadiusMm = 0.0;
    std::uint32_t knives = 1;
    std::uint32_t pulsesPerMotorRev = 0;
    std::uint32_t gearNumerator = 1;
    std::uint32_t gearDenominator = 1;
    std::uint16_t pinned = 0; // bit 0 bag length, 1 rate, 2 base speed, 3 film speed
    double bagLengthMm = 0.0;
    double rateBagsPerMin = 0.0;
    double baseSpeedMmPerS = 0.0;
    double filmSpeedMmPerS = 0.0;
    double syncRatio = 1.0;
    std::array<double, 4> k{};
    std::uint16_t law = 0;
    std::array<double, 2> lawParameters{};
    std::uint32_t rampSlices = 0;
    std::uint32_t recipeVersion = 0;
    std::string recipeName;
};

// The place of a point cam's knots in its bank, behind the rows; count 0 for other banks.
struct KnotSpan {
    std::uint16_t offset = 0; // from the bank's base
    std::uint16_t count = 0;  // registers
};
[[nodiscard]] KnotSpan knotSpan(std::span<const std::uint16_t> header);

// Returns the number of registers of the whole bank by its header: header, rows and knots. Empty for an
// impossible bank.
[[nodiscard]] std::optional<std::uint16_t> bankLength(std::span<const std::uint16_t> header);

// Decodes `registers`, which must contain at least the header (bankHeaderRegisters).
[[nodiscard]] BankHeader decodeBankHeader(std::span<const std::uint16_t> registers);

// Returns the bank's registers, header and rows. rowCount comes from `rows`. Errors: a value that its
// register cannot hold, more rows than rowCapacity.
[[nodiscard]] tl::expected<std::vector<std::uint16_t>, CodecError> encodeBank(const BankHeader& header,
                                                                              std::span<const TableRow> rows);

// Returns the rows of a whole bank; empty when the bank is shorter than its header says.
[[nodiscard]] std::vector<TableRow> decodeRows(std::span<const std::uint16_t> bank);

} // namespace campanel::modbus
