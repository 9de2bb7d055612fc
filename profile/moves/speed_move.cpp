// SPDX-License-Identifier: Apache-2.0
// Solves a speed move. The peak acceleration is |v1 - v0| Cv / T and the travel T (v0 + (v1 - v0) w), where w
// is G(1), or 1 - G(1) mirrored. Each limit is met exactly at a root of these in one of the inputs.
#include "profile/moves/speed_move.h"

#include "profile/cutter/validate.h"
#include "profile/laws/laws.h"
#include "profile/model/bounds.h"
#include "profile/model/grid_search.h"
#include "profile/model/polynomial.h"
#include "profile/model/torque.h"
#include "profile/moves/move_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace campanel::profile {
namespace {

using detail::Polynomial;
using detail::product;
using detail::realRoots;

bool isMirrored(const SpeedMoveProgram& program)
{
    return std::abs(program.endSpeedMmPerS) < std::abs(program.startSpeedMmPerS);
}

double changeMmPerS(const SpeedMoveProgram& program)
{
    return program.endSpeedMmPerS - program.startSpeedMmPerS;
}

// Returns G(1) of the law in the table, exactly 1/2 for a symmetric one.
double lawTravel(const SpeedMoveProgram& program)
{
    const Law& law = *findLaw(program.law);
    return law.isSymmetric ? 0.5 : law.at(1, program.lawParameters).integral;
}

double lawCv(const SpeedMoveProgram& program)
{
    return findLaw(program.law)->peaks(program.lawParameters).cv;
}

// Returns true for a value that solve() uses.
bool isRead(const SpeedMoveProgram& program, Field field)
{
    switch (field) {
    case Field::StartSpeed:
    case Field::EndSpeed:
    case Field::CamPoints:
        return true;
    case Field::MoveTime:
        return program.duration == MoveDuration::GivenTime;
    case Field::Distance:
        return program.duration == MoveDuration::OverDistance;
    default:
        return false;
    }
}

std::optional<Refusal> findInvalidSpeedInput(const SpeedMoveProgram& program, const Machine& machine)
{
    if (auto refusal = detail::findInvalidMachine(machine, machine_use::axis))
        return refusal;
    const auto isUsed = [&program](const Member<SpeedMoveProgram>& member) {
        return isRead(program, member.field);
    };
    if (auto refusal = detail::findOutOfRange(program, isUsed))
        return refusal;
    if (auto refusal = detail::findInvalidLaw(program.law, program.lawParameters, detail::LawUse::Speed))
        return refusal;
    if (program.startSpeedMmPerS == program.endSpeedMmPerS)
        return detail::noMotion(Field::EndSpeed, program.endSpeedMmPerS);
    return std::nullopt;
}

MotionProfile speedMotion(const SpeedMoveProgram& program, double timeS)
{
    MotionProfile motion;
    motion.addRamp(timeS, program.startSpeedMmPerS, program.endSpeedMmPerS, *findLaw(program.law),
                   program.lawParameters, isMirrored(program));
    return motion;
}

// The times between which the torque of a move suffices. Friction shortens a move that slows down: where it
// exceeds the torque, a long move cannot be made.
struct PossibleTimes {
    double firstS = 0; // infinite when no time is possible
    double lastS = std::numeric_limits<double>::infinity();
};

// Returns the times within the rated torque. With G = |v1| - |v0|:
// (M_n^2 - M_f^2) T^2 - 2 k M_f G T - k^2 (v1 - v0)^2 I2 >= 0.
PossibleTimes ratedTimes(const SpeedMoveProgram& program, const Machine& machine)
{
    const TorqueLoad load = axisLoad(machine);
    if (!load.isKnown() || !(machine.ratedTorqueNm > 0))
        return {};
    const double k = load.nmPerMmPerS2;
    const double left = machine.ratedTorqueNm * machine.ratedTorqueNm - load.frictionNm * load.frictionNm;
    const double gain = std::abs(program.endSpeedMmPerS) - std::abs(program.startSpeedMmPerS);
    const double half = k * load.frictionNm * gain;
    const double change = k * changeMmPerS(program);
    const double square = change * change * lawSpeedSquare(*findLaw(program.law), program.lawParameters);
    const double discriminant = half * half + left * square;
    if (discriminant < 0 || (left <= 0 && half >= 0))
        return {std::numeric_limits<double>::infinity(), 0};
    const double root = std::sqrt(discriminant);
    PossibleTimes times{half > 0 ? (half + root) / left : square / (root - half)};
    if (left < 0)
        times.lastS = (half - root) / left;
    return times;
}

// Returns the times within the peak torque.
PossibleTimes peakTimes(const SpeedMoveProgram& program, const Machine& machine)
{
    const TorqueLoad load = axisLoad(machine);
    if (!load.isKnown() || !(machine.maxTorqueNm > 0))
        return {};
    const AccelerationExtremes inOneS = accelerationExtremes(speedMotion(program, 1));
    PossibleTimes times{1 / load.peakShare(inOneS, machine.maxTorqueNm)};
    if (load.frictionNm > machine.maxTorqueNm)
        times.lastS = inOneS.leastMmPerS2 / -load.speedingAllowance(machine.maxTorqueNm);
    return times;
}

double shortestSpeedMoveS(const SpeedMoveProgram& program, const Machine& machine)
{
    return maxOf(std::abs(changeMmPerS(program)) * lawCv(program) / machine.maxAccelerationMmPerS2,
                 peakTimes(program, machine).firstS, ratedTimes(program, machine).firstS);
}

double longestSpeedMoveS(const SpeedMoveProgram& program, const Machine& machine)
{
    return minOf(peakTimes(program, machine).lastS, ratedTimes(program, machine).lastS);
}

Refusal distanceRefusal(Limit limit, double actualMm, double allowedMm)
{
    Refusal refusal;
    refusal.limit = limit;
    refusal.field = Field::Distance;
    refusal.actual = actualMm;
    refusal.allowed = allowedMm;
    refusal.unit = info(Field::Distance).unit;
    return refusal;
}

tl::expected<double, Refusal> timeOverDistanceS(const SpeedMoveProgram& program)
{
    constexpr double rounding = 1e-12; // share of the speeds: forward and backward travel cancel
    const double mean = meanSpeedMmPerS(program);
    const double speeds = std::abs(program.startSpeedMmPerS) + std::abs(program.endSpeedMmPerS);
    if (std::abs(mean) <= rounding * speeds)
        return tl::unexpected(detail::noMotion(Field::EndSpeed, program.endSpeedMmPerS));
    const double timeS = program.distanceMm / mean;
    if (timeS < 0)
        return tl::unexpected(distanceRefusal(Limit::DistanceSign, program.distanceMm, -program.distanceMm));
    // Stricter than inRange(), whose tolerance is for entered values.
    if (timeS > info(Field::MoveTime).max * (1 + rounding))
        return tl::unexpected(detail::outOfRange(Field::MoveTime, timeS));
    if (timeS >= info(Field::MoveTime).min * (1 - rounding))
        return timeS;
    const double step = info(Field::Distance).resolution();
    const double least = std::ceil(std::abs(mean) * info(Field::MoveTime).min / step - rounding) * step;
    return tl::unexpected(
        distanceRefusal(Limit::DistanceTooShort, program.distanceMm, std::copysign(least, mean)));
}

// Returns the time of the move, without suggestions in the refusal.
tl::expected<double, Refusal> speedMoveTimeS(const SpeedMoveProgram& program, const Machine& machine)
{
    if (auto refusal = findInvalidSpeedInput(program, machine))
        return tl::unexpected(*std::move(refusal));
    if (program.duration == MoveDuration::GivenTime)
        return program.timeS;
    if (program.duration == MoveDuration::OverDistance)
        return timeOverDistanceS(program);
    if (!std::isfinite(peakTimes(program, machine).firstS))
        return tl::unexpected(detail::noTorqueLeft(machine, Limit::MotorTorque));
    if (!std::isfinite(ratedTimes(program, machine).firstS))
        return tl::unexpected(detail::noTorqueLeft(machine, Limit::RmsTorque));
    return detail::timeOnGrid(shortestSpeedMoveS(program, machine));
}

// Appends the speed changes x with a x^2 + b x = c.
void appendRoots(std::vector<double>& changes, double a, double b, double c)
{
    const double root = std::sqrt(b * b + 4 * a * c);
    changes.push_back((-b + root) / (2 * a));
    changes.push_back((-b - root) / (2 * a));
}

// Returns the changes v1 - v0 at which a limit of the acceleration or of the time is met exactly, with the
// other speed fixed.
std::vector<double> changesAtLimits(const SpeedMoveProgram& program, const Machine& machine, Field field)
{
    const FieldInfo& time = info(Field::MoveTime);
    const AxisAllowance allowed = axisAllowance(machine);
    const std::array perTimes{allowed.accelerationMmPerS2 / lawCv(program),
                              allowed.slowingMmPerS2 / lawCv(program)};
    std::vector<double> changes;
    if (program.duration != MoveDuration::OverDistance) {
        const double timeS = program.duration == MoveDuration::GivenTime ? program.timeS : time.max;
        for (const double perTime : perTimes)
            changes.insert(changes.end(), {perTime * timeS, -perTime * timeS});
        return changes;
    }
    // The mean speed is kept + share x, with x the change; T = D / mean, and |x| = perTime T at the limit.
    const double kept = field == Field::EndSpeed ? program.startSpeedMmPerS : program.endSpeedMmPerS;
    const double g1 = lawTravel(program);
    for (const double travel : {g1, 1 - g1}) {
        const double share = field == Field::EndSpeed ? travel : travel - 1;
        for (const double perTime : perTimes) {
            appendRoots(changes, share, kept, perTime * program.distanceMm);
            appendRoots(changes, share, kept, -perTime * program.distanceMm);
        }
        for (const double timeS : {time.min, time.max})
            changes.push_back((program.distanceMm / timeS - kept) / share);
    }
    return changes;
}

std::vector<double> speedCandidates(const SpeedMoveProgram& program, const Machine& machine, Field field)
{
    const bool isEnd = field == Field::EndSpeed;
    const double kept = isEnd ? program.startSpeedMmPerS : program.endSpeedMmPerS;
    const double limit = axisAllowance(machine).speedMmPerS;
    std::vector<double> found{limit, -limit, kept, -kept, 0};
    for (const double change : changesAtLimits(program, machine, field))
        found.push_back(isEnd ? kept + change : kept - change);
    return found;
}

std::vector<double> distanceCandidates(const SpeedMoveProgram& program, const Machine& machine)
{
    const double mean = meanSpeedMmPerS(program);
    return {-program.distanceMm, mean * shortestSpeedMoveS(program, machine),
            mean * longestSpeedMoveS(program, machine), mean * info(Field::MoveTime).min,
            mean * info(Field::MoveTime).max};
}

// Returns the speeds s at which the RMS torque is the rated one, with the other speed u fixed:
// k^2 I2 (s - u)^2 m^2 + 2 k M_f D G m = (M_n^2 - M_f^2) D^2, where T = D / m, m is the mean speed, and G the
// gain of |speed|. In a given time m is 1 and D the time.
std::vector<double> speedsAtRatedTorque(const SpeedMoveProgram& program, const Machine& machine, Field field)
{
    const TorqueLoad load = axisLoad(machine);
    std::vector<double> found;
    if (!load.isKnown() || !(machine.ratedTorqueNm > 0))
        return found;
    const bool isEnd = field == Field::EndSpeed;
    const double kept = isEnd ? program.startSpeedMmPerS : program.endSpeedMmPerS;
    const bool isOverDistance = program.duration == MoveDuration::OverDistance;
    const double timeS =
        program.duration == MoveDuration::GivenTime ? program.timeS : info(Field::MoveTime).max;
    const double d = isOverDistance ? program.distanceMm : timeS;
    const double k = load.nmPerMmPerS2;
    const double left = machine.ratedTorqueNm * machine.ratedTorqueNm - load.frictionNm * load.frictionNm;
    const double square = k * k * lawSpeedSquare(*findLaw(program.law), program.lawParameters);
    const double travel = lawTravel(program);
    for (const double g : {travel, 1 - travel}) {
        const double share = isEnd ? g : 1 - g;
        const Polynomial mean = isOverDistance ? Polynomial{kept * (1 - share), share} : Polynomial{1};
        const Polynomial change{-kept, 1};
        Polynomial squares = product(product(change, change), product(mean, mean));
        for (double& c : squares)
            c *= square;
        for (const double direction : {-1.0, 1.0}) { // of the speed s
            const double friction = (isEnd ? 2 : -2) * k * load.frictionNm * d;
            const Polynomial work = product({-friction * std::abs(kept), friction * direction}, mean);
            Polynomial excess = squares;
            for (std::size_t i = 0; i < work.size(); ++i)
                excess[i] += work[i];
            excess[0] -= left * d * d;
            for (const double root : realRoots(excess, info(field).min, info(field).max))
                found.push_back(root);
        }
    }
    return found;
}

std::optional<Suggestion> nearestSpeedInput(const SpeedMoveProgram& program, const Machine& machine,
                                            Field field)
{
    detail::GridSearch search(program, machine, field);
    search.tryAround(search.present());
    search.tryAround(info(field).min);
    search.tryAround(info(field).max);
    if (field == Field::MoveTime) {
        search.tryAround(shortestSpeedMoveS(program, machine));
        search.tryAround(longestSpeedMoveS(program, machine));
    }
    if (field == Field::Distance) {
        for (const double candidate : distanceCandidates(program, machine))
            search.tryAround(candidate);
    }
    if (field == Field::StartSpeed || field == Field::EndSpeed) {
        for (const double candidate : speedCandidates(program, machine, field))
            search.tryAround(candidate);
        for (const double candidate : speedsAtRatedTorque(program, machine, field))
            search.tryAround(candidate);
    }
    search.closeIn(); // where both directions of friction limit a move, no formula gives its end
    return search.best();
}

std::vector<Suggestion> speedSuggestions(const SpeedMoveProgram& program, const Machine& machine,
                                         const Refusal& refusal)
{
    if (refusal.limit == Limit::NoMotion ||
        detail::findInvalidLaw(program.law, program.lawParameters, detail::LawUse::Speed))
        return {};
    std::vector<Suggestion> found;
    const auto keep = [&found](std::optional<Suggestion> suggestion) {
        if (suggestion)
            found.push_back(*suggestion);
    };
    if (refusal.limit == Limit::FieldRange && isRead(program, refusal.field)) {
        keep(nearestSpeedInput(program, machine, refusal.field));
        return found;
    }
    if (refusal.limit == Limit::FieldRange && refusal.field != Field::MoveTime) {
        keep(detail::nearestInRange(program, machine, refusal));
        return found;
    }
    for (const Field field : {Field::MoveTime, Field::Distance, Field::EndSpeed, Field::StartSpeed}) {
        if (isRead(program, field))
            keep(nearestSpeedInput(program, machine, field));
    }
    return found;
}

} // namespace

double meanSpeedMmPerS(const SpeedMoveProgram& program)
{
    const double travel = lawTravel(program);
    return program.startSpeedMmPerS + changeMmPerS(program) * (isMirrored(program) ? 1 - travel : travel);
}

tl::expected<AxisMotion, Refusal> solve(const SpeedMoveProgram& program, const Machine& machine)
{
    return detail::solveMove(program, machine, speedMoveTimeS, speedMotion, speedSuggestions);
}

bool isFeasible(const SpeedMoveProgram& program, const Machine& machine)
{
    const tl::expected<double, Refusal> timeS = speedMoveTimeS(program, machine);
    return timeS && isWithinLimits(axisPeaks(speedMotion(program, *timeS), machine), machine);
}

} // namespace campanel::profile
