// SPDX-License-Identifier: Apache-2.0
// The input pins of the simulated machine that a person sets: by option or by a statement.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace campanel::controller {

struct PinStatement {
    unsigned bit = 0; // of InputBit
    bool isOn = false;
};

// Returns their names, separated by a comma and a space.
[[nodiscard]] std::string pinNames();
// Parses "NAME on" or "NAME off".
[[nodiscard]] std::optional<PinStatement> parsePinStatement(std::string_view text);
// Parses names separated by commas; returns the bits of InputBit.
[[nodiscard]] std::optional<std::uint16_t> parsePins(std::string_view names);

} // namespace campanel::controller
