// SPDX-License-Identifier: Apache-2.0
// The commands that the controller accepts in each state: the rules of its core, for everything that offers a
// command.
#pragma once

#include "app/link/link_values.h"

namespace campanel::panel {

// Returns the refusal that follows from this status; None: the controller accepts the command. The status
// does not contain every reason for a refusal: parameters of the packing line or a persisting fault may still
// refuse it. Supports Start, Home, ResetFault and, with a cutter's program, bags by hand; the status must
// have a state.
[[nodiscard]] modbus::Refusal expectedRefusal(const modbus::StatusBlock& status, modbus::Command command);

} // namespace campanel::panel
