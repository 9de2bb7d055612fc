// SPDX-License-Identifier: Apache-2.0
// The soak's table.
#pragma once

#include "tests/soak/fault_classes.h"
#include "tests/soak/tally.h"

#include <array>

namespace campanel::soak {

struct ClassResult {
    Tally panel;
    std::array<Tally, 2> plain; // recovery NONE, PROTOCOL
};
using Results = std::array<ClassResult, faultClasses.size()>;

// Prints everything; true when the panel's client did nothing wrong.
[[nodiscard]] bool report(const Results& results);

} // namespace campanel::soak
