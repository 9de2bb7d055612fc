// SPDX-License-Identifier: Apache-2.0
// A stand-in of NetworkManager with two wired ports: the same objects, methods and refusals, as far as the
// panel uses them.
#pragma once

#include "app/panel/settings/system_network.h"
#include "tests/support/peer_bus.h"

#include <QDBusArgument>
#include <QDBusContext>
#include <QDBusMetaType>
#include <QDBusObjectPath>

#include <array>

namespace campanel::test {

struct NetworkPort {
    QString name;
    panel::NetworkGroups settings; // empty: no cable
    bool isManaged = true;
    QVariantMap lease; // what IP4Config says
    uint activation = 0;
    uint state = 0; // of the activation; 0: it is gone
};

// org.freedesktop.NetworkManager
class NetworkService : public QObject, protected QDBusContext {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.freedesktop.NetworkManager")

public:
    using Maps = QList<QVariantMap>;

    NetworkService()
    {
        // The bus looks types up by the names of the slots.
        qRegisterMetaType<panel::NetworkGroups>("campanel::panel::NetworkGroups");
        qDBusRegisterMetaType<QMap<QString, uint>>();
        ports[0].name = QStringLiteral("eth0");
        ports[1].name = QStringLiteral("eth1");
        ports[0].settings = {
            {QStringLiteral("connection"), {{QStringLiteral("id"), QStringLiteral("Wired")}}},
            {QStringLiteral("ipv4"), {{QStringLiteral("method"), QStringLiteral("auto")}}}};
        connectPort(0);
    }

    std::array<NetworkPort, 2> ports;
    bool m_isForbidden = false;
    bool m_hasDhcpServer = true;
    bool m_failsRollback = false;
    QString m_usedAddress; // by another device
    QString m_updateError;
    QStringList m_calls;
    std::optional<NetworkPort> m_checkpoint; // of the first port

    [[nodiscard]] static QString path(const QString& kind, uint number)
    {
        return QStringLiteral("/org/freedesktop/NetworkManager/%1/%2").arg(kind).arg(number);
    }
    [[nodiscard]] QVariantMap ipv4() const { return ports[0].settings[QStringLiteral("ipv4")]; }
    [[nodiscard]] Maps addressData() const
    {
        return qdbus_cast<Maps>(ipv4()[QStringLiteral("address-data")]);
    }

    // Returns true when the call is refused.
    bool isRefused(QDBusContext& call, const QString& method)
    {
        m_calls << method;
        if (m_isForbidden)
            call.sendErrorReply(QStringLiteral("org.freedesktop.NetworkManager.PermissionDenied"),
                                QStringLiteral("Insufficient privileges"));
        return m_isForbidden;
    }

public slots:
    QDBusObjectPath CheckpointCreate(const QList<QDBusObjectPath>& devices, uint timeoutS, uint flags)
    {
        if (isRefused(*this, QStringLiteral("CheckpointCreate")))
            return {};
        if (m_checkpoint || timeoutS == 0 || flags != 0 ||
            devices != QList{QDBusObjectPath(path(QStringLiteral("Devices"), 0))})
            sendErrorReply(QStringLiteral("org.freedesktop.NetworkManager.InvalidArguments"),
                           QStringLiteral("overlapping checkpoint"));
        m_checkpoint = ports[0];
        return QDBusObjectPath(path(QStringLiteral("Checkpoint"), 1));
    }
    void CheckpointDestroy(const QDBusObjectPath&)
    {
        if (!isRefused(*this, QStringLiteral("CheckpointDestroy")))
            m_checkpoint.reset();
    }
    QMap<QString, uint> CheckpointRollback(const QDBusObjectPath&)
    {
        if (isRefused(*this, QStringLiteral("CheckpointRollback")))
            return {};
        if (m_failsRollback || !m_checkpoint) {
            sendErrorReply(QStringLiteral("org.freedesktop.NetworkManager.Failed"),
                           QStringLiteral("no checkpoint"));
            return {};
        }
        ports[0].settings = m_checkpoint->settings;
        m_checkpoint.reset();
        connectPort(0);
        return {{path(QStringLiteral("Devices"), 0), 0}};
    }
    QDBusObjectPath ActivateConnection(const QDBusObjectPath&, const QDBusObjectPath&, const QDBusObjectPath&)
    {
        if (isRefused(*this, QStringLiteral("ActivateConnection")))
            return {};
        connectPort(0);
        return QDBusObjectPath(path(QStringLiteral("ActiveConnection"), ports[0].activation));
    }

public:
    void connectPort(std::size_t number)
    {
        NetworkPort& port = ports.at(number);
        const QVariantMap ipv4 = port.settings.value(QStringLiteral("ipv4"));
        port.activation = ++m_activations;
        port.lease = {};
        if (ipv4[QStringLiteral("method")] == QStringLiteral("manual")) {
            const auto addresses = qdbus_cast<Maps>(ipv4[QStringLiteral("address-data")]);
            const bool isUsed = addresses.value(0)[QStringLiteral("address")] == m_usedAddress;
            port.state = isUsed ? 1 : 2;
            if (!isUsed)
                port.lease.insert(QStringLiteral("AddressData"), QVariant::fromValue(addresses));
        } else {
            port.state = m_hasDhcpServer ? 2 : 0;
            if (m_hasDhcpServer)
                port.lease = lease();
        }
    }

private:
    [[nodiscard]] static QVariantMap lease()
    {
        const auto address = [](const char* text) { return QString::fromLatin1(text); };
        return {{QStringLiteral("AddressData"),
                 QVariant::fromValue(Maps{{{QStringLiteral("address"), address("192.168.1.20")},
                                           {QStringLiteral("prefix"), 24U}}})},
                {QStringLiteral("Gateway"), address("192.168.1.1")},
                {QStringLiteral("NameserverData"),
                 QVariant::fromValue(Maps{{{QStringLiteral("address"), address("192.168.1.1")}},
                                          {{QStringLiteral("address"), address("9.9.9.9")}}})}};
    }

