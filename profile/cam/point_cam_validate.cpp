// SPDX-License-Identifier: Apache-2.0
// Validates the inputs of a point cam against the table of fields, its knots one by one, and for a motion at
// all.
#include "profile/cam/point_cam_validate.h"

#include "profile/model/bounds.h"

#include <algorithm>
#include <cmath>

namespace campanel::profile {
namespace {

using detail::angleToleranceDeg;
using detail::indexedRefusal;

double nearestWithin(double value, double min, double max)
{
    return std::isfinite(value) ? clamped(value, min, max) : maxOf(min, 0.0);
}

std::optional<Refusal> checkPlaces(std::span<const Knot> knots)
{
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const Knot& knot = knots[i];
        if (!(knot.masterDeg >= 0 && knot.masterDeg <= camCycleDeg))
            return indexedRefusal(Limit::KnotRange, i, knot.masterDeg,
                                  nearestWithin(knot.masterDeg, 0, camCycleDeg), "deg");
        if (!(std::abs(knot.slaveMm) <= maxSlaveMm))
            return indexedRefusal(Limit::KnotRange, i, knot.slaveMm,
                                  nearestWithin(knot.slaveMm, -maxSlaveMm, maxSlaveMm), "mm");
    }
    return std::nullopt;
}

} // namespace

std::optional<Refusal> checkKnots(std::span<const Knot> knots)
{
    if (knots.size() < minKnots || knots.size() > maxKnots)
        return indexedRefusal(Limit::KnotCount, 0, static_cast<double>(knots.size()),
                              static_cast<double>(clamped(knots.size(), minKnots, maxKnots)), {});
    if (auto refusal = checkPlaces(knots))
        return refusal;
    for (std::size_t i = 1; i < knots.size(); ++i) {
        const double before = knots[i - 1].masterDeg;
        const double spacing = knots[i].masterDeg - before;
        if (spacing <= 0)
            return indexedRefusal(Limit::KnotOrder, i, knots[i].masterDeg, before, "deg");
        if (spacing < minMasterSpacingDeg - angleToleranceDeg)
            return indexedRefusal(Limit::KnotSpacing, i, spacing, minMasterSpacingDeg, "deg");
    }
    if (knots.front().masterDeg > angleToleranceDeg)
        return indexedRefusal(Limit::KnotEnds, 0, knots.front().masterDeg, 0, "deg");
    if (knots.back().masterDeg < camCycleDeg - angleToleranceDeg)
        return indexedRefusal(Limit::KnotEnds, knots.size() - 1, knots.back().masterDeg, camCycleDeg, "deg");
    return std::nullopt;
}

std::optional<Refusal> detail::findInvalid(const PointCamProgram& program, const Machine& machine)
{
    if (auto refusal = findInvalidMaster(program, machine))
        return refusal;
    if (auto refusal = checkKnots(program.knots))
        return refusal;
    return findNoMotion(program, std::ranges::all_of(program.knots, [&](const Knot& knot) {
                            return knot.slaveMm == program.knots.front().slaveMm;
                        }));
}

} // namespace campanel::profile
