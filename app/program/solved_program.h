// SPDX-License-Identifier: Apache-2.0
// A recipe solved, whatever its kind: the motion of one cycle and what it demands of the machine.
#pragma once

#include "app/program/recipe.h"

#include "profile/cutter/limits.h"
#include "profile/cutter/sampling.h"
#include "profile/model/axis_motion.h"

#include <optional>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::program {

struct SolvedProgram {
    std::optional<profile::RotaryCutter> cutter; // of a rotary cutter
    profile::Machine machine;
    profile::MotionProfile motion;        // of one cycle; of a press: a nominal stroke
    profile::AxisPeaks peaks;             // of a cutter without the torque, which is NaN
    std::vector<profile::Refusal> broken; // limits of the machine; empty when it can do it
    std::vector<double> marksS;           // worth a line on the plot: ends of stretches, knots, stages
    double pulsesPerMm = 0;

    [[nodiscard]] double cycleS() const { return motion.durationS(); }
};

// Refuses what cannot be a motion at all.
[[nodiscard]] tl::expected<SolvedProgram, profile::Refusal> solveProgram(const Recipe& recipe);

[[nodiscard]] profile::Curves sampleCurves(const SolvedProgram& solved, std::size_t points);

} // namespace campanel::program
