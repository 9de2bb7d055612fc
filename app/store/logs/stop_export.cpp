// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/stop_export.h"

#include "app/store/files/csv.h"

#include <QMap>

using namespace Qt::StringLiterals;

namespace campanel::store {

namespace {

constexpr double msPerSecond = 1000;

QString secondsText(qint64 durationMs)
{
    return QString::number(static_cast<double>(durationMs) / msPerSecond, 'f', 3);
}

QString yesOrNo(bool isTrue)
{
    return isTrue ? u"yes"_s : u"no"_s;
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

QByteArray statesCsv(const StopLog::Span& span)
{
    QByteArray csv = "begin_utc,begin_local,duration_s,state,stop,program,version,ideal_per_min,pieces,"
                     "out_of_tolerance,start_up_scrap,skipped_cuts,clock\n";
    for (const StateInterval& each : span.intervals) {
        const QStringList fields{csvUtcAndLocal(each.beginMs),
                                 secondsText(each.durationMs),
                                 nameOf(each.state),
                                 each.stop == 0 ? QString() : QString::number(each.stop),
                                 csvField(each.program),
                                 QString::number(each.version),
                                 each.idealPerMin > 0 ? QString::number(each.idealPerMin, 'f', 3) : QString(),
                                 QString::number(each.pieces),
                                 QString::number(each.outOfTolerance),
                                 QString::number(each.startUpScrap),
                                 QString::number(each.skipped),
                                 csvClock(each.isClockDoubtful)};
        csv += fields.join(u',').toUtf8() + '\n';
    }
    return csv;
}

QByteArray stopsCsv(const StopLog::Span& span)
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
    QByteArray csv =
        "stop,begin_utc,begin_local,duration_s,state,reason,planned,answered_by,answered_utc,clock\n";
    for (auto it = parts.cbegin(); it != parts.cend(); ++it) {
        const StopRow reason = reasons.value(it.key());
        const QStringList fields{QString::number(it.key()),
                                 csvUtcAndLocal(it->first->beginMs),
                                 secondsText(it->durationMs),
                                 nameOf(it->first->state),
                                 csvField(reason.reason),
                                 yesOrNo(reason.isPlanned),
                                 csvField(reason.by),
                                 reason.answeredMs == 0 ? QString() : csvUtc(reason.answeredMs),
                                 csvClock(it->first->isClockDoubtful)};
        csv += fields.join(u',').toUtf8() + '\n';
    }
    return csv;
}

} // namespace campanel::store
