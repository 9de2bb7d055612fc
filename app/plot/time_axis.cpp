// SPDX-License-Identifier: Apache-2.0
#include "app/plot/time_axis.h"

#include <QDateTime>

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

namespace campanel::plot {

namespace {

constexpr qint64 minute = 60;
constexpr qint64 hour = 3600;
constexpr qint64 day = 24 * hour;
constexpr std::array<qint64, 20> roundSteps{1,           2,           5,          10,         15,
                                            30,          minute,      2 * minute, 5 * minute, 10 * minute,
                                            15 * minute, 30 * minute, hour,       2 * hour,   3 * hour,
                                            6 * hour,    12 * hour,   day,        2 * day,    5 * day};
constexpr double msPerSecond = 1000;

qint64 stepFor(double spanMs, int maxTicks)
{
    const auto fits = std::ranges::find_if(roundSteps, [&](qint64 step) {
        return spanMs / (msPerSecond * static_cast<double>(step)) < maxTicks;
    });
    return fits == roundSteps.end() ? roundSteps.back() : *fits;
}

// Returns the last round time before `time`, counted from local midnight or, for steps of days, from a fixed
// day.
QDateTime roundBefore(const QDateTime& time, qint64 step)
{
    const QDate date = time.date();
    if (step >= day)
        return QDateTime(date.addDays(-(date.toJulianDay() % (step / day))), QTime(0, 0));
    const qint64 seconds = time.time().msecsSinceStartOfDay() / 1000;
    // Not from date and time: at the end of summer time an hour has them twice.
    if (step <= hour)
        return time.addMSecs(-time.time().msec()).addSecs(-(seconds % step));
    return QDateTime(date, QTime(0, 0).addSecs(static_cast<int>(seconds / step * step)));
}

// Returns the next one, by the clock, so that a day of 23 hours has its ticks at the same times.
QDateTime roundAfter(const QDateTime& tick, qint64 step)
{
    if (step >= day)
        return QDateTime(tick.date().addDays(step / day), QTime(0, 0));
    if (step <= hour)
        return tick.addSecs(step);
    const qint64 next = tick.time().msecsSinceStartOfDay() / 1000 + step;
    return QDateTime(tick.date().addDays(next / day), QTime(0, 0).addSecs(static_cast<int>(next % day)));
}

// Returns true in the hour that the end of summer time repeats, for both of them.
bool isRepeated(const QDateTime& time)
{
    return time.addSecs(hour).time() == time.time() || time.addSecs(-hour).time() == time.time();
}

QString clockText(const QDateTime& time, const QString& form, bool isZoneNeeded)
{
    const QString text = time.toString(form);
    return isZoneNeeded ? text + u' ' + time.timeZoneAbbreviation() : text;
}

} // namespace

QString shortDate(const QDate& date, const QLocale& locale)
{
    return locale.toString(date, locale.language() == QLocale::Chinese ? u"M月d日"_s : u"d MMM"_s);
}

QString momentText(double timeMs, double spanMs, const QLocale& locale)
{
    const QDateTime time = QDateTime::fromMSecsSinceEpoch(std::llround(timeMs));
    const bool needsSeconds = spanMs < 4 * hour * msPerSecond;
    return shortDate(time.date(), locale) + u' ' +
           clockText(time, needsSeconds ? u"HH:mm:ss"_s : u"HH:mm"_s, isRepeated(time));
}

QList<TimeTick> timeTicks(double fromMs, double toMs, int maxTicks, const QLocale& locale)
{
    QList<TimeTick> ticks;
    if (!(toMs > fromMs))
        return ticks;
    const qint64 step = stepFor(toMs - fromMs, std::max(2, maxTicks));
    int zoneS = -1; // offset of the last tick that names its zone
    QDateTime tick = roundBefore(QDateTime::fromMSecsSinceEpoch(std::llround(std::ceil(fromMs))), step);
    for (; static_cast<double>(tick.toMSecsSinceEpoch()) <= toMs; tick = roundAfter(tick, step)) {
        const auto at = static_cast<double>(tick.toMSecsSinceEpoch());
        if (at < fromMs)
            continue;
        const bool isMidnight = tick.time() == QTime(0, 0);
        const bool isZoneNeeded = isRepeated(tick) && tick.offsetFromUtc() != zoneS;
        if (isZoneNeeded)
            zoneS = tick.offsetFromUtc();
        const QString text = step >= day || isMidnight
                                 ? shortDate(tick.date(), locale)
                                 : clockText(tick, step < minute ? u"HH:mm:ss"_s : u"HH:mm"_s, isZoneNeeded);
        ticks << TimeTick{at, text};
    }
    return ticks;
}

} // namespace campanel::plot
