// SPDX-License-Identifier: Apache-2.0
// What the press's curve, its table and its suggestions share. Internal to profile/.
#pragma once

#include "profile/press/press.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace campanel::profile::detail {

// What a row holds: the longest ramp, the farthest position.
inline constexpr std::int64_t longestPressRampMs = 1000;
inline constexpr double farthestPressPulses = std::numeric_limits<std::int32_t>::max() / 2;

// Milliseconds from standstill to this speed: the least whole number, at least 1, with which the acceleration
// stays within the machine's.
[[nodiscard]] std::int64_t pressRampMs(double speedMmPerS, const Machine& machine);

// From standstill to standstill with the ramps of a stage.
struct PressRun {
    double accelerationMmPerS2 = 0;
    double rampS = 0;       // of each ramp; shorter where the way is too short for the speed
    double speedMmPerS = 0; // that is reached
};
[[nodiscard]] PressRun pressRun(double lengthMm, double speedMmPerS, const Machine& machine);

// The stages that move, and their ways.
struct MovingStage {
    Field speed = Field::ApproachSpeed;
    double lengthMm = 0;
};
[[nodiscard]] std::array<MovingStage, 4> movingStages(const PressProgram& program);

// Inputs that alone mend a program that was refused.
[[nodiscard]] std::vector<Suggestion> nearestPressInputs(const PressProgram& program, const Machine& machine,
                                                         const Refusal& refusal);
// The input that alone mends a stroke that breaks limits: the speed of the one stage that does, or the press
// position.
[[nodiscard]] std::vector<Suggestion> nearestPressStroke(const PressProgram& program, const Machine& machine);

} // namespace campanel::profile::detail
