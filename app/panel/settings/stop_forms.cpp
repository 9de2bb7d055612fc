// SPDX-License-Identifier: Apache-2.0
#include "app/panel/settings/stop_forms.h"

#include <QMap>
#include <QSet>
#include <QStringList>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

const QString plannedPrefix = u"planned:"_s;

const QString standardReasons = uR"(material
material/film_change
material/film_torn
material/no_product
material/product_jam
machine
machine/film_jam
machine/knife
machine/sensor
machine/adjustment
quality
quality/seal
quality/length
quality/print
changeover
cleaning
planned:maintenance
planned:break
planned:no_order)"_s;

bool isReasonWord(const QString& word)
{
    return !word.isEmpty() && word.size() <= maxReasonLength && word == word.simplified();
}

} // namespace

QList<QTime> shiftStartsIn(const QString& text)
{
    constexpr int quarter = 15;
    QList<QTime> starts;
    for (const QString& each : text.split(u' ')) {
        const QTime start = QTime::fromString(each, u"HH:mm"_s);
        const bool isAfter = starts.isEmpty() || start > starts.last();
        if (!start.isValid() || start.minute() % quarter != 0 || !isAfter || starts.size() == maxShifts)
            return {};
        starts << start;
    }
    return starts;
}

QString shiftStartsText(const QList<QTime>& starts)
{
    QStringList texts;
    for (const QTime& start : starts)
        texts << start.toString(u"HH:mm"_s);
    return texts.join(u' ');
}

QList<int> workingDaysIn(const QString& text)
{
    QList<int> days;
    for (const QChar letter : text) {
        const int day = letter.digitValue();
        if (day < 1 || day > 7 || (!days.isEmpty() && day <= days.last()))
            return {};
        days << day;
    }
    return days;
}

QString workingDaysText(const QList<int>& days)
{
    QString text;
    for (const int day : days)
        text += QString::number(day);
    return text;
}

QList<StopReason> stopReasonsIn(const QString& text)
{
    QList<StopReason> reasons;
    QMap<QString, int> sizes; // by group
    QSet<QString> keys;
    for (QString line : (text.isEmpty() ? standardReasons : text).split(u'\n')) {
        StopReason reason;
        reason.isPlanned = line.startsWith(plannedPrefix);
        if (reason.isPlanned)
            line.remove(0, plannedPrefix.size());
        reason.group = line.section(u'/', 0, 0);
        reason.name = line.section(u'/', 1);
        const bool isGroup = !line.contains(u'/');
        const bool hasWords = isReasonWord(reason.group) && (isGroup || isReasonWord(reason.name)) &&
                              !reason.name.contains(u'/');
        if (!hasWords || keys.contains(reason.key()) || isGroup == sizes.contains(reason.group))
            return {};
        keys.insert(reason.key());
        if (isGroup)
            sizes.insert(reason.group, 0);
        else if (++sizes[reason.group] > maxReasons)
            return {};
        reasons << reason;
    }
    return sizes.size() <= maxReasons ? reasons : QList<StopReason>();
}

QString stopReasonsText(const QList<StopReason>& reasons)
{
    QStringList lines;
    for (const StopReason& reason : reasons)
        lines << (reason.isPlanned ? plannedPrefix : QString()) + reason.key();
    return lines.join(u'\n');
}

} // namespace campanel::panel
