// SPDX-License-Identifier: Apache-2.0
#include "app/machine/solution.h"

#include "app/machine/controller_program.h"

#include <algorithm>

namespace campanel::machine {

bool Solution::isCloseToLimit() const
{
    constexpr double closeShare = 0.95;
    if (!isFeasible())
        return false;
    const profile::Machine& machine = cutter->machine;
    return std::max({peaks.motorRpm / machine.maxMotorRpm,
                     peaks.accelerationMmPerS2 / machine.maxKnifeAccelerationMmPerS2,
                     peaks.pulseFrequencyHz / profile::pulseFrequencyLimitHz(machine)}) > closeShare;
}

Solution solveRecipe(const program::Recipe& recipe, const std::optional<modbus::Identity>& controller)
{
    Solution solution;
    program::Recipe wanted = program::quantised(recipe);
    if (controller)
        wanted.machine = program::withController(wanted.machine, *controller);
    auto cutter = profile::solve(wanted.program, wanted.machine);
    if (!cutter) {
        solution.refusals.push_back(std::move(cutter.error()));
        return solution;
    }
    solution.cutter = std::move(*cutter);
    solution.curves =
        std::make_shared<const profile::Curves>(profile::sampleCurves(*solution.cutter, curvePoints));
    solution.peaks = profile::peaks(*solution.cutter);
    solution.fastest = profile::fastestRate(*solution.cutter);
    auto image = program::buildProgram(wanted);
    if (image) {
        solution.image = std::make_shared<const program::ProgramImage>(std::move(*image));
    } else {
        solution.refusals = std::move(image.error().limits);
        solution.unstorable = image.error().unstorable;
    }
    return solution;
}

} // namespace campanel::machine
