// SPDX-License-Identifier: Apache-2.0
// The trends between two times for display: the suitable level of detail, as many columns as can be drawn,
// and the statistics. Call it in the thread of the database.
#pragma once

#include "app/store/logs/trend_log.h"

#include <array>

namespace campanel::store {

struct TrendQuestion {
    qint64 fromMs = 0;
    qint64 toMs = 0;
    QList<TrendQuantity> quantities{};
    int columns = 400; // maximum within the window; the same number beside it
};

struct TrendColumn {
    qint64 startMs = 0;
    TrendBucket bucket;
};

struct TrendCurve {
    TrendQuantity quantity = TrendQuantity::BagLength;
    QList<TrendColumn> columns{}; // those with values, oldest first; also half a window on both sides
    TrendStatistics statistics{}; // columns that begin in the window
};

struct TrendWindow {
    TrendLog::Level level = TrendLog::Level::Second;
    qint64 columnMs = 0;          // width of a column; a multiple of the level's bucket
    bool isClockDoubtful = false; // for a bag in the window
    bool hasAny = false;          // these quantities have a bucket at any time
    QList<TrendCurve> curves{};   // in the requested order
};

[[nodiscard]] tl::expected<TrendWindow, StoreError> readTrends(Database& database,
                                                               const TrendQuestion& question);

// Returns the finest level with data for the window and not too many buckets to read at once. `firstMs`: the
// first data of each level in the window or after it, finest first; empty without data.
[[nodiscard]] TrendLog::Level levelFor(qint64 fromMs, qint64 toMs,
                                       const std::array<std::optional<qint64>, 3>& firstMs);

} // namespace campanel::store
