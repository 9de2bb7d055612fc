// SPDX-License-Identifier: Apache-2.0
// Seven-segment S: a trapezoid with ramps that begin and end with constant jerk during the share q of the
// ramp.
#pragma once

#include "profile/laws/half.h"
#include "text/marked.h"

#include <array>

namespace campanel::profile::detail {

inline constexpr std::array sCurveParameters{
    LawParameterInfo{"ramp_fraction", CAMPANEL_TEXT("Recipe", "Ramp fraction r"), 0.01, 0.5, 0.25, 3},
    LawParameterInfo{"jerk_share", CAMPANEL_TEXT("Recipe", "Jerk share q"), 0.01, 0.5, 0.25, 3}};

inline LawPeaks sCurvePeaks(const LawParameters& parameters)
{
    const double r = parameters[0];
    const double q = parameters[1];
    const double ca = 1 / (r * (1 - q) * (1 - r));
    return {1 / (1 - r), ca, ca / (q * r), 0.5, q * r};
}

inline LawPoint sCurveAt(double x, const LawParameters& parameters)
{
    const LawPeaks peaks = sCurvePeaks(parameters);
    const double r = parameters[0];
    const double jerkTime = parameters[1] * r;
    return reflected(x, [&](double u) {
        if (u <= jerkTime)
            return constantJerk({}, 0, peaks.cj, u);
        const LawPoint rise = constantJerk({}, 0, peaks.cj, jerkTime);
        if (u <= r - jerkTime)
            return constantJerk(rise, peaks.ca, 0, u - jerkTime);
        const LawPoint flat = constantJerk(rise, peaks.ca, 0, r - 2 * jerkTime);
        if (u <= r)
            return constantJerk(flat, peaks.ca, -peaks.cj, u - (r - jerkTime));
        return constantJerk(constantJerk(flat, peaks.ca, -peaks.cj, jerkTime), 0, 0, u - r);
    });
}

inline LawPieces sCurvePieces(const LawParameters& parameters)
{
    const double r = parameters[0];
    const double jerkTime = parameters[1] * r;
    const double g3 = sCurvePeaks(parameters).cj;
    return {{jerkTime, r - jerkTime, r, 1 - r, 1 - r + jerkTime, 1 - jerkTime}, g3, 0};
}

} // namespace campanel::profile::detail
