// SPDX-License-Identifier: Apache-2.0
// The closed forms of the best ramps, for a window of v_b and a law. Shares are parts of the cycle time T;
// the ramp tau is the same there and back.
#pragma once

#include "profile/cutter/rotary_cutter.h"

#include <limits>
#include <optional>

namespace campanel::profile {

// The shortest part of a cycle: k1 is at most 1000. Base speed has this share at each end of the cycle, and
// no ramp is shorter.
inline constexpr double minCycleShare = 0.001;

// Everything that the best ramps depend on: the bag, the cycle time, the window, the law and the limits.
struct RampTask {
    double strokeMm = 0; // h
    double filmMm = 0;   // c L
    double cycleTimeS = 0;
    double window = 0;      // sigma, the share of v_b
    double lawTravel = 0.5; // G(1)
    double lawPeak = 1.5;   // Cv
    double lawSquare = 1.2; // I2, the integral of g'^2
    double maxSpeedMmPerS = 0;
    double maxAccelerationMmPerS2 = 0; // of the ramp that speeds the knife up
    double maxSlowingMmPerS2 = 0;      // of the other one; friction may allow more
    double maxRmsAccelerationMmPerS2 = std::numeric_limits<double>::infinity(); // by the rated torque
};

// Returns the ramp that fills the cycle beside the window: S/2, where S = 1 - sigma, less minCycleShare.
[[nodiscard]] double longestRamp(const RampTask& task);
// Returns the ramp with the minimum peak acceleration Cv D / (tau (S - 2 G tau) T^2): the shorter
// of the longest ramp and S/(4 G), where D = |c L - h|.
[[nodiscard]] double gentlestRamp(const RampTask& task);
// Returns the ramp with the minimum RMS acceleration: S/(6 G).
[[nodiscard]] double coolestRamp(const RampTask& task);

struct RampRange {
    double shortest = 0;
    double longest = 0;
};

// Returns the ramps that keep the limits of speed, acceleration and RMS acceleration, and v_a >= 0. The
// shortest has the minimum peak speed: the smallest root of 2 G tau^2 - S tau + Cv D / (a_max T^2) = 0,
// unless the RMS acceleration needs a longer one. Nothing when no ramp does.
[[nodiscard]] std::optional<RampRange> possibleRamps(const RampTask& task);

// Returns the ramp of the highest rate for this bag length, alike there and back.
[[nodiscard]] double fastestRamp(const RampTask& task);

// Ramps of different lengths: the one that speeds the knife up lasts mean (1 + skew), the other one
// mean (1 - skew).
struct RampPair {
    double mean = 0;
    double skew = 0;
};

// Returns the ramps of the highest rate. Where friction helps the knife to slow down, that ramp may be
// shorter: with the skew the acceleration is A (1 + skew), and I2 becomes I2 / (1 - skew^2).
[[nodiscard]] RampPair fastestRamps(const RampTask& task);

// Returns the ramp of a mode other than ByHand, within possibleRamps(); fastestRamp() where there is none.
[[nodiscard]] double rampFor(RatioMode mode, double positionPercent, const RampTask& task);

} // namespace campanel::profile
