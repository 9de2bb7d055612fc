// SPDX-License-Identifier: Apache-2.0
// Trends in three levels of detail: a bucket per second for the last hours, per minute for a month, per hour
// for a year. In the thread of the database.
#pragma once

#include "app/store/database/database.h"
#include "app/store/logs/trend_bucket.h"

#include <QList>

#include <functional>

namespace campanel::store {

struct TrendPart {
    qint64 second = 0; // since 1970 UTC
    TrendQuantity quantity = TrendQuantity::BagLength;
    TrendBucket bucket;
};

class TrendLog {
public:
    enum class Level { Second, Minute, Hour };

    explicit TrendLog(Database& database)
        : m_database(database)
    {
    }

    [[nodiscard]] static qint64 lengthMs(Level level); // of one bucket
    // Of all quantities together; of a database in memory a tenth.
    [[nodiscard]] static qint64 rowsKept(Level level);
    [[nodiscard]] static QString table(Level level);

    // To all levels. To be called in a transaction. What comes for a second that has values joins them.
    [[nodiscard]] tl::expected<void, StoreError> add(const QList<TrendPart>& parts);
    // Buckets that begin from `fromMs` to before `toMs`, oldest first, in the order of time.
    [[nodiscard]] tl::expected<void, StoreError>
    forEach(Level level, qint64 fromMs, qint64 toMs, const QList<TrendQuantity>& quantities,
            const std::function<void(qint64 startMs, TrendQuantity, const TrendBucket&)>& take);
    // Start of the oldest bucket; empty when there is none.
    [[nodiscard]] tl::expected<std::optional<qint64>, StoreError> firstMs(Level level);
    // Some bucket of one of these at some time.
    [[nodiscard]] tl::expected<bool, StoreError> hasAny(const QList<TrendQuantity>& quantities);

private:
    [[nodiscard]] tl::expected<void, StoreError> addTo(Level level, const QList<TrendPart>& parts);
    // True when there was none before.
    [[nodiscard]] tl::expected<bool, StoreError> put(Level level, qint64 slot, const TrendBucket& bucket);

    Database& m_database;
};

} // namespace campanel::store
