// SPDX-License-Identifier: Apache-2.0
// The pages that show what is on the disk.
#pragma once

#include "bench_report.h"

#include <QString>

namespace campanel::bench {

// Within this a page must show what it was asked for.
inline constexpr double pageLimitMs = 200;

// The panel of that folder, whose bags and trends are there already. The log of alarms in it is filled first.
[[nodiscard]] Figures measurePages(const QString& folder);

} // namespace campanel::bench
