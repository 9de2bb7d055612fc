// SPDX-License-Identifier: Apache-2.0
#include "app/panel/settings/system_clock.h"

#include "app/panel/kit/format.h"

#include <QDBusError>
#include <QDBusPendingReply>
#include <QDateTime>
#include <QTimeZone>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

const QString timedateInterface = QStringLiteral("org.freedesktop.timedate1");
const QString timedatePath = QStringLiteral("/org/freedesktop/timedate1");
constexpr qint64 usPerMinute = 60'000'000;
constexpr bool isInteractive = false; // nobody can answer a question of polkit on a kiosk

QString offsetText(const QByteArray& zone)
{
    const int minutes = QTimeZone(zone).standardTimeOffset(QDateTime::currentDateTimeUtc()) / 60;
    return Format::utcOffset(minutes);
}

QString utcText(const QDateTime& moment)
{
    return moment.toUTC().toString(Qt::ISODate);
}

QString onOff(bool isOn)
{
    return isOn ? u"on"_s : u"off"_s;
}

} // namespace

SystemClock::SystemClock(AccessCheck& check, QObject* parent)
    : SystemService(check, timedateInterface, parent)
{
}

void SystemClock::ask()
{
    send({timedatePath, u"org.freedesktop.DBus.Properties"_s, u"GetAll"_s, {timedateInterface}},
         [this](const QDBusPendingCall& answer) { take(answer); });
}

void SystemClock::take(const QDBusPendingCall& answer)
{
    const QDBusPendingReply<QVariantMap> reply(answer);
    const QVariantMap values = reply.isError() ? QVariantMap() : reply.value();
    m_zone = values.value(u"Timezone"_s).toString();
    m_canUseTimeServer = values.value(u"CanNTP"_s).toBool();
    m_usesTimeServer = values.value(u"NTP"_s).toBool();
    m_isSynchronized = values.value(u"NTPSynchronized"_s).toBool();
    setAnswer(values.contains(u"Timezone"_s));
}

QString SystemClock::stateText() const
{
    if (!isAsked())
        return tr("Asking the operating system …");
    if (!available())
        return tr("systemd-timedated does not respond. Set the clock in the operating system.");
    if (!m_usesTimeServer)
        return tr("The clock is set by hand.");
    return m_isSynchronized ? tr("The clock follows a time server.")
                            : tr("No time server has responded yet. Check the network.");
}

QStringList SystemClock::regions()
{
    return {u"Africa"_s,    u"America"_s, u"Antarctica"_s, u"Asia"_s,    u"Atlantic"_s,
            u"Australia"_s, u"Europe"_s,  u"Indian"_s,     u"Pacific"_s, u"UTC"_s};
}

QVariantList SystemClock::zonesOf(const QString& region) const
{
    QVariantList zones;
    for (const QByteArray& id : QTimeZone::availableTimeZoneIds()) {
        const QString key = QString::fromLatin1(id);
        if (key != region && !key.startsWith(region + u'/'))
            continue;
        const QString city = key == region ? key : key.mid(region.size() + 1);
        zones << QVariantMap{
            {u"key"_s, key}, {u"text"_s, QString(city).replace(u'_', u' ')}, {u"note"_s, offsetText(id)}};
    }
    return zones;
}

void SystemClock::move(int minutes)
{
    const QDateTime now = QDateTime::currentDateTimeUtc();
    apply(u"SetTime"_s, {minutes * usPerMinute, true, isInteractive},
          {u"clock"_s, utcText(now), utcText(now.addSecs(qint64{60} * minutes))});
}

void SystemClock::setUsesTimeServer(bool isUsed)
{
    if (isUsed != m_usesTimeServer)
        apply(u"SetNTP"_s, {isUsed, isInteractive}, {u"time_server"_s, onOff(!isUsed), onOff(isUsed)});
}

void SystemClock::setZone(const QString& zone)
{
    if (zone != m_zone)
        apply(u"SetTimezone"_s, {zone, isInteractive}, {u"time_zone"_s, m_zone, zone});
}

void SystemClock::apply(const QString& method, const QVariantList& arguments, const Change& change)
{
    if (!begin())
        return;
    send({timedatePath, timedateInterface, method, arguments},
         [this, change](const QDBusPendingCall& answer) {
             const QString problem = problemOf(answer.error());
             finish(change, problem);
             if (problem.isEmpty() && change.object == u"clock")
                 emit moved();
         });
}

} // namespace campanel::panel
