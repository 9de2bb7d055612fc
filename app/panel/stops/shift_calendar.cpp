// SPDX-License-Identifier: Apache-2.0
#include "app/panel/stops/shift_calendar.h"

#include <QDateTime>

#include <algorithm>

namespace campanel::panel {

ShiftCalendar::ShiftCalendar(QList<QTime> starts, QList<int> workingDays, QTimeZone zone)
    : m_starts(std::move(starts))
    , m_workingDays(std::move(workingDays))
    , m_zone(std::move(zone))
{
}

QList<qint64> ShiftCalendar::beginsAround(QDate day) const
{
    constexpr int daysAround = 2;
    QList<qint64> begins;
    for (int offset = -daysAround; offset <= daysAround; ++offset) {
        for (const QTime& start : m_starts)
            begins << QDateTime(day.addDays(offset), start, m_zone).toMSecsSinceEpoch();
    }
    // A time that daylight saving leaves out may fall on another one.
    std::ranges::sort(begins);
    begins.erase(std::unique(begins.begin(), begins.end()), begins.end());
    return begins;
}

Shift ShiftCalendar::at(qint64 utcMs) const
{
    const QList<qint64> begins = beginsAround(QDateTime::fromMSecsSinceEpoch(utcMs, m_zone).date());
    const auto end = std::ranges::upper_bound(begins, utcMs);
    const qint64 beginMs = *std::prev(end);
    const int day = QDateTime::fromMSecsSinceEpoch(beginMs, m_zone).date().dayOfWeek();
    return {beginMs, *end, m_workingDays.contains(day)};
}

} // namespace campanel::panel
