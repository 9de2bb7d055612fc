// SPDX-License-Identifier: Apache-2.0
// What a motion demands of an axis other than the knife's, compared with what the axis allows. Moves, point
// cams and the press share it.
#pragma once

#include "profile/model/machine.h"
#include "profile/model/motion_profile.h"
#include "profile/model/refusal.h"

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
    double jerkMmPerS3 = 0; // infinite where the acceleration has a step, at the ends too
};

// A solved program that is not a rotary cutter: one cycle of it, what it demands, and which limits it breaks.
struct AxisMotion {
    MotionProfile motion;
    AxisPeaks peaks;
    std::vector<Refusal> broken; // limits of the machine; empty when the axis can do it
    std::vector<double> marksS;  // joints worth a line on the plot: stages, knots
};

// The largest speed and acceleration that break no limit of the machine: speed by motor speed and pulse
// frequency, acceleration by its own limit and by the torque that is left beside friction. Negative
// acceleration when friction alone takes more torque than there is.
struct AxisAllowance {
    double speedMmPerS = 0;
    double accelerationMmPerS2 = 0;
};

[[nodiscard]] AxisAllowance axisAllowance(const Machine& machine);

// By the closed forms of each stretch of the motion. A motion that ends as it begins (speed and acceleration)
// may repeat; any other has no acceleration before and after, so that one at its ends is a step.
[[nodiscard]] AxisPeaks axisPeaks(const MotionProfile& motion, const Machine& machine);

// Every broken limit (motor speed, acceleration, torque, pulse frequency) with its peak, its place and the
// time spans where it is broken; without suggestions, which each kind adds.
[[nodiscard]] std::vector<Refusal> checkAxis(const MotionProfile& motion, const AxisPeaks& peaks,
                                             const Machine& machine);

// True when checkAxis would find nothing. Cheap.
[[nodiscard]] bool isWithinLimits(const AxisPeaks& peaks, const Machine& machine);

} // namespace campanel::profile
