// SPDX-License-Identifier: Apache-2.0
// The torque that a recipe demands of its motor, and the recipe that demands the most.
#pragma once

#include "app/program/recipe.h"

#include <optional>
#include <span>
#include <string>

namespace campanel::panel {

struct MotorDemand {
    std::string recipeName;
    double peakNm = 0;
    double rmsNm = 0;
};

// Returns nothing for a recipe without a motion, or while the inertia is unknown.
[[nodiscard]] std::optional<MotorDemand> motorDemand(const program::Recipe& recipe);

// Returns the recipe with the highest RMS torque. For one cutter at one rate that is the shortest bag.
[[nodiscard]] std::optional<MotorDemand> hardestForMotor(std::span<const program::Recipe> recipes);

} // namespace campanel::panel
