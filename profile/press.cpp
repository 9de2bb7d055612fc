// SPDX-License-Identifier: Apache-2.0
// Checks of a press program and its nominal stroke, with the ramps that the controller makes.
#include "profile/press.h"

#include "profile/move_time.h"
#include "profile/press_ramp.h"
#include "profile/validate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace campanel::profile {
namespace {

constexpr Field firstInput = Field::ApproachPosition;
constexpr Field lastInput = Field::MaxStopForce;
constexpr std::array speedFields{Field::ApproachSpeed, Field::ProbeSpeed, Field::PressSpeed,
                                 Field::ReturnSpeed};

std::optional<Refusal> findWrongStage(const PressProgram& program)
{
    const auto check = [&program](Field field, Field before) -> std::optional<Refusal> {
        if (value(program, field) > value(program, before))
            return std::nullopt;
        return detail::stageOrder(field, value(program, field), value(program, before));
    };
    if (auto refusal = check(Field::ProbeEnd, Field::ApproachPosition))
        return refusal;
    return check(Field::PressPosition, Field::ProbeEnd);
}

std::optional<Refusal> findWrongForce(const PressProgram& program)
{
    const auto check = [&program](Field field, double allowed) -> std::optional<Refusal> {
        if (value(program, field) <= allowed)
            return std::nullopt;
        Refusal refusal;
        refusal.limit = Limit::ForceOrder;
        refusal.field = field;
        refusal.actual = value(program, field);
        refusal.allowed = allowed;
        refusal.unit = info(field).unit;
        if (inRange(field, allowed))
            refusal.nearest.push_back({field, allowed});
        return refusal;
    };
    if (auto refusal = check(Field::ProbeForce, program.maxForceN - info(Field::ProbeForce).resolution()))
        return refusal;
    if (auto refusal = check(Field::MaxStopForce, program.maxForceN))
        return refusal;
    return check(Field::MinStopForce, program.maxStopForceN);
}

std::optional<Refusal> findInvalidPress(const PressProgram& program, const Machine& machine)
{
    if (auto refusal = detail::findInvalidAxis(machine))
        return refusal;
    for (Field field = firstInput; field <= lastInput;
         field = static_cast<Field>(static_cast<int>(field) + 1)) {
        if (!inRange(field, value(program, field)))
            return detail::outOfRange(field, value(program, field));
    }
    if (auto refusal = findWrongStage(program))
        return refusal;
    if (auto refusal = findWrongForce(program))
        return refusal;
    if (!(axisAllowance(machine).accelerationMmPerS2 > 0))
        return detail::noTorqueLeft(machine);
    return std::nullopt;
}

// From standstill to standstill, up or down, with the ramps of a stage; short of the speed where the way is
// short.
void addMove(MotionProfile& motion, double distanceMm, double speedMmPerS, const Machine& machine)
{
    const double length = std::abs(distanceMm);
    if (length <= 0)
        return;
    const double sign = distanceMm < 0 ? -1 : 1;
    const double rampS = static_cast<double>(detail::pressRampMs(speedMmPerS, machine)) / 1000;
    const double acceleration = speedMmPerS / rampS;
    const double usedS = std::min(rampS, std::sqrt(length / acceleration));
    const double speed = acceleration * usedS;
    motion.addCubic(usedS, 0, sign * acceleration, 0);
    if (length > speed * usedS)
        motion.addConstant((length - speed * usedS) / speed, sign * speed);
    motion.addCubic(usedS, sign * speed, -sign * acceleration, 0);
}

// One speed that is too high can be lowered; of two neither alone helps.
void suggestSpeed(std::vector<Refusal>& broken, const PressProgram& program, const Machine& machine)
{
    const double allowed = axisAllowance(machine).speedMmPerS;
    std::vector<Suggestion> tooFast;
    for (const Field field : speedFields) {
        if (value(program, field) <= allowed)
            continue;
        const double step = info(field).resolution();
        tooFast.push_back({field, std::floor(allowed / step) * step});
    }
    if (tooFast.size() != 1 || !inRange(tooFast[0].field, tooFast[0].value))
        return;
    for (Refusal& refusal : broken)
        refusal.nearest = tooFast;
}

} // namespace

namespace detail {

std::int64_t pressRampMs(double speedMmPerS, const Machine& machine)
{
    constexpr double rounding = 1e-9; // of a quotient that is a whole number
    const double ms = 1000 * speedMmPerS / axisAllowance(machine).accelerationMmPerS2;
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(ms - rounding)));
}

Refusal stageOrder(Field field, double actual, double allowed)
{
    Refusal refusal;
    refusal.limit = Limit::StageOrder;
    refusal.field = field;
    refusal.actual = actual;
    refusal.allowed = allowed;
    refusal.unit = info(field).unit;
    return refusal;
}

} // namespace detail

tl::expected<PressStroke, Refusal> solveStroke(const PressProgram& program, const Machine& machine)
{
    if (auto refusal = findInvalidPress(program, machine))
        return tl::unexpected(*std::move(refusal));
    const double touchMm = (program.approachPositionMm + program.probeEndMm) / 2;
    MotionProfile motion;
    PressStroke stroke;
    double positionMm = 0;
    std::size_t stage = 0;
    const auto endStage = [&](double endMm) {
        const double fromS = stage == 0 ? 0 : stroke.stages[stage - 1].toS;
        stroke.stages[stage++] = {fromS, motion.durationS(), positionMm, endMm};
        positionMm = endMm;
    };
    addMove(motion, program.approachPositionMm, program.approachSpeedMmPerS, machine);
    motion.addConstant(pressRestS, 0);
    endStage(program.approachPositionMm);
    addMove(motion, touchMm - positionMm, program.probeSpeedMmPerS, machine);
    motion.addConstant(pressRestS, 0);
    endStage(touchMm);
    addMove(motion, program.pressPositionMm - positionMm, program.pressSpeedMmPerS, machine);
    endStage(program.pressPositionMm);
    motion.addConstant(std::max(program.holdTimeS, pressRestS), 0);
    endStage(program.pressPositionMm);
    addMove(motion, -positionMm, program.returnSpeedMmPerS, machine);
    endStage(0);

    stroke.motion = detail::checkedMotion(std::move(motion), machine);
    suggestSpeed(stroke.motion.broken, program, machine);
    for (std::size_t i = 0; i + 1 < pressStages; ++i)
        stroke.motion.marksS.push_back(stroke.stages[i].toS);
    return stroke;
}

tl::expected<AxisMotion, Refusal> solve(const PressProgram& program, const Machine& machine)
{
    return solveStroke(program, machine).map([](PressStroke&& stroke) { return std::move(stroke.motion); });
}

} // namespace campanel::profile
