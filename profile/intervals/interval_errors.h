// SPDX-License-Identifier: Apache-2.0
// The error of the accumulators' motion against the motion that the rows were compiled from.
#pragma once

#include "profile/intervals/interval_row.h"
#include "profile/model/motion_profile.h"

#include <span>

namespace campanel::profile {

// The error of the accumulators' motion against the compiled motion. In Published mode the reference is the
// motion at the generator's pace, k times slower, as accepted in the paper. The comparison continues before
// and after the motion. A motion that ends moving keeps its speed, and so do its rows; one that ends at rest
// stays at rest. Neither figure is below the true maximum. Each is at most a thousandth above it, the speed
// also by one register step.
struct IntervalErrors {
    double speedMmPerS = 0; // maximum
    double speedTimeS = 0;
    double positionPulses = 0; // maximum, also between the pulses
    double positionTimeS = 0;
};

namespace detail {

[[nodiscard]] IntervalErrors intervalErrors(std::span<const IntervalRow> rows, int fractionBits,
                                            double iterationS, const MotionProfile& motion,
                                            double pulsesPerMm);

} // namespace detail

} // namespace campanel::profile
