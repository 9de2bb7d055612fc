// SPDX-License-Identifier: Apache-2.0
// The ticks of a time axis and their labels: round local times, from seconds to days.
#pragma once

#include <QList>
#include <QLocale>
#include <QString>

namespace campanel::plot {

struct TimeTick {
    double timeMs = 0; // since 1970 UTC
    QString text;
};

// Returns at most `maxTicks` ticks (at least 2) in the window, at round times of the computer's time zone. A
// tick at midnight has the date, the others the time; with steps of days each has the date. In the hour that
// the end of summer time repeats the first tick of each pass names its zone.
[[nodiscard]] QList<TimeTick> timeTicks(double fromMs, double toMs, int maxTicks, const QLocale& locale);
// Returns "15 Jan", "1月15日".
[[nodiscard]] QString shortDate(const QDate& date, const QLocale& locale);
// Returns a time for a cursor, with a precision that depends on the window: date, hours, minutes, seconds,
// and the zone where the time alone is ambiguous.
[[nodiscard]] QString momentText(double timeMs, double spanMs, const QLocale& locale);

} // namespace campanel::plot
