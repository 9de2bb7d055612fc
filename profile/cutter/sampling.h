// SPDX-License-Identifier: Apache-2.0
// Curves of one cycle for plotting, one array per quantity.
#pragma once

#include "profile/cutter/rotary_cutter.h"

#include <cstddef>
#include <vector>

namespace campanel::profile {

// All arrays have the same length. At a joint of two segments there are two points with the same time (the
// value before and after), so that steps of acceleration and jerk are drawn upright and corners are not
// rounded.
struct Curves {
    std::vector<double> timeS;
    std::vector<double> positionMm;
    std::vector<double> velocityMmPerS;
    std::vector<double> accelerationMmPerS2;
    std::vector<double> jerkMmPerS3;
    std::vector<double> frequencyHz;
};

// `points` evenly spaced points from 0 to T (at least 2), and the joints in addition. A negative frequency
// stands for backwards.
[[nodiscard]] Curves sampleCurves(const MotionProfile& motion, double pulsesPerMm, std::size_t points);
[[nodiscard]] Curves sampleCurves(const RotaryCutter& cutter, std::size_t points);

} // namespace campanel::profile
