// SPDX-License-Identifier: Apache-2.0
// The rows of a shift: stretches of the bar, reasons by their time, stops.
#pragma once

#include "app/panel/kit/format.h"
#include "app/panel/kit/row_model.h"
#include "app/panel/stops/shift_summary.h"
#include "app/panel/words/alarm_words.h"
#include "app/panel/words/stop_words.h"

#include <QDateTime>

namespace campanel::panel {

struct BarRow {
    Q_GADGET
    Q_PROPERTY(double from READ from)
    Q_PROPERTY(double share READ share)
    Q_PROPERTY(int kind READ kind)

public:
    // The states that look alike.
    enum Kind { Producing, Standing, Waiting, Manual, Faulted };
    Q_ENUM(Kind)

    BarStretch stretch;
    int number = 0;

    [[nodiscard]] double from() const { return stretch.from; }
    [[nodiscard]] double share() const { return stretch.width; }
    [[nodiscard]] int kind() const { return kindOf(stretch.state); }
    [[nodiscard]] static Kind kindOf(store::StateInterval::State state);
    bool operator==(const BarRow&) const = default;
};

struct ReasonRow {
    Q_GADGET
    Q_PROPERTY(QString text READ text)
    Q_PROPERTY(QString durationText READ durationText)
    Q_PROPERTY(double share MEMBER share)
    Q_PROPERTY(bool isPlanned READ isPlanned)
    Q_PROPERTY(bool isOpen READ isOpen)

public:
    ReasonShare value;
    double share = 0;   // of the longest one
    qint64 shortMs = 0; // stops up to this time are short

    [[nodiscard]] QString id() const
    {
        return value.reason + (value.isShort ? QStringLiteral(" short") : QString()) +
               (value.isPlanned ? QStringLiteral(" planned") : QString());
    }
    [[nodiscard]] QString text() const;
    // Returns "23 min · 4×".
    [[nodiscard]] QString durationText() const;
    [[nodiscard]] bool isPlanned() const { return value.isPlanned; }
    // Returns true when its stops have no reason.
    [[nodiscard]] bool isOpen() const { return value.reason.isEmpty(); }
    bool operator==(const ReasonRow&) const = default;
};

struct StopListRow {
    Q_GADGET
    Q_PROPERTY(QString time READ time)
    Q_PROPERTY(QString clockNote READ clockNote)
    Q_PROPERTY(QString durationText READ durationText)
    Q_PROPERTY(QString reasonText READ reasonText)
    Q_PROPERTY(QString stateText READ stateText)
    Q_PROPERTY(QString by READ by)
    Q_PROPERTY(bool isOpen READ isOpen)

public:
    ShiftStop stop;

    [[nodiscard]] qint64 id() const { return stop.id; }
    [[nodiscard]] QString time() const
    {
        return Format::local(QDateTime::fromMSecsSinceEpoch(stop.beginMs), QStringLiteral("HH:mm:ss"));
    }
    [[nodiscard]] QString clockNote() const { return AlarmWords::clockNote(stop.isClockDoubtful); }
    [[nodiscard]] QString durationText() const { return StopWords::duration(stop.durationMs); }
    [[nodiscard]] QString reasonText() const { return StopWords::reason(stop.answer.reason); }
    [[nodiscard]] QString stateText() const { return StopWords::state(stop.state); }
    [[nodiscard]] QString by() const { return stop.answer.by; }
    [[nodiscard]] bool isOpen() const { return stop.answer.reason.isEmpty(); }
    bool operator==(const StopListRow&) const = default;
};

using BarRows = RowModel<BarRow, &BarRow::number>;
using ReasonRows = RowModel<ReasonRow, &ReasonRow::id>;
using StopRows = RowModel<StopListRow, &StopListRow::id>;

} // namespace campanel::panel
