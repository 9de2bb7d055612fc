// SPDX-License-Identifier: Apache-2.0
// The checks of limits.h for searches that try many cycles of one law on one machine. What does not depend on
// the cycle is computed once, and inputs are not validated again. Internal to profile/.
#pragma once

#include "profile/cutter/cycle_shape.h"
#include "profile/cutter/limits.h"
#include "profile/model/torque.h"

#include <optional>

namespace campanel::profile::detail {

// The figures of a law, a film and a machine, which must be valid. The machine must outlive them.
struct CutterFigures {
    CutterFigures(const RotaryCutterProgram& program, const Machine& machineOfKnife);

    const Machine& machine;
    double minSealTimeMs = 0;
    LawAndStroke shape;
    double lawSquare = 0; // I2; 0 while no torque is known
    bool accelerationSteps = false;
    double rpmPerMmPerS = 0;
    double pulsesPerMm = 0;
    double maxPulseFrequencyHz = 0;
    TorqueLoad load;
};

[[nodiscard]] MotionLimits motionLimits(const CutterFigures& figures);
[[nodiscard]] Peaks peaks(const CycleNumbers& cycle, const CutterFigures& figures);
[[nodiscard]] std::optional<Limit> firstBroken(const CycleNumbers& cycle, const CutterFigures& figures);

// Returns true when the program, whose inputs are valid, can be solved and exceeds no limit.
[[nodiscard]] bool isFeasible(const RotaryCutterProgram& program, const CutterFigures& figures);

// Returns the fastest rate of a solved program with its own ratios, whatever their mode.
[[nodiscard]] std::optional<FastestRate>
fastestByHand(const CycleNumbers& cycle, const RotaryCutterProgram& program, const CutterFigures& figures);

// Returns the program with the ratios for the highest rate of this bag length, in mm, at a low rate. The
// window must be valid.
[[nodiscard]] RotaryCutterProgram withFastestRatios(RotaryCutterProgram program, double bagLengthMm,
                                                    const CutterFigures& figures);

} // namespace campanel::profile::detail
