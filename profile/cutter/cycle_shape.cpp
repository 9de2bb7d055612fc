// SPDX-License-Identifier: Apache-2.0
// All six pairs lead to linear equations.
#include "profile/cutter/cycle_shape.h"

#include "profile/laws/laws.h"
#include "profile/model/bounds.h"

#include <limits>
#include <optional>

namespace campanel::profile::detail {

CycleShape cycleShape(const RotaryCutterProgram& program, const Machine& machine)
{
    const Law& law = *findLaw(program.speedLaw);
    return cycleShape(program, {strokeMm(machine), law.at(1, program.speedLawParameters).integral,
                                law.peaks(program.speedLawParameters)});
}

CycleShape cycleShape(const RotaryCutterProgram& program, const LawAndStroke& given)
{
    const double rampUp = 1 / program.k[1] - 1 / program.k[0];
    const double rampBack = 1 / program.k[3] - 1 / program.k[2];
    CycleShape shape;
    shape.strokeMm = given.strokeMm;
    shape.weight = 1 / program.k[2] - 1 / program.k[1] + given.lawTravel * (rampUp + rampBack);
    shape.syncRatio = program.syncRatio;
    shape.shortestRamp = minOf(rampUp, rampBack);
    shape.lawPeaks = given.lawPeaks;
    return shape;
}

double CycleValues::of(Field field) const
{
    switch (field) {
    case Field::BagLength:
        return bagLengthMm;
    case Field::Rate:
        return 60 / cycleTimeS;
    case Field::BaseSpeed:
        return baseSpeedMmPerS;
    case Field::FilmSpeed:
        return filmSpeedMmPerS;
    default:
        return std::numeric_limits<double>::quiet_NaN();
    }
}

CycleValues closeCycle(const CycleShape& shape, FieldValue first, FieldValue second)
{
    const auto given = [&](Field field) -> std::optional<double> {
        if (first.field == field)
            return first.value;
        if (second.field == field)
            return second.value;
        return std::nullopt;
    };
    const std::optional<double> length = given(Field::BagLength);
    const std::optional<double> rate = given(Field::Rate);
    const std::optional<double> base = given(Field::BaseSpeed);
    const std::optional<double> film = given(Field::FilmSpeed);
    const double h = shape.strokeMm;
    const double w = shape.weight;
    const double c = shape.syncRatio;

    double time = 0;
    if (rate)
        time = 60 / *rate;
    else if (length && film)
        time = c * *length / *film;
    else if (length && base)
        time =
            *base > 0 ? (h - c * *length * w) / (*base * (1 - w)) : std::numeric_limits<double>::infinity();
    else if (base && film)
        time = h / (*base * (1 - w) + *film * w);

    double filmSpeed = 0;
    if (film)
        filmSpeed = *film;
    else if (length)
        filmSpeed = c * *length / time;
    else if (base)
        filmSpeed = (h / time - *base * (1 - w)) / w;

    return {length ? *length : filmSpeed * time / c, time,
            base ? *base : (h / time - filmSpeed * w) / (1 - w), filmSpeed};
}

} // namespace campanel::profile::detail
