// SPDX-License-Identifier: Apache-2.0
// A stand-in of systemd's manager, and a connection to it between two ends of this program.
#pragma once

#include "app/panel/update/software_update.h"

#include <QDBusConnection>
#include <QDBusContext>
#include <QDBusObjectPath>
#include <QDBusServer>
#include <QObject>

#include <functional>
#include <optional>

namespace campanel::test {

// org.freedesktop.systemd1.Manager with one unit.
class UnitService : public QObject, protected QDBusContext {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.freedesktop.systemd1.Manager")

public:
    QString m_fileState = QStringLiteral("enabled"); // empty: there is no such unit
    bool m_isForbidden = false;
    QStringList m_started;
    std::function<void()> m_work; // of the unit

public slots:
    QString GetUnitFileState(const QString& unit)
    {
        if (m_fileState.isEmpty() || unit != QStringLiteral("campanel-update.service"))
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

// A bus with the service alone.
class UnitBus : public QObject {
    Q_OBJECT

public:
    UnitBus()
        : m_name(QStringLiteral("unit%1").arg(reinterpret_cast<quintptr>(this)))
    {
        connect(&m_server, &QDBusServer::newConnection, this, [this](const QDBusConnection& connection) {
            m_serviceSide = connection;
            m_serviceSide->registerObject(QStringLiteral("/org/freedesktop/systemd1"), &service,
                                          QDBusConnection::ExportAllSlots);
        });
        QDBusConnection::connectToPeer(m_server.address(), m_name);
    }
    ~UnitBus() override { QDBusConnection::disconnectFromPeer(m_name); }

    [[nodiscard]] panel::SoftwareUpdate::Bus bus() const
    {
        return {[name = m_name] { return QDBusConnection(name); }, {}};
    }

    UnitService service;

private:
    QString m_name;
    QDBusServer m_server{QStringLiteral("unix:tmpdir=/tmp")};
    std::optional<QDBusConnection> m_serviceSide;
};

} // namespace campanel::test
