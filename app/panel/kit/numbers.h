// SPDX-License-Identifier: Apache-2.0
// The value of an unknown number, and the mean of numbers.
#pragma once

#include <QList>

#include <limits>
#include <numeric>

namespace campanel::panel {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// Returns the mean; unknown for an empty list.
[[nodiscard]] inline double mean(const QList<double>& values)
{
    return values.isEmpty()
               ? unknown
               : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace campanel::panel
