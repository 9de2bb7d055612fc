// SPDX-License-Identifier: Apache-2.0
// Which command the controller takes in which state: the rules of its core, for everything that offers a
// command.
#pragma once

#include "app/link/link_values.h"

namespace campanel::machine {

// Returns the refusal that follows from this status; None: the controller takes the command, unless
// something refuses it that the status does not tell (parameters of the packing line, a fault that persists).
// Knows Start, Home and ResetFault; the status must have a state.
[[nodiscard]] modbus::Refusal expectedRefusal(const modbus::StatusBlock& status, modbus::Command command);

} // namespace campanel::machine
