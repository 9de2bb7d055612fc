// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/figures_csv.h"

#include <QDateTime>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

constexpr double usPerMs = 1000;
constexpr qint64 sPerMinute = 60;

// Returns "2026-01-31T12:34Z".
QString minuteText(std::int64_t minute)
{
    return QDateTime::fromSecsSinceEpoch(minute * sPerMinute).toUTC().toString(u"yyyy-MM-ddTHH:mm"_s) + u'Z';
}

QString errorName(modbus::LinkErrorKind kind)
{
    return QString::fromStdString(std::string(modbus::errorId(kind)));
}

void addLatencies(store::CsvWriter& csv, const modbus::LatencyHistogram& latency)
{
    const auto line = [&](const QString& key, std::chrono::nanoseconds time) {
        csv.text(key);
        latency.count() > 0 ? csv.number(std::chrono::duration<double, std::milli>(time).count(), 3)
                            : csv.empty();
        csv.endLine();
    };
    line(u"latency_p50_ms"_s, latency.percentile(0.50));
    line(u"latency_p95_ms"_s, latency.percentile(0.95));
    line(u"latency_p99_ms"_s, latency.percentile(0.99));
    line(u"latency_max_ms"_s, latency.maximum());
}

} // namespace

QByteArray figuresCsv(const modbus::LinkFigures& figures, const store::CsvDialect& dialect)
{
    store::CsvWriter csv(u"figure,value", dialect);
    const auto line = [&csv](const QString& key, std::uint64_t value) {
        csv.text(key).whole(static_cast<qint64>(value)).endLine();
    };
    line(u"requests"_s, figures.requests());
    line(u"answers"_s, figures.answers());
    for (std::size_t i = 0; i < modbus::countedErrors.size(); ++i)
        line(errorName(modbus::countedErrors[i]), figures.errors()[i]);
    line(u"retries"_s, figures.retries());
    line(u"drains"_s, figures.drains());
    line(u"sent_bytes"_s, figures.sentBytes());
    line(u"received_bytes"_s, figures.receivedBytes());
    line(u"dropped_bytes"_s, figures.droppedBytes());
    line(u"stray_bytes"_s, figures.strayBytes());
    addLatencies(csv, figures.latency());
    constexpr int shareDecimals = 4;
    csv.text(u"wire_share"_s).number(figures.wireShare(), shareDecimals).endLine();
    if (const auto& controller = figures.controller()) {
        line(u"controller_requests"_s, controller->requests);
        line(u"controller_crc_errors"_s, controller->crcErrors);
        line(u"controller_frame_errors"_s, controller->frameErrors);
        line(u"controller_exceptions"_s, controller->exceptions);
    }
    return csv.bytes();
}

QByteArray stripCsv(const modbus::LinkFigures& figures, const store::CsvDialect& dialect)
{
    using Csv = store::CsvWriter;
    using Minute = modbus::MinuteFigures;
    const auto latency = [](Csv& csv, const Minute& minute, std::uint32_t us) {
        minute.answers > 0 ? csv.number(us / usPerMs, 3) : csv.empty();
    };
    store::CsvColumns<Minute> columns{
        {u"minute"_s, [](Csv& csv, const Minute& minute) { csv.text(minuteText(minute.minute)); }},
        {u"answers"_s, [](Csv& csv, const Minute& minute) { csv.whole(minute.answers); }}};
    for (std::size_t i = 0; i < modbus::countedErrors.size(); ++i)
        columns.push_back({errorName(modbus::countedErrors[i]),
                           [i](Csv& csv, const Minute& minute) { csv.whole(minute.errors[i]); }});
    columns.push_back({u"latency_p99_ms"_s,
                       [=](Csv& csv, const Minute& minute) { latency(csv, minute, minute.latencyP99Us); }});
    columns.push_back({u"latency_max_ms"_s,
                       [=](Csv& csv, const Minute& minute) { latency(csv, minute, minute.latencyMaxUs); }});
    store::CsvTable<Minute> file(columns, dialect);
    for (const Minute& minute : figures.strip())
        file.add(minute);
    return file.bytes();
}

} // namespace campanel::panel
