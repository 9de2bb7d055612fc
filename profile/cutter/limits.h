// SPDX-License-Identifier: Apache-2.0
// What a solved program demands of the machine, compared with what the machine allows.
#pragma once

#include "profile/cutter/rotary_cutter.h"

#include <optional>
#include <vector>

namespace campanel::profile {

// Largest magnitudes within a cycle, by formula, and when they are reached.
struct Peaks {
    double speedMmPerS = 0;
    double speedTimeS = 0;
    double motorRpm = 0;
    double pulseFrequencyHz = 0;
    double accelerationMmPerS2 = 0;
    double accelerationTimeS = 0;
    double jerkMmPerS3 = 0; // infinite where the law's acceleration has a step
};

[[nodiscard]] Peaks peaks(const CycleNumbers& cycle, const RotaryCutterProgram& program,
                          const Machine& machine);
[[nodiscard]] Peaks peaks(const RotaryCutter& cutter);

// Every broken limit with its peak, its place, the time spans where it is broken and the nearest feasible
// inputs; empty when the machine can do it.
[[nodiscard]] std::vector<Refusal> checkLimits(const RotaryCutter& cutter);

// True when the program can be solved and breaks no limit. Cheap: a few hundred nanoseconds.
[[nodiscard]] bool isFeasible(const RotaryCutterProgram& program, const Machine& machine);

// The largest rate (on the grid of the rate field) for this bag length, ratios and law, and the limit that
// sets it. MachineRate also stands for the end of the rate field's own range.
struct FastestRate {
    double rateBagsPerMin = 0;
    Limit limitedBy = Limit::MachineRate;
};

// Nothing when no rate at all is feasible, e.g. when a speed's own range forbids every one.
[[nodiscard]] std::optional<FastestRate> fastestRate(const RotaryCutter& cutter);

} // namespace campanel::profile
