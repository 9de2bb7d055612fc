// SPDX-License-Identifier: Apache-2.0
// Whether two numbers are the same, also where both are unknown (NaN).
#pragma once

#include <cmath>

namespace campanel::plot {

[[nodiscard]] inline bool sameNumber(double a, double b)
{
    return a == b || (std::isnan(a) && std::isnan(b));
}

} // namespace campanel::plot
