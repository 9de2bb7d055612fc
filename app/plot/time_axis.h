// SPDX-License-Identifier: Apache-2.0
// Where the ticks of a time axis stand and what is written at them: round local times, seconds to days.
#pragma once

#include <QList>
#include <QLocale>
#include <QString>

namespace campanel::plot {

struct TimeTick {
    double timeMs = 0; // since 1970 UTC
    QString text;
};

// At most `most` ticks (at least 2) in the window, on round times of the computer's time zone. A tick at
// midnight has the date, the others the time; from days on each has the date.
[[nodiscard]] QList<TimeTick> timeTicks(double fromMs, double toMs, int most, const QLocale& locale);
// "15 Jan", "1月15日".
[[nodiscard]] QString shortDate(const QDate& date, const QLocale& locale);
// A time as it is read at a cursor, the more exact the shorter the window: date, hours, minutes, seconds.
[[nodiscard]] QString momentText(double timeMs, double spanMs, const QLocale& locale);

} // namespace campanel::plot
