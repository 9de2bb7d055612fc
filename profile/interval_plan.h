// SPDX-License-Identifier: Apache-2.0
// The search for the fewest rows of constant acceleration along a speed curve.
#pragma once

#include "profile/interval_row.h"
#include "profile/speed_curve.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace campanel::profile::detail {

// A row may follow the curve from one whole pulse to a later one when
// - its speed stays within toleranceHz of the curve's at the same time, and begins with the speed the row
//   before it ended with;
// - it takes as long as the curve between these pulses, to half a pulse or misfitShare of the pulses by
//   which that speed error moves the axis meanwhile; what one row is late the next one makes good;
// - its acceleration goes on to its end, but for less than the last pulse at the last speed.
inline constexpr double mostMisfitShare = 0.25;

struct PlanRules {
    double iterationS = realIterationS; // as which the rows' registers are computed
    int fractionBits = 0;
    double toleranceHz = 0;
    double maxSpeedHz = 0;
    double misfitShare = 0; // see above; 0 or mostMisfitShare
};

// At most mostRows rows; nothing when there is no such plan. Beam search: of the plans with equally many rows
// those go on whose next row would reach farthest.
[[nodiscard]] std::optional<std::vector<IntervalRow>> planRows(const SpeedCurve& curve,
                                                               const PlanRules& rules, std::size_t mostRows);

} // namespace campanel::profile::detail
