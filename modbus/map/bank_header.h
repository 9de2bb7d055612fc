// SPDX-License-Identifier: Apache-2.0
// The sizes of a program bank by its header. The rows follow the header; a point cam's knots follow its rows.
#pragma once

#include "modbus/map/protocol.h"

#include <cstdint>
#include <optional>
#include <span>

namespace campanel::modbus {

// The registers of one row and the maximum number of rows; 0 for an unknown layout.
struct RowSize {
    std::uint16_t registers = 0;
    std::uint16_t capacity = 0;
};
[[nodiscard]] RowSize rowSize(TableLayout layout);

// The place of a point cam's knots in its bank, behind the rows; count 0 for other banks.
struct KnotSpan {
    std::uint16_t offset = 0; // from the bank's base
    std::uint16_t count = 0;  // registers
};
[[nodiscard]] KnotSpan knotSpan(std::span<const std::uint16_t> header);

// Returns the number of registers of the whole bank by its header: header, rows and knots. Empty for an
// impossible bank.
[[nodiscard]] std::optional<std::uint16_t> bankLength(std::span<const std::uint16_t> header);

} // namespace campanel::modbus
