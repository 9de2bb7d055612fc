// SPDX-License-Identifier: Apache-2.0
// The one codec of a program bank, for all kinds: recipe and table to registers, and the recipe back from a
// header.
#pragma once

#include "app/program/recipe.h"
#include "app/program/solved_program.h"

#include "modbus/map/codec.h"
#include "profile/cam/cam_table.h"
#include "profile/cutter/step_table.h"
#include "profile/intervals/intervals.h"
#include "profile/press/press.h"

#include <cstdint>
#include <span>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

namespace campanel::program {

using Table =
    std::variant<profile::StepTable, profile::CamTable, profile::IntervalTable, profile::PressTable>;

// Returns header and rows, for a cam also its knots or segments. `recipe` must be quantised, `solved` and
// `table` its own. Errors: a value that its register cannot hold, more rows than the bank can hold.
[[nodiscard]] tl::expected<std::vector<std::uint16_t>, modbus::CodecError>
encodeBank(const Recipe& recipe, const SolvedProgram& solved, const Table& table);

// Copies the inputs of the header to the recipe, which must be of the header's kind. `list`: registers of
// the knots or segments of a cam, empty for other kinds. Returns false when the header does not pin two
// values of a cutter.
[[nodiscard]] bool decodeBank(std::span<const std::uint16_t> header, std::span<const std::uint16_t> list,
                              Recipe& recipe);

} // namespace campanel::program
