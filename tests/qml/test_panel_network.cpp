// SPDX-License-Identifier: Apache-2.0
// The network address of the computer by touch: fixed, corrected, by DHCP again, and without the service.
#include "panel_test.h"
#include "tests/support/test_program.h"

namespace test_panel_network {

using namespace Qt::StringLiterals;

class TestPanelNetwork : public campanel::test::PanelTest {
    Q_OBJECT

    campanel::test::NetworkService& service() { return m_window->networkService(); }
    campanel::panel::SystemNetwork& network() { return m_window->panel().systemNetwork(); }
    void openNetwork()
    {
        for (const char* name : {"nav_settings", "section0", "sectionSystem", "setNetwork"})
            tap(name);
        QTRY_VERIFY(network().editable());
        m_window->settle();
    }
    void enter(const char* field, const QString& digits)
    {
        tap(field);
        while (!textOf("padText").isEmpty())
            tap("pinBackspace");
        for (const QChar digit : digits)
            m_window->tap(u"pin"_s + digit);
        tap("pinAccept");
        QTRY_VERIFY(network().editable());
        m_window->settle();
    }
    bool isOn(const char* name) { return m_window->find(QString::fromLatin1(name))->isEnabled(); }

private slots:
    void addressIsFixedAndByDhcpAgain()
    {
        openNetwork();
        QVERIFY2(!isOn("networkField0"), "a DHCP server gives the address");
        QVERIFY(!isOn("networkApply"));
        tap("networkFixed");
        enter("networkField0", u"10.0.0.7"_s);
        QVERIFY2(textOf("networkProblem").startsWith(u"The gateway is not in the subnet."),
                 qPrintable(textOf("networkProblem")));
        QVERIFY(!isOn("networkApply"));
        enter("networkField2", {});
        enter("networkField1", u"16"_s);
        enter("networkField3", u"10.0.0.1"_s);
        QCOMPARE(textOf("networkProblem"), QString());
        QCOMPARE(service().m_calls, QStringList());
        tap("networkApply");
        QTRY_COMPARE(network().stateText(), u"eth0 has the address 10.0.0.7."_s);
        QCOMPARE(service().addressData()[0][u"prefix"_s].toUInt(), 16U);
        m_window->settle();
        QVERIFY2(!isOn("networkApply"), "nothing is left to apply");
        tap("networkDhcp");
        tap("networkApply");
        QTRY_COMPARE(network().stateText(), u"eth0 has the address 192.168.1.20."_s);
        tap("sheetClose");
        QVERIFY2(!network().watched(), "nothing is asked while nobody looks");
    }

    void wrongAddressIsRefusedOnThePad()
    {
        openNetwork();
        tap("networkFixed");
        tap("networkField0");
        QCOMPARE(textOf("padText"), u"192.168.1.20"_s);
        tap("pin0");
        QVERIFY(isOn("pinAccept")); // 192.168.1.200
        tap("pin0");
        QVERIFY(!isOn("pinAccept"));
        QVERIFY2(textOf("addressProblem").startsWith(u"Not an IPv4 address."),
                 qPrintable(textOf("addressProblem")));
        tap("pinCancel");
        QCOMPARE(network().fields()[0].toMap()[u"text"_s], u"192.168.1.20"_s);
    }

    void failedAddressIsRolledBackAndCorrected()
    {
        service().m_usedAddress = u"192.168.1.2"_s;
        network().setPatienceMs(0, 0);
        openNetwork();
        tap("networkFixed");
        enter("networkField0", u"192.168.1.2"_s);
        tap("networkApply");
        QTRY_VERIFY(textOf("networkProblem").startsWith(u"eth0 did not get this address"));
        network().setPatienceMs(10'000, 10'000);
        enter("networkField0", u"192.168.1.3"_s);
        tap("networkApply");
        QTRY_COMPARE(network().stateText(), u"eth0 has the address 192.168.1.3."_s);
        QCOMPARE(network().problem(), QString());
    }

    void otherPortIsChosen()
    {
        openNetwork();
        tap("networkPort");
        tap("choice_eth1");
        QTRY_COMPARE(network().stateText(), u"eth1 is not connected. Plug in the network cable."_s);
        QVERIFY(!isOn("networkFixed"));
    }

    void entriesOfAClosedSheetAreDropped()
    {
        openNetwork();
        tap("networkFixed");
        tap("sheetClose"); // asks
        tap("sheetClose");
        tap("setNetwork");
        QVERIFY(network().isDhcp() && !network().edited());
    }

    void networkCannotBeSetWithoutTheService()
    {
        network().setBus({[] { return QDBusConnection(u"nowhere"_s); }, {}});
        for (const char* name : {"nav_settings", "section0", "sectionSystem", "setNetwork"})
            tap(name);
        QTRY_VERIFY(network().stateText().startsWith(u"NetworkManager does not respond."));
        QVERIFY(!isOn("networkFixed") && !isOn("networkApply"));
    }
};

CAMPANEL_TEST(TestPanelNetwork)

} // namespace test_panel_network

#include "test_panel_network.moc"
