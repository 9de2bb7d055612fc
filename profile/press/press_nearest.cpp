// SPDX-License-Identifier: Apache-2.0
// Finds the nearest press inputs. Each stage has its own speed, so one speed corrects a stroke when only one
// stage exceeds limits. A longer ramp of whole milliseconds can lower the speed over a short distance, so
// every value of the grid is tried.
#include "profile/model/bounds.h"
#include "profile/model/grid_search.h"
#include "profile/model/limit_check.h"
#include "profile/press/press_ramp.h"

#include <cmath>
#include <utility>

namespace campanel::profile::detail {
namespace {

bool canRun(double lengthMm, double speedMmPerS, const Machine& machine)
{
    constexpr double room = 1 + limitTolerance;
    return pressRampMs(speedMmPerS, machine) <= longestPressRampMs &&
           speedMmPerS * axisPulsesPerMm(machine) <= pulseFrequencyLimitHz(machine) * room &&
           pressRun(lengthMm, speedMmPerS, machine).speedMmPerS * axisRpmPerMmPerS(machine) <=
               machine.maxMotorRpm * room;
}

std::optional<double> nearestSpeed(const MovingStage& stage, double present, const Machine& machine)
{
    const FieldInfo& field = info(stage.speed);
    std::optional<double> best;
    const auto steps = std::llround((field.max - field.min) / field.resolution());
    for (std::int64_t i = 0; i <= steps; ++i) {
        const double speed = snapToGrid(stage.speed, field.min + static_cast<double>(i) * field.resolution());
        if ((!best || std::abs(speed - present) < std::abs(*best - present)) &&
            canRun(stage.lengthMm, speed, machine))
            best = speed;
    }
    return best;
}

// Returns the input that the refused one must exceed or stay below.
Field otherOf(Field refused)
{
    switch (refused) {
    case Field::ProbeEnd:
        return Field::ApproachPosition;
    case Field::PressPosition:
        return Field::ProbeEnd;
    case Field::MinStopForce:
        return Field::MaxStopForce;
    default:
        return Field::MaxForce;
    }
}

void appendBest(std::vector<Suggestion>& found, const GridSearch<PressProgram>& search)
{
    if (const auto best = search.best())
        found.push_back(*best);
}

} // namespace

std::array<MovingStage, 4> movingStages(const PressProgram& program)
{
    const double touchMm = (program.approachPositionMm + program.probeEndMm) / 2;
    return {{{Field::ApproachSpeed, program.approachPositionMm},
             {Field::ProbeSpeed, touchMm - program.approachPositionMm},
             {Field::PressSpeed, program.pressPositionMm - touchMm},
             {Field::ReturnSpeed, program.pressPositionMm}}};
}

std::vector<Suggestion> nearestPressInputs(const PressProgram& program, const Machine& machine,
                                           const Refusal& refusal)
{
    std::vector<Suggestion> found;
    if (refusal.limit == Limit::FieldRange) {
        if (const auto inside = nearestInRange(program, machine, refusal))
            found.push_back(*inside);
        return found;
    }
    const Field other = otherOf(refusal.field);
    GridSearch<PressProgram> own(program, machine, refusal.field);
    GridSearch<PressProgram> others(program, machine, other);
    own.tryAround(refusal.allowed);
    others.tryAround(refusal.actual);
    if (other == Field::MaxForce) // two others must stay below it
        others.tryAround(maxOf(program.probeForceN + 1, program.maxStopForceN));
    if (refusal.limit == Limit::StageOrder) { // half a pulse apart
        const double perMm = axisPulsesPerMm(machine);
        own.tryAround((std::round(value(program, other) * perMm) + 0.5) / perMm);
        others.tryAround((std::round(refusal.actual * perMm) - 0.5) / perMm);
    }
    appendBest(found, own);
    appendBest(found, others);
    return found;
}

std::vector<Suggestion> nearestPressStroke(const PressProgram& program, const Machine& machine)
{
    std::vector<Suggestion> found;
    std::vector<MovingStage> beyond;
    for (const MovingStage& stage : movingStages(program)) {
        if (!canRun(stage.lengthMm, value(program, stage.speed), machine))
            beyond.push_back(stage);
    }
    if (beyond.empty()) {
        GridSearch<PressProgram> search(program, machine, Field::PressPosition);
        search.tryAround(farthestPressPulses / axisPulsesPerMm(machine));
        appendBest(found, search);
    } else if (beyond.size() == 1) {
        PressProgram mended = program;
        const auto speed = nearestSpeed(beyond[0], value(program, beyond[0].speed), machine);
        if (speed)
            setValue(mended, beyond[0].speed, *speed);
        if (speed && isFeasible(mended, machine))
            found.push_back({beyond[0].speed, *speed});
    }
    return found;
}

} // namespace campanel::profile::detail
