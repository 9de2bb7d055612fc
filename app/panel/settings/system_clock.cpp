// SPDX-License-Identifier: Apache-2.0
#include "app/panel/settings/system_clock.h"

#include "app/panel/kit/access_check.h"
#include "app/panel/kit/engine_instances.h"
#include "app/panel/kit/language_notifier.h"

#include <QDBusError>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDateTime>
#include <QTimeZone>

#include <utility>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

const QString timedateInterface = QStringLiteral("org.freedesktop.timedate1");
const QString timedatePath = QStringLiteral("/org/freedesktop/timedate1");
constexpr int patienceMs = 5000;
constexpr qint64 usPerMinute = 60'000'000;
constexpr bool isInteractive = false; // nobody can answer a question of polkit on a kiosk

QString offsetText(const QByteArray& zone)
{
    const int minutes = QTimeZone(zone).standardTimeOffset(QDateTime::currentDateTimeUtc()) / 60;
    return u"UTC%1%2:%3"_s.arg(QChar(minutes < 0 ? u'-' : u'+'))
        .arg(std::abs(minutes) / 60, 2, 10, QLatin1Char('0'))
        .arg(std::abs(minutes) % 60, 2, 10, QLatin1Char('0'));
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
    : QObject(parent)
    , m_check(check)
    , m_bus{[] { return QDBusConnection::systemBus(); }, timedateInterface}
{
    m_timer.setInterval(2s);
    m_timer.callOnTimeout(this, &SystemClock::ask);
    connect(LanguageNotifier::ofApplication(), &LanguageNotifier::languageChanged, this,
            &SystemClock::changed);
}

SystemClock* SystemClock::create(QQmlEngine* qmlEngine, QJSEngine*)
{
    return attachedInstance<SystemClock>(qmlEngine);
}

void SystemClock::setWatched(bool isWatched)
{
    if (m_isWatched == isWatched)
        return;
    m_isWatched = isWatched;
    m_problem.clear();
    if (isWatched) {
        m_isAsked = m_isAvailable = false; // the service may have come or gone
        m_timer.start();
        ask();
    } else {
        m_timer.stop();
    }
    emit changed();
}

QDBusMessage SystemClock::callOf(const QString& interface, const QString& method) const
{
    return QDBusMessage::createMethodCall(m_bus.service, timedatePath, interface, method);
}

// A call without a bus would never end.
QDBusPendingCall SystemClock::send(const QDBusMessage& call) const
{
    const QDBusConnection bus = m_bus.connect();
    return bus.isConnected() ? bus.asyncCall(call, patienceMs)
                             : QDBusPendingCall::fromError({QDBusError::Disconnected, u"no D-Bus"_s});
}

void SystemClock::ask()
{
    if (std::exchange(m_isAsking, true))
        return;
    QDBusMessage call = callOf(u"org.freedesktop.DBus.Properties"_s, u"GetAll"_s);
    call << timedateInterface;
    auto* watcher = new QDBusPendingCallWatcher(send(call), this);
    connect(watcher, &QDBusPendingCallWatcher::finished, this, [this](QDBusPendingCallWatcher* finished) {
        finished->deleteLater();
        take(*finished);
    });
}

void SystemClock::take(const QDBusPendingCall& answer)
{
    const QDBusPendingReply<QVariantMap> reply(answer);
    const QVariantMap values = reply.isError() ? QVariantMap() : reply.value();
    m_isAsking = false;
    m_isAsked = true;
    m_isAvailable = values.contains(u"Timezone"_s);
    m_zone = values.value(u"Timezone"_s).toString();
    m_canUseTimeServer = values.value(u"CanNTP"_s).toBool();
    m_usesTimeServer = values.value(u"NTP"_s).toBool();
    m_isSynchronized = values.value(u"NTPSynchronized"_s).toBool();
    emit changed();
}

QString SystemClock::stateText() const
{
    if (!m_isAsked)
        return tr("Asking the operating system …");
    if (!m_isAvailable)
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
    apply({u"SetTime"_s,
           {minutes * usPerMinute, true, isInteractive},
           u"clock"_s,
           utcText(now),
           utcText(now.addSecs(qint64{60} * minutes))});
}

void SystemClock::setUsesTimeServer(bool isUsed)
{
    if (isUsed != m_usesTimeServer)
        apply({u"SetNTP"_s, {isUsed, isInteractive}, u"time_server"_s, onOff(!isUsed), onOff(isUsed)});
}

void SystemClock::setZone(const QString& zone)
{
    if (zone != m_zone)
        apply({u"SetTimezone"_s, {zone, isInteractive}, u"time_zone"_s, m_zone, zone});
}

void SystemClock::apply(const Change& change)
{
    if (m_isBusy || !m_check.require(Level::Service))
        return;
    m_isBusy = true;
    m_problem.clear();
    emit changed();
    QDBusMessage call = callOf(timedateInterface, change.method);
    call.setArguments(change.arguments);
    auto* watcher = new QDBusPendingCallWatcher(send(call), this);
    connect(watcher, &QDBusPendingCallWatcher::finished, this,
            [this, change](QDBusPendingCallWatcher* finished) {
                finished->deleteLater();
                finish(change, *finished);
            });
}

void SystemClock::finish(const Change& change, const QDBusPendingCall& answer)
{
    m_isBusy = false;
    const QDBusError error = answer.error();
    if (error.isValid()) {
        const bool isForbidden =
            error.type() == QDBusError::AccessDenied ||
            error.name() == u"org.freedesktop.DBus.Error.InteractiveAuthorizationRequired";
        m_problem = isForbidden
                        ? tr("The operating system does not allow the panel to do this. Install polkit "
                             "and the rule of the CamPanel package.")
                        : tr("Not set: %1").arg(error.message());
    }
    store::AuditEntry entry;
    entry.what = u"setting.change"_s;
    entry.object = change.object;
    entry.before = change.before;
    entry.after = change.after;
    entry.outcome = error.isValid() ? u"failed"_s : u"done"_s;
    emit noted(entry);
    if (!error.isValid() && change.object == u"clock")
        emit moved();
    emit changed();
    ask();
}

} // namespace campanel::panel
