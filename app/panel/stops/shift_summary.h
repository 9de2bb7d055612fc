// SPDX-License-Identifier: Apache-2.0
// A shift computed from its intervals: production, stops, reasons by their time, and the bar of states.
#pragma once

#include "app/panel/stops/oee.h"
#include "app/panel/stops/shift_calendar.h"
#include "app/store/logs/stop_log.h"

#include <QList>
#include <QString>

namespace campanel::panel {

// A stretch of the bar, as shares of the shift.
struct BarStretch {
    double from = 0;
    double width = 0;
    store::StateInterval::State state = store::StateInterval::State::Idle;

    bool operator==(const BarStretch&) const = default;
};

// The part of a stop that lies in the shift.
struct ShiftStop {
    qint64 id = 0;
    qint64 beginMs = 0;
    qint64 durationMs = 0;
    store::StateInterval::State state = store::StateInterval::State::Idle; // at its begin
    store::StopRow answer;
    bool isClockDoubtful = false; // of the begin

    bool operator==(const ShiftStop&) const = default;
};

struct ReasonShare {
    QString reason;       // empty: without a reason
    bool isShort = false; // stops without a reason that are too short to be asked about
    bool isPlanned = false;
    qint64 durationMs = 0;
    int count = 0;

    bool operator==(const ReasonShare&) const = default;
};

struct ShiftSummary {
    Shift shift;
    Production production;
    qint64 knownMs = 0;
    qint64 plannedStopMs = 0; // of a shift of a day off: all of it
    qint64 stopMs = 0;        // the other stops
    QList<BarStretch> bar;
    QList<ShiftStop> stops;       // in their order
    QList<ReasonShare> reasons;   // longest first
    QStringList programs;         // that ran, as "Biscuit 250 v3", in their order
    bool isClockDoubtful = false; // of an interval
};

// Returns the summary of the intervals that begin in the shift. Stops without a reason up to `shortMs` are
// one reason.
[[nodiscard]] ShiftSummary summarize(const store::StopLog::Span& span, const Shift& shift, qint64 shortMs);

} // namespace campanel::panel
