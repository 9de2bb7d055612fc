// SPDX-License-Identifier: Apache-2.0
// Quintic 3-4-5: g' and g'' are zero at both ends.
#pragma once

#include "profile/model/law.h"

#include <numbers>

namespace campanel::profile::detail {

inline LawPoint quinticAt(double x, const LawParameters&)
{
    const double x2 = x * x;
    const double x3 = x2 * x;
    return {x3 * (10 + x * (6 * x - 15)), 30 * x2 * (1 - x) * (1 - x), 60 * x * (1 + x * (2 * x - 3)),
            60 + 360 * x * (x - 1), x3 * x * (2.5 + x * (x - 3))};
}

inline LawPeaks quinticPeaks(const LawParameters&)
{
    return {1.875, 10 * std::numbers::inv_sqrt3, 60, 0.5, (3 - std::numbers::sqrt3) / 6};
}

inline LawPieces quinticPieces(const LawParameters&)
{
    return {.g3 = 60, .g4 = 360};
}

} // namespace campanel::profile::detail
