// SPDX-License-Identifier: Apache-2.0
// Bags and trends between two times as CSV, times in UTC and in the panel's time zone. Call it in the thread
// of the database.
#pragma once

#include "app/store/files/csv.h"
#include "app/store/logs/bag_log.h"
#include "app/store/logs/trend_window.h"

#include <QByteArray>

namespace campanel::store {

// Returns one line for each bag, oldest first. Empty when there are none, or more than `maxRows`.
[[nodiscard]] tl::expected<QByteArray, StoreError> bagsCsv(Database& database, qint64 fromMs, qint64 toMs,
                                                           qint64 maxRows, const CsvDialect& dialect = {});
// Returns one line for each column (second, minute ...) of each quantity that begins in the window.
[[nodiscard]] QByteArray trendsCsv(const TrendWindow& window, qint64 fromMs, qint64 toMs,
                                   const CsvDialect& dialect = {});

} // namespace campanel::store
