// SPDX-License-Identifier: Apache-2.0
// The ratios that suit the machine: the closed forms of ramps.h on the grid of k1 to k4.
#pragma once

#include "profile/cutter/limits.h"
#include "profile/cutter/ramps.h"

#include <optional>
#include <vector>

namespace campanel::profile {

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
