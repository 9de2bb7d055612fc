// SPDX-License-Identifier: Apache-2.0
// One register by its name over the line: read with proof, or written and read back. Internal to app/link.
#pragma once

#include "app/link/link_values.h"

#include <tl/expected.hpp>

namespace campanel::link {

// The physical value that the controller holds. Errors: ValueRefused, and nothing went out, when there is no
// such numeric register, when it is not a parameter and is to be written, or when the value is outside its
// limits; else those of modbus::RtuClient. Takes one exchange to read, two to write.
[[nodiscard]] tl::expected<double, modbus::LinkError> exchangeParameter(modbus::RtuClient& client,
                                                                        const ParameterRequest& request);

[[nodiscard]] ParameterEnd parameterEndAfter(const modbus::LinkError& error);

} // namespace campanel::link
