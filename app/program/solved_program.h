// SPDX-License-Identifier: Apache-2.0
// A solved recipe of any kind: the motion of one cycle and its demands on the machine.
#pragma once

#include "app/program/recipe.h"

#include "profile/cam/cam_table.h"
#include "profile/cutter/limits.h"
#include "profile/cutter/sampling.h"
#include "profile/model/axis_motion.h"
#include "profile/model/torque.h"

#include <optional>
#include <tl/expected.hpp>
#include <vector>

namespace campanel::program {

struct SolvedProgram {
    std::optional<profile::RotaryCutter> cutter; // only for a rotary cutter
    profile::Machine machine;
    profile::MotionProfile motion; // one cycle; for a press a nominal stroke
    profile::Peaks peaks;
    profile::TorqueLoad load;             // unknown without an inertia, and for a press
    std::vector<profile::Refusal> broken; // exceeded limits of the machine; empty when it can execute the
                                          // motion
    std::vector<double> marksS;           // lines on the plot: ends of segments, knots, stages
    double pulsesPerMm = 0;

    [[nodiscard]] double cycleS() const { return motion.durationS(); }
};

// Solves the recipe. Refuses inputs without a possible motion.
[[nodiscard]] tl::expected<SolvedProgram, profile::Refusal> solveProgram(const Recipe& recipe);

// The motion that the cam points of a program are made of: of a cam the forward one, in either direction of
// its master.
struct CamSource {
    profile::MotionProfile motion;
    profile::CamUse use = profile::CamUse::Once;
};
[[nodiscard]] CamSource camSource(const Recipe& recipe, const SolvedProgram& solved);

// Returns the vibration of the shaft in mm: of a cutter the error while it seals and of a cam that over its
// cycle, peak to peak; of a move the amplitude after it. NaN while the natural frequency is unknown.
[[nodiscard]] double vibrationMm(const Recipe& recipe, const SolvedProgram& solved);

[[nodiscard]] profile::Curves sampleCurves(const SolvedProgram& solved, std::size_t points);

} // namespace campanel::program
