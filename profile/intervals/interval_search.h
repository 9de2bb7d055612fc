// SPDX-License-Identifier: Apache-2.0
// Finds rows with whole pulses beside given straight lines.
#pragma once

#include "profile/intervals/interval_row.h"
#include "profile/intervals/link_path.h"
#include "profile/intervals/speed_curve.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace campanel::profile::detail {

struct RowRules {
    double iterationS = realIterationS; // iteration time that the rows' registers are computed for
    int fractionBits = 0;
    double minHz = 0; // one unit of the rows' speeds, because no speed may be zero
    double maxHz = 0;
};

// Returns how many rows cover the lines: one for each line, but a horizontal line belongs to the row before
// it.
[[nodiscard]] std::size_t rowsOf(const std::vector<PathPoint>& lines);

// Returns an upper bound of the rows that rowsAlong() gives: each ends within a pulse of its line's end, and
// lines shorter than a pulse share a row.
[[nodiscard]] std::size_t maxRowsOf(const std::vector<PathPoint>& lines);

// Returns rows along the lines. Rows follow each other without a jump of speed. Each row covers whole pulses
// and reaches its last speed. Together they cover the pulses of the curve, in its duration as nearly as whole
// pulses allow. They keep the tolerance wherever the curve has been compared. A curve that begins or ends
// moving does so with exactly its speed, to one unit of the register. From and to rest, the speed of the rows
// is free within the tolerance.
[[nodiscard]] std::optional<std::vector<IntervalRow>> rowsAlong(const std::vector<PathPoint>& lines,
                                                                const SpeedCurve& curve,
                                                                const RowRules& rules, double toleranceHz);

} // namespace campanel::profile::detail
