// SPDX-License-Identifier: Apache-2.0
// Trapezoid: g' rises linearly during the ramp fraction r, is constant, and falls linearly.
#pragma once

#include "profile/laws/half.h"
#include "text/marked.h"

#include <array>
#include <limits>

namespace campanel::profile::detail {

inline constexpr std::array trapezoidParameters{
    LawParameterInfo{"ramp_fraction", CAMPANEL_TEXT("Recipe", "Ramp fraction r"), 0.01, 0.5, 0.25, 3}};

inline LawPoint trapezoidAt(double x, const LawParameters& parameters)
{
    const double r = parameters[0];
    const double a = 1 / (r * (1 - r));
    return reflected(x, [r, a](double u) {
        if (u <= r)
            return constantJerk({}, a, 0, u);
        return constantJerk(constantJerk({}, a, 0, r), 0, 0, u - r);
    });
}

inline LawPeaks trapezoidPeaks(const LawParameters& parameters)
{
    const double r = parameters[0];
    return {1 / (1 - r), 1 / (r * (1 - r)), std::numeric_limits<double>::infinity(), 0.5, 0};
}

inline LawPieces trapezoidPieces(const LawParameters& parameters)
{
    const double r = parameters[0];
    return {{r, 1 - r, 1, 1, 1, 1}, 0, 0};
}

} // namespace campanel::profile::detail
