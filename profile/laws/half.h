// SPDX-License-Identifier: Apache-2.0
// Defines a symmetric law by its first half; the second half is the point reflection.
#pragma once

#include "profile/model/law.h"

namespace campanel::profile::detail {

// Returns the law at x from firstHalf(x), which is valid for x in [0, 1/2]. For larger x: g(x) = 1 - g(1-x),
// G(x) = x - 1/2 + G(1-x).
template <typename FirstHalf> LawPoint reflected(double x, FirstHalf firstHalf)
{
    if (x <= 0.5)
        return firstHalf(x);
    const LawPoint p = firstHalf(1 - x);
    return {1 - p.g, p.g1, -p.g2, p.g3, x - 0.5 + p.integral};
}

// Returns the point at u after `start` of a stretch with constant g'''.
inline LawPoint constantJerk(const LawPoint& start, double g2, double g3, double u)
{
    LawPoint p;
    p.g3 = g3;
    p.g2 = g2 + g3 * u;
    p.g1 = start.g1 + u * (g2 + u * g3 / 2);
    p.g = start.g + u * (start.g1 + u * (g2 / 2 + u * g3 / 6));
    p.integral = start.integral + u * (start.g + u * (start.g1 / 2 + u * (g2 / 6 + u * g3 / 24)));
    return p;
}

} // namespace campanel::profile::detail
