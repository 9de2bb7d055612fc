// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/trend_export.h"

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

QString flags(quint8 flags)
{
    QStringList words;
    const std::pair<Bag::Flag, QString> known[]{{Bag::Tracked, u"tracked"_s},
                                                {Bag::MarkMissed, u"mark_missed"_s},
                                                {Bag::ProductAcross, u"product_across"_s},
                                                {Bag::Empty, u"empty"_s}};
    for (const auto& [flag, word] : known) {
        if (flags & flag)
            words << word;
    }
    return words.join(u' ');
}

QString nameOf(TrendQuantity quantity)
{
    switch (quantity) {
    case TrendQuantity::BagLength:
        return u"bag_length_mm"_s;
    case TrendQuantity::Deviation:
        return u"deviation_mm"_s;
    case TrendQuantity::MarkError:
        return u"mark_error_mm"_s;
    case TrendQuantity::FollowingError:
        return u"following_error_mm"_s;
    case TrendQuantity::Rate:
        return u"rate_bags_per_min"_s;
    case TrendQuantity::Latency:
        break;
    }
    return u"link_latency_ms"_s;
}

} // namespace

tl::expected<QByteArray, StoreError> bagsCsv(Database& database, qint64 fromMs, qint64 toMs, qint64 maxRows,
                                             const CsvDialect& dialect)
{
    BagLog log(database);
    const auto counted = log.countBetween(fromMs, toMs, maxRows + 1);
    if (!counted)
        return tl::unexpected(counted.error());
    if (*counted == 0 || *counted > maxRows)
        return QByteArray();
    CsvWriter csv(u"each_bag_utc,each_bag_local,program,version,lengths,length_mm,deviation_mm,mark_error_mm,"
                  "following_error_mm,rate_bags_per_min,flags,clock",
                  dialect);
    const auto read = log.forEach(fromMs, toMs, [&csv](const Bag& bag) {
        csv.utcAndLocal(bag.timeMs).text(bag.programName).whole(bag.programVersion).whole(bag.lengths);
        csv.number(bag.lengthMm(), 3).number(bag.deviationMm, 3).number(bag.markErrorMm, 3);
        csv.number(bag.followingErrorMm, 3).number(bag.rateBagsPerMin, 3).text(flags(bag.flags));
        csv.clock(bag.flags & Bag::ClockNotSet).endLine();
    });
    if (!read)
        return tl::unexpected(read.error());
    return csv.bytes();
}

QByteArray trendsCsv(const TrendWindow& window, qint64 fromMs, qint64 toMs, const CsvDialect& dialect)
{
    CsvWriter csv(u"stretch_begin_utc,stretch_begin_local,stretch_s,quantity,count,mean,min,max", dialect);
    for (const TrendCurve& curve : window.curves) {
        for (const TrendColumn& column : curve.columns) {
            if (column.startMs + window.columnMs <= fromMs || column.startMs >= toMs)
                continue;
            const TrendBucket& bucket = column.bucket;
            csv.utcAndLocal(column.startMs).whole(window.columnMs / 1000).text(nameOf(curve.quantity));
            csv.whole(bucket.count).number(bucket.mean(), 3).number(bucket.lowest(), 3);
            csv.number(bucket.highest(), 3).endLine();
        }
    }
    return csv.bytes();
}

} // namespace campanel::store
