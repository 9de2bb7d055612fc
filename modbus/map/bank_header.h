// SPDX-License-Identifier: Apache-2.0
// The sizes of a program bank by its header. The rows follow the header; the knots or segments of a cam
// follow its rows.
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

// The place of a cam's list in its bank, behind the rows: the knots or segments of which its curve is made.
// count is 0 for other banks.
struct ListSpan {
    std::uint16_t offset = 0; // from the bank's base
    std::uint16_t count = 0;  // registers
};
[[nodiscard]] ListSpan listSpan(std::span<const std::uint16_t> header);

// Returns the number of registers of the whole bank by its header: header, rows and list. Empty for an
// impossible bank.
[[nodiscard]] std::optional<std::uint16_t> bankLength(std::span<const std::uint16_t> header);

} // namespace campanel::modbus
