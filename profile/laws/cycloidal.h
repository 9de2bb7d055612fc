// SPDX-License-Identifier: Apache-2.0
// Cycloidal: one sine wave of acceleration.
#pragma once

#include "profile/model/law.h"

#include <cmath>
#include <numbers>

namespace campanel::profile::detail {

inline LawPoint cycloidalAt(double x, const LawParameters&)
{
    constexpr double w = 2 * std::numbers::pi;
    const double s = std::sin(w * x);
    const double c = std::cos(w * x);
    return {x - s / w, 1 - c, w * s, w * w * c, x * x / 2 + (c - 1) / (w * w)};
}

inline LawPeaks cycloidalPeaks(const LawParameters&)
{
    constexpr double w = 2 * std::numbers::pi;
    return {2, w, w * w, 0.5, 0.25};
}

inline LawPieces cycloidalPieces(const LawParameters&)
{
    constexpr double w = 2 * std::numbers::pi;
    return {.g3 = w * w, .g4 = w * w * w};
}

} // namespace campanel::profile::detail
