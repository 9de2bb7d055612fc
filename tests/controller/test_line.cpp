// SPDX-License-Identifier: Apache-2.0
// The paced line on simulated time: bytes take as long as on the wire, in both directions.
#include "line.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <numeric>

namespace test_line {

using namespace campanel::controller;

namespace {

constexpr std::int64_t ms = 1'000'000;

std::vector<std::uint8_t> counting(std::size_t size)
{
    std::vector<std::uint8_t> bytes(size);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
    return bytes;
}

} // namespace

class TestLine : public QObject {
    Q_OBJECT

private slots:
    void characterTimes_data();
    void characterTimes();
    void requestArrivesWithItsLastByte();
    void piecesQueueUp();
    void answerLeavesByteAfterByte();
    void directionsAreIndependent();
    void unpacedTakesNoTime();
};

void TestLine::characterTimes_data()
{
    QTest::addColumn<unsigned>("baud");
    QTest::addColumn<QChar>("parity");
    QTest::addColumn<unsigned>("stopBits");
    QTest::addColumn<qint64>("character");
    QTest::addColumn<qint64>("gap");
    QTest::newRow("115200 8N1") << 115200u << QChar('N') << 1u << qint64{86'805} << qint64{1'750'000};
    QTest::newRow("9600 8N1") << 9600u << QChar('N') << 1u << qint64{1'041'666} << qint64{3'645'831};
    QTest::newRow("9600 8E1") << 9600u << QChar('E') << 1u << qint64{1'145'833} << qint64{4'010'415};
    QTest::newRow("19200 8O2") << 19200u << QChar('O') << 2u << qint64{625'000} << qint64{2'187'500};
}

void TestLine::characterTimes()
{
    QFETCH(unsigned, baud);
    QFETCH(QChar, parity);
    QFETCH(unsigned, stopBits);
    QFETCH(qint64, character);
    QFETCH(qint64, gap);
    const LineSettings settings{baud, parity.toLatin1(), stopBits, true};
    QCOMPARE(characterNs(settings), character);
    QCOMPARE(frameGapNs(settings), gap);
}

void TestLine::requestArrivesWithItsLastByte()
{
    const LineSettings settings{9600, 'N', 1, true};
    Line line(settings);
    line.fromPanel(counting(8), 5 * ms);
    const std::int64_t endNs = 5 * ms + 8 * characterNs(settings);
    QCOMPARE(line.nextEventNs().value_or(0), endNs);
    QVERIFY(!line.takeArrival(endNs - 1));
    const auto arrival = line.takeArrival(endNs);
    QVERIFY(arrival.has_value());
    QCOMPARE(arrival->endNs, endNs);
    QVERIFY(arrival->bytes == counting(8));
    QVERIFY(!line.takeArrival(endNs + 1000 * ms));
    QVERIFY(!line.nextEventNs());
}

void TestLine::piecesQueueUp()
{
    const LineSettings settings{9600, 'N', 1, true};
    Line line(settings);
    line.fromPanel(counting(4), 0);
    line.fromPanel(counting(4), 1 * ms); // while the first piece is still on the wire
    QCOMPARE(line.takeArrival(100 * ms)->endNs, 4 * characterNs(settings));
    QCOMPARE(line.takeArrival(100 * ms)->endNs, 8 * characterNs(settings));
}

void TestLine::answerLeavesByteAfterByte()
{
    for (const std::uint32_t baud : {9600u, 115200u}) {
        const LineSettings settings{baud, 'N', 1, true};
        Line line(settings);
        const auto answer = counting(85);
        line.fromController(answer, 0);
        std::vector<std::uint8_t> received;
        for (std::int64_t nowNs = 0; received.size() < answer.size(); nowNs += ms / 10) {
            const auto bytes = line.takeForPanel(nowNs);
            received.insert(received.end(), bytes.begin(), bytes.end());
            const std::int64_t onTheWire = nowNs / characterNs(settings);
            QVERIFY(static_cast<std::int64_t>(received.size()) <= onTheWire);
            QVERIFY(onTheWire - static_cast<std::int64_t>(received.size()) <=
                        1 + ms / characterNs(settings) ||
                    received.size() == answer.size());
        }
        QVERIFY(received == answer);
    }
}

void TestLine::directionsAreIndependent()
{
    const LineSettings settings{9600, 'N', 1, true};
    Line line(settings);
    line.fromController(counting(100), 0);
    line.fromPanel(counting(2), 0);
    QVERIFY(line.takeArrival(2 * characterNs(settings)).has_value());
}

void TestLine::unpacedTakesNoTime()
{
    Line line({9600, 'N', 1, false});
    line.fromPanel(counting(200), 7);
    QCOMPARE(line.takeArrival(7)->endNs, 7);
    line.fromController(counting(200), 7);
    QCOMPARE(line.takeForPanel(7).size(), std::size_t{200});
}

CAMPANEL_TEST(TestLine)

} // namespace test_line

#include "test_line.moc"
