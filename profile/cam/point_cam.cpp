// SPDX-License-Identifier: Apache-2.0
// Checks a point cam, and computes its cycle in time and the master rate that the axis can follow.
#include "profile/cam/point_cam.h"

#include "profile/cam/point_cam_validate.h"
#include "profile/model/limit_check.h"
#include "profile/model/torque.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace campanel::profile {
namespace {

constexpr double secondsPerMinute = 60;
constexpr double overshootShare = 0.1; // share of the knots' span
constexpr double jumpTolerance = 1e-9; // share of the maximum speed: the rounding of a continuous speed

double phaseWithinCycleDeg(const PointCamProgram& program)
{
    const double phase = std::fmod(program.phaseDeg, camCycleDeg);
    return phase < 0 ? phase + camCycleDeg : phase;
}

// Adds a part of a piece as a segment in time, forward or backward.
void addPart(MotionProfile& motion, const SplinePiece& piece, double fromDeg, double toDeg, double degPerS,
             double scale)
{
    const double widthDeg = std::abs(toDeg - fromDeg);
    if (widthDeg <= detail::angleToleranceDeg)
        return;
    const SplinePoint start = piece.at(fromDeg);
    motion.addCubic(widthDeg / std::abs(degPerS), scale * start.slope * degPerS,
                    scale * start.curvature * degPerS * degPerS,
                    scale * start.third * degPerS * degPerS * degPerS);
}

// Returns one cycle of the curve from the phase on. degPerS, of the cam, is negative for backward motion.
MotionProfile camCycleMotion(const PointCamProgram& program, double degPerS)
{
    const Spline curve = camCurve(program);
    const auto pieces = curve.pieces();
    const double phase = phaseWithinCycleDeg(program);
    MotionProfile motion;
    motion.setStartPosition(program.slaveScale * curve.at(phase).value);
    // Two passes over the pieces: the part after the phase in the first, the part before it in the second.
    const auto add = [&](const SplinePiece& piece, double low, double high) {
        const double from = std::max(piece.start, low);
        const double to = std::min(piece.end(), high);
        if (to > from)
            addPart(motion, piece, degPerS > 0 ? from : to, degPerS > 0 ? to : from, degPerS,
                    program.slaveScale);
    };
    if (degPerS > 0) {
        for (const SplinePiece& piece : pieces)
            add(piece, phase, camCycleDeg);
        for (const SplinePiece& piece : pieces)
            add(piece, 0, phase);
    } else {
        for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece)
            add(*piece, 0, phase);
        for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece)
            add(*piece, phase, camCycleDeg);
    }
    return motion;
}

double camDegPerS(const PointCamProgram& program)
{
    return std::copysign(camCycleDeg / camCycleS(program), program.masterRateRevPerMin);
}

double timeOfAngleS(const PointCamProgram& program, double angleDeg)
{
    const double turned = (angleDeg - phaseWithinCycleDeg(program)) / camDegPerS(program);
    return turned < 0 ? turned + camCycleS(program) : turned;
}

double angleOfTimeDeg(const PointCamProgram& program, double timeS)
{
    const double angle = std::fmod(phaseWithinCycleDeg(program) + camDegPerS(program) * timeS, camCycleDeg);
    return angle < 0 ? angle + camCycleDeg : angle;
}

// Returns the zeros of the slope inside a piece. The second form avoids the cancellation of the first one.
std::array<std::optional<double>, 2> turningPoints(const SplinePiece& piece)
{
    const double a = piece.at0.third / 2;
    const double b = piece.at0.curvature;
    const double c = piece.at0.slope;
    const double discriminant = b * b - 4 * a * c;
    if (discriminant < 0)
        return {};
    const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    const auto inside = [&](double numerator, double denominator) -> std::optional<double> {
        const double d = numerator / denominator;
        return denominator != 0 && d > 0 && d < piece.width ? std::optional(piece.start + d) : std::nullopt;
    };
    return {inside(q, a), inside(c, q)};
}

std::optional<Refusal> findOvershoot(const PointCamProgram& program)
{
    double least = program.knots.front().slaveMm;
    double most = least;
    for (const Knot& knot : program.knots) {
        least = std::min(least, knot.slaveMm);
        most = std::max(most, knot.slaveMm);
    }
    std::optional<Refusal> worst;
    double worstExcess = overshootShare * (most - least);
    const Spline curve = camCurve(program);
    for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
        const SplinePiece& piece = curve.pieces()[i];
        for (const std::optional<double> angle : turningPoints(piece)) {
            const double reached = angle ? piece.at(*angle).value : least;
            const double excess = std::max(reached - most, least - reached);
            if (excess <= worstExcess)
                continue;
            worstExcess = excess;
            const std::size_t nearest = *angle - piece.start < piece.width / 2 ? i : i + 1;
            worst =
                detail::knotRefusal(Limit::Overshoot, nearest, reached, reached > most ? most : least, "mm");
            worst->angleDeg = angle;
            worst->timeS = timeOfAngleS(program, *angle);
        }
    }
    return worst;
}

