// SPDX-License-Identifier: Apache-2.0
// The network address of the computer, set by a stand-in of NetworkManager on a bus of its own.
#include "app/panel/kit/access_check.h"
#include "tests/support/network_service.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>
#include <QtEndian>

#include <memory>

namespace test_system_network {

using namespace Qt::StringLiterals;
using campanel::panel::AccessCheck;
using campanel::panel::Level;
using campanel::panel::NetworkAddress;
using campanel::panel::SystemNetwork;
using campanel::store::AuditEntry;
using campanel::test::NetworkBus;

class TestSystemNetwork : public QObject {
    Q_OBJECT

    std::unique_ptr<NetworkBus> m_bus;
    campanel::test::NetworkService* m_service = nullptr;
    AccessCheck m_check;
    std::unique_ptr<SystemNetwork> m_network;
    std::unique_ptr<QSignalSpy> m_noted;

    QString field(NetworkAddress::Field field) const
    {
        return m_network->fields()[field].toMap()[u"text"_s].toString();
    }
    void enterFixed(const QString& address)
    {
        m_network->setFixed(true);
        m_network->enter(NetworkAddress::Address, address);
        m_network->enter(NetworkAddress::Mask, u"24"_s);
        m_network->enter(NetworkAddress::Gateway, {});
    }
    void enterFixedFrom(const QString& network)
    {
        enterFixed(network + u"7"_s);
        m_network->enter(NetworkAddress::Gateway, network + u"1"_s);
    }
    AuditEntry entry(qsizetype row) const { return m_noted->at(row)[0].value<AuditEntry>(); }

private slots:
    void init()
    {
        m_bus = std::make_unique<NetworkBus>();
        m_service = &m_bus->service;
        m_check.setLevel(Level::Service);
        m_network = std::make_unique<SystemNetwork>(m_check, nullptr);
        m_network->setBus(m_bus->bus());
        m_network->setPatienceMs(0, 0);
        m_noted = std::make_unique<QSignalSpy>(m_network.get(), &SystemNetwork::noted);
        m_network->setWatched(true);
        QTRY_VERIFY(m_network->editable());
    }

    void cleanup()
    {
        m_noted.reset();
        m_network.reset();
        m_bus.reset();
    }

    void stateIsRead()
    {
        QCOMPARE(m_network->ports().size(), 2);
        QCOMPARE(m_network->port(), u"eth0"_s);
        QCOMPARE(m_network->stateText(), u"eth0 has the address 192.168.1.20."_s);
        QVERIFY(m_network->isDhcp());
        QCOMPARE(field(NetworkAddress::Address), u"192.168.1.20"_s);
        QCOMPARE(field(NetworkAddress::Mask), u"255.255.255.0"_s);
        QCOMPARE(field(NetworkAddress::Gateway), u"192.168.1.1"_s);
        QCOMPARE(field(NetworkAddress::NameServer), u"192.168.1.1, 9.9.9.9"_s);
        QVERIFY(!m_network->edited());
    }

