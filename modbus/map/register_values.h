// SPDX-License-Identifier: Apache-2.0
// Runs of registers as values with their names: for the register inspector and for reading frames.
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

// Where the named register lies; a field of a bank in the active bank. Empty: there is none of that name.
[[nodiscard]] std::optional<RegisterSpan> findSpan(std::string_view name);

// One value of the register table, or one register that no row of the table names.
struct NamedValue {
    const RegisterInfo* info = nullptr; // empty: not in the table
    std::uint16_t address = 0;          // absolute
    std::uint16_t count = 1;            // registers
    std::int64_t raw = 0;
    std::optional<double> physical; // raw * scale; empty for texts, enumerations, bits and unnamed registers

    // "status.master_angle", "0x4123".
    [[nodiscard]] std::string name() const;
    // "Running", "12.34 deg", "NotHomed, ClockNotSet", "0x04D2".
    [[nodiscard]] std::string text() const;

    std::string words; // of a text register
};

// Rows that are only for one kind of program or layout are taken when the run itself says which, else when
// `kind` and `layout` do.
[[nodiscard]] std::vector<NamedValue> namedValues(std::uint16_t address,
                                                  std::span<const std::uint16_t> registers,
                                                  ProgramKind kind = ProgramKind::None,
                                                  TableLayout layout = TableLayout::None);

} // namespace campanel::modbus
