// SPDX-License-Identifier: Apache-2.0
// Converts a recipe to the registers of a bank, and the header of a bank back to its recipe.
#pragma once

#include "app/program/bank_codec.h"
#include "app/program/recipe.h"
#include "app/program/solved_program.h"

#include "modbus/map/bank_header.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace campanel::program {

// The reason why a recipe has no program: all exceeded limits of the machine, in the order of the checks, or
// a value that its register cannot hold.
struct ProgramRefusal {
    std::vector<profile::Refusal> limits;
    std::optional<modbus::CodecError> unstorable;
};

// Returns the ids and the numbers, for logs.
[[nodiscard]] std::string describe(const ProgramRefusal& refusal);

// The data of one program, built from the quantised recipe.
struct ProgramImage {
    Recipe recipe;
    std::vector<std::uint16_t> registers; // header and rows, as downloaded
    std::uint32_t crc = 0;                // CRC-32 of the registers
    SolvedProgram solved;
    Table table;

    // Returns the solved rotary cutter; the recipe must be one.
    [[nodiscard]] const profile::RotaryCutter& cutter() const { return solved.cutter.value(); }
    [[nodiscard]] const profile::StepTable& stepTable() const { return std::get<profile::StepTable>(table); }
};

// Builds the program. Refuses an impossible cycle, exceeded limits of the machine, and a table that the
// controller cannot hold.
[[nodiscard]] tl::expected<ProgramImage, ProgramRefusal> buildProgram(const Recipe& recipe);
// The same of a recipe that is quantised and solved already.
[[nodiscard]] tl::expected<ProgramImage, ProgramRefusal> buildProgram(Recipe quantised, SolvedProgram solved);

enum class DecodeErrorKind : std::uint8_t { Layout, Kind, Pinned, Law, Choice };

// A header that this version cannot represent as a recipe; `code` is the unknown value.
struct DecodeError {
    DecodeErrorKind kind = DecodeErrorKind::Layout;
    int code = 0;
};

// Returns the recipe stored beside the table: the controller's active program. `list`: the registers of
// modbus::listSpan(), for a cam. `limits` supplies the data that is not in the bank (limits of the
// drive, timer, table size). The derived cycle values are those of the header.
[[nodiscard]] tl::expected<Recipe, DecodeError> decodeProgram(std::span<const std::uint16_t> header,
                                                              std::span<const std::uint16_t> list,
                                                              const profile::Machine& limits);

} // namespace campanel::program
