// SPDX-License-Identifier: Apache-2.0
// One move computed with several laws: the peaks side by side, and curves for overlaid plots.
#pragma once

#include "profile/cutter/sampling.h"
#include "profile/moves/position_move.h"
#include "profile/moves/speed_move.h"

#include <span>
#include <vector>

namespace campanel::profile {

struct LawChoice {
    LawId law = LawId::Quintic;
    LawParameters parameters{};
};

struct LawComparison {
    LawChoice choice;
    tl::expected<AxisMotion, Refusal> result; // the same move with this law
};

// Returns the laws that can be used for the move, in the order of laws(). Parameters are the defaults, except
// for the program's own law.
[[nodiscard]] std::vector<LawChoice> suitableLaws(const PositionMoveProgram& program);
[[nodiscard]] std::vector<LawChoice> suitableLaws(const SpeedMoveProgram& program);

// Solves the move with each of these laws; all other inputs stay. The result of an unsuitable law is a
// refusal.
[[nodiscard]] std::vector<LawComparison>
compareLaws(const PositionMoveProgram& program, const Machine& machine, std::span<const LawChoice> choices);
[[nodiscard]] std::vector<LawComparison> compareLaws(const SpeedMoveProgram& program, const Machine& machine,
                                                     std::span<const LawChoice> choices);

// Samples the curves of a move: sampleCurves() with the pulses per mm of the machine's axis.
[[nodiscard]] Curves sampleAxisCurves(const AxisMotion& motion, const Machine& machine, std::size_t points);

} // namespace campanel::profile
