// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/trend_log.h"

#include "app/store/database/ring.h"

#include <map>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

constexpr qint64 quantitiesPerSlot = 8; // reserve for two more
constexpr qint64 msOfSecond = 1000;
constexpr qint64 secondsPerMinute = 60;
constexpr qint64 secondsPerHour = 3600;
constexpr qint64 hoursOfSeconds = 4;
constexpr qint64 daysOfMinutes = 31;
constexpr qint64 daysOfHours = 366;
constexpr qint64 shareInMemory = 10; // when the file cannot be opened

qint64 floorDivided(qint64 value, qint64 by)
{
    return value / by - (value % by < 0 ? 1 : 0);
}

// Returns the first bucket that begins at that time or later.
qint64 firstSlot(qint64 timeMs, TrendLog::Level level)
{
    return -floorDivided(-timeMs, TrendLog::lengthMs(level)) * quantitiesPerSlot;
}

// Returns "0,3".
QString listOf(const QList<TrendQuantity>& quantities)
{
    QStringList wanted;
    for (const TrendQuantity quantity : quantities)
        wanted << QString::number(static_cast<int>(quantity));
    return wanted.join(u',');
}

} // namespace

qint64 TrendLog::lengthMs(Level level)
{
    switch (level) {
    case Level::Second:
        return msOfSecond;
    case Level::Minute:
        return secondsPerMinute * msOfSecond;
    case Level::Hour:
        break;
    }
    return secondsPerHour * msOfSecond;
}

qint64 TrendLog::rowsKept(Level level)
{
    switch (level) {
    case Level::Second:
        return hoursOfSeconds * secondsPerHour * trendQuantities;
    case Level::Minute:
        return daysOfMinutes * 24 * 60 * trendQuantities;
    case Level::Hour:
        break;
    }
    return daysOfHours * 24 * trendQuantities;
}

QString TrendLog::table(Level level)
{
    switch (level) {
    case Level::Second:
        return u"trend_second"_s;
    case Level::Minute:
        return u"trend_minute"_s;
    case Level::Hour:
        break;
    }
    return u"trend_hour"_s;
}

tl::expected<void, StoreError> TrendLog::add(const QList<TrendPart>& parts)
{
    for (const Level level : {Level::Second, Level::Minute, Level::Hour}) {
        if (const auto added = addTo(level, parts); !added)
            return added;
    }
    return {};
}

tl::expected<void, StoreError> TrendLog::addTo(Level level, const QList<TrendPart>& parts)
{
    std::map<qint64, TrendBucket> buckets;
    for (const TrendPart& part : parts) {
        const qint64 start = floorDivided(part.second * msOfSecond, lengthMs(level));
        buckets[start * quantitiesPerSlot + static_cast<qint64>(part.quantity)].merge(part.bucket);
    }
    auto ring = Ring::begin(m_database, table(level), u"slot"_s, quantitiesPerSlot);
    if (!ring)
        return tl::unexpected(ring.error());
    qint64 added = 0;
    for (const auto& [slot, bucket] : buckets) {
        const auto isNew = put(level, slot, bucket, ring->eraOf(slot));
        if (!isNew)
            return tl::unexpected(isNew.error());
        added += *isNew ? 1 : 0;
    }
    const qint64 kept = m_database.isInMemory() ? rowsKept(level) / shareInMemory : rowsKept(level);
    return ring->end(added, kept);
}

tl::expected<bool, StoreError> TrendLog::put(Level level, qint64 slot, const TrendBucket& bucket, qint64 era)
{
    const auto joined = m_database.execute(
        uR"(UPDATE %1 SET count = count + ?, sum = sum + ?, squares = squares + ?, low = min(low, ?),
                          high = max(high, ?), inside = inside + ?, era = ? WHERE slot = ?)"_s.arg(
            table(level)),
        {bucket.count, bucket.sum, bucket.squares, bucket.low, bucket.high, bucket.within, era, slot});
    if (!joined)
        return tl::unexpected(joined.error());
    if (joined->numRowsAffected() > 0)
        return false;
    const auto inserted = m_database.execute(
        u"INSERT INTO %1 VALUES (?, ?, ?, ?, ?, ?, ?, ?)"_s.arg(table(level)),
        {slot, bucket.count, bucket.sum, bucket.squares, bucket.low, bucket.high, bucket.within, era});
    if (!inserted)
        return tl::unexpected(inserted.error());
    return true;
}

tl::expected<void, StoreError>
TrendLog::forEach(Level level, qint64 fromMs, qint64 toMs, const QList<TrendQuantity>& quantities,
                  const std::function<void(qint64, TrendQuantity, const TrendBucket&)>& take)
{
    auto rows = m_database.execute(uR"(SELECT slot, count, sum, squares, low, high, inside FROM %1
            WHERE slot >= ? AND slot < ? AND (slot & 7) IN (%2) ORDER BY slot)"_s.arg(table(level),
                                                                                      listOf(quantities)),
                                   {firstSlot(fromMs, level), firstSlot(toMs, level)});
    if (!rows)
        return tl::unexpected(rows.error());
    while (rows->next()) {
        const qint64 slot = rows->value(0).toLongLong();
        const TrendBucket bucket{rows->value(1).toLongLong(), rows->value(2).toLongLong(),
                                 rows->value(3).toLongLong(), rows->value(4).toLongLong(),
                                 rows->value(5).toLongLong(), rows->value(6).toLongLong()};
        take(floorDivided(slot, quantitiesPerSlot) * lengthMs(level),
             static_cast<TrendQuantity>(slot & (quantitiesPerSlot - 1)), bucket);
    }
    return m_database.stepped(*rows);
}

tl::expected<bool, StoreError> TrendLog::hasAny(const QList<TrendQuantity>& quantities)
{
    auto found = m_database.execute(
        u"SELECT 1 FROM %1 WHERE (slot & 7) IN (%2) LIMIT 1"_s.arg(table(Level::Hour), listOf(quantities)));
    if (!found)
        return tl::unexpected(found.error());
    return found->next();
}

tl::expected<std::optional<qint64>, StoreError> TrendLog::firstMs(Level level, qint64 fromMs)
{
    auto found = m_database.execute(u"SELECT min(slot) FROM %1 WHERE slot >= ?"_s.arg(table(level)),
                                    {firstSlot(fromMs, level)});
    if (!found)
        return tl::unexpected(found.error());
    if (!found->next() || found->value(0).isNull())
        return std::nullopt;
    return floorDivided(found->value(0).toLongLong(), quantitiesPerSlot) * lengthMs(level);
}

} // namespace campanel::store
