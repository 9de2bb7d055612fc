// SPDX-License-Identifier: Apache-2.0
// Ranges of registers as named values: for the register inspector and for decoding frames.
#pragma once

#include "modbus/map/register_map.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace campanel::modbus {

struct RegisterSpan {
    std::uint16_t address = 0; // absolute
    std::uint16_t count = 0;

    bool operator==(const RegisterSpan&) const = default;
};

// Returns the range of the named register; a field of a bank is that of the active bank. Empty for an unknown
// name.
[[nodiscard]] std::optional<RegisterSpan> findSpan(std::string_view name);

// One value of the register table, or one register without a row in the table.
struct NamedValue {
    const RegisterInfo* info = nullptr; // empty: not in the table
    std::uint16_t address = 0;          // absolute
    std::uint16_t count = 1;            // registers
    std::int64_t raw = 0;
    std::optional<double> physical; // raw * scale; empty for texts, enumerations, bits and unnamed registers

    // Returns "status.master_angle", "0x4123".
    [[nodiscard]] std::string name() const;
    // Returns "Running", "12.34 deg", "NotHomed, ClockNotSet", "0x04D2".
    [[nodiscard]] std::string text() const;

    std::string words; // contents of a text register
};

// Returns the values of a range. Rows for only one kind of program or layout are included if the range itself
// contains that kind or layout, else if `kind` and `layout` match.
[[nodiscard]] std::vector<NamedValue> namedValues(std::uint16_t address,
                                                  std::span<const std::uint16_t> registers,
                                                  ProgramKind kind = ProgramKind::None,
                                                  TableLayout layout = TableLayout::None);

} // namespace campanel::modbus
