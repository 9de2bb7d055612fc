// SPDX-License-Identifier: Apache-2.0
// Edits knots; the result passes checkKnots() and is on the controller's grid.
#include "profile/cam/point_cam_edit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace campanel::profile {
namespace {

double slaveSpanMm(const PointCamProgram& program)
{
    Extent slave;
    for (const Knot& knot : program.knots)
        slave.add(knot.slaveMm);
    return slave.span();
}

} // namespace

WrapCheck wrapCheck(const PointCamProgram& program)
{
    const Spline curve = camCurve(program);
    const SplinePoint first = curve.pieces().front().at0;
    const SplinePoint last = curve.at(camCycleDeg);
    WrapCheck wrap;
    wrap.advanceMm = netAdvanceMm(program);
    wrap.speedMmPerDeg = first.slope - last.slope;
    wrap.accelerationMmPerDeg2 = first.curvature - last.curvature;
    const double tolerance = 1e-9 * slaveSpanMm(program);
    wrap.isSmooth =
        std::abs(wrap.speedMmPerDeg) <= tolerance && std::abs(wrap.accelerationMmPerDeg2) <= tolerance;
    return wrap;
}

PointCamProgram closed(PointCamProgram program)
{
    if (!program.knots.empty())
        program.knots.back().slaveMm = program.knots.front().slaveMm;
    return program;
}

PointCamProgram repaired(PointCamProgram program)
{
    program.ends = SplineEnds::Periodic;
    const bool isClosed = program.knots.size() >= minKnots && netAdvanceMm(program) == 0;
    return isClosed ? closed(std::move(program)) : program;
}

std::optional<std::size_t> insertKnot(PointCamProgram& program, double masterDeg)
{
    std::vector<Knot>& knots = program.knots;
    if (knots.size() >= maxKnots || !std::isfinite(masterDeg))
        return std::nullopt;
    const auto next = std::upper_bound(knots.begin() + 1, knots.end() - 1, masterDeg,
                                       [](double deg, const Knot& knot) { return deg < knot.masterDeg; });
    const auto place = detail::masterBetween((next - 1)->masterDeg, next->masterDeg, masterDeg);
    if (!place)
        return std::nullopt;
    const Knot knot{*place, detail::slaveOnGrid(camCurve(program).at(*place).value)};
    const auto inserted = knots.insert(next, knot);
    return static_cast<std::size_t>(inserted - knots.begin());
}

bool removeKnot(PointCamProgram& program, std::size_t index)
{
    std::vector<Knot>& knots = program.knots;
    if (knots.size() <= minKnots || index == 0 || index + 1 >= knots.size())
        return false;
    knots.erase(knots.begin() + static_cast<std::ptrdiff_t>(index));
    return true;
}

Knot moveKnot(PointCamProgram& program, std::size_t index, const Knot& wanted)
{
    std::vector<Knot>& knots = program.knots;
    Knot& knot = knots[index];
    const bool isClosed =
        program.ends == SplineEnds::Periodic && knots.front().slaveMm == knots.back().slaveMm;
    const bool isEnd = index == 0 || index + 1 == knots.size();
    if (std::isfinite(wanted.slaveMm))
        knot.slaveMm = detail::slaveOnGrid(wanted.slaveMm);
    if (isEnd && isClosed) {
        knots.front().slaveMm = knot.slaveMm;
        knots.back().slaveMm = knot.slaveMm;
    }
    if (!isEnd && std::isfinite(wanted.masterDeg))
        knot.masterDeg =
            detail::masterBetween(knots[index - 1].masterDeg, knots[index + 1].masterDeg, wanted.masterDeg)
                .value_or(knot.masterDeg);
    return knot;
}

} // namespace campanel::profile