    uint m_activations = 0;
};

// org.freedesktop.DBus.ObjectManager: everything that NetworkManager has, in one answer.
class NetworkInventory : public QObject {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.freedesktop.DBus.ObjectManager")

public:
    explicit NetworkInventory(const NetworkService& service)
        : m_service(service)
    {
    }

public slots:
    campanel::panel::NetworkObjects GetManagedObjects() const
    {
        const QString root = QStringLiteral("org.freedesktop.NetworkManager");
        const auto object = [](const QString& path) { return QVariant::fromValue(QDBusObjectPath(path)); };
        panel::NetworkObjects objects;
        for (uint number = 0; number < m_service.ports.size(); ++number) {
            const NetworkPort& port = m_service.ports.at(number);
            const auto path = [number](const char* kind) {
                return NetworkService::path(QString::fromLatin1(kind), number);
            };
            const QString active = NetworkService::path(QStringLiteral("ActiveConnection"), port.activation);
            QList<QDBusObjectPath> usable;
            if (!port.settings.isEmpty())
                usable << QDBusObjectPath(path("Settings"));
            objects[QDBusObjectPath(path("Devices"))] = {
                {root + QStringLiteral(".Device"),
                 {{QStringLiteral("Interface"), port.name},
                  {QStringLiteral("DeviceType"), 1U},
                  {QStringLiteral("Managed"), port.isManaged},
                  {QStringLiteral("ActiveConnection"), object(port.state > 0 ? active : QStringLiteral("/"))},
                  {QStringLiteral("Ip4Config"), object(path("IP4Config"))},
                  {QStringLiteral("AvailableConnections"), QVariant::fromValue(usable)}}}};
            objects[QDBusObjectPath(path("IP4Config"))] = {{root + QStringLiteral(".IP4Config"), port.lease}};
            if (port.state > 0) {
                objects[QDBusObjectPath(active)] = {
                    {root + QStringLiteral(".Connection.Active"),
                     {{QStringLiteral("State"), port.state},
                      {QStringLiteral("Connection"), object(path("Settings"))}}}};
            }
        }
        return objects;
    }

private:
    const NetworkService& m_service;
};

// org.freedesktop.NetworkManager.Settings.Connection of the first port
class NetworkConnection : public QObject, protected QDBusContext {
    Q_OBJECT
    Q_CLASSINFO("D-Bus Interface", "org.freedesktop.NetworkManager.Settings.Connection")

public:
    explicit NetworkConnection(NetworkService& service)
        : m_service(service)
    {
    }

public slots:
    campanel::panel::NetworkGroups GetSettings() const { return m_service.ports[0].settings; }
    QVariantMap Update2(const campanel::panel::NetworkGroups& settings, uint, const QVariantMap&)
    {
        if (m_service.isRefused(*this, QStringLiteral("Update2")))
            return {};
        if (m_service.m_updateError.isEmpty())
            m_service.ports[0].settings = settings;
        else
            sendErrorReply(
                QStringLiteral("org.freedesktop.NetworkManager.Settings.Connection.InvalidProperty"),
                m_service.m_updateError);
        return {};
    }

private:
    NetworkService& m_service;
};

class NetworkBus : public PeerBus {
    Q_OBJECT

public:
    NetworkBus()
    {
        add(QStringLiteral("/org/freedesktop"), m_inventory);
        add(QStringLiteral("/org/freedesktop/NetworkManager"), service);
        add(NetworkService::path(QStringLiteral("Settings"), 0), m_connection);
    }

    NetworkService service;

private:
    NetworkInventory m_inventory{service};
    NetworkConnection m_connection{service};
};

} // namespace campanel::test
