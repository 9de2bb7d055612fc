// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/trend_window.h"

#include "app/store/logs/bag_log.h"

#include <QHash>

#include <algorithm>

namespace campanel::store {

namespace {

using Level = TrendLog::Level;

constexpr qint64 msPerHour = 3'600'000;
constexpr qint64 longestOfSeconds = 2 * msPerHour;
constexpr qint64 longestOfMinutes = 8 * 24 * msPerHour;

using Firsts = std::array<std::optional<qint64>, 3>;

// Returns true when the data of the level begin as early as those of the next one.
bool reaches(const Firsts& firstMs, Level level)
{
    const auto& first = firstMs[static_cast<std::size_t>(level)];
    const Level coarser = level == Level::Second ? Level::Minute : Level::Hour;
    const auto& before = firstMs[static_cast<std::size_t>(coarser)];
    return first && (!before || *first - *before < TrendLog::lengthMs(coarser));
}

qint64 columnLength(const TrendQuestion& question, Level level)
{
    const qint64 bucketMs = TrendLog::lengthMs(level);
    const qint64 wanted = (question.toMs - question.fromMs) / std::max(1, question.columns);
    return std::max<qint64>(1, (wanted + bucketMs - 1) / bucketMs) * bucketMs;
}

} // namespace

Level levelFor(qint64 fromMs, qint64 toMs, const Firsts& firstMs)
{
    if (toMs - fromMs <= longestOfSeconds && reaches(firstMs, Level::Second))
        return Level::Second;
    if (toMs - fromMs <= longestOfMinutes && reaches(firstMs, Level::Minute))
        return Level::Minute;
    return Level::Hour;
}

tl::expected<TrendWindow, StoreError> readTrends(Database& database, const TrendQuestion& question)
{
    TrendLog log(database);
    Firsts firstMs;
    for (const Level level : {Level::Second, Level::Minute, Level::Hour}) {
        // The bucket that contains the beginning may be the only one of a short window.
        const qint64 partMs = level == Level::Hour ? 0 : TrendLog::lengthMs(level) - 1;
        const auto first = log.firstMs(level, question.fromMs - partMs);
        if (!first)
            return tl::unexpected(first.error());
        firstMs[static_cast<std::size_t>(level)] = *first;
    }
    TrendWindow window;
    const auto hasAny = log.hasAny(question.quantities);
    if (!hasAny)
        return tl::unexpected(hasAny.error());
    window.hasAny = *hasAny;
    const auto isDoubtful = BagLog(database).hasClockNotSet(question.fromMs, question.toMs);
    if (!isDoubtful)
        return tl::unexpected(isDoubtful.error());
    window.isClockDoubtful = *isDoubtful;
    window.level = levelFor(question.fromMs, question.toMs, firstMs);
    window.columnMs = columnLength(question, window.level);
    QHash<TrendQuantity, qsizetype> places;
    for (const TrendQuantity quantity : question.quantities) {
        places.insert(quantity, window.curves.size());
        window.curves << TrendCurve{quantity};
    }
    // Whole columns, always at the same times: a moved curve does not change its shape.
    const qint64 margin = (question.toMs - question.fromMs) / 2;
    const qint64 begin = (question.fromMs - margin) / window.columnMs * window.columnMs;
    const auto read = log.forEach(window.level, begin, question.toMs + margin, question.quantities,
                                  [&](qint64 startMs, TrendQuantity quantity, const TrendBucket& bucket) {
                                      QList<TrendColumn>& columns =
                                          window.curves[places.value(quantity)].columns;
                                      const qint64 column = startMs / window.columnMs * window.columnMs;
                                      if (columns.isEmpty() || columns.last().startMs != column)
                                          columns << TrendColumn{column, {}};
                                      columns.last().bucket.merge(bucket);
                                  });
    if (!read)
        return tl::unexpected(read.error());
    for (TrendCurve& curve : window.curves) {
        for (const TrendColumn& column : curve.columns) {
            if (column.startMs + window.columnMs > question.fromMs && column.startMs < question.toMs)
                curve.statistics.add(column.bucket);
        }
    }
    return window;
}

} // namespace campanel::store
