// SPDX-License-Identifier: Apache-2.0
// Harmonic: half a cosine wave.
#pragma once

#include "profile/model/law.h"

#include <cmath>
#include <numbers>

namespace campanel::profile::detail {

inline LawPoint harmonicAt(double x, const LawParameters&)
{
    using std::numbers::pi;
    const double s = std::sin(pi * x);
    const double c = std::cos(pi * x);
    return {(1 - c) / 2, pi / 2 * s, pi * pi / 2 * c, -pi * pi * pi / 2 * s, x / 2 - s / (2 * pi)};
}

inline LawPeaks harmonicPeaks(const LawParameters&)
{
    using std::numbers::pi;
    return {pi / 2, pi * pi / 2, pi * pi * pi / 2, 0.5, 0};
}

inline LawPieces harmonicPieces(const LawParameters&)
{
    using std::numbers::pi;
    return {.g3 = pi * pi * pi / 2, .g4 = pi * pi * pi * pi / 2};
}

} // namespace campanel::profile::detail
