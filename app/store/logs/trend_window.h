// SPDX-License-Identifier: Apache-2.0
// What a screen shows of the trends between two times: the level of detail that suits it, in as many columns
// as can be drawn, and the statistics. In the thread of the database.
#pragma once

#include "app/store/logs/trend_log.h"

#include <array>

namespace campanel::store {

struct TrendQuestion {
    qint64 fromMs = 0;
    qint64 toMs = 0;
    QList<TrendQuantity> quantities{};
    int columns = 400; // in the window, at most; as many again beside it
};

struct TrendColumn {
    qint64 startMs = 0;
    TrendBucket bucket;
};

struct TrendCurve {
    TrendQuantity quantity = TrendQuantity::BagLength;
    QList<TrendColumn> columns{}; // that have values, oldest first; half a window beside it on both sides too
    TrendStatistics statistics{}; // of the columns that begin in the window
};

struct TrendWindow {
    TrendLog::Level level = TrendLog::Level::Second;
    qint64 columnMs = 0;        // of each; a whole number of the level's buckets
    bool hasAny = false;        // there is something of these quantities at some time
    QList<TrendCurve> curves{}; // as asked for
};

[[nodiscard]] tl::expected<TrendWindow, StoreError> readTrends(Database& database,
                                                               const TrendQuestion& question);

// The finest level that has what is asked for and not more buckets than can be read at once. `firstMs`: of
// each level, finest first; empty while there is nothing.
[[nodiscard]] TrendLog::Level levelFor(qint64 fromMs, qint64 toMs,
                                       const std::array<std::optional<qint64>, 3>& firstMs);

} // namespace campanel::store
