// SPDX-License-Identifier: Apache-2.0
// The entries of a fixed network address: what is refused, and with which sentence.
#include "app/panel/settings/network_address.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_network_address {

using namespace Qt::StringLiterals;
using campanel::panel::NetworkAddress;

class TestNetworkAddress : public QObject {
    Q_OBJECT

private slots:
    void addressesAreStrict_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("isValid");
        for (const char* text : {"192.168.1.20", "10.0.0.2", "1.0.0.1", "223.255.255.254"})
            QTest::newRow(text) << QString::fromLatin1(text) << true;
        for (const char* text : {"10.1", "192.168.1.256", "192.168.1.20.", "192.168..20", "192.168.1.0020",
                                 "a.b.c.d", "+1.2.3.4", "0.0.0.5", "127.0.0.1", "224.0.0.1",
                                 "255.255.255.255", "192.168.1.20/24", " 10.0.0.2", "10.0.0.-2"})
            QTest::newRow(text) << QString::fromLatin1(text) << false;
        QTest::newRow("other digits") << u"１92.168.1.20"_s << false;
        QTest::newRow("empty") << QString() << false;
    }
    void addressesAreStrict()
    {
        QFETCH(QString, text);
        QFETCH(bool, isValid);
        QCOMPARE(NetworkAddress::refusal(NetworkAddress::Address, text).isEmpty(), isValid);
        QCOMPARE(NetworkAddress::refusal(NetworkAddress::Gateway, text).isEmpty(), isValid || text.isEmpty());
        QCOMPARE(NetworkAddress::refusal(NetworkAddress::NameServer, text).isEmpty(),
                 isValid || text.isEmpty());
    }

    void masksAreReadAsMaskOrLength_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("prefix"); // 0: refused
        QTest::newRow("mask") << u"255.255.255.0"_s << 24;
        QTest::newRow("length") << u"24"_s << 24;
        QTest::newRow("shortest mask") << u"128.0.0.0"_s << 1;
        QTest::newRow("shortest") << u"1"_s << 1;
        QTest::newRow("longest mask") << u"255.255.255.252"_s << 30;
        QTest::newRow("longest") << u"30"_s << 30;
        for (const char* text : {"0", "31", "32", "0.0.0.0", "255.255.255.254", "255.255.255.255",
                                 "255.0.255.0", "255.255.1.0", "-24", "24.5", "", "255.255.255"})
            QTest::addRow("refused: %s", text) << QString::fromLatin1(text) << 0;
    }
    void masksAreReadAsMaskOrLength()
    {
        QFETCH(QString, text);
        QFETCH(int, prefix);
        QCOMPARE(campanel::panel::prefixFrom(text).value_or(0), prefix);
        QCOMPARE(NetworkAddress::refusal(NetworkAddress::Mask, text).isEmpty(), prefix > 0);
        for (int each = 1; each <= 30; ++each)
            QCOMPARE(campanel::panel::prefixFrom(campanel::panel::maskText(each)), each);
    }

    void entriesFitTogether_data()
    {
        QTest::addColumn<QStringList>("entries"); // address, mask, gateway, DNS server
        QTest::addColumn<QString>("sentence");    // its start; empty: valid
        const auto row = [](const char* name, const QStringList& entries, const QString& sentence) {
            QTest::newRow(name) << entries << sentence;
        };
        const QString mask = u"255.255.255.0"_s;
        row("all", {u"192.168.1.20"_s, mask, u"192.168.1.1"_s, u"9.9.9.9, 1.1.1.1"_s}, {});
        row("no gateway, no DNS", {u"192.168.1.20"_s, mask, {}, {}}, {});
        row("first host", {u"192.168.1.1"_s, mask, {}, {}}, {});
        row("last host", {u"192.168.1.254"_s, mask, {}, {}}, {});
        row("two hosts", {u"10.0.0.1"_s, u"255.255.255.252"_s, u"10.0.0.2"_s, {}}, {});
        row("no address", {{}, mask, {}, {}}, u"Address: Not an IPv4 address."_s);
        row("no mask", {u"192.168.1.20"_s, {}, {}, {}}, u"Subnet mask: Not a subnet mask."_s);
        row("wrong DNS", {u"192.168.1.20"_s, mask, {}, u"9.9.9"_s}, u"DNS server: Not an IPv4 address."_s);
        row("the subnet", {u"192.168.1.0"_s, mask, {}, {}},
            u"192.168.1.0 is the subnet itself. Enter an address from 192.168.1.1 to 192.168.1.254"_s);
        row("broadcast", {u"192.168.1.255"_s, mask, {}, {}},
            u"192.168.1.255 is the broadcast address. Enter an address from 192.168.1.1 to 192.168.1.254"_s);
        row("not broadcast in a larger subnet", {u"192.168.1.255"_s, u"255.255.0.0"_s, {}, {}}, {});
        row("gateway outside", {u"192.168.1.20"_s, mask, u"192.168.2.1"_s, {}},
            u"The gateway is not in the subnet. Enter a gateway from 192.168.1.1 to 192.168.1.254"_s);
        row("gateway is the subnet", {u"192.168.1.20"_s, mask, u"192.168.1.0"_s, {}},
            u"The gateway is not in the subnet."_s);
        row("gateway is broadcast", {u"192.168.1.20"_s, mask, u"192.168.1.255"_s, {}},
            u"The gateway is not in the subnet."_s);
        row("gateway is the panel", {u"192.168.1.20"_s, mask, u"192.168.1.20"_s, {}},
            u"The gateway has the address of this panel."_s);
    }
    void entriesFitTogether()
    {
        QFETCH(QStringList, entries);
        QFETCH(QString, sentence);
        NetworkAddress address{NetworkAddress::Method::Fixed, {}};
        std::copy(entries.begin(), entries.end(), address.fields.begin());
        if (sentence.isEmpty())
            QCOMPARE(address.refusal(), QString());
        else
            QVERIFY2(address.refusal().startsWith(sentence), qPrintable(address.refusal()));
        address.method = NetworkAddress::Method::Dhcp;
        QCOMPARE(address.refusal(), QString());
    }

    void auditTrailHasOneLine()
    {
        NetworkAddress address{NetworkAddress::Method::Fixed,
                               {u"10.0.0.2"_s, u"255.255.0.0"_s, u"10.0.0.1"_s, u"9.9.9.9"_s}};
        QCOMPARE(address.text(), u"10.0.0.2/16, gateway 10.0.0.1, DNS 9.9.9.9"_s);
        address.fields[NetworkAddress::Gateway].clear();
        address.fields[NetworkAddress::NameServer].clear();
        QCOMPARE(address.text(), u"10.0.0.2/16"_s);
        address.method = NetworkAddress::Method::Dhcp;
        QCOMPARE(address.text(), u"DHCP"_s);
    }
};

CAMPANEL_TEST(TestNetworkAddress)

} // namespace test_network_address

#include "test_network_address.moc"
