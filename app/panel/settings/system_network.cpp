// SPDX-License-Identifier: Apache-2.0
#include "app/panel/settings/system_network.h"

#include <QDBusArgument>
#include <QDBusError>
#include <QDBusMetaType>
#include <QDBusPendingReply>
#include <QtEndian>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace campanel::panel {

namespace {

const QString networkService = QStringLiteral("org.freedesktop.NetworkManager");
const QString networkPath = QStringLiteral("/org/freedesktop/NetworkManager");
const QString deviceInterface = networkService + QStringLiteral(".Device");
const QString connectionInterface = networkService + QStringLiteral(".Settings.Connection");
const QString noObject = QStringLiteral("/");

// NetworkManager names wired ports 1, wireless ones 2, and the end of a virtual cable, as in a container, 20.
constexpr std::array<uint, 3> typesOfPorts{1, 2, 20};
constexpr uint savedOnDisk = 0x1;
constexpr uint isActivated = 2;
constexpr uint isDeactivating = 3;

constexpr int betweenLooksMs = 300;
constexpr int fixedPatienceMs = 10'000;
constexpr int dhcpPatienceMs = 50'000; // NetworkManager itself waits for 45 s
constexpr uint checkpointS = 90;       // longer than the panel waits
// Another device with the address answers within this time.
constexpr int duplicateAddressMs = 1000;

using VariantMaps = QList<QVariantMap>;

QString pathIn(const QVariant& value)
{
    const QString path = value.value<QDBusObjectPath>().path();
    return path == noObject ? QString() : path;
}

QString listText(const QStringList& addresses)
{
    return addresses.join(listSeparator);
}

QStringList addressesIn(const QVariant& maps)
{
    QStringList addresses;
    for (const QVariantMap& each : qdbus_cast<VariantMaps>(maps))
        addresses << each.value(u"address"_s).toString();
    return addresses;
}

QString maskIn(const QVariant& addresses)
{
    const auto maps = qdbus_cast<VariantMaps>(addresses);
    const int prefix = maps.isEmpty() ? 0 : maps.front().value(u"prefix"_s).toInt();
    return prefix > 0 && prefix <= 32 ? maskText(prefix) : QString();
}

} // namespace

SystemNetwork::SystemNetwork(AccessCheck& check, QObject* parent)
    : SystemService(check, networkService, parent)
    , m_patienceMs(fixedPatienceMs, dhcpPatienceMs)
{
    qDBusRegisterMetaType<NetworkGroups>();
    qDBusRegisterMetaType<NetworkObjects>();
    qDBusRegisterMetaType<VariantMaps>();
    qDBusRegisterMetaType<QList<uint>>();
    qDBusRegisterMetaType<QList<QDBusObjectPath>>();
}

// Reading ------------------------------------------------------------------------------------------------

void SystemNetwork::ask()
{
    send({u"/org/freedesktop"_s, u"org.freedesktop.DBus.ObjectManager"_s, u"GetManagedObjects"_s, {}},
         [this](const QDBusPendingCall& answer) { takeObjects(answer); });
}

void SystemNetwork::takeObjects(const QDBusPendingCall& answer)
{
    const QDBusPendingReply<NetworkObjects> reply(answer);
    m_objects = reply.isError() ? NetworkObjects() : reply.value();
    m_devices.clear();
    for (auto each = m_objects.cbegin(); each != m_objects.cend(); ++each) {
        const QVariantMap device = each.value().value(deviceInterface);
        const bool isPort = std::ranges::count(typesOfPorts, device.value(u"DeviceType"_s).toUInt()) > 0;
        if (isPort && device.value(u"Managed"_s).toBool())
            m_devices.insert(device.value(u"Interface"_s).toString(), each.key().path());
    }
    if (!m_devices.contains(m_port))
        m_port = m_devices.isEmpty() ? QString() : m_devices.firstKey();
    m_connection = connectionOf(m_devices.value(m_port));
    if (!m_job.activation.isEmpty())
        follow();
    if (m_connection.isEmpty()) {
        m_current = {};
        setAnswer(!reply.isError());
    } else {
        send({m_connection, connectionInterface, u"GetSettings"_s, {}},
             [this, connection = m_connection](const QDBusPendingCall& settings) {
                 if (connection == m_connection)
                     takeSettings(settings);
                 setAnswer(true);
                 if (connection != m_connection) // another port was chosen meanwhile
                     refresh();
             });
    }
}

