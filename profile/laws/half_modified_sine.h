// SPDX-License-Identifier: Apache-2.0
// Half a modified sine: the speed law of the servo paper, g(x) = S'(x/2) / S'(1/2). Not symmetric.
#pragma once

#include "profile/laws/modified_sine.h"

namespace campanel::profile::detail {

inline LawPoint halfModifiedSineAt(double x, const LawParameters&)
{
    using std::numbers::pi;
    constexpr double peak = 4 * pi / modifiedSineScale; // S'(1/2)
    const LawPoint s = modifiedSineFirstHalf(x / 2);
    const double s4 = (x <= 0.25 ? -16 : -16.0 / 9) * pi * pi * s.g2; // fourth derivative of S
    return {1 / peak * s.g1, 0.5 / peak * s.g2, 0.25 / peak * s.g3, 0.125 / peak * s4, 2 / peak * s.g};
}

// |g'| is largest at x = 1/4 (S'' at 1/8), |g''| at x = 0.
inline LawPeaks halfModifiedSinePeaks(const LawParameters&)
{
    using std::numbers::pi;
    return {pi / 2, pi * pi, 2 * pi * pi * pi, 0.25, 0};
}

inline LawPieces halfModifiedSinePieces(const LawParameters& parameters)
{
    const double g3 = halfModifiedSinePeaks(parameters).cj;
    return {{0.25, 1, 1, 1, 1, 1}, g3, 2 * std::numbers::pi * g3};
}

} // namespace campanel::profile::detail
