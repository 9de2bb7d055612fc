// SPDX-License-Identifier: Apache-2.0
// Rows with whole pulses beside given straight lines.
#pragma once

#include "profile/intervals/interval_row.h"
#include "profile/intervals/link_path.h"
#include "profile/intervals/speed_curve.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace campanel::profile::detail {

struct RowRules {
    double iterationS = realIterationS; // as which the rows' registers are computed
    int fractionBits = 0;
    double minHz = 0; // a unit of the rows' speeds, as none may be zero
    double maxHz = 0;
};

// Returns how many rows go along the lines: one for each, but a horizontal line belongs to the row before it.
[[nodiscard]] std::size_t rowsOf(const std::vector<PathPoint>& lines);

// Rows follow each other without a jump of speed, each goes over whole pulses and reaches its last speed,
// together they go over the pulses of the curve, in its time as nearly as whole pulses allow. They keep to
// the tolerance wherever the curve has been compared. A curve that begins or ends moving does so with exactly
// its speed, to one unit of the register; from and to rest the rows' speed is free within the tolerance.
[[nodiscard]] std::optional<std::vector<IntervalRow>> rowsAlong(const std::vector<PathPoint>& lines,
                                                                const SpeedCurve& curve,
                                                                const RowRules& rules, double toleranceHz);

} // namespace campanel::profile::detail
