// SPDX-License-Identifier: Apache-2.0
// The table of the soak test.
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

// Prints everything; returns true when the panel's client made no error.
[[nodiscard]] bool report(const Results& results);

} // namespace campanel::soak
