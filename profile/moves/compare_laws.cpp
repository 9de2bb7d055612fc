// SPDX-License-Identifier: Apache-2.0
// Solves one move with several laws.
#include "profile/moves/compare_laws.h"

#include "profile/laws/laws.h"

namespace campanel::profile {
namespace {

std::vector<LawChoice> choicesOf(bool Law::*isSuitable, LawId own, const LawParameters& ownParameters)
{
    std::vector<LawChoice> choices;
    for (const Law& law : laws()) {
        if (law.*isSuitable)
            choices.push_back({law.id, law.id == own ? ownParameters : defaultParameters(law)});
    }
    return choices;
}

template <typename Program>
std::vector<LawComparison> solveByEach(Program program, const Machine& machine,
                                       std::span<const LawChoice> choices)
{
    std::vector<LawComparison> compared;
    compared.reserve(choices.size());
    for (const LawChoice& choice : choices) {
        program.law = choice.law;
        program.lawParameters = choice.parameters;
        compared.push_back({choice, solve(program, machine)});
    }
    return compared;
}

} // namespace

std::vector<LawChoice> suitableLaws(const PositionMoveProgram& program)
{
    return choicesOf(&Law::isDisplacementLaw, program.law, program.lawParameters);
}

std::vector<LawChoice> suitableLaws(const SpeedMoveProgram& program)
{
    return choicesOf(&Law::isSpeedLaw, program.law, program.lawParameters);
}

std::vector<LawComparison> compareLaws(const PositionMoveProgram& program, const Machine& machine,
                                       std::span<const LawChoice> choices)
{
    return solveByEach(program, machine, choices);
}

std::vector<LawComparison> compareLaws(const SpeedMoveProgram& program, const Machine& machine,
                                       std::span<const LawChoice> choices)
{
    return solveByEach(program, machine, choices);
}

Curves sampleAxisCurves(const AxisMotion& motion, const Machine& machine, std::size_t points)
{
    Curves curves = sampleCurves(motion.motion, axisPulsesPerMm(machine), points);
    addTorque(curves, axisLoad(machine));
    return curves;
}

} // namespace campanel::profile