    void fixedAddressIsSetAndAudited()
    {
        enterFixedFrom(u"10.0.0."_s);
        QVERIFY(m_network->edited());
        m_network->apply();
        QVERIFY(m_network->busy() && !m_network->editable());
        QTRY_VERIFY(!m_network->busy());
        QCOMPARE(m_network->problem(), QString());
        QTRY_COMPARE(m_network->stateText(), u"eth0 has the address 10.0.0.7."_s);
        QVERIFY(m_network->isFixed() && !m_network->edited());
        QTRY_COMPARE(m_service->m_calls, QStringList({u"CheckpointCreate"_s, u"Update2"_s,
                                                      u"ActivateConnection"_s, u"CheckpointDestroy"_s}));
        QVERIFY(!m_service->m_checkpoint);
        const QVariantMap ipv4 = m_service->ipv4();
        QCOMPARE(ipv4[u"method"_s], u"manual"_s);
        QCOMPARE(ipv4[u"gateway"_s], u"10.0.0.1"_s);
        QCOMPARE(m_service->addressData()[0][u"prefix"_s].toUInt(), 24U);
        const auto servers = qdbus_cast<QList<uint>>(ipv4[u"dns"_s]);
        QCOMPARE(servers, QList({qToBigEndian(0xC0A80101U), qToBigEndian(0x09090909U)}));
        QVERIFY2(m_service->ports[0].settings.contains(u"connection"_s), "other settings stay");
        QCOMPARE(m_noted->size(), 1);
        QCOMPARE(entry(0).what, u"setting.change"_s);
        QCOMPARE(entry(0).object, u"network_address"_s);
        QCOMPARE(entry(0).before, u"eth0: DHCP"_s);
        QCOMPARE(entry(0).after, u"eth0: 10.0.0.7/24, gateway 10.0.0.1, DNS 192.168.1.1, 9.9.9.9"_s);
        QCOMPARE(entry(0).outcome, u"done"_s);
        m_network->setFixed(false);                          // and back
        QCOMPARE(field(NetworkAddress::Address), QString()); // the server has not said it yet
        m_network->apply();
        QTRY_COMPARE(m_network->stateText(), u"eth0 has the address 192.168.1.20."_s);
        QCOMPARE(m_service->ipv4(), QVariantMap({{u"method"_s, u"auto"_s}}));
        QCOMPARE(entry(1).after, u"eth0: DHCP"_s);
    }

    void furtherAddressesStay()
    {
        const auto address = [](const QString& text) {
            return QVariantMap{{u"address"_s, text}, {u"prefix"_s, 24U}};
        };
        m_service->ports[0].settings[u"ipv4"_s] = {
            {u"method"_s, u"manual"_s},
            {u"address-data"_s, QVariant::fromValue(QList{address(u"10.0.0.2"_s), address(u"10.9.0.2"_s)})}};
        m_network->setWatched(false);
        m_network->setWatched(true);
        QTRY_COMPARE(field(NetworkAddress::Address), u"10.0.0.2"_s);
        QTRY_VERIFY(m_network->isFixed());
        enterFixed(u"10.0.0.3"_s);
        m_network->apply();
        QTRY_VERIFY(!m_network->busy());
        QCOMPARE(m_network->problem(), QString());
        QCOMPARE(m_service->addressData().size(), 2);
        QCOMPARE(m_service->addressData()[0][u"address"_s], u"10.0.0.3"_s);
        QCOMPARE(m_service->addressData()[1][u"address"_s], u"10.9.0.2"_s);
    }

    void wrongEntriesAreNotSent()
    {
        enterFixedFrom(u"10.0.0."_s);
        m_network->enter(NetworkAddress::Address, u"10.0.0"_s);
        QCOMPARE(field(NetworkAddress::Address), u"10.0.0.7"_s);
        m_network->enter(NetworkAddress::Address, u"10.0.1.7"_s);
        QVERIFY2(m_network->refusal().startsWith(u"The gateway is not in the subnet."),
                 qPrintable(m_network->refusal()));
        m_network->apply();
        QVERIFY(!m_network->busy());
        m_network->discard();
        QVERIFY(m_network->isDhcp() && !m_network->edited());
        m_network->enter(NetworkAddress::Address, u"10.0.0.7"_s); // by DHCP nothing is entered
        QVERIFY(!m_network->edited());
        QCOMPARE(m_service->m_calls, QStringList());
    }

    void usedAddressIsRolledBack()
    {
        m_service->m_usedAddress = u"10.0.0.7"_s;
        enterFixedFrom(u"10.0.0."_s);
        m_network->apply();
        QTRY_VERIFY(!m_network->busy());
        QVERIFY2(m_network->problem().startsWith(u"eth0 did not get this address"),
                 qPrintable(m_network->problem()));
        QCOMPARE(m_service->m_calls.last(), u"CheckpointRollback"_s);
        QCOMPARE(m_service->ipv4()[u"method"_s], u"auto"_s);
        QTRY_COMPARE(m_network->stateText(), u"eth0 has the address 192.168.1.20."_s);
        QVERIFY2(m_network->edited() && m_network->isFixed(), "the entries stay, to be corrected");
        QCOMPARE(entry(0).outcome, u"failed"_s);
    }

