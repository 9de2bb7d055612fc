// SPDX-License-Identifier: Apache-2.0
// An adapter that was unplugged is found again, and another one is never taken for it.
#include "app/link/port_finder.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_port_finder {

using namespace campanel::link;
using namespace Qt::StringLiterals;

namespace {

constexpr quint16 wch = 0x1A86;
constexpr quint16 ftdi = 0x0403;

Adapter adapter(const QString& path, quint16 vendor, const QString& serial, const QString& place)
{
    return {path, {vendor, 0x7523, serial, place}};
}

} // namespace

class PortFinderTest : public QObject {
    Q_OBJECT

private slots:
    void adapterIsFoundAgain_data()
    {
        QTest::addColumn<QString>("serial");
        QTest::addColumn<QList<Adapter>>("present");
        QTest::addColumn<QString>("found");
        const auto usb1 = u"/dev/ttyUSB1"_s;
        const auto usb2 = u"/dev/ttyUSB2"_s;
        const auto lost = u"/dev/ttyUSB0"_s;
        const QString none;
        QTest::newRow("nothing there") << none << QList<Adapter>{} << lost;
        QTest::newRow("no serial number, same socket")
            << none << QList{adapter(usb1, wch, none, u"1-2:1.0"_s)} << usb1;
        QTest::newRow("no serial number, another socket, the only one")
            << none << QList{adapter(usb1, wch, none, u"1-4:1.0"_s)} << usb1;
        QTest::newRow("no serial number, two alike, one in its socket")
            << none << QList{adapter(usb1, wch, none, u"1-4:1.0"_s), adapter(usb2, wch, none, u"1-2:1.0"_s)}
            << usb2;
        QTest::newRow("no serial number, two alike elsewhere")
            << none << QList{adapter(usb1, wch, none, u"1-4:1.0"_s), adapter(usb2, wch, none, u"1-5:1.0"_s)}
            << lost;
        QTest::newRow("another make in its socket")
            << none << QList{adapter(usb1, ftdi, none, u"1-2:1.0"_s)} << lost;
        QTest::newRow("its name went to one alike")
            << none << QList{adapter(lost, wch, none, u"1-4:1.0"_s), adapter(usb1, wch, none, u"1-2:1.0"_s)}
            << usb1;
        QTest::newRow("serial number, another socket")
            << u"A1"_s
            << QList{adapter(usb1, wch, u"A2"_s, u"1-2:1.0"_s), adapter(usb2, wch, u"A1"_s, u"2-1:1.0"_s)}
            << usb2;
        QTest::newRow("another serial number in its socket")
            << u"A1"_s << QList{adapter(usb1, wch, u"A2"_s, u"1-2:1.0"_s)} << lost;
        QTest::newRow("the same serial number twice")
            << u"0001"_s
            << QList{adapter(usb1, wch, u"0001"_s, u"1-4:1.0"_s), adapter(usb2, wch, u"0001"_s, u"1-2:1.0"_s)}
            << usb2;
        QTest::newRow("the other port of the same adapter")
            << u"A1"_s << QList{adapter(usb1, wch, u"A1"_s, u"2-1:1.1"_s)} << lost;
        QTest::newRow("its port of an adapter with two, in another socket")
            << u"A1"_s
            << QList{adapter(usb1, wch, u"A1"_s, u"2-1:1.1"_s), adapter(usb2, wch, u"A1"_s, u"2-1:1.0"_s)}
            << usb2;
    }

    void adapterIsFoundAgain()
    {
        QFETCH(const QString, serial);
        QFETCH(const QList<Adapter>, present);
        QFETCH(const QString, found);
        const AdapterIdentity identity{wch, 0x7523, serial, u"1-2:1.0"_s};
        QCOMPARE(findPort(u"/dev/ttyUSB0"_s, identity, present), found);
    }

    void placeIsTakenFromTheDevice()
    {
        const QString root = u"/sys/devices/pci0000:00/0000:00:14.0/usb1/1-1/"_s;
        QCOMPARE(usbPlaceOf(root + u"1-1.2/1-1.2:1.0/ttyUSB0"_s), u"1-1.2:1.0"_s);
        QCOMPARE(usbPlaceOf(root + u"1-1:1.1"_s), u"1-1:1.1"_s); // a modem's node
        QCOMPARE(usbPlaceOf(u"/sys/devices/platform/serial8250"_s), QString());
        QCOMPARE(usbPlaceOf({}), QString());
    }
};

CAMPANEL_TEST(PortFinderTest)

} // namespace test_port_finder

#include "test_port_finder.moc"
