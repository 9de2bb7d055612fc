// SPDX-License-Identifier: Apache-2.0
// Exponential ramp with constant k. Acceleration steps at both ends; not symmetric; a speed law only.
#pragma once

#include "profile/model/law.h"
#include "text/marked.h"

#include <array>
#include <cmath>
#include <limits>

namespace campanel::profile::detail {

inline constexpr std::array exponentialParameters{
    LawParameterInfo{"k", CAMPANEL_TEXT("Recipe", "Exponent k"), 0.1, 20, 3, 2}};

inline LawPoint exponentialAt(double x, const LawParameters& parameters)
{
    // With k >= 0.1 the differences lose at most two of sixteen digits, and exp is three times faster than
    // expm1.
    const double k = parameters[0];
    const double decayed = std::exp(-k * x);
    const double scale = 1 / (1 - std::exp(-k));
    const double decay = k * decayed * scale;
    return {(1 - decayed) * scale, decay, -k * decay, k * k * decay, (x + (decayed - 1) / k) * scale};
}

inline LawPeaks exponentialPeaks(const LawParameters& parameters)
{
    const double k = parameters[0];
    const double cv = -k / std::expm1(-k);
    return {cv, k * cv, std::numeric_limits<double>::infinity(), 0, 0};
}

inline LawPieces exponentialPieces(const LawParameters& parameters)
{
    const double k = parameters[0];
    const double g3 = k * exponentialPeaks(parameters).ca;
    return {.g3 = g3, .g4 = k * g3};
}

} // namespace campanel::profile::detail
