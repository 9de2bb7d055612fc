// SPDX-License-Identifier: Apache-2.0
// Compares what a solved program demands of the machine with what the machine allows.
#pragma once

#include "profile/cutter/rotary_cutter.h"
#include "profile/model/limit_check.h"

#include <limits>
#include <optional>
#include <vector>

namespace campanel::profile {

// Returns the largest magnitudes within a cycle, by formula. The torque is NaN while the inertia is unknown.
[[nodiscard]] Peaks peaks(const CycleNumbers& cycle, const RotaryCutterProgram& program,
                          const Machine& machine);
[[nodiscard]] Peaks peaks(const RotaryCutter& cutter);

// Returns the mean of the squared acceleration over a cycle, mm^2/s^4: (v_b - v_a)^2 I2 (1 / AB + 1 / CD) /
// T, with I2 the integral of the law's g'^2.
[[nodiscard]] double squareAcceleration(const CycleNumbers& cycle, const RotaryCutterProgram& program);

// Returns the peak-to-peak vibration in mm of the knife while it seals, by the mode of its shaft; NaN while
// that is unknown.
[[nodiscard]] double sealErrorMm(const RotaryCutter& cutter);

// Returns every exceeded limit with its peak, the place of the peak, the time spans and the nearest feasible
// inputs. Empty when the machine can execute the program.
[[nodiscard]] std::vector<Refusal> checkLimits(const RotaryCutter& cutter);

// Returns true when the program can be solved and exceeds no limit. Cheap: a few hundred nanoseconds.
[[nodiscard]] bool isFeasible(const RotaryCutterProgram& program, const Machine& machine);

// The limits of the knife's motion itself, whichever part of the machine sets them.
struct MotionLimits {
    double maxSpeedMmPerS = 0;
    double maxAccelerationMmPerS2 = 0; // while it speeds up: friction takes a part of the torque
    double maxSlowingMmPerS2 = 0;      // while it slows down: friction adds to the torque
    double maxRmsAccelerationMmPerS2 = std::numeric_limits<double>::infinity(); // of a knife that never rests
};

[[nodiscard]] MotionLimits motionLimits(const Machine& machine);

// The maximum rate (on the grid of the rate field) for this bag length, ratios and law, and the limit that
// sets it. Ratios that were not set by hand follow the rate. MachineRate also stands for the limit of the
// rate field's own range.
struct FastestRate {
    double rateBagsPerMin = 0;
    Limit limitedBy = Limit::MachineRate;
};

// Returns nothing when no rate is feasible, e.g. when the range of a speed field excludes every rate.
[[nodiscard]] std::optional<FastestRate> fastestRate(const RotaryCutter& cutter);
// Returns the same for solved numbers of the program, without its curves.
[[nodiscard]] std::optional<FastestRate>
fastestRate(const CycleNumbers& cycle, const RotaryCutterProgram& program, const Machine& machine);

} // namespace campanel::profile
