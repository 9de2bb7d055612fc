// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/stop_export.h"

#include <QMap>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

constexpr double msPerSecond = 1000;

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
    CsvWriter csv(u"begin_utc,begin_local,duration_s,state,stop,program,version,ideal_per_min,pieces,"
                  "out_of_tolerance,start_up_scrap,skipped_cuts,clock",
                  dialect);
    for (const StateInterval& each : span.intervals) {
        csv.utcAndLocal(each.beginMs).number(secondsOf(each.durationMs), 3).text(nameOf(each.state));
        each.stop == 0 ? csv.empty() : csv.whole(each.stop);
        csv.text(each.program).whole(each.version);
        each.idealPerMin > 0 ? csv.number(each.idealPerMin, 3) : csv.empty();
        csv.whole(each.pieces).whole(each.outOfTolerance).whole(each.startUpScrap).whole(each.skipped);
        csv.clock(each.isClockDoubtful).endLine();
    }
    return csv.bytes();
}

QByteArray stopsCsv(const StopLog::Span& span, const CsvDialect& dialect)
{
    struct Part {
        const StateInterval* first = nullptr;
        qint64 durationMs = 0;
    };
    QMap<qint64, Part> parts;
    for (const StateInterval& each : span.intervals) {
        if (each.stop == 0)
            continue;
        Part& part = parts[each.stop];
        if (!part.first)
            part.first = &each;
        part.durationMs += each.durationMs;
    }
    QMap<qint64, StopRow> reasons;
    for (const StopRow& each : span.stops)
        reasons.insert(each.id, each);
    CsvWriter csv(
        u"stop,begin_utc,begin_local,duration_s,state,reason,planned,answered_by,answered_utc,clock",
        dialect);
    for (auto it = parts.cbegin(); it != parts.cend(); ++it) {
        const StopRow reason = reasons.value(it.key());
        csv.whole(it.key()).utcAndLocal(it->first->beginMs).number(secondsOf(it->durationMs), 3);
        csv.text(nameOf(it->first->state)).text(reason.reason).yesOrNo(reason.isPlanned).text(reason.by);
        csv.utc(reason.answeredMs).clock(it->first->isClockDoubtful).endLine();
    }
    return csv.bytes();
}

} // namespace campanel::store
