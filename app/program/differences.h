// SPDX-License-Identifier: Apache-2.0
// The changes of a download, value by value, compared as register values.
#pragma once

#include "modbus/map/register_map.h"
#include "profile/model/fields.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace campanel::program {

struct Difference {
    const modbus::RegisterInfo* info = nullptr; // "program.bag_length", unit and scale
    std::optional<profile::Field> field;        // empty: law, its parameters, name, version, pins
    double a = 0.0;                             // numbers, in the register's unit
    double b = 0.0;
    std::string textA; // texts, such as the name
    std::string textB;
};

// Returns the fields that differ between the headers of two banks, in the order of the map. Rows are not
// compared.
[[nodiscard]] std::vector<Difference> differences(std::span<const std::uint16_t> a,
                                                  std::span<const std::uint16_t> b);

} // namespace campanel::program
