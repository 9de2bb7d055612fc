// SPDX-License-Identifier: Apache-2.0
// Checks a point cam, and computes its cycle in time and the master rate that the axis can follow.
#include "profile/cam/point_cam.h"

#include "profile/cam/point_cam_validate.h"
#include "profile/model/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace campanel::profile {
namespace {

constexpr double overshootShare = 0.1; // share of the knots' span

// Returns one cycle of the curve from the phase on. degPerS, of the cam, is negative for backward motion.
MotionProfile pointCamMotion(const PointCamProgram& program, double degPerS)
{
    const Spline curve = camCurve(program);
    const double scale = program.slaveScale;
    const double startMm = scale * curve.at(detail::phaseWithinCycleDeg(program)).value;
    return detail::camCycleMotion(
        program, degPerS, curve.pieces(), startMm,
        [&](MotionProfile& motion, const SplinePiece& piece, double fromDeg, double toDeg) {
            const SplinePoint start = piece.at(fromDeg);
            motion.addCubic(std::abs(toDeg - fromDeg) / std::abs(degPerS), scale * start.slope * degPerS,
                            scale * start.curvature * degPerS * degPerS,
                            scale * start.third * degPerS * degPerS * degPerS);
        });
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
    Extent slave;
    for (const Knot& knot : program.knots)
        slave.add(knot.slaveMm);
    const auto [minMm, maxMm] = slave;
    std::optional<Refusal> worst;
    double worstExcess = overshootShare * slave.span();
    const Spline curve = camCurve(program);
    for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
        const SplinePiece& piece = curve.pieces()[i];
        for (const std::optional<double> angle : turningPoints(piece)) {
            const double reached = angle ? piece.at(*angle).value : minMm;
            const double excess = maxOf(reached - maxMm, minMm - reached);
            if (excess <= worstExcess)
                continue;
            worstExcess = excess;
            const std::size_t nearest = *angle - piece.start < piece.width / 2 ? i : i + 1;
            worst = detail::indexedRefusal(Limit::Overshoot, nearest, reached,
                                           reached > maxMm ? maxMm : minMm, "mm");
            worst->angleDeg = angle;
            worst->timeS = detail::timeOfAngleS(program, *angle);
        }
    }
    return worst;
}

AxisMotion solveValid(const PointCamProgram& program, const Machine& machine)
{
    const Spline curve = camCurve(program);
    const std::array wrap{
        detail::SpeedStep{0, curve.pieces().front().at0.slope - curve.at(camCycleDeg).slope}};
    AxisMotion solved =
        detail::solveCycle(program, machine, pointCamMotion(program, detail::camDegPerS(program)), wrap,
                           {Limit::WrapJump, false}, findOvershoot(program));
    for (const Knot& knot : program.knots)
        solved.marksS.push_back(detail::timeOfAngleS(program, knot.masterDeg));
    std::sort(solved.marksS.begin(), solved.marksS.end());
    return solved;
}

} // namespace

Spline camCurve(const PointCamProgram& program)
{
    std::array<double, maxKnots> masterDeg{};
    std::array<double, maxKnots> slaveMm{};
    const std::size_t count = minOf(program.knots.size(), maxKnots);
    for (std::size_t i = 0; i < count; ++i) {
        masterDeg[i] = program.knots[i].masterDeg;
        slaveMm[i] = program.knots[i].slaveMm;
    }
    if (netAdvanceMm(program) == 0)
        slaveMm[count - 1] = slaveMm[0];
    return {std::span(masterDeg).first(count), std::span(slaveMm).first(count), program.ends};
}

double netAdvanceMm(const PointCamProgram& program)
{
    Extent slave;
    for (const Knot& knot : program.knots)
        slave.add(knot.slaveMm);
    return detail::withoutClosingError(program.knots.back().slaveMm - program.knots.front().slaveMm,
                                       slave.span());
}

double closingErrorMm(const PointCamProgram& program)
{
    return program.knots.back().slaveMm - program.knots.front().slaveMm - netAdvanceMm(program);
}

MotionProfile forwardMotion(const PointCamProgram& program)
{
    return pointCamMotion(program, std::abs(detail::camDegPerS(program)));
}

tl::expected<AxisMotion, Refusal> solve(const PointCamProgram& program, const Machine& machine)
{
    return detail::solveCam(
        program, machine,
        [](const PointCamProgram& cam, const Machine& axis) { return detail::findInvalid(cam, axis); },
        solveValid);
}

} // namespace campanel::profile
