// SPDX-License-Identifier: Apache-2.0
// Finds the nearest feasible value of an input. Internal to profile/.
#pragma once

#include "profile/cutter/rotary_cutter.h"

#include <vector>

namespace campanel::profile::detail {

// Returns the fields that alone correct a refused or limit-exceeding program, the smallest relative change
// first.
[[nodiscard]] std::vector<Suggestion> nearestFeasible(const RotaryCutterProgram& program,
                                                      const Machine& machine, const Refusal& refusal);

} // namespace campanel::profile::detail
