// SPDX-License-Identifier: Apache-2.0
// A D-Bus between two ends of this program, with the objects of a stand-in of one service.
#pragma once

#include "app/panel/settings/system_service.h"

#include <QDBusConnection>
#include <QDBusServer>
#include <QObject>

#include <optional>
#include <utility>

namespace campanel::test {

class PeerBus : public QObject {
    Q_OBJECT

public:
    PeerBus()
        : m_name(QStringLiteral("peer%1").arg(reinterpret_cast<quintptr>(this)))
    {
        connect(&m_server, &QDBusServer::newConnection, this, [this](const QDBusConnection& connection) {
            m_serviceSide = connection;
            for (const auto& [path, object] : m_objects) {
                m_serviceSide->registerObject(
                    path, object, QDBusConnection::ExportAllSlots | QDBusConnection::ExportAllProperties);
            }
        });
        QDBusConnection::connectToPeer(m_server.address(), m_name);
    }
    ~PeerBus() override { QDBusConnection::disconnectFromPeer(m_name); }

    [[nodiscard]] panel::SystemService::Bus bus() const
    {
        return {[name = m_name] { return QDBusConnection(name); }, {}};
    }

protected:
    void add(const QString& path, QObject& object) { m_objects.append({path, &object}); }

private:
    QString m_name;
    QDBusServer m_server{QStringLiteral("unix:tmpdir=/tmp")};
    std::optional<QDBusConnection> m_serviceSide;
    QList<std::pair<QString, QObject*>> m_objects;
};

} // namespace campanel::test
