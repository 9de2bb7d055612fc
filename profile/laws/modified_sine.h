// SPDX-License-Identifier: Apache-2.0
// Modified sine: a cycloid of period 1/2 at both ends, a slower sine between x = 1/8 and 7/8.
#pragma once

#include "profile/laws/half.h"

#include <cmath>
#include <numbers>

namespace campanel::profile::detail {

inline constexpr double modifiedSineScale = 4 + std::numbers::pi;

inline LawPoint modifiedSineFirstHalf(double x)
{
    using std::numbers::pi;
    // The constants are computed at compile time: a division costs as much as half a sine.
    constexpr double d = modifiedSineScale;
    constexpr double p1 = pi / d;
    constexpr double p2 = 4 * pi * pi / d;
    constexpr double p3 = 16 * pi * pi * pi / d;
    constexpr double p0 = 1 / (16 * pi * d);
    if (x <= 0.125) {
        const double s = std::sin(4 * pi * x);
        const double c = std::cos(4 * pi * x);
        return {p1 * x - 0.25 / d * s, p1 * (1 - c), p2 * s, p3 * c, p1 / 2 * x * x + p0 * (c - 1)};
    }
    const double s = std::sin(pi / 3 * (1 + 4 * x));
    const double c = std::cos(pi / 3 * (1 + 4 * x));
    return {2 / d + p1 * x - 2.25 / d * s, p1 * (1 - 3 * c), p2 * s, p3 / 3 * c,
            (2 / d + p1 / 2 * x) * x + 27 * p0 * c - 0.25 / d - p0};
}

inline LawPoint modifiedSineAt(double x, const LawParameters&)
{
    return reflected(x, modifiedSineFirstHalf);
}

inline LawPeaks modifiedSinePeaks(const LawParameters&)
{
    using std::numbers::pi;
    constexpr double d = modifiedSineScale;
    return {4 * pi / d, 4 * pi * pi / d, 16 * pi * pi * pi / d, 0.5, 0.125};
}

inline LawPieces modifiedSinePieces(const LawParameters& parameters)
{
    const double g3 = modifiedSinePeaks(parameters).cj;
    return {{0.125, 0.875, 1, 1, 1, 1}, g3, 4 * std::numbers::pi * g3};
}

} // namespace campanel::profile::detail
