// SPDX-License-Identifier: Apache-2.0
#include "app/panel/recipe/motor_demand.h"

#include "app/program/solved_program.h"

#include <cmath>

namespace campanel::panel {

std::optional<MotorDemand> motorDemand(const program::Recipe& recipe)
{
    const auto solved = program::solveProgram(recipe);
    if (!solved || !std::isfinite(solved->peaks.torqueNm))
        return std::nullopt;
    return MotorDemand{recipe.name, solved->peaks.torqueNm, solved->peaks.rmsTorqueNm};
}

std::optional<MotorDemand> hardestForMotor(std::span<const program::Recipe> recipes)
{
    std::optional<MotorDemand> hardest;
    for (const program::Recipe& recipe : recipes) {
        auto demand = motorDemand(recipe);
        if (demand && (!hardest || demand->rmsNm > hardest->rmsNm))
            hardest = std::move(demand);
    }
    return hardest;
}

} // namespace campanel::panel