// Returns the speed after the wrap minus the speed before it.
double wrapJumpMmPerS(const PointCamProgram& program)
{
    const Spline curve = camCurve(program);
    return (curve.pieces().front().at0.slope - curve.at(camCycleDeg).slope) * program.slaveScale *
           camDegPerS(program);
}

// Returns the largest speed step that the axis follows within one update of the master.
double allowedWrapJumpMmPerS(const Machine& machine)
{
    return std::max(axisAllowance(machine).accelerationMmPerS2, 0.0) * masterUpdateS;
}

std::optional<Refusal> findWrapJump(const PointCamProgram& program, const Machine& machine)
{
    const double jump = std::abs(wrapJumpMmPerS(program));
    const double allowed = allowedWrapJumpMmPerS(machine);
    // Without any acceleration the rest of the cycle is refused as well, and a jump may be rounding.
    if (jump <= allowed * (1 + detail::limitTolerance) || allowed <= 0)
        return std::nullopt;
    Refusal refusal;
    refusal.limit = Limit::WrapJump;
    refusal.lawParameter = "speed";
    refusal.actual = jump;
    refusal.allowed = allowed;
    refusal.unit = "mm/s";
    refusal.angleDeg = 0;
    refusal.timeS = timeOfAngleS(program, 0);
    return refusal;
}

// Refuses a cycle that repeats faster than the natural frequency of the shaft.
std::optional<Refusal> findFastCycle(const PointCamProgram& program, const Machine& machine)
{
    const double cycleHz = 1 / camCycleS(program);
    if (!(machine.naturalFrequencyHz > 0) ||
        cycleHz <= machine.naturalFrequencyHz * (1 + detail::limitTolerance))
        return std::nullopt;
    Refusal refusal;
    refusal.limit = Limit::NaturalFrequency;
    refusal.field = Field::NaturalFrequency;
    refusal.actual = cycleHz;
    refusal.allowed = machine.naturalFrequencyHz;
    refusal.unit = info(Field::NaturalFrequency).unit;
    return refusal;
}

// Includes the acceleration and the torque of the jump at the wrap in the peaks.
void addWrapPeak(Peaks& peaks, const PointCamProgram& program, const Machine& machine)
{
    const double jump = std::abs(wrapJumpMmPerS(program));
    if (jump > jumpTolerance * peaks.speedMmPerS)
        peaks.jerkMmPerS3 = std::numeric_limits<double>::infinity();
    if (jump / masterUpdateS <= peaks.accelerationMmPerS2)
        return;
    peaks.accelerationMmPerS2 = jump / masterUpdateS;
    peaks.accelerationTimeS = timeOfAngleS(program, 0);
    peaks.torqueNm = axisLoad(machine).peakNm(peaks.accelerationMmPerS2);
}

// Returns the mean of the squared acceleration that the jump at the wrap makes, mm^2/s^4.
double wrapSquare(const PointCamProgram& program)
{
    const double jump = wrapJumpMmPerS(program);
    return jump * jump / (masterUpdateS * camCycleS(program));
}

// Includes the jump at the wrap in the means; with it the speed is that of the beginning again.
TorqueMeans camMeans(const PointCamProgram& program, const MotionProfile& motion)
{
    TorqueMeans means = torqueMeans(motion);
    means.squareMm2PerS4 += wrapSquare(program);
    means.speedGainMmPerS2 = 0;
    return means;
}

// Returns the share of the rate at which the RMS torque is the rated one, 1 when it is below that already.
// The mean square grows with the fourth power of the rate; the part of the jump with its cube.
double rmsFactor(const PointCamProgram& program, const MotionProfile& motion, const Machine& machine)
{
    const TorqueMeans means = camMeans(program, motion);
    const double allowed =
        std::max(axisLoad(machine).rmsAllowance(machine.ratedTorqueNm, means.movingShare), 0.0);
    const double jump = wrapSquare(program);
    const auto isWithin = [&](double factor) {
        const double cube = factor * factor * factor;
        return std::sqrt(cube * (factor * (means.squareMm2PerS4 - jump) + jump)) <= allowed;
    };
    double within = 0;
    double beyond = 1;
    constexpr int halvings = 60;
    for (int i = 0; i < halvings && !isWithin(1); ++i) {
        const double middle = (within + beyond) / 2;
        (isWithin(middle) ? within : beyond) = middle;
    }
    return isWithin(1) ? 1 : within;
}

