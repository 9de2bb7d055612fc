// SPDX-License-Identifier: Apache-2.0
// Validates the inputs of a point cam against the table of fields, its knots one by one, and for a motion at
// all.
#include "profile/cam/point_cam_validate.h"

#include "profile/cutter/validate.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace campanel::profile {
namespace {

using detail::angleToleranceDeg;
using detail::knotRefusal;

constexpr std::array programFields{Field::MasterRate,  Field::MasterRamp, Field::MasterRatio,
                                   Field::MasterScale, Field::SlaveScale, Field::Phase,
                                   Field::CamPoints};

double nearestWithin(double value, double least, double most)
{
    return std::isfinite(value) ? std::clamp(value, least, most) : std::max(least, 0.0);
}

std::optional<Refusal> checkPlaces(std::span<const Knot> knots)
{
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const Knot& knot = knots[i];
        if (!(knot.masterDeg >= 0 && knot.masterDeg <= camCycleDeg))
            return knotRefusal(Limit::KnotRange, i, knot.masterDeg,
                               nearestWithin(knot.masterDeg, 0, camCycleDeg), "deg");
        if (!(std::abs(knot.slaveMm) <= maxSlaveMm))
            return knotRefusal(Limit::KnotRange, i, knot.slaveMm,
                               nearestWithin(knot.slaveMm, -maxSlaveMm, maxSlaveMm), "mm");
    }
    return std::nullopt;
}

std::optional<Refusal> findNoMotion(const PointCamProgram& program)
{
    const bool isFlat = std::all_of(program.knots.begin(), program.knots.end(), [&](const Knot& knot) {
        return knot.slaveMm == program.knots.front().slaveMm;
    });
    if (program.masterRateRevPerMin != 0 && program.slaveScale != 0 && !isFlat)
        return std::nullopt;
    Refusal refusal;
    refusal.limit = Limit::NoMotion;
    refusal.field =
        program.masterRateRevPerMin == 0 ? Field::MasterRate : (isFlat ? Field::Distance : Field::SlaveScale);
    refusal.unit = info(refusal.field).unit;
    return refusal;
}

} // namespace

std::optional<Refusal> checkKnots(std::span<const Knot> knots)
{
    if (knots.size() < minKnots || knots.size() > maxKnots)
        return knotRefusal(Limit::KnotCount, 0, static_cast<double>(knots.size()),
                           static_cast<double>(std::clamp(knots.size(), minKnots, maxKnots)), {});
    if (auto refusal = checkPlaces(knots))
        return refusal;
    for (std::size_t i = 1; i < knots.size(); ++i) {
        const double before = knots[i - 1].masterDeg;
        const double spacing = knots[i].masterDeg - before;
        if (spacing <= 0)
            return knotRefusal(Limit::KnotOrder, i, knots[i].masterDeg, before, "deg");
        if (spacing < minKnotSpacingDeg - angleToleranceDeg)
            return knotRefusal(Limit::KnotSpacing, i, spacing, minKnotSpacingDeg, "deg");
    }
    if (knots.front().masterDeg > angleToleranceDeg)
        return knotRefusal(Limit::KnotEnds, 0, knots.front().masterDeg, 0, "deg");
    if (knots.back().masterDeg < camCycleDeg - angleToleranceDeg)
        return knotRefusal(Limit::KnotEnds, knots.size() - 1, knots.back().masterDeg, camCycleDeg, "deg");
    return std::nullopt;
}

namespace detail {

Refusal knotRefusal(Limit limit, std::size_t index, double actual, double allowed, std::string_view unit)
{
    Refusal refusal;
    refusal.limit = limit;
    refusal.index = static_cast<int>(index);
    refusal.actual = actual;
    refusal.allowed = allowed;
    refusal.unit = unit;
    return refusal;
}

std::optional<Refusal> findInvalid(const PointCamProgram& program, const Machine& machine)
{
    if (auto refusal = findInvalidAxis(machine))
        return refusal;
    for (const Field field : programFields) {
        if (!inRange(field, value(program, field)))
            return detail::outOfRange(field, value(program, field));
    }
    if (auto refusal = checkKnots(program.knots))
        return refusal;
    return findNoMotion(program);
}

} // namespace detail
} // namespace campanel::profile
