// SPDX-License-Identifier: Apache-2.0
// The rows of the lists of alarms: occurrences, live or in the log, and shelved alarms.
#pragma once

#include "app/panel/kit/row_model.h"
#include "app/panel/words/alarm_words.h"

#include <QDate>

namespace campanel::panel {

struct AlarmListRow {
    Q_GADGET
    Q_PROPERTY(QString code READ code)
    Q_PROPERTY(QString title READ title)
    Q_PROPERTY(int severity READ severity)
    Q_PROPERTY(QString time READ time)
    Q_PROPERTY(QString clockNote READ clockNote)
    Q_PROPERTY(QString stateText READ stateText)
    Q_PROPERTY(bool calls READ calls)
    Q_PROPERTY(bool live READ live)
    Q_PROPERTY(int times READ times)

public:
    store::AlarmRow alarm;
    QDate today; // times of other days include the date

    [[nodiscard]] qint64 id() const { return alarm.id; }
    [[nodiscard]] QString code() const { return alarm.code; }
    [[nodiscard]] QString title() const { return AlarmWords::title(alarm.code); }
    // Returns an Alarms.Severity.
    [[nodiscard]] int severity() const { return static_cast<int>(AlarmWords::severity(alarm.code)); }
    [[nodiscard]] QString time() const { return AlarmWords::time(alarm.raisedMs, today); }
    [[nodiscard]] QString clockNote() const { return AlarmWords::clockNote(alarm.isClockDoubtful); }
    // Returns "active, acknowledged", ...
    [[nodiscard]] QString stateText() const { return AlarmWords::state(alarm); }
    // Returns true if it needs to be acknowledged.
    [[nodiscard]] bool calls() const { return alarm.wantsAcknowledgement && alarm.acknowledgedMs == 0; }
    [[nodiscard]] bool live() const { return alarm.end == store::AlarmRow::End::Active; }
    [[nodiscard]] int times() const { return alarm.count; }

    bool operator==(const AlarmListRow&) const = default;
};

using AlarmList = RowModel<AlarmListRow, &AlarmListRow::id>;

struct ShelfRow {
    Q_GADGET
    Q_PROPERTY(QString code READ code)
    Q_PROPERTY(QString title READ title)
    Q_PROPERTY(QString until READ until)
    Q_PROPERTY(QString by READ by)

public:
    store::AlarmShelf shelf;
    QDate today;

    [[nodiscard]] QString code() const { return shelf.code; }
    [[nodiscard]] QString title() const { return AlarmWords::title(shelf.code); }
    [[nodiscard]] QString until() const { return AlarmWords::until(shelf.untilMs, today); }
    [[nodiscard]] QString by() const { return shelf.by; }

    bool operator==(const ShelfRow&) const = default;
};

using ShelvedAlarms = RowModel<ShelfRow, &ShelfRow::code>;

} // namespace campanel::panel
