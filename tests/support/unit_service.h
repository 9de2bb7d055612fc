// SPDX-License-Identifier: Apache-2.0
// A stand-in of systemd's manager.
#pragma once

#include "tests/support/peer_bus.h"

#include <QDBusContext>
#include <QDBusObjectPath>
#include <QObject>

#include <functional>

namespace campanel::test {

// org.freedesktop.systemd1.Manager with the units that the panel may start.
class UnitService : public QObject, protected QDBusContext {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.freedesktop.systemd1.Manager")

public:
    QString m_fileState = QStringLiteral("enabled"); // empty: there are no such units
    bool m_isForbidden = false;
    QStringList m_started;
    std::function<void()> m_work; // of the unit

public slots:
    QString GetUnitFileState(const QString& unit)
    {
        const QStringList units{QStringLiteral("campanel-update.service"),
                                QStringLiteral("campanel-touch.service")};
        if (m_fileState.isEmpty() || !units.contains(unit))
            sendErrorReply(QStringLiteral("org.freedesktop.DBus.Error.FileNotFound"),
                           QStringLiteral("No such file or directory"));
        return m_fileState;
    }
    QDBusObjectPath StartUnit(const QString& unit, const QString& mode)
    {
        if (m_isForbidden) {
            sendErrorReply(QStringLiteral("org.freedesktop.DBus.Error.InteractiveAuthorizationRequired"),
                           QStringLiteral("Interactive authentication required."));
            return QDBusObjectPath(QStringLiteral("/"));
        }
        m_started << unit + u' ' + mode;
        if (m_work)
            m_work();
        return QDBusObjectPath(QStringLiteral("/org/freedesktop/systemd1/job/1"));
    }
};

class UnitBus : public PeerBus {
    Q_OBJECT

public:
    UnitBus() { add(QStringLiteral("/org/freedesktop/systemd1"), service); }

    UnitService service;
};

} // namespace campanel::test
