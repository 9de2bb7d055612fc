// SPDX-License-Identifier: Apache-2.0
// Computes what a motion demands of an axis and compares it with what the axis allows. Used by moves, point
// cams and the press; the knife has cutter/limits.h.
#pragma once

#include "profile/model/limit_check.h"
#include "profile/model/machine.h"

#include <vector>

namespace campanel::profile {

// A solved program other than a rotary cutter: one cycle of motion, its peaks, and the limits it exceeds.
struct AxisMotion {
    MotionProfile motion;
    Peaks peaks;
    std::vector<Refusal> broken; // exceeded limits of the machine; empty when the axis can execute the motion
    std::vector<double> marksS;  // joints to mark on the plot: stages, knots
};

// The largest speed and accelerations within the limits of the machine. Motor speed and pulse frequency limit
// the speed. The acceleration limit and the torque limit the acceleration: friction takes a part of the
// torque from one that speeds up, and adds to it for one that slows down. The acceleration is negative when
// friction alone exceeds the available torque. The RMS torque limits the time of a motion instead.
struct AxisAllowance {
    double speedMmPerS = 0;
    double accelerationMmPerS2 = 0; // to speed up
    double slowingMmPerS2 = 0;      // to slow down
};

[[nodiscard]] AxisAllowance axisAllowance(const Machine& machine);

// Returns the extremes of the acceleration, without steps of speed.
[[nodiscard]] AccelerationExtremes accelerationExtremes(const MotionProfile& motion);

// Computes the peaks from the closed forms of each segment. A motion may repeat when it ends with the speed
// and acceleration it begins with. Any other motion has no acceleration before and after it: one at its ends
// counts as a step.
[[nodiscard]] Peaks axisPeaks(const MotionProfile& motion, const Machine& machine);

// Returns every exceeded limit (motor speed, acceleration, peak and RMS torque, pulse frequency) with its
// peak, the place of the peak and the time spans. Suggestions are missing; each kind of program adds its own.
[[nodiscard]] std::vector<Refusal> checkAxis(const MotionProfile& motion, const Peaks& peaks,
                                             const Machine& machine);

// Returns true when checkAxis() would find nothing. Cheap.
[[nodiscard]] bool isWithinLimits(const Peaks& peaks, const Machine& machine);

} // namespace campanel::profile