// Returns the feasible rate: speeds are proportional to it, accelerations to its square; the limits of both
// are known.
std::optional<Suggestion> feasibleRate(const PointCamProgram& program, const Machine& machine,
                                       const AxisMotion& solved)
{
    const Peaks& peaks = solved.peaks;
    const AxisAllowance allowance = axisAllowance(machine);
    const auto share = [](double allowed, double actual) {
        return actual > allowed ? std::max(allowed, 0.0) / actual : 1.0;
    };
    const double factor =
        std::min({share(allowance.speedMmPerS, peaks.speedMmPerS),
                  std::sqrt(share(allowance.accelerationMmPerS2, peaks.accelerationMmPerS2)),
                  share(allowedWrapJumpMmPerS(machine), std::abs(wrapJumpMmPerS(program))),
                  rmsFactor(program, solved.motion, machine),
                  share(machine.naturalFrequencyHz > 0 ? machine.naturalFrequencyHz
                                                       : std::numeric_limits<double>::max(),
                        1 / camCycleS(program))});
    const double present = program.masterRateRevPerMin;
    const double step = info(Field::MasterRate).resolution();
    const double steps = std::floor(std::abs(present) * factor / step * (1 + detail::limitTolerance));
    if (steps < 1)
        return std::nullopt;
    return Suggestion{Field::MasterRate, snapToGrid(Field::MasterRate, std::copysign(steps * step, present))};
}

AxisMotion solveValid(const PointCamProgram& program, const Machine& machine)
{
    AxisMotion solved;
    solved.motion = camCycleMotion(program, camDegPerS(program));
    solved.peaks = axisPeaks(solved.motion, machine);
    if (const TorqueLoad load = axisLoad(machine); load.isKnown())
        solved.peaks.rmsTorqueNm = load.rmsNm(camMeans(program, solved.motion));
    solved.broken = checkAxis(solved.motion, solved.peaks, machine);
    for (Refusal& refusal : solved.broken) {
        if (refusal.timeS)
            refusal.angleDeg = angleOfTimeDeg(program, *refusal.timeS);
    }
    if (auto jump = findWrapJump(program, machine))
        solved.broken.push_back(*std::move(jump));
    if (auto fast = findFastCycle(program, machine))
        solved.broken.push_back(*std::move(fast));
    if (auto overshoot = findOvershoot(program)) {
        solved.broken.push_back(*std::move(overshoot)); // no rate corrects the curve
    } else if (!solved.broken.empty()) {
        if (const auto rate = feasibleRate(program, machine, solved)) {
            for (Refusal& refusal : solved.broken)
                refusal.nearest.push_back(*rate);
        }
    }
    addWrapPeak(solved.peaks, program, machine);
    for (const Knot& knot : program.knots)
        solved.marksS.push_back(timeOfAngleS(program, knot.masterDeg));
    std::sort(solved.marksS.begin(), solved.marksS.end());
    return solved;
}

} // namespace

Spline camCurve(const PointCamProgram& program)
{
    std::array<double, maxKnots> masterDeg{};
    std::array<double, maxKnots> slaveMm{};
    const std::size_t count = std::min(program.knots.size(), maxKnots);
    for (std::size_t i = 0; i < count; ++i) {
        masterDeg[i] = program.knots[i].masterDeg;
        slaveMm[i] = program.knots[i].slaveMm;
    }
    return {std::span(masterDeg).first(count), std::span(slaveMm).first(count), program.ends};
}

double netAdvanceMm(const PointCamProgram& program)
{
    return program.knots.back().slaveMm - program.knots.front().slaveMm;
}

double camCycleS(const PointCamProgram& program)
{
    return secondsPerMinute / std::abs(program.masterRateRevPerMin) * program.masterRatio *
           program.masterScale;
}

MotionProfile forwardMotion(const PointCamProgram& program)
{
    return camCycleMotion(program, std::abs(camDegPerS(program)));
}

tl::expected<AxisMotion, Refusal> solve(const PointCamProgram& program, const Machine& machine)
{
    if (auto refusal = detail::findInvalid(program, machine)) {
        if (refusal->limit == Limit::FieldRange) {
            PointCamProgram mended = program;
            Machine mendedMachine = machine;
            const double inside =
                std::isfinite(refusal->actual) ? refusal->allowed : info(refusal->field).defaultValue;
            setValue(mended, refusal->field, inside);
            setValue(mendedMachine, refusal->field, inside);
            if (!detail::findInvalid(mended, mendedMachine) &&
                solveValid(mended, mendedMachine).broken.empty())
                refusal->nearest.push_back({refusal->field, inside});
        }
        return tl::unexpected(*std::move(refusal));
    }
    return solveValid(program, machine);
}

} // namespace campanel::profile
