// SPDX-License-Identifier: Apache-2.0
// The nearest feasible value of an input. Internal to profile/.
#pragma once

#include "profile/cutter/rotary_cutter.h"

#include <vector>

namespace campanel::profile::detail {

// For a refused or limit-breaking program: the fields that can mend it alone, the smallest relative change
// first.
[[nodiscard]] std::vector<Suggestion> nearestFeasible(const RotaryCutterProgram& program,
                                                      const Machine& machine, const Refusal& refusal);

} // namespace campanel::profile::detail
