// SPDX-License-Identifier: Apache-2.0
#include "app/panel/recipe/solution.h"

#include "app/panel/recipe/controller_program.h"
#include "profile/cutter/jaw.h"

#include <algorithm>

namespace campanel::panel {

bool Solution::isCloseToLimit() const
{
    constexpr double closeShare = 0.95;
    if (!isFeasible())
        return false;
    const profile::Machine& machine = solved->machine;
    const profile::Peaks& peaks = solved->peaks;
    const double speedShare = std::max(peaks.motorRpm / machine.maxMotorRpm,
                                       peaks.pulseFrequencyHz / profile::pulseFrequencyLimitHz(machine));
    // A press always uses the maximum acceleration in its ramps.
    if (image->recipe.kind() == profile::ProgramKind::Press)
        return speedShare > closeShare;
    // A torque or a limit that is unknown is not close.
    const auto isCloseTorque = [](double torqueNm, double limitNm) {
        return limitNm > 0 && torqueNm > closeShare * limitNm;
    };
    const double maxAcceleration =
        cutter() ? machine.maxKnifeAccelerationMmPerS2 : machine.maxAccelerationMmPerS2;
    const auto* knife = cutter();
    const double sealShare =
        knife ? knife->program.minSealTimeMs / profile::sealTimeMs(knife->cycle, machine) : 0;
    return std::max({speedShare, sealShare, peaks.accelerationMmPerS2 / maxAcceleration}) > closeShare ||
           isCloseTorque(peaks.torqueNm, machine.maxTorqueNm) ||
           isCloseTorque(peaks.rmsTorqueNm, machine.ratedTorqueNm);
}

Solution solveRecipe(const program::Recipe& recipe, const std::optional<modbus::Identity>& controller,
                     TableWork work)
{
    Solution solution;
    program::Recipe wanted = recipe;
    if (controller)
        wanted.machine = program::withController(wanted.machine, *controller);
    wanted = program::quantised(wanted);
    auto solved = program::solveProgram(wanted);
    if (!solved) {
        solution.refusals.push_back(std::move(solved.error()));
        return solution;
    }
    solution.solved = std::move(*solved);
    solution.curves =
        std::make_shared<const profile::Curves>(program::sampleCurves(*solution.solved, curvePoints));
    if (const auto* cutter = solution.cutter())
        solution.fastest = profile::fastestRate(*cutter);
    const bool isSlow = program::choice(wanted.program, program::Choice::Execution) ==
                        static_cast<std::uint16_t>(profile::Execution::Intervals);
    if (isSlow && work == TableWork::WithoutSlow && solution.solved->broken.empty()) {
        solution.isTablePending = true;
        return solution;
    }
    auto image = program::buildProgram(std::move(wanted), *solution.solved);
    if (image) {
        solution.image = std::make_shared<const program::ProgramImage>(std::move(*image));
    } else {
        solution.refusals = std::move(image.error().limits);
        solution.unstorable = image.error().unstorable;
    }
    return solution;
}

} // namespace campanel::panel
