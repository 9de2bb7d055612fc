// SPDX-License-Identifier: Apache-2.0
// Measures the pages that display stored data.
#pragma once

#include "bench_report.h"

#include <QString>

namespace campanel::bench {

// The limit for the display of requested data.
inline constexpr double pageLimitMs = 200;

// Measures the panel of that folder, which already has bags and trends. Fills its log of alarms first.
[[nodiscard]] Figures measurePages(const QString& folder);

} // namespace campanel::bench
