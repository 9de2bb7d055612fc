// SPDX-License-Identifier: Apache-2.0
// Samples the curves of one cycle for plots, one array per quantity.
#pragma once

#include "profile/cutter/rotary_cutter.h"
#include "profile/model/torque.h"

#include <cstddef>
#include <vector>

namespace campanel::profile {

// The sampled curves; all arrays have the same length, but for a torque that is unknown. At a joint of two
// segments there are two points with the same time (the values before and after). Steps of acceleration and
// jerk are therefore vertical, and corners are sharp.
struct Curves {
    std::vector<double> timeS;
    std::vector<double> positionMm;
    std::vector<double> velocityMmPerS;
    std::vector<double> accelerationMmPerS2;
    std::vector<double> jerkMmPerS3;
    std::vector<double> frequencyHz;
    std::vector<double> torqueNm; // positive: accelerates forward; empty while the inertia is unknown
};

// Samples `points` evenly spaced points from 0 to T (at least 2), and the joints in addition. A negative
// frequency means backward.
[[nodiscard]] Curves sampleCurves(const MotionProfile& motion, double pulsesPerMm, std::size_t points);
[[nodiscard]] Curves sampleCurves(const RotaryCutter& cutter, std::size_t points);
// Computes the torque of sampled curves.
void addTorque(Curves& curves, const TorqueLoad& load);

} // namespace campanel::profile
