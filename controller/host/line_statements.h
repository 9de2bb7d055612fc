// SPDX-License-Identifier: Apache-2.0
// The statements by which somebody else moves the shaft of the line, and by which its encoder gets faults.
#pragma once

#include "machine.h"

#include <string_view>

namespace campanel::controller {

// Carries out "start 250", "stop", "slip 0.1", "lose 5", "swap on", "noise off", "jump". Returns false, and
// changes nothing, when the statement is unknown, its number is outside its range, or there is no encoder.
[[nodiscard]] bool applyLineStatement(std::string_view text, LineShaft& shaft);

} // namespace campanel::controller
