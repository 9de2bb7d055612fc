// SPDX-License-Identifier: Apache-2.0
// The shifts of a plant: they begin at local times of the day and follow one another without a gap. A change
// to or from daylight saving makes a shift an hour shorter or longer.
#pragma once

#include "app/panel/settings/stop_forms.h"

#include <QDate>
#include <QTimeZone>

namespace campanel::panel {

struct Shift {
    qint64 beginMs = 0; // since 1970 UTC
    qint64 endMs = 0;
    bool isWorking = true; // its day is one of the working days

    [[nodiscard]] qint64 durationMs() const { return endMs - beginMs; }
    bool operator==(const Shift&) const = default;
};

class ShiftCalendar {
public:
    // Takes at least one time of the day, and the working days, 1: Monday.
    ShiftCalendar(QList<QTime> starts, QList<int> workingDays, QTimeZone zone);

    // Returns the shift in which this moment lies.
    [[nodiscard]] Shift at(qint64 utcMs) const;
    [[nodiscard]] Shift after(const Shift& shift) const { return at(shift.endMs); }
    [[nodiscard]] Shift before(const Shift& shift) const { return at(shift.beginMs - 1); }

private:
    // Returns the begins of shifts from two days before to two days after, ascending.
    [[nodiscard]] QList<qint64> beginsAround(QDate day) const;

    QList<QTime> m_starts;
    QList<int> m_workingDays;
    QTimeZone m_zone;
};

} // namespace campanel::panel