QVariantMap SystemNetwork::values(const QString& path, const QString& interface) const
{
    return path.isEmpty() ? QVariantMap()
                          : m_objects.value(QDBusObjectPath(path)).value(networkService + interface);
}

QString SystemNetwork::connectionOf(const QString& device) const
{
    const QVariantMap port = values(device, u".Device"_s);
    const QString active = pathIn(port.value(u"ActiveConnection"_s));
    if (!active.isEmpty())
        return pathIn(values(active, u".Connection.Active"_s).value(u"Connection"_s));
    const auto usable = qdbus_cast<QList<QDBusObjectPath>>(port.value(u"AvailableConnections"_s));
    return usable.isEmpty() ? QString() : usable.front().path();
}

QVariantMap SystemNetwork::leaseOf(const QString& device) const
{
    return values(pathIn(values(device, u".Device"_s).value(u"Ip4Config"_s)), u".IP4Config"_s);
}

void SystemNetwork::takeSettings(const QDBusPendingCall& answer)
{
    const QDBusPendingReply<NetworkGroups> reply(answer);
    m_settings = reply.isError() ? NetworkGroups() : reply.value();
    const QVariantMap ipv4 = m_settings.value(u"ipv4"_s);
    const QString method = ipv4.value(u"method"_s).toString();
    m_current.method = method == u"auto"     ? NetworkAddress::Method::Dhcp
                       : method == u"manual" ? NetworkAddress::Method::Fixed
                                             : NetworkAddress::Method::Other;
    if (m_current.method == NetworkAddress::Method::Fixed) {
        QStringList servers;
        for (const uint each : qdbus_cast<QList<uint>>(ipv4.value(u"dns"_s)))
            servers << ipv4Text(qFromBigEndian(each));
        m_current.fields = {addressesIn(ipv4.value(u"address-data"_s)).value(0),
                            maskIn(ipv4.value(u"address-data"_s)), ipv4.value(u"gateway"_s).toString(),
                            listText(servers)};
    } else {
        const QVariantMap lease = leaseOf(m_devices.value(m_port));
        m_current.fields = {addressesIn(lease.value(u"AddressData"_s)).value(0),
                            maskIn(lease.value(u"AddressData"_s)), lease.value(u"Gateway"_s).toString(),
                            listText(addressesIn(lease.value(u"NameserverData"_s)))};
    }
}

QVariantList SystemNetwork::ports() const
{
    QVariantList rows;
    for (auto each = m_devices.cbegin(); each != m_devices.cend(); ++each) {
        rows << QVariantMap{
            {u"key"_s, each.key()},
            {u"text"_s, each.key()},
            {u"note"_s, listText(addressesIn(leaseOf(each.value()).value(u"AddressData"_s)))}};
    }
    return rows;
}

QString SystemNetwork::stateText() const
{
    if (busy())
        return tr("Setting the address of %1. This takes up to a minute.").arg(m_port);
    if (!isAsked())
        return tr("Asking the operating system …");
    if (!available())
        return tr("NetworkManager does not respond. Set the network in the operating system.");
    if (m_devices.isEmpty())
        return tr("NetworkManager manages no network port. Set the network in the operating system.");
    if (m_connection.isEmpty())
        return tr("%1 is not connected. Plug in the network cable.").arg(m_port);
    const QString address = addressesIn(leaseOf(m_devices.value(m_port)).value(u"AddressData"_s)).value(0);
    return address.isEmpty() ? tr("%1 has no address yet.").arg(m_port)
                             : tr("%1 has the address %2.").arg(m_port, address);
}

// The draft ----------------------------------------------------------------------------------------------

