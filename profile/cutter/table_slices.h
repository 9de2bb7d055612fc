// SPDX-License-Identifier: Apache-2.0
// A cycle cut into slices of whole ticks and whole pulses. Internal to profile/.
#pragma once

#include "profile/cutter/table_error.h"

#include <optional>
#include <vector>

namespace campanel::profile::detail {

struct SlicedCycle {
    std::vector<TableSlice> slices;
    std::size_t carrySlice = 0; // may have become empty and be missing; then slices.size()
};

// Nothing when the pulses of the cycle do not fit the timer.
[[nodiscard]] std::optional<SlicedCycle> cutSlices(const RotaryCutter& cutter, std::int64_t cycleTicks);

} // namespace campanel::profile::detail
