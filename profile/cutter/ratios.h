// SPDX-License-Identifier: Apache-2.0
// The ratios that suit the machine: for a window of v_b and a law, the length of the two ramps in closed
// form. Shares are parts of the cycle time T; the ramp tau is the same there and back.
#pragma once

#include "profile/cutter/limits.h"
#include "profile/cutter/rotary_cutter.h"

#include <limits>
#include <optional>
#include <vector>

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
    double maxAccelerationMmPerS2 = 0;
    double maxRmsAccelerationMmPerS2 = std::numeric_limits<double>::infinity(); // by the rated torque
};

// Returns the ramp with the minimum peak acceleration Cv D / (tau (S - 2 G tau) T^2): min(S/2, S/(4 G)),
// where S = 1 - sigma and D = |c L - h|; S/2 leaves minCycleShare at each end.
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

// Returns the ramp of the highest rate for this bag length.
[[nodiscard]] double fastestRamp(const RampTask& task);

// Returns the ramp of a mode other than ByHand, within possibleRamps(); fastestRamp() where there is none.
[[nodiscard]] double rampFor(RatioMode mode, double positionPercent, const RampTask& task);

// Returns the program with the ratios of its mode, on the grid of their fields. The ramps suit the bag length
// and the rate that follow from the pinned values with these ratios. The window keeps its length, and its
// place unless the ramps need room beside it. Unchanged ByHand and where the inputs are not valid. A feasible
// program stays feasible.
[[nodiscard]] RotaryCutterProgram withRatios(const RotaryCutterProgram& program, const Machine& machine);

// Returns the program with the ratios for the highest rate of this bag length, at a low rate.
[[nodiscard]] RotaryCutterProgram withFastestRatios(const RotaryCutter& cutter);

// Returns the place of the shorter ramp of a solved cutter among the possible ones, in per cent: 0 the
// shortest, 50 the coolest, 100 the gentlest.
[[nodiscard]] double rampPosition(const RotaryCutter& cutter);

// Returns the program with a window of this share around its present middle, as far as base speed and ramps
// leave room, and with the ratios of its mode. By hand, the ramps keep their length where they can.
[[nodiscard]] RotaryCutterProgram withWindow(RotaryCutterProgram program, const Machine& machine,
                                             double share);

// Returns the RMS acceleration of a cycle, mm/s^2: sqrt(I2 (v_b - v_a)^2 (1/(tb - ta) + 1/(td - tc)) / T).
[[nodiscard]] double rmsAcceleration(const CycleNumbers& cycle, const RotaryCutterProgram& program);

// Returns the rate that the gentlest ratios make possible where those set by hand do not do: the present
// rate, else the highest one for this bag length if it is higher. Nothing when they do not help.
[[nodiscard]] std::optional<RampOffer> otherRamps(const RotaryCutterProgram& program, const Machine& machine);

// A law with the ratios that suit it; the cycle is empty when it has none.
struct RankedLaw {
    RotaryCutterProgram program;
    std::optional<CycleNumbers> cycle;
    Peaks peaks; // NaN without a cycle
    double rmsAccelerationMmPerS2 = 0;
    bool isFeasible = false;
};

// Returns all speed laws, each with its own best ratios: those of the program's mode, the gentlest for ratios
// set by hand. The law with the lowest peak acceleration is first, then RMS acceleration and jerk decide.
[[nodiscard]] std::vector<RankedLaw> rankLaws(const RotaryCutterProgram& program, const Machine& machine);

} // namespace campanel::profile
