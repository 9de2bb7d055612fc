// SPDX-License-Identifier: Apache-2.0
// A stand-in of systemd-timedated, and a connection to it between two ends of this program.
#pragma once

#include "app/panel/settings/system_clock.h"

#include <QDBusConnection>
#include <QDBusContext>
#include <QDBusServer>
#include <QObject>

#include <optional>

namespace campanel::test {

// org.freedesktop.timedate1 with the same methods, properties and refusals.
class TimeService : public QObject, protected QDBusContext {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.freedesktop.timedate1")
    Q_PROPERTY(QString Timezone MEMBER m_zone)
    Q_PROPERTY(bool CanNTP MEMBER m_canNtp)
    Q_PROPERTY(bool NTP MEMBER m_ntp)
    Q_PROPERTY(bool NTPSynchronized MEMBER m_isSynchronized)

public:
    QString m_zone = QStringLiteral("Europe/Berlin");
    bool m_canNtp = true;
    bool m_ntp = false;
    bool m_isSynchronized = false;
    bool m_isForbidden = false;
    qint64 m_movedUs = 0;

public slots:
    void SetTime(qlonglong us, bool isRelative, bool isInteractive)
    {
        if (isRefused(isInteractive))
            return;
        if (m_ntp || !isRelative)
            sendErrorReply(QStringLiteral("org.freedesktop.timedate1.AutomaticTimeSyncEnabled"),
                           QStringLiteral("Automatic time synchronization is enabled"));
        else
            m_movedUs += us;
    }
    void SetTimezone(const QString& zone, bool isInteractive)
    {
        if (!isRefused(isInteractive))
            m_zone = zone;
    }
    void SetNTP(bool isUsed, bool isInteractive)
    {
        if (!isRefused(isInteractive))
            m_ntp = isUsed;
    }

private:
    bool isRefused(bool isInteractive)
    {
        if (m_isForbidden || isInteractive)
            sendErrorReply(QStringLiteral("org.freedesktop.DBus.Error.InteractiveAuthorizationRequired"),
                           QStringLiteral("Interactive authentication required."));
        return m_isForbidden || isInteractive;
    }
};

// A bus with the service alone.
class TimeBus : public QObject {
    Q_OBJECT

public:
    TimeBus()
        : m_name(QStringLiteral("time%1").arg(reinterpret_cast<quintptr>(this)))
    {
        connect(&m_server, &QDBusServer::newConnection, this, [this](const QDBusConnection& connection) {
            m_serviceSide = connection;
            m_serviceSide->registerObject(QStringLiteral("/org/freedesktop/timedate1"), &service,
                                          QDBusConnection::ExportAllSlots |
                                              QDBusConnection::ExportAllProperties);
        });
        QDBusConnection::connectToPeer(m_server.address(), m_name);
    }
    ~TimeBus() override { QDBusConnection::disconnectFromPeer(m_name); }

    [[nodiscard]] panel::SystemClock::Bus bus() const
    {
        return {[name = m_name] { return QDBusConnection(name); }, {}};
    }

    TimeService service;

private:
    QString m_name;
    QDBusServer m_server{QStringLiteral("unix:tmpdir=/tmp")};
    std::optional<QDBusConnection> m_serviceSide;
};

} // namespace campanel::test
