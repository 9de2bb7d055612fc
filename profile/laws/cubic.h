// SPDX-License-Identifier: Apache-2.0
// Cubic 2-3: the law of the paper. As a speed law it has zero acceleration at both ends.
#pragma once

#include "profile/model/law.h"

namespace campanel::profile::detail {

inline LawPoint cubicAt(double x, const LawParameters&)
{
    const double x2 = x * x;
    return {x2 * (3 - 2 * x), 6 * x * (1 - x), 6 - 12 * x, -12, x2 * x * (1 - x / 2)};
}

inline LawPeaks cubicPeaks(const LawParameters&)
{
    return {1.5, 6, 12, 0.5, 0};
}

inline LawPieces cubicPieces(const LawParameters&)
{
    return {.g3 = 12, .g4 = 0};
}

} // namespace campanel::profile::detail
