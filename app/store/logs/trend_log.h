// SPDX-License-Identifier: Apache-2.0
// Trends in three levels of detail: a bucket per second for the last hours, per minute for a month, per hour
// for a year. Call it in the thread of the database.
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

    [[nodiscard]] static qint64 lengthMs(Level level); // length of a bucket
    // Returns the limit of rows for all quantities together; a tenth for a database in memory.
    [[nodiscard]] static qint64 rowsKept(Level level);
    [[nodiscard]] static QString table(Level level);

    // Adds values to all levels; call it in a transaction. Values of an existing second are merged.
    [[nodiscard]] tl::expected<void, StoreError> add(const QList<TrendPart>& parts);
    // Reads the buckets that begin from `fromMs` to before `toMs`, oldest first.
    [[nodiscard]] tl::expected<void, StoreError>
    forEach(Level level, qint64 fromMs, qint64 toMs, const QList<TrendQuantity>& quantities,
            const std::function<void(qint64 startMs, TrendQuantity, const TrendBucket&)>& take);
    // Returns the start of the first bucket that begins at `fromMs` or later; empty when there is none.
    [[nodiscard]] tl::expected<std::optional<qint64>, StoreError> firstMs(Level level, qint64 fromMs);
    [[nodiscard]] tl::expected<bool, StoreError> hasAny(const QList<TrendQuantity>& quantities);

private:
    [[nodiscard]] tl::expected<void, StoreError> addTo(Level level, const QList<TrendPart>& parts);
    // Returns true when the bucket is new.
    [[nodiscard]] tl::expected<bool, StoreError> put(Level level, qint64 slot, const TrendBucket& bucket,
                                                     qint64 era);

    Database& m_database;
};

} // namespace campanel::store
