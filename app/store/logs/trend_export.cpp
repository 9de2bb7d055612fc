// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/trend_export.h"

#include "app/store/files/csv.h"

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

QString number(const std::optional<double>& value)
{
    return value ? QString::number(*value, 'f', 3) : QString();
}

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

tl::expected<QByteArray, StoreError> bagsCsv(Database& database, qint64 fromMs, qint64 toMs, qint64 maxRows)
{
    BagLog log(database);
    const auto counted = log.countBetween(fromMs, toMs, maxRows + 1);
    if (!counted)
        return tl::unexpected(counted.error());
    if (*counted == 0 || *counted > maxRows)
        return QByteArray();
    QByteArray csv =
        "each_bag_utc,each_bag_local,program,version,lengths,length_mm,deviation_mm,mark_error_mm,"
        "following_error_mm,rate_bags_per_min,flags,clock\n";
    const auto read = log.forEach(fromMs, toMs, [&](const Bag& bag) {
        const QStringList fields{csvUtcAndLocal(bag.timeMs),
                                 csvField(bag.programName),
                                 QString::number(bag.programVersion),
                                 QString::number(bag.lengths),
                                 number(bag.lengthMm()),
                                 number(bag.deviationMm),
                                 number(bag.markErrorMm),
                                 number(bag.followingErrorMm),
                                 number(bag.rateBagsPerMin),
                                 flags(bag.flags),
                                 csvClock(bag.flags & Bag::ClockNotSet)};
        csv += fields.join(u',').toUtf8() + '\n';
    });
    if (!read)
        return tl::unexpected(read.error());
    return csv;
}

QByteArray trendsCsv(const TrendWindow& window, qint64 fromMs, qint64 toMs)
{
    QByteArray csv = "stretch_begin_utc,stretch_begin_local,stretch_s,quantity,count,mean,min,max\n";
    for (const TrendCurve& curve : window.curves) {
        for (const TrendColumn& column : curve.columns) {
            if (column.startMs + window.columnMs <= fromMs || column.startMs >= toMs)
                continue;
            const TrendBucket& bucket = column.bucket;
            const QStringList fields{csvUtcAndLocal(column.startMs), QString::number(window.columnMs / 1000),
                                     nameOf(curve.quantity),         QString::number(bucket.count),
                                     number(bucket.mean()),          number(bucket.lowest()),
                                     number(bucket.highest())};
            csv += fields.join(u',').toUtf8() + '\n';
        }
    }
    return csv;
}

} // namespace campanel::store
