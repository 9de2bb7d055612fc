// SPDX-License-Identifier: Apache-2.0
// Creates the documents of the register map: REGISTERS.md and the controller's C header, as text.
#pragma once

#include "modbus/map/register_map.h"

#include <string>
#include <string_view>

namespace campanel::modbus {

[[nodiscard]] std::string registersMarkdown();
[[nodiscard]] std::string registersCHeader();

// Returns "u16", "text" ...
[[nodiscard]] std::string_view typeName(RegisterType type);
// Returns "0x011B".
[[nodiscard]] std::string hexAddress(unsigned address);

} // namespace campanel::modbus
