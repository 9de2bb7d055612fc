// SPDX-License-Identifier: Apache-2.0
// One move by many laws: peaks side by side, and curves to draw over each other.
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
    tl::expected<AxisMotion, Refusal> result; // of the same move by this law
};

// The laws that such a move can use, in the order of laws(), with their default parameters; the program's own
// law with the program's.
[[nodiscard]] std::vector<LawChoice> suitableLaws(const PositionMoveProgram& program);
[[nodiscard]] std::vector<LawChoice> suitableLaws(const SpeedMoveProgram& program);

// The same move by each of these laws, all other inputs kept. One that is not suitable is refused in its
// result.
[[nodiscard]] std::vector<LawComparison>
compareLaws(const PositionMoveProgram& program, const Machine& machine, std::span<const LawChoice> choices);
[[nodiscard]] std::vector<LawComparison> compareLaws(const SpeedMoveProgram& program, const Machine& machine,
                                                     std::span<const LawChoice> choices);

// Curves of a move on this machine's axis: sampleCurves() with the axis' pulses per mm.
[[nodiscard]] Curves sampleAxisCurves(const AxisMotion& motion, const Machine& machine, std::size_t points);

} // namespace campanel::profile
