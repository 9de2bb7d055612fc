// SPDX-License-Identifier: Apache-2.0
// Banks of the kinds other than the rotary cutter: tables and inputs to registers, and the inputs back from a
// header.
#pragma once

#include "app/program/recipe.h"

#include "modbus/map/codec.h"
#include "profile/cam/cam_table.h"
#include "profile/intervals/intervals.h"
#include "profile/press/press.h"

#include <cstdint>
#include <optional>
#include <span>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

namespace campanel::program {

using AxisTable = std::variant<profile::CamTable, profile::IntervalTable, profile::PressTable>;

// Returns header and rows, for a point cam also its knots. `recipe` must be quantised and no cutter. Error:
// an input that its register cannot hold.
[[nodiscard]] tl::expected<std::vector<std::uint16_t>, modbus::CodecError>
encodeAxisBank(const Recipe& recipe, const AxisTable& table);

// Copies the inputs of the header to the recipe, which must be of the header's kind. `knots`: registers of
// the knots, empty for other kinds.
void decodeAxisHeader(std::span<const std::uint16_t> header, std::span<const std::uint16_t> knots,
                      Recipe& recipe);

} // namespace campanel::program
