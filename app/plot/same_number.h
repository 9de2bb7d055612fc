// SPDX-License-Identifier: Apache-2.0
// Compares two numbers; two unknown ones (NaN) are equal.
#pragma once

#include <cmath>

namespace campanel::plot {

[[nodiscard]] inline bool sameNumber(double a, double b)
{
    return a == b || (std::isnan(a) && std::isnan(b));
}

} // namespace campanel::plot
