// SPDX-License-Identifier: Apache-2.0
// Checks a press program, and computes its nominal stroke with the ramps of the controller.
#include "profile/press/press.h"

#include "profile/cutter/validate.h"
#include "profile/model/bounds.h"
#include "profile/model/limit_check.h"
#include "profile/moves/move_time.h"
#include "profile/press/press_ramp.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace campanel::profile {
namespace {

// Returns the machine without torque. The recipe of a press has no torque, inertia or friction, because the
// work piece determines the torque. The maximum acceleration limits its ramps.
Machine withoutTorque(Machine machine)
{
    machine.inertiaKgCm2 = 0;
    machine.frictionNm = 0;
    return machine;
}

// Returns a refusal when a stage does not end beyond the previous one, at another pulse.
std::optional<Refusal> findWrongStage(const PressProgram& program, const Machine& machine)
{
    const double perMm = axisPulsesPerMm(machine);
    const auto check = [&](Field field, Field before) -> std::optional<Refusal> {
        const double end = value(program, field);
        const double start = value(program, before);
        const double startPulses = std::round(start * perMm);
        if (end > start && std::round(end * perMm) > startPulses)
            return std::nullopt;
        Refusal refusal;
        refusal.limit = Limit::StageOrder;
        refusal.field = field;
        refusal.actual = end;
        refusal.allowed = end > start ? (startPulses + 0.5) / perMm : start;
        refusal.unit = info(field).unit;
        return refusal;
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
    if (auto refusal = detail::findInvalidMachine(machine, machine_use::axis))
        return refusal;
    if (auto refusal = detail::findOutOfRange(program, [](const auto&) { return true; }))
        return refusal;
    if (auto refusal = findWrongStage(program, machine))
        return refusal;
    return findWrongForce(program);
}

// Adds a move from standstill to standstill, up or down, with the ramps of a stage; below the speed where the
// distance is short.
void addMove(MotionProfile& motion, double distanceMm, double speedMmPerS, const Machine& machine)
{
    const double length = std::abs(distanceMm);
    if (length <= 0)
        return;
    const double sign = distanceMm < 0 ? -1 : 1;
    const detail::PressRun run = detail::pressRun(length, speedMmPerS, machine);
    motion.addCubic(run.rampS, 0, sign * run.accelerationMmPerS2, 0);
    if (length > run.speedMmPerS * run.rampS)
        motion.addConstant((length - run.speedMmPerS * run.rampS) / run.speedMmPerS, sign * run.speedMmPerS);
    motion.addCubic(run.rampS, sign * run.speedMmPerS, -sign * run.accelerationMmPerS2, 0);
}

// Returns the values that the rows of the table cannot hold.
std::vector<Refusal> findUnfit(const PressProgram& program, const Machine& machine)
{
    std::vector<Refusal> unfit;
    const auto add = [&unfit](Limit limit, Field field, double actual, double allowed, const char* unit) {
        Refusal refusal;
        refusal.limit = limit;
        refusal.field = field;
        refusal.actual = actual;
        refusal.allowed = allowed;
        refusal.unit = unit;
        unfit.push_back(std::move(refusal));
    };
    for (const detail::MovingStage& stage : detail::movingStages(program)) {
        const std::int64_t ms = detail::pressRampMs(value(program, stage.speed), machine);
        if (ms > detail::longestPressRampMs)
            add(Limit::RampTooLong, stage.speed, static_cast<double>(ms),
                static_cast<double>(detail::longestPressRampMs), "ms");
    }
    const double pulses = std::round(program.pressPositionMm * axisPulsesPerMm(machine));
    if (pulses > detail::farthestPressPulses)
        add(Limit::TableRange, Field::PressPosition, pulses, detail::farthestPressPulses, "");
    return unfit;
}

// Returns a row that is too fast: a short distance may not reach the speed of its row, but the controller
// refuses the row's frequency.
std::optional<Refusal> findFastRow(const PressProgram& program, const Machine& machine)
{
    double fastest = 0;
    for (const detail::MovingStage& stage : detail::movingStages(program))
        fastest = maxOf(fastest, value(program, stage.speed) * axisPulsesPerMm(machine));
    const double allowed = pulseFrequencyLimitHz(machine);
    if (fastest <= allowed * (1 + detail::limitTolerance))
        return std::nullopt;
    Refusal refusal;
    refusal.limit = Limit::PulseFrequency;
    refusal.field = Field::MaxPulseFrequency;
    refusal.actual = fastest;
    refusal.allowed = allowed;
    refusal.unit = info(refusal.field).unit;
    return refusal;
}

// Returns the stroke and its exceeded limits, without suggestions.
tl::expected<PressStroke, Refusal> strokeOf(const PressProgram& program, const Machine& machine)
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
    motion.addConstant(maxOf(program.holdTimeS, pressRestS), 0);
    endStage(program.pressPositionMm);
    addMove(motion, -positionMm, program.returnSpeedMmPerS, machine);
    endStage(0);

    stroke.motion = detail::checkedMotion(std::move(motion), withoutTorque(machine));
    std::vector<Refusal> unfit = findUnfit(program, machine);
    std::ranges::move(stroke.motion.broken, std::back_inserter(unfit));
    const bool isPulsing = std::ranges::find(unfit, Limit::PulseFrequency, &Refusal::limit) != unfit.end();
    if (auto fast = findFastRow(program, machine); fast && !isPulsing)
        unfit.push_back(*std::move(fast));
    stroke.motion.broken = std::move(unfit);
    for (std::size_t i = 0; i + 1 < pressStages; ++i)
        stroke.motion.marksS.push_back(stroke.stages[i].toS);
    return stroke;
}

} // namespace

namespace detail {

std::int64_t pressRampMs(double speedMmPerS, const Machine& machine)
{
    constexpr double rounding = 1e-9; // share of a quotient that is a whole number
    const double ms = 1000 * speedMmPerS / machine.maxAccelerationMmPerS2;
    return maxOf<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(ms - rounding)));
}

PressRun pressRun(double lengthMm, double speedMmPerS, const Machine& machine)
{
    const double rampS = static_cast<double>(pressRampMs(speedMmPerS, machine)) / 1000;
    const double acceleration = speedMmPerS / rampS;
    const double usedS = minOf(rampS, std::sqrt(lengthMm / acceleration));
    return {acceleration, usedS, acceleration * usedS};
}

} // namespace detail

tl::expected<PressStroke, Refusal> solveStroke(const PressProgram& program, const Machine& machine)
{
    auto stroke = strokeOf(program, machine);
    if (!stroke) {
        stroke.error().nearest = detail::nearestPressInputs(program, machine, stroke.error());
    } else if (!stroke->motion.broken.empty()) {
        const auto nearest = detail::nearestPressStroke(program, machine);
        for (Refusal& refusal : stroke->motion.broken)
            refusal.nearest = nearest;
    }
    return stroke;
}

bool isFeasible(const PressProgram& program, const Machine& machine)
{
    const auto stroke = strokeOf(program, machine);
    return stroke && stroke->motion.broken.empty();
}

tl::expected<AxisMotion, Refusal> solve(const PressProgram& program, const Machine& machine)
{
    return solveStroke(program, machine).map([](PressStroke&& stroke) { return std::move(stroke.motion); });
}

} // namespace campanel::profile
