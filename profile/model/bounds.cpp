// SPDX-License-Identifier: Apache-2.0
#include "profile/model/bounds.h"

#include <cmath>
#ifdef CAMPANEL_NAN_ABORTS
#include <cstdio>
#include <cstdlib>
#endif

namespace campanel::profile {

void detail::reportNan()
{
#ifdef CAMPANEL_NAN_ABORTS
    std::fputs("profile: a number is compared with NaN\n", stderr);
    std::abort();
#endif
}

int wholeOf(double value)
{
    constexpr double beyond = 1e9;
    return static_cast<int>(std::isnan(value) ? -beyond : clamped(std::round(value), -beyond, beyond));
}

} // namespace campanel::profile
