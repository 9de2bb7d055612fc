// SPDX-License-Identifier: Apache-2.0
// Reads one register by its name with proof, or writes it and reads it back. Internal to app/link.
#pragma once

#include "app/link/link_values.h"

#include <tl/expected.hpp>

namespace campanel::link {

// Returns the physical value in the controller. Takes one exchange to read, two to write. Errors: those of
// modbus::RtuClient, and ValueRefused without an exchange. ValueRefused means that the numeric register does
// not exist, that the register to write is not a parameter, or that the value is outside its limits.
[[nodiscard]] tl::expected<double, modbus::LinkError> exchangeParameter(modbus::RtuClient& client,
                                                                        const ParameterRequest& request);

[[nodiscard]] ParameterEnd parameterEndAfter(const modbus::LinkError& error);

} // namespace campanel::link
