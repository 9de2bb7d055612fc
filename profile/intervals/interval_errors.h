// SPDX-License-Identifier: Apache-2.0
// How far the accumulators' own motion is from the motion that their rows were made from.
#pragma once

#include "profile/intervals/interval_row.h"
#include "profile/model/motion_profile.h"

#include <span>

namespace campanel::profile {

// Of the accumulators' own motion against the motion compiled; in Published mode against the motion at the
// generator's pace, k times slower, as the paper accepts it. Before and after the motion the comparison goes
// on: a motion that ends moving keeps its speed, and so do its rows; one that ends at rest stands.
// Neither number is below the true maximum. It is above it by a thousandth at most, the speed also by a step
// of its register.
struct IntervalErrors {
    double speedMmPerS = 0; // largest
    double speedTimeS = 0;
    double positionPulses = 0; // largest, between the pulses as well
    double positionTimeS = 0;
};

namespace detail {

[[nodiscard]] IntervalErrors intervalErrors(std::span<const IntervalRow> rows, int fractionBits,
                                            double iterationS, const MotionProfile& motion,
                                            double pulsesPerMm);

} // namespace detail

} // namespace campanel::profile
