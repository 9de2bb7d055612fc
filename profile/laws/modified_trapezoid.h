// SPDX-License-Identifier: Apache-2.0
// Modified trapezoid (1/8): constant acceleration with quarter sines at its edges.
#pragma once

#include "profile/laws/half.h"

#include <cmath>
#include <numbers>

namespace campanel::profile::detail {

inline constexpr double modifiedTrapezoidCa = 8 * std::numbers::pi / (2 + std::numbers::pi);

inline LawPoint modifiedTrapezoidRise(double x)
{
    constexpr double a = modifiedTrapezoidCa;
    constexpr double w = 4 * std::numbers::pi;
    const double s = std::sin(w * x);
    const double c = std::cos(w * x);
    return {a / w * (x - s / w), a / w * (1 - c), a * s, a * w * c, a / w * (x * x / 2 + (c - 1) / (w * w))};
}

inline LawPoint modifiedTrapezoidFirstHalf(double x)
{
    constexpr double a = modifiedTrapezoidCa;
    constexpr double w = 4 * std::numbers::pi;
    if (x <= 0.125)
        return modifiedTrapezoidRise(x);
    // At x = 1/8: sin(w x) = 1, cos(w x) = 0.
    constexpr LawPoint edge{a / w * (0.125 - 1 / w), a / w, a, 0, a / w * (0.0078125 - 1 / (w * w))};
    if (x <= 0.375)
        return constantJerk(edge, a, 0, x - 0.125);
    const LawPoint fall = constantJerk(edge, a, 0, 0.25);
    const double u = x - 0.375;
    const double s = std::sin(w * u);
    const double c = std::cos(w * u);
    return {fall.g + fall.g1 * u + a * (1 - c) / (w * w), fall.g1 + a * s / w, a * c, -a * w * s,
            fall.integral + u * (fall.g + fall.g1 * u / 2) + a / (w * w) * (u - s / w)};
}

inline LawPoint modifiedTrapezoidAt(double x, const LawParameters&)
{
    return reflected(x, modifiedTrapezoidFirstHalf);
}

inline LawPeaks modifiedTrapezoidPeaks(const LawParameters&)
{
    return {2, modifiedTrapezoidCa, 4 * std::numbers::pi * modifiedTrapezoidCa, 0.5, 0.125};
}

inline LawPieces modifiedTrapezoidPieces(const LawParameters&)
{
    constexpr double w = 4 * std::numbers::pi;
    return {{0.125, 0.375, 0.625, 0.875, 1, 1}, w * modifiedTrapezoidCa, w * w * modifiedTrapezoidCa};
}

} // namespace campanel::profile::detail
