// SPDX-License-Identifier: Apache-2.0
// 4-5-6-7 polynomial: g', g'' and g''' are zero at both ends.
#pragma once

#include "profile/model/law.h"

#include <cmath>

namespace campanel::profile::detail {

inline LawPoint polynomial4567At(double x, const LawParameters&)
{
    const double x2 = x * x;
    const double x3 = x2 * x;
    const double y = 1 - x;
    return {x3 * x * (35 + x * (-84 + x * (70 - 20 * x))), 140 * x3 * y * y * y,
            420 * x2 * y * y * (1 - 2 * x), 840 * x * y * (1 + 5 * x * (x - 1)),
            x3 * x2 * (7 + x * (-14 + x * (10 - 2.5 * x)))};
}

// |g''| is largest at x = (5 - sqrt 5) / 10, |g'''| at x = 1/2.
inline LawPeaks polynomial4567Peaks(const LawParameters&)
{
    return {2.1875, 84 * std::sqrt(5.0) / 25, 52.5, 0.5, (5 - std::sqrt(5.0)) / 10};
}

inline LawPieces polynomial4567Pieces(const LawParameters&)
{
    return {.g3 = 52.5, .g4 = 840};
}

} // namespace campanel::profile::detail