    void dhcpWithoutServerIsRolledBack()
    {
        enterFixedFrom(u"10.0.0."_s);
        m_network->apply();
        QTRY_COMPARE(m_network->stateText(), u"eth0 has the address 10.0.0.7."_s);
        m_service->m_hasDhcpServer = false;
        m_network->setFixed(false);
        m_network->apply();
        QTRY_VERIFY(!m_network->busy());
        QVERIFY2(m_network->problem().startsWith(u"No DHCP server responded"),
                 qPrintable(m_network->problem()));
        QCOMPARE(m_service->addressData()[0][u"address"_s], u"10.0.0.7"_s);
        QTRY_COMPARE(m_network->stateText(), u"eth0 has the address 10.0.0.7."_s);
    }

    void failedRollbackIsSaid()
    {
        m_service->m_usedAddress = u"10.0.0.7"_s;
        m_service->m_failsRollback = true;
        enterFixedFrom(u"10.0.0."_s);
        m_network->apply();
        QTRY_VERIFY(!m_network->busy());
        QCOMPARE(m_network->problem(),
                 u"The previous address was not restored: no checkpoint. Set the network in "
                 "the operating system."_s);
    }

    void refusalsAreSentences()
    {
        m_service->m_isForbidden = true;
        enterFixedFrom(u"10.0.0."_s);
        m_network->apply();
        QTRY_VERIFY(!m_network->busy());
        QVERIFY2(m_network->problem().contains(u"polkit"_s), qPrintable(m_network->problem()));
        QCOMPARE(entry(0).outcome, u"failed"_s);
        m_service->m_isForbidden = false;
        m_service->m_updateError = u"ipv4.dns: invalid"_s;
        m_network->apply();
        QTRY_VERIFY(!m_network->busy());
        QCOMPARE(m_network->problem(), u"Not set: ipv4.dns: invalid"_s);
        QCOMPARE(m_service->m_calls.last(), u"CheckpointRollback"_s);
        QVERIFY(!m_service->m_checkpoint);
    }

    void levelServiceIsNeeded()
    {
        m_check.setLevel(Level::Technician);
        const QSignalSpy refused(&m_check, &AccessCheck::refused);
        enterFixedFrom(u"10.0.0."_s);
        m_network->apply();
        QCOMPARE(refused.size(), 1);
        QVERIFY(!m_network->busy());
        QCOMPARE(m_service->m_calls, QStringList());
    }

    void portWithoutCableCannotBeSet()
    {
        m_network->setFixed(true);
        m_network->setPort(u"eth1"_s);
        QVERIFY2(!m_network->edited() && !m_network->editable(), "the draft was of the other port");
        QTRY_COMPARE(m_network->stateText(), u"eth1 is not connected. Plug in the network cable."_s);
        QCOMPARE(field(NetworkAddress::Address), QString());
        m_network->setPort(u"eth0"_s);
        QTRY_VERIFY(m_network->editable());
        QCOMPARE(field(NetworkAddress::Address), u"192.168.1.20"_s);
    }

    void unmanagedPortsAreLeftOut()
    {
        for (auto& port : m_service->ports)
            port.isManaged = false;
        QTRY_VERIFY(m_network->ports().isEmpty());
        QCOMPARE(m_network->stateText(),
                 u"NetworkManager manages no network port. Set the network in the operating system."_s);
        QVERIFY(!m_network->editable());
    }

    void withoutTheServiceASentenceSaysSo()
    {
        m_network->setWatched(false);
        m_network->setBus({[] { return QDBusConnection(u"nowhere"_s); }, {}});
        m_network->setWatched(true);
        QTRY_COMPARE(m_network->stateText(),
                     u"NetworkManager does not respond. Set the network in the operating system."_s);
        QVERIFY(!m_network->available() && !m_network->editable() && m_network->ports().isEmpty());
    }

    void changeGoesOnWhileNobodyLooks()
    {
        enterFixedFrom(u"10.0.0."_s);
        m_network->apply();
        m_network->setWatched(false);
        QTRY_VERIFY(!m_network->busy());
        QTRY_VERIFY(!m_service->m_checkpoint);
        QCOMPARE(entry(0).outcome, u"done"_s);
    }
};

CAMPANEL_TEST(TestSystemNetwork)

} // namespace test_system_network

#include "test_system_network.moc"
