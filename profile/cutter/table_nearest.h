// SPDX-License-Identifier: Apache-2.0
// What to change when a table does not fit the controller. Internal to profile/.
#pragma once

#include "profile/cutter/step_table.h"

#include <vector>

namespace campanel::profile::detail {

// The table without suggestions in its refusal.
[[nodiscard]] tl::expected<StepTable, Refusal> buildTable(const RotaryCutter& cutter);

// Inputs that, alone changed, give a feasible recipe with a table that fits; the best first.
[[nodiscard]] std::vector<Suggestion> nearestForTable(const RotaryCutter& cutter, const Refusal& refusal);

} // namespace campanel::profile::detail
