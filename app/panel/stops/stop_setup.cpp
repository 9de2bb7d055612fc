// SPDX-License-Identifier: Apache-2.0
#include "app/panel/stops/stop_setup.h"

#include "app/panel/kit/language_notifier.h"
#include "app/panel/settings/settings.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

constexpr int quarterMinutes = 15;
constexpr int dayMinutes = 24 * 60;
constexpr int secondsPerMinute = 60;
constexpr int daysPerWeek = 7;

int minutesOf(const QTime& time)
{
    return time.msecsSinceStartOfDay() / 1000 / secondsPerMinute;
}

QTime timeAt(int minutes)
{
    return QTime(minutes / secondsPerMinute, minutes % secondsPerMinute);
}

} // namespace

StopSetup::StopSetup(Settings& settings)
    : m_settings(settings)
    , m_reasons(settings)
{
    connect(&settings, &Settings::changed, this, &StopSetup::update);
    LanguageNotifier::follow(this, &StopSetup::update);
    update();
}

void StopSetup::update()
{
    const QList<QTime> starts = times();
    QList<ShiftStartRow> rows;
    for (qsizetype i = 0; i < starts.size(); ++i)
        rows << ShiftStartRow{
            static_cast<int>(i), minutesOf(starts[i]), i == 0 ? 0 : minutesOf(starts[i - 1]) + quarterMinutes,
            (i + 1 == starts.size() ? dayMinutes : minutesOf(starts[i + 1])) - quarterMinutes};
    m_starts.setRows(rows);
    emit changed();
}

QList<QTime> StopSetup::times() const
{
    return shiftStartsIn(m_settings.values().text("stops.shift_starts"));
}

QString StopSetup::shiftsText() const
{
    return m_settings.values().text("stops.shift_starts").replace(u' ', u" · "_s);
}

QString StopSetup::daysText() const
{
    const QStringList names = dayNames();
    const QList<int> days = workingDays();
    if (days.size() == daysPerWeek)
        return tr("every day");
    QStringList chosen;
    for (const int day : days)
        chosen << names[day - 1];
    return chosen.join(u' ');
}

QString StopSetup::reasonsText() const
{
    const QString text = m_settings.values().text("stops.reasons");
    return text.isEmpty() ? tr("standard list") : tr("own list (%1)").arg(stopReasonsIn(text).size());
}

bool StopSetup::canAddStart() const
{
    return m_starts.count() < maxShifts;
}

QStringList StopSetup::dayNames() const
{
    QStringList names;
    for (int day = 1; day <= daysPerWeek; ++day)
        names << QLocale().standaloneDayName(day, QLocale::ShortFormat);
    return names;
}

QList<int> StopSetup::workingDays() const
{
    return workingDaysIn(m_settings.values().text("stops.working_days"));
}

void StopSetup::moveStart(int row, int minutes)
{
    if (row < 0 || row >= m_starts.count())
        return;
    const ShiftStartRow& moved = m_starts.row(row);
    const int target = moved.minutes + minutes;
    if (target < moved.earliest || target > moved.latest)
        return;
    QList<QTime> starts = times();
    starts[row] = timeAt(target);
    m_settings.set("stops.shift_starts", shiftStartsText(starts));
}

void StopSetup::addStart()
{
    QList<QTime> starts = times();
    if (starts.size() >= maxShifts)
        return;
    int longest = 0;
    int middle = 0;
    for (qsizetype i = 0; i < starts.size(); ++i) {
        const int begin = minutesOf(starts[i]);
        const int end =
            i + 1 < starts.size() ? minutesOf(starts[i + 1]) : minutesOf(starts.first()) + dayMinutes;
        if (end - begin <= longest)
            continue;
        longest = end - begin;
        middle = (begin + longest / 2) % dayMinutes;
    }
    starts << timeAt(middle - middle % quarterMinutes);
    std::ranges::sort(starts);
    m_settings.set("stops.shift_starts", shiftStartsText(starts));
}

void StopSetup::removeStart(int row)
{
    QList<QTime> starts = times();
    if (row < 0 || row >= starts.size() || starts.size() == 1)
        return;
    starts.removeAt(row);
    m_settings.set("stops.shift_starts", shiftStartsText(starts));
}

void StopSetup::toggleDay(int day)
{
    if (day < 1 || day > daysPerWeek)
        return;
    QList<int> days = workingDays();
    if (days == QList<int>{day})
        return;
    if (days.removeAll(day) == 0)
        days << day;
    std::ranges::sort(days);
    m_settings.set("stops.working_days", workingDaysText(days));
}

} // namespace campanel::panel
