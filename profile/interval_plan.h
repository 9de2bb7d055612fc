// SPDX-License-Identifier: Apache-2.0
// The fewest rows of constant acceleration along a speed curve.
#pragma once

#include "profile/interval_row.h"
#include "profile/speed_curve.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace campanel::profile::detail {

struct PlanRules {
    double iterationS = realIterationS; // as which the rows' registers are computed
    int fractionBits = 0;
    double toleranceHz = 0;
    double maxSpeedHz = 0;
};

struct IntervalPlan {
    std::vector<IntervalRow> rows;
    // No fewer straight lines keep within the tolerance, whatever distance they make and in whatever time.
    std::size_t fewestLinks = 0;
};

// Rows follow each other without a jump of speed, each goes over whole pulses, together over those of the
// curve and in its time, to half a pulse at a speed and to half a pulse's share of the last row at rest. They
// keep to the tolerance all the time. A curve that begins or ends moving does so with exactly its speed (to
// one unit of the register); at rest the rows have a small part of the tolerance, as no row's speed may be
// zero.
//
// First the fewest straight lines through the tolerance that also make the curve's distance; of these, lines
// whose error evens out over each bend of the curve, as far as the tolerance has room, then lines with a
// smaller error. Then rows with whole pulses beside these lines. When either does not exist, with one row
// more. Nothing when there is none with mostRows.
[[nodiscard]] std::optional<IntervalPlan> planRows(const SpeedCurve& curve, const PlanRules& rules,
                                                   std::size_t mostRows);

} // namespace campanel::profile::detail
