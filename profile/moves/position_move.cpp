// SPDX-License-Identifier: Apache-2.0
// Solves a position move: v = S/T g', a = S/T^2 g'', so that each limit gives a minimum time or a maximum
// distance in closed form from Cv and Ca.
#include "profile/moves/position_move.h"

#include "profile/cutter/validate.h"
#include "profile/laws/laws.h"
#include "profile/model/bounds.h"
#include "profile/model/grid_search.h"
#include "profile/model/torque.h"
#include "profile/moves/move_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace campanel::profile {
namespace {

bool isFastest(const PositionMoveProgram& program)
{
    return program.duration == MoveDuration::Fastest;
}

std::optional<Refusal> findInvalidPositionInput(const PositionMoveProgram& program, const Machine& machine)
{
    if (auto refusal = detail::findInvalidMachine(machine, machine_use::axis))
        return refusal;
    const auto isRead = [&program](const Member<PositionMoveProgram>& member) {
        return member.field != Field::MoveTime || !isFastest(program);
    };
    if (auto refusal = detail::findOutOfRange(program, isRead))
        return refusal;
    if (auto refusal =
            detail::findInvalidLaw(program.law, program.lawParameters, detail::LawUse::Displacement))
        return refusal;
    if (program.distanceMm == 0)
        return detail::noMotion(Field::Distance, program.distanceMm);
    return std::nullopt;
}

// Returns the largest |distance| / time^2 within the rated torque: the RMS acceleration is that times the
// root of the integral of g''^2.
double ratedDistancePerSquare(const PositionMoveProgram& program, const Machine& machine)
{
    return maxOf(axisLoad(machine).rmsAllowance(machine.ratedTorqueNm), 0.0) /
           std::sqrt(lawAccelerationSquare(*findLaw(program.law), program.lawParameters));
}

double shortestPositionMoveS(const PositionMoveProgram& program, const Machine& machine)
{
    const LawPeaks law = findLaw(program.law)->peaks(program.lawParameters);
    const AxisAllowance allowed = axisAllowance(machine);
    const double distance = std::abs(program.distanceMm);
    return maxOf(distance * law.cv / allowed.speedMmPerS,
                 std::sqrt(distance * law.ca / maxOf(allowed.accelerationMmPerS2, 0.0)),
                 std::sqrt(distance / ratedDistancePerSquare(program, machine)));
}

double longestDistanceMm(const PositionMoveProgram& program, const Machine& machine, double timeS)
{
    const LawPeaks law = findLaw(program.law)->peaks(program.lawParameters);
    const AxisAllowance allowed = axisAllowance(machine);
    return minOf(allowed.speedMmPerS * timeS / law.cv, allowed.accelerationMmPerS2 * timeS * timeS / law.ca,
                 ratedDistancePerSquare(program, machine) * timeS * timeS);
}

// Returns the time of the move, without suggestions in the refusal.
tl::expected<double, Refusal> positionMoveTimeS(const PositionMoveProgram& program, const Machine& machine)
{
    if (auto refusal = findInvalidPositionInput(program, machine))
        return tl::unexpected(*std::move(refusal));
    if (!isFastest(program))
        return program.timeS;
    const TorqueLoad load = axisLoad(machine);
    if (!(load.speedingAllowance(machine.maxTorqueNm) > 0))
        return tl::unexpected(detail::noTorqueLeft(machine, Limit::MotorTorque));
    if (!(load.rmsAllowance(machine.ratedTorqueNm) > 0))
        return tl::unexpected(detail::noTorqueLeft(machine, Limit::RmsTorque));
    return detail::timeOnGrid(shortestPositionMoveS(program, machine));
}

MotionProfile positionMotion(const PositionMoveProgram& program, double timeS)
{
    MotionProfile motion;
    motion.addDisplacement(timeS, program.distanceMm, *findLaw(program.law), program.lawParameters);
    return motion;
}

std::optional<Suggestion> nearestPositionInput(const PositionMoveProgram& program, const Machine& machine,
                                               Field field)
{
    detail::GridSearch search(program, machine, field);
    search.tryAround(search.present());
    search.tryAround(info(field).min);
    search.tryAround(info(field).max);
    if (field == Field::MoveTime)
        search.tryAround(shortestPositionMoveS(program, machine));
    if (field == Field::Distance) {
        const double timeS = isFastest(program) ? info(Field::MoveTime).max : program.timeS;
        const double longest = longestDistanceMm(program, machine, timeS);
        search.tryAround(std::copysign(longest, search.present()));
        search.tryAround(std::copysign(info(field).resolution(), search.present()));
    }
    return search.best();
}

std::vector<Suggestion> positionSuggestions(const PositionMoveProgram& program, const Machine& machine,
                                            const Refusal& refusal)
{
    if (refusal.limit == Limit::NoMotion ||
        detail::findInvalidLaw(program.law, program.lawParameters, detail::LawUse::Displacement))
        return {};
    std::vector<Field> mendable{Field::Distance};
    if (refusal.limit != Limit::FieldRange && !isFastest(program))
        mendable = {Field::MoveTime, Field::Distance};
    else if (refusal.limit == Limit::FieldRange && (refusal.field != Field::MoveTime || !isFastest(program)))
        mendable = {refusal.field};
    std::vector<Suggestion> found;
    for (const Field field : mendable) {
        const auto suggestion = memberOf<PositionMoveProgram>(field)
                                    ? nearestPositionInput(program, machine, field)
                                    : detail::nearestInRange(program, machine, refusal);
        if (suggestion)
            found.push_back(*suggestion);
    }
    return found;
}

} // namespace

tl::expected<AxisMotion, Refusal> solve(const PositionMoveProgram& program, const Machine& machine)
{
    return detail::solveMove(program, machine, positionMoveTimeS, positionMotion, positionSuggestions);
}

bool isFeasible(const PositionMoveProgram& program, const Machine& machine)
{
    const tl::expected<double, Refusal> timeS = positionMoveTimeS(program, machine);
    return timeS && isWithinLimits(axisPeaks(positionMotion(program, *timeS), machine), machine);
}

std::optional<PolynomialCoefficients> polynomialCoefficients(LawId law, double distanceMm, double timeS)
{
    PolynomialCoefficients coefficients{};
    switch (law) {
    case LawId::Cubic:
        coefficients = {0, 0, 3, -2};
        break;
    case LawId::Quintic:
        coefficients = {0, 0, 0, 10, -15, 6};
        break;
    case LawId::Polynomial4567:
        coefficients = {0, 0, 0, 0, 35, -84, 70, -20};
        break;
    default:
        return std::nullopt;
    }
    constexpr double msPerS = 1000;
    double scale = distanceMm;
    for (double& coefficient : coefficients) {
        coefficient *= scale;
        scale /= timeS * msPerS;
    }
    return coefficients;
}

} // namespace campanel::profile
