// SPDX-License-Identifier: Apache-2.0
// Recipe to the registers of a bank, and a bank's header back to the recipe that it was built from.
#pragma once

#include "app/program/axis_bank.h"
#include "app/program/recipe.h"
#include "app/program/solved_program.h"

#include "modbus/map/bank_header.h"
#include "profile/cutter/step_table.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace campanel::program {

// Why no program can be made of a recipe: limits of the machine (all that are broken, worst first as
// checked), or a value that its register cannot hold.
struct ProgramRefusal {
    std::vector<profile::Refusal> limits;
    std::optional<modbus::CodecError> unstorable;
};

[[nodiscard]] std::string describe(const ProgramRefusal& refusal);

// Everything about one program, made from the quantised recipe.
struct ProgramImage {
    Recipe recipe;
    std::vector<std::uint16_t> registers; // header and rows, as downloaded
    std::uint32_t crc = 0;                // CRC-32 of the registers
    SolvedProgram solved;
    std::variant<profile::StepTable, profile::CamTable, profile::IntervalTable, profile::PressTable> table;

    // Of a rotary cutter; the recipe must be one.
    [[nodiscard]] const profile::RotaryCutter& cutter() const { return solved.cutter.value(); }
    [[nodiscard]] const profile::StepTable& stepTable() const { return std::get<profile::StepTable>(table); }
};

// Refuses a cycle that cannot be, broken limits of the machine, and a table that the controller cannot hold.
[[nodiscard]] tl::expected<ProgramImage, ProgramRefusal> buildProgram(const Recipe& recipe);

enum class DecodeErrorKind : std::uint8_t { Layout, Kind, Pinned, Law, Choice };

// A header that this version cannot show as a recipe; `code` is the value that it does not know.
struct DecodeError {
    DecodeErrorKind kind = DecodeErrorKind::Layout;
    int code = 0;
};

[[nodiscard]] std::string describe(const DecodeError& error);

// The recipe kept beside the table: what the controller is running. `knots`: the registers that
// modbus::knotSpan() names, for a point cam. `limits` supplies what the bank does not hold (limits of the
// drive, timer, table size). The derived cycle values are those of the header.
[[nodiscard]] tl::expected<Recipe, DecodeError> decodeProgram(std::span<const std::uint16_t> header,
                                                              std::span<const std::uint16_t> knots,
                                                              const profile::Machine& limits);

} // namespace campanel::program