void SystemNetwork::setPort(const QString& name)
{
    if (busy() || name == m_port)
        return;
    m_port = name;
    m_connection.clear();
    m_current = {};
    discard();
    refresh();
}

void SystemNetwork::setFixed(bool isFixed)
{
    if (!editable())
        return;
    m_draft = shown();
    m_draft->method = isFixed ? NetworkAddress::Method::Fixed : NetworkAddress::Method::Dhcp;
    emit changed();
}

QVariantList SystemNetwork::fields() const
{
    const bool isUnknown = isDhcp() && m_current.method != NetworkAddress::Method::Dhcp; // before Apply
    QVariantList rows;
    for (const NetworkAddress::Field field : NetworkAddress::allFields) {
        rows << QVariantMap{{u"key"_s, static_cast<int>(field)},
                            {u"label"_s, NetworkAddress::label(field)},
                            {u"text"_s, isUnknown ? QString() : shown().fields.at(field)}};
    }
    return rows;
}

QString SystemNetwork::label(int field) const
{
    return NetworkAddress::label(static_cast<NetworkAddress::Field>(field));
}

QString SystemNetwork::hint(int field) const
{
    return NetworkAddress::hint(static_cast<NetworkAddress::Field>(field));
}

QString SystemNetwork::refusalOf(int field, const QString& text) const
{
    return NetworkAddress::refusal(static_cast<NetworkAddress::Field>(field), text);
}

void SystemNetwork::enter(int field, const QString& text)
{
    if (!isFixed() || !refusalOf(field, text).isEmpty())
        return;
    m_draft = shown();
    const std::optional<int> prefix = field == NetworkAddress::Mask ? prefixFrom(text) : std::nullopt;
    m_draft->fields.at(static_cast<std::size_t>(field)) = prefix ? maskText(*prefix) : text;
    emit changed();
}

void SystemNetwork::discard()
{
    if (busy())
        return;
    m_draft.reset();
    emit changed();
}

// The change ---------------------------------------------------------------------------------------------

NetworkGroups SystemNetwork::changedSettings() const
{
    NetworkGroups settings = m_settings;
    QVariantMap& ipv4 = settings[u"ipv4"_s];
    auto addresses = m_current.method == NetworkAddress::Method::Fixed
                         ? qdbus_cast<VariantMaps>(ipv4.value(u"address-data"_s))
                         : VariantMaps();
    for (const QString& key :
         {u"addresses"_s, u"address-data"_s, u"gateway"_s, u"dns"_s, u"dns-data"_s, u"dad-timeout"_s})
        ipv4.remove(key);
    ipv4[u"method"_s] = u"auto"_s;
    const NetworkAddress& wanted = m_job.wanted;
    if (wanted.method != NetworkAddress::Method::Fixed)
        return settings;
    ipv4[u"method"_s] = u"manual"_s;
    addresses.resize(std::max<qsizetype>(addresses.size(), 1)); // further ones stay
    addresses.front() = {{u"address"_s, wanted.fields[NetworkAddress::Address]},
                         {u"prefix"_s, static_cast<uint>(*prefixFrom(wanted.fields[NetworkAddress::Mask]))}};
    ipv4[u"address-data"_s] = QVariant::fromValue(addresses);
    ipv4[u"dad-timeout"_s] = duplicateAddressMs;
    if (!wanted.fields[NetworkAddress::Gateway].isEmpty())
        ipv4[u"gateway"_s] = wanted.fields[NetworkAddress::Gateway];
    QList<uint> servers;
    for (const QString& each :
         wanted.fields[NetworkAddress::NameServer].split(listSeparator, Qt::SkipEmptyParts))
        servers << qToBigEndian(ipv4From(each).value_or(0));
    if (!servers.isEmpty())
        ipv4[u"dns"_s] = QVariant::fromValue(servers);
    return settings;
}

