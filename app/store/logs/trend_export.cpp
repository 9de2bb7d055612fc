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
        return u"link_latency_ms"_s;
    case TrendQuantity::JamResidue:
        break;
    }
    return u"jam_residue_percent"_s;
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
    using Csv = CsvWriter;
    CsvTable<Bag> file(
        {{u"each_bag_utc,each_bag_local"_s, [](Csv& csv, const Bag& bag) { csv.utcAndLocal(bag.timeMs); }},
         {u"program"_s, [](Csv& csv, const Bag& bag) { csv.text(bag.programName); }},
         {u"version"_s, [](Csv& csv, const Bag& bag) { csv.whole(bag.programVersion); }},
         {u"lengths"_s, [](Csv& csv, const Bag& bag) { csv.whole(bag.lengths); }},
         {u"length_mm"_s, [](Csv& csv, const Bag& bag) { csv.number(bag.lengthMm(), 3); }},
         {u"deviation_mm"_s, [](Csv& csv, const Bag& bag) { csv.number(bag.deviationMm, 3); }},
         {u"mark_error_mm"_s, [](Csv& csv, const Bag& bag) { csv.number(bag.markErrorMm, 3); }},
         {u"following_error_mm"_s, [](Csv& csv, const Bag& bag) { csv.number(bag.followingErrorMm, 3); }},
         {u"rate_bags_per_min"_s, [](Csv& csv, const Bag& bag) { csv.number(bag.rateBagsPerMin, 3); }},
         {u"flags"_s, [](Csv& csv, const Bag& bag) { csv.text(flags(bag.flags)); }},
         {u"clock"_s, [](Csv& csv, const Bag& bag) { csv.clock(bag.flags & Bag::ClockNotSet); }}},
        dialect);
    const auto read = log.forEach(fromMs, toMs, [&file](const Bag& bag) { file.add(bag); });
    if (!read)
        return tl::unexpected(read.error());
    return file.bytes();
}

QByteArray trendsCsv(const TrendWindow& window, qint64 fromMs, qint64 toMs, const CsvDialect& dialect)
{
    struct Stretch {
        qint64 startMs;
        qint64 lengthMs;
        TrendQuantity quantity;
        TrendBucket bucket;
    };
    using Csv = CsvWriter;
    CsvTable<Stretch> file(
        {{u"stretch_begin_utc,stretch_begin_local"_s,
          [](Csv& csv, const Stretch& row) { csv.utcAndLocal(row.startMs); }},
         {u"stretch_s"_s, [](Csv& csv, const Stretch& row) { csv.whole(row.lengthMs / 1000); }},
         {u"quantity"_s, [](Csv& csv, const Stretch& row) { csv.text(nameOf(row.quantity)); }},
         {u"count"_s, [](Csv& csv, const Stretch& row) { csv.whole(row.bucket.count); }},
         {u"mean"_s, [](Csv& csv, const Stretch& row) { csv.number(row.bucket.mean(), 3); }},
         {u"min"_s, [](Csv& csv, const Stretch& row) { csv.number(row.bucket.lowest(), 3); }},
         {u"max"_s, [](Csv& csv, const Stretch& row) { csv.number(row.bucket.highest(), 3); }}},
        dialect);
    for (const TrendCurve& curve : window.curves) {
        for (const TrendColumn& column : curve.columns) {
            if (column.startMs + window.columnMs > fromMs && column.startMs < toMs)
                file.add({column.startMs, window.columnMs, curve.quantity, column.bucket});
        }
    }
    return file.bytes();
}

} // namespace campanel::store
