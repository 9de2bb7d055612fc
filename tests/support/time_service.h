// SPDX-License-Identifier: Apache-2.0
// A stand-in of systemd-timedated.
#pragma once

#include "tests/support/peer_bus.h"

#include <QDBusContext>

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

class TimeBus : public PeerBus {
    Q_OBJECT

public:
    TimeBus() { add(QStringLiteral("/org/freedesktop/timedate1"), service); }

    TimeService service;
};

} // namespace campanel::test
