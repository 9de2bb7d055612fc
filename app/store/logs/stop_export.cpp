// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/stop_export.h"

#include <QMap>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

constexpr double msPerSecond = 1000;

// A stop with all its intervals.
struct Stop {
    StateInterval first;
    qint64 durationMs = 0;
    StopRow answer;
};

double secondsOf(qint64 durationMs)
{
    return static_cast<double>(durationMs) / msPerSecond;
}

} // namespace

QString nameOf(StateInterval::State state)
{
    switch (state) {
    case StateInterval::State::Idle:
        return u"idle"_s;
    case StateInterval::State::Ready:
        return u"ready"_s;
    case StateInterval::State::Running:
        return u"running"_s;
    case StateInterval::State::Stopping:
        return u"stopping"_s;
    case StateInterval::State::Jogging:
        return u"jogging"_s;
    case StateInterval::State::Homing:
        return u"homing"_s;
    case StateInterval::State::Fault:
        return u"fault"_s;
    case StateInterval::State::Suspended:
        break;
    }
    return u"suspended"_s;
}

QByteArray statesCsv(const StopLog::Span& span, const CsvDialect& dialect)
{
    using Csv = CsvWriter;
    using Row = StateInterval;
    CsvTable<Row> file(
        {{u"begin_utc,begin_local"_s, [](Csv& csv, const Row& row) { csv.utcAndLocal(row.beginMs); }},
         {u"duration_s"_s, [](Csv& csv, const Row& row) { csv.number(secondsOf(row.durationMs), 3); }},
         {u"state"_s, [](Csv& csv, const Row& row) { csv.text(nameOf(row.state)); }},
         {u"stop"_s, [](Csv& csv, const Row& row) { row.stop == 0 ? csv.empty() : csv.whole(row.stop); }},
         {u"program"_s, [](Csv& csv, const Row& row) { csv.text(row.program); }},
         {u"version"_s, [](Csv& csv, const Row& row) { csv.whole(row.version); }},
         {u"ideal_per_min"_s,
          [](Csv& csv, const Row& row) {
              row.idealPerMin > 0 ? csv.number(row.idealPerMin, 3) : csv.empty();
          }},
         {u"pieces"_s, [](Csv& csv, const Row& row) { csv.whole(row.pieces); }},
         {u"out_of_tolerance"_s, [](Csv& csv, const Row& row) { csv.whole(row.outOfTolerance); }},
         {u"start_up_scrap"_s, [](Csv& csv, const Row& row) { csv.whole(row.startUpScrap); }},
         {u"skipped_cuts"_s, [](Csv& csv, const Row& row) { csv.whole(row.skipped); }},
         {u"clock"_s, [](Csv& csv, const Row& row) { csv.clock(row.isClockDoubtful); }}},
        dialect);
    for (const StateInterval& each : span.intervals)
        file.add(each);
    return file.bytes();
}

QByteArray stopsCsv(const StopLog::Span& span, const CsvDialect& dialect)
{
    QMap<qint64, Stop> stops;
    for (const StateInterval& each : span.intervals) {
        if (each.stop == 0)
            continue;
        Stop& stop = stops[each.stop];
        if (stop.first.stop == 0)
            stop.first = each;
        stop.durationMs += each.durationMs;
    }
    for (const StopRow& each : span.stops) {
        if (const auto stop = stops.find(each.id); stop != stops.end())
            stop->answer = each;
    }
    using Csv = CsvWriter;
    CsvTable<Stop> file(
        {{u"stop"_s, [](Csv& csv, const Stop& stop) { csv.whole(stop.first.stop); }},
         {u"begin_utc,begin_local"_s,
          [](Csv& csv, const Stop& stop) { csv.utcAndLocal(stop.first.beginMs); }},
         {u"duration_s"_s, [](Csv& csv, const Stop& stop) { csv.number(secondsOf(stop.durationMs), 3); }},
         {u"state"_s, [](Csv& csv, const Stop& stop) { csv.text(nameOf(stop.first.state)); }},
         {u"reason"_s, [](Csv& csv, const Stop& stop) { csv.text(stop.answer.reason); }},
         {u"planned"_s, [](Csv& csv, const Stop& stop) { csv.yesOrNo(stop.answer.isPlanned); }},
         {u"answered_by"_s, [](Csv& csv, const Stop& stop) { csv.text(stop.answer.by); }},
         {u"answered_utc"_s, [](Csv& csv, const Stop& stop) { csv.utc(stop.answer.answeredMs); }},
         {u"clock"_s, [](Csv& csv, const Stop& stop) { csv.clock(stop.first.isClockDoubtful); }}},
        dialect);
    for (const Stop& stop : stops)
        file.add(stop);
    return file.bytes();
}

} // namespace campanel::store
