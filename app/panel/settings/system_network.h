// SPDX-License-Identifier: Apache-2.0
// `SystemNetwork` in QML: sets the address of a network port of this computer, by DHCP or fixed, by
// NetworkManager on the D-Bus. For the level Service. Entries are a draft until apply(). NetworkManager keeps
// a checkpoint meanwhile: when the port does not get the address, or the panel ends, the old one is restored.
#pragma once

#include "app/panel/kit/singleton.h"
#include "app/panel/settings/network_address.h"
#include "app/panel/settings/system_service.h"

#include <QDBusObjectPath>
#include <QDeadlineTimer>
#include <QMap>
#include <QVariantMap>

#include <optional>
#include <utility>

namespace campanel::panel {

// The properties of an object of NetworkManager by interface, and the settings of a connection by group.
using NetworkGroups = QMap<QString, QVariantMap>;
using NetworkObjects = QMap<QDBusObjectPath, NetworkGroups>;

class SystemNetwork : public campanel::panel::SystemService, public Singleton<SystemNetwork> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // The ports that NetworkManager manages as {key, text, note}: "eth0", "eth0", "192.168.1.20".
    Q_PROPERTY(QVariantList ports READ ports NOTIFY changed FINAL)
    Q_PROPERTY(QString port READ port WRITE setPort NOTIFY changed FINAL)
    Q_PROPERTY(QString stateText READ stateText NOTIFY changed FINAL)
    // True when the address of the port can be set.
    Q_PROPERTY(bool editable READ editable NOTIFY changed FINAL)
    // The draft: by DHCP, fixed, or neither; and the entries as {key, label, text}, of DHCP those of the
    // server.
    Q_PROPERTY(bool dhcp READ isDhcp NOTIFY changed FINAL)
    Q_PROPERTY(bool fixed READ isFixed WRITE setFixed NOTIFY changed FINAL)
    Q_PROPERTY(QVariantList fields READ fields NOTIFY changed FINAL)
    // Why the draft cannot be applied; empty: it can.
    Q_PROPERTY(QString refusal READ refusal NOTIFY changed FINAL)
    Q_PROPERTY(bool edited READ edited NOTIFY changed FINAL)

public:
    // The check must outlive the object.
    SystemNetwork(AccessCheck& check, QObject* parent);

    // The time that a port has to get its address, for tests.
    void setPatienceMs(int fixedMs, int dhcpMs) { m_patienceMs = {fixedMs, dhcpMs}; }

    [[nodiscard]] QVariantList ports() const;
    [[nodiscard]] QString port() const { return m_port; }
    void setPort(const QString& name);
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] bool editable() const { return available() && !busy() && !m_connection.isEmpty(); }
    [[nodiscard]] bool isDhcp() const { return shown().method == NetworkAddress::Method::Dhcp; }
    [[nodiscard]] bool isFixed() const { return shown().method == NetworkAddress::Method::Fixed; }
    void setFixed(bool isFixed);
    [[nodiscard]] QVariantList fields() const;
    [[nodiscard]] QString refusal() const { return edited() ? m_draft->refusal() : QString(); }
    [[nodiscard]] bool edited() const { return m_draft && *m_draft != m_current; }

    // A field is the key of an entry of `fields`.
    Q_INVOKABLE QString label(int field) const;
    Q_INVOKABLE QString hint(int field) const;
    Q_INVOKABLE QString refusalOf(int field, const QString& text) const;
    Q_INVOKABLE void enter(int field, const QString& text);
    // Drops what was entered.
    Q_INVOKABLE void discard();
    Q_INVOKABLE void apply();

protected:
    void ask() override;

private:
    // The change that is being made.
    struct Job {
        Change change;
        NetworkAddress wanted;
        QString connection;
        QString device;
        QString checkpoint;
        QString activation;
        QDeadlineTimer deadline;
    };

    [[nodiscard]] const NetworkAddress& shown() const { return m_draft ? *m_draft : m_current; }
    [[nodiscard]] QVariantMap values(const QString& path, const QString& interface) const;
    [[nodiscard]] QString connectionOf(const QString& device) const;
    // Returns addresses, gateway and DNS servers that the device has.
    [[nodiscard]] QVariantMap leaseOf(const QString& device) const;
    void takeObjects(const QDBusPendingCall& answer);
    void takeSettings(const QDBusPendingCall& answer);
    [[nodiscard]] NetworkGroups changedSettings() const;
    void update();
    void activate();
    void follow();
    void rollBack(const QString& problem);
    void endJob(const QString& problem);
    // Sends the next call of the job; an error ends the job.
    void sendStep(const Call& call, const Handler& next);

    NetworkObjects m_objects;
    QMap<QString, QString> m_devices; // paths by the name of the port
    QString m_port;
    QString m_connection; // of the port; empty: it has none
    NetworkGroups m_settings;
    NetworkAddress m_current;
    std::optional<NetworkAddress> m_draft;
    Job m_job;
    std::pair<int, int> m_patienceMs; // fixed, by DHCP
};

} // namespace campanel::panel
