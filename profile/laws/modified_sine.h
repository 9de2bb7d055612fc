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
    constexpr double d = modifiedSineScale;
    constexpr double pi2 = pi * pi;
    constexpr double pi3 = pi2 * pi;
    if (x <= 0.125) {
        const double s = std::sin(4 * pi * x);
        const double c = std::cos(4 * pi * x);
        return {(pi * x - s / 4) / d, pi * (1 - c) / d, 4 * pi2 * s / d, 16 * pi3 * c / d,
                (pi * x * x / 2 + (c - 1) / (16 * pi)) / d};
    }
    const double s = std::sin(pi / 3 * (1 + 4 * x));
    const double c = std::cos(pi / 3 * (1 + 4 * x));
    return {(2 + pi * x - 2.25 * s) / d, pi * (1 - 3 * c) / d, 4 * pi2 * s / d, 16 * pi3 / 3 * c / d,
            (2 * x + pi * x * x / 2 + 27 / (16 * pi) * c - 0.25 - 1 / (16 * pi)) / d};
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

} // namespace campanel::profile::detail