void SystemNetwork::apply()
{
    if (!editable() || !edited() || !refusal().isEmpty() || !begin())
        return;
    m_job = {};
    m_job.wanted = *m_draft;
    m_job.connection = m_connection;
    m_job.device = m_devices.value(m_port);
    m_job.change = {u"network_address"_s, u"%1: %2"_s.arg(m_port, m_current.text()),
                    u"%1: %2"_s.arg(m_port, m_draft->text())};
    const auto devices = QVariant::fromValue(QList{QDBusObjectPath(m_job.device)});
    sendStep({networkPath, networkService, u"CheckpointCreate"_s, {devices, checkpointS, 0U}},
             [this](const QDBusPendingCall& answer) {
                 m_job.checkpoint = QDBusPendingReply<QDBusObjectPath>(answer).value().path();
                 update();
             });
}

void SystemNetwork::update()
{
    sendStep({m_job.connection,
              connectionInterface,
              u"Update2"_s,
              {QVariant::fromValue(changedSettings()), savedOnDisk, QVariantMap()}},
             [this](const QDBusPendingCall&) { activate(); });
}

void SystemNetwork::activate()
{
    const auto path = [](const QString& each) { return QVariant::fromValue(QDBusObjectPath(each)); };
    sendStep({networkPath,
              networkService,
              u"ActivateConnection"_s,
              {path(m_job.connection), path(m_job.device), path(noObject)}},
             [this](const QDBusPendingCall& answer) {
                 m_job.activation = QDBusPendingReply<QDBusObjectPath>(answer).value().path();
                 const bool isFixed = m_job.wanted.method == NetworkAddress::Method::Fixed;
                 m_job.deadline.setRemainingTime(isFixed ? m_patienceMs.first : m_patienceMs.second);
                 refresh();
             });
}

// A connection can be active without an IPv4 address, by IPv6 alone.
void SystemNetwork::follow()
{
    const QVariantMap activation = values(m_job.activation, u".Connection.Active"_s);
    const uint state = activation.value(u"State"_s).toUInt();
    const QStringList addresses = addressesIn(leaseOf(m_job.device).value(u"AddressData"_s));
    const bool isFixed = m_job.wanted.method == NetworkAddress::Method::Fixed;
    const bool hasAddress =
        isFixed ? addresses.contains(m_job.wanted.fields[NetworkAddress::Address]) : !addresses.isEmpty();
    if (state == isActivated && hasAddress) {
        send({networkPath,
              networkService,
              u"CheckpointDestroy"_s,
              {QVariant::fromValue(QDBusObjectPath(m_job.checkpoint))}},
             [](const QDBusPendingCall&) {});
        m_current = m_job.wanted;
        m_draft.reset();
        endJob({});
    } else if (activation.isEmpty() || state >= isDeactivating || m_job.deadline.hasExpired()) {
        rollBack(isFixed ? tr("%1 did not get this address; the previous one is restored. Check the cable, "
                              "and that no other device has the address.")
                               .arg(m_port)
                         : tr("No DHCP server responded; the previous address is restored. Check the cable, "
                              "or enter a fixed address."));
    } else {
        QTimer::singleShot(betweenLooksMs, this, &SystemNetwork::refresh);
    }
}

void SystemNetwork::rollBack(const QString& problem)
{
    m_job.activation.clear();
    if (m_job.checkpoint.isEmpty()) {
        endJob(problem);
        return;
    }
    send({networkPath,
          networkService,
          u"CheckpointRollback"_s,
          {QVariant::fromValue(QDBusObjectPath(m_job.checkpoint))}},
         [this, problem](const QDBusPendingCall& answer) {
             endJob(answer.isError() ? tr("The previous address was not restored: %1. Set the network in the "
                                          "operating system.")
                                           .arg(answer.error().message())
                                     : problem);
         });
}

void SystemNetwork::endJob(const QString& problem)
{
    const Change change = m_job.change;
    m_job = {};
    finish(change, problem);
    // A restored address is there a moment later.
    QTimer::singleShot(betweenLooksMs, this, &SystemNetwork::refresh);
}

void SystemNetwork::sendStep(const Call& call, const Handler& next)
{
    send(call, [this, next](const QDBusPendingCall& answer) {
        if (answer.isError())
            rollBack(problemOf(answer.error()));
        else
            next(answer);
    });
}

} // namespace campanel::panel
