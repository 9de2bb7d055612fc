// SPDX-License-Identifier: Apache-2.0
// Parabolic: constant acceleration, then constant deceleration.
#pragma once

#include "profile/laws/half.h"

#include <limits>

namespace campanel::profile::detail {

inline LawPoint parabolicAt(double x, const LawParameters&)
{
    return reflected(x, [](double u) { return LawPoint{2 * u * u, 4 * u, 4, 0, 2 * u * u * u / 3}; });
}

inline LawPeaks parabolicPeaks(const LawParameters&)
{
    return {2, 4, std::numeric_limits<double>::infinity(), 0.5, 0};
}

inline LawPieces parabolicPieces(const LawParameters&)
{
    return {{0.5, 1, 1, 1, 1, 1}, 0, 0};
}

} // namespace campanel::profile::detail
