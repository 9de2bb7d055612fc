// SPDX-License-Identifier: Apache-2.0
// Cuts a cycle into slices of whole ticks and whole pulses. Internal to profile/.
#pragma once

#include "profile/cutter/table_error.h"

#include <optional>
#include <vector>

namespace campanel::profile::detail {

struct SlicedCycle {
    std::vector<TableSlice> slices;
    std::size_t carrySlice = 0; // slices.size() when the slice became empty and was removed
};

// Returns nothing when the pulses of the cycle do not fit the timer.
[[nodiscard]] std::optional<SlicedCycle> cutSlices(const RotaryCutter& cutter, std::int64_t cycleTicks);

} // namespace campanel::profile::detail
