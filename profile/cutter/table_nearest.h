// SPDX-License-Identifier: Apache-2.0
// Suggests changes when a table does not fit the controller. Internal to profile/.
#pragma once

#include "profile/cutter/step_table.h"

#include <vector>

namespace campanel::profile::detail {

// Builds the table without suggestions in its refusal.
[[nodiscard]] tl::expected<StepTable, Refusal> buildTable(const RotaryCutter& cutter);

// Returns the inputs that, changed alone, give a feasible recipe with a table that fits, the best first.
[[nodiscard]] std::vector<Suggestion> nearestForTable(const RotaryCutter& cutter, const Refusal& refusal);

} // namespace campanel::profile::detail
