// SPDX-License-Identifier: Apache-2.0
// What a motion demands of an axis other than the knife's, compared with what the axis allows. Moves, point
// cams and the press share it.
#pragma once

#include "profile/machine.h"
#include "profile/motion_profile.h"
#include "profile/refusal.h"

#include <vector>

namespace campanel::profile {

// Largest magnitudes and when they are reached.
struct AxisPeaks {
    double speedMmPerS = 0;
    double speedTimeS = 0;
    double motorRpm = 0;
    double pulseFrequencyHz = 0;
    double accelerationMmPerS2 = 0;
    double accelerationTimeS = 0;
    double torqueNm = 0;
    double jerkMmPerS3 = 0; // infinite where the acceleration has a step
};

// A solved program that is not a rotary cutter: one cycle of it, what it demands, and which limits it breaks.
struct AxisMotion {
    MotionProfile motion;
    AxisPeaks peaks;
    std::vector<Refusal> broken; // limits of the machine; empty when the axis can do it
    std::vector<double> marksS;  // joints worth a line on the plot: stages, knots
};

// By the closed forms of each stretch of the motion.
[[nodiscard]] AxisPeaks axisPeaks(const MotionProfile& motion, const Machine& machine);

// Every broken limit (motor speed, acceleration, torque, pulse frequency) with its peak, its place and the
// time spans where it is broken; without suggestions, which each kind adds.
[[nodiscard]] std::vector<Refusal> checkAxis(const MotionProfile& motion, const AxisPeaks& peaks,
                                             const Machine& machine);

} // namespace campanel::profile
