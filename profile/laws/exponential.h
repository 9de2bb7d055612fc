// SPDX-License-Identifier: Apache-2.0
// Exponential ramp with constant k. Acceleration steps at both ends; not symmetric; a speed law only.
#pragma once

#include "profile/law.h"

#include <array>
#include <cmath>
#include <limits>

namespace campanel::profile::detail {

inline constexpr std::array exponentialParameters{
    LawParameterInfo{"k", "Exponential constant k", 0.1, 20, 3, 2}};

inline LawPoint exponentialAt(double x, const LawParameters& parameters)
{
    const double k = parameters[0];
    const double rest = std::expm1(-k * x); // e^-kx - 1
    const double scale = -1 / std::expm1(-k);
    const double decay = k * (1 + rest) * scale;
    return {-rest * scale, decay, -k * decay, k * k * decay, (x + rest / k) * scale};
}

inline LawPeaks exponentialPeaks(const LawParameters& parameters)
{
    const double k = parameters[0];
    const double cv = -k / std::expm1(-k);
    return {cv, k * cv, std::numeric_limits<double>::infinity(), 0, 0};
}

} // namespace campanel::profile::detail
