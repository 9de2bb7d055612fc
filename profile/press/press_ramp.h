// SPDX-License-Identifier: Apache-2.0
// Shared by the press's curve, its table and its suggestions. Internal to profile/.
#pragma once

#include "profile/press/press.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace campanel::profile::detail {

// The capacity of a row: the longest ramp, the farthest position.
inline constexpr std::int64_t longestPressRampMs = 1000;
inline constexpr double farthestPressPulses = std::numeric_limits<std::int32_t>::max() / 2;

// Returns the milliseconds from standstill to this speed: the smallest whole number, at least 1, that keeps
// the acceleration within the machine's limit.
[[nodiscard]] std::int64_t pressRampMs(double speedMmPerS, const Machine& machine);

// A run from standstill to standstill with the ramps of a stage.
struct PressRun {
    double accelerationMmPerS2 = 0;
    double rampS = 0;       // each ramp; shorter where the distance is too short for the speed
    double speedMmPerS = 0; // speed that is reached
};
[[nodiscard]] PressRun pressRun(double lengthMm, double speedMmPerS, const Machine& machine);

struct MovingStage {
    Field speed = Field::ApproachSpeed;
    double lengthMm = 0;
};
[[nodiscard]] std::array<MovingStage, 4> movingStages(const PressProgram& program);

// Returns the inputs that alone correct a refused program.
[[nodiscard]] std::vector<Suggestion> nearestPressInputs(const PressProgram& program, const Machine& machine,
                                                         const Refusal& refusal);
// Returns the input that alone corrects a stroke that exceeds limits: the speed of the only stage that does,
// or the press position.
[[nodiscard]] std::vector<Suggestion> nearestPressStroke(const PressProgram& program, const Machine& machine);

} // namespace campanel::profile::detail
