// SPDX-License-Identifier: Apache-2.0
// The gateway's executable between a panel's socket and mosquitto, seen by mosquitto_sub.
#include "tests/gateway/plant_bench.h"
#include "tests/support/test_program.h"

#include <QDateTime>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <map>

namespace test_gateway_and_broker {

using namespace campanel;
using namespace Qt::StringLiterals;
using gateway::PayloadMetric;
using plant::Metric;
using plant::MetricValue;
using test::Host;
using test::HostMessage;
using test::Machine;
using test::Mosquitto;

namespace {

constexpr int longWaitMs = 60'000;
const QString commandTopic = u"spBv1.0/Hall/NCMD/P1"_s;
const QString stateTopic = u"spBv1.0/STATE/scada"_s;

MetricValue whole(std::int64_t value)
{
    return value;
}

std::int64_t numberOf(const PayloadMetric& sample)
{
    const auto* number = std::get_if<std::int64_t>(&sample.value);
    return number ? *number : -1;
}

std::int64_t bdSeqOf(const HostMessage& message)
{
    for (const PayloadMetric& metric : message.payload.metrics) {
        if (metric.name == u"bdSeq")
            return numberOf(metric);
    }
    return -1;
}

double nowS()
{
    return double(QDateTime::currentMSecsSinceEpoch()) / 1000;
}

QByteArray commandOf(const PayloadMetric& metric)
{
    return gateway::encodedPayload({QDateTime::currentMSecsSinceEpoch(), {}, {metric}});
}

// Returns the numbers of a metric in the order of their times, without those that came twice.
QList<std::int64_t> countsOf(const QList<PayloadMetric>& samples)
{
    std::map<std::int64_t, bool> seen;
    for (const PayloadMetric& sample : samples) {
        if (plant::isKnown(sample.value))
            seen[numberOf(sample)] = true;
    }
    QList<std::int64_t> counts;
    for (const auto& [count, isSeen] : seen)
        counts << count;
    return counts;
}

QList<std::int64_t> upTo(std::int64_t last)
{
    QList<std::int64_t> counts;
    for (std::int64_t count = 1; count <= last; ++count)
        counts << count;
    return counts;
}

} // namespace

class TestGatewayAndBroker : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY2(Mosquitto::isInstalled(),
                 "mosquitto or mosquitto_sub is not installed; see packaging/dependencies");
    }

    void tenThousandChanges()
    {
        Mosquitto broker;
        Host host(broker);
        Machine machine(broker.port());
        QTRY_VERIFY(machine.panel.hasGateway());
        QTRY_VERIFY(!host.ofType(u"NBIRTH"_s).isEmpty());
        constexpr int changes = 10'000;
        // The host gets each thousand before the next one. When too many values are under way, the gateway
        // keeps the others and sends the present value once more after them.
        constexpr int together = 1000;
        for (int bags = together; bags <= changes; bags += together) {
            machine.panel.countBags(bags - together + 1, bags);
            QTRY_VERIFY_WITH_TIMEOUT(host.samplesOf(Metric::ProdProcessedCount).size() >= bags, longWaitMs);
        }
        const auto samples = host.samplesOf(Metric::ProdProcessedCount);
        QCOMPARE(samples.size(), changes);
        for (int i = 0; i < changes; ++i)
            QVERIFY2(numberOf(samples[i]) == i + 1 && !samples[i].isHistorical, QByteArray::number(i));
        QCOMPARE(host.gap(), QString());
        QVERIFY(host.ofType(u"NDATA"_s).size() > 256);
    }

    void aKilledGatewayIsDeadWithinOneSecond()
    {
        Mosquitto broker;
        Host host(broker);
        Machine machine(broker.port());
        QTRY_COMPARE(host.ofType(u"NBIRTH"_s).size(), 1);
        for (int times = 1; times <= 3; ++times) {
            const double killedAtS = nowS();
            machine.killGateway();
            QTRY_COMPARE(host.ofType(u"NDEATH"_s).size(), times);
            const double tookS = host.ofType(u"NDEATH"_s).last().timeS - killedAtS;
            qInfo("NDEATH %.0f ms after kill -9", tookS * 1000);
            QVERIFY(tookS < 1);
            QCOMPARE(bdSeqOf(host.ofType(u"NDEATH"_s).last()), bdSeqOf(host.ofType(u"NBIRTH"_s).last()));
            machine.startGateway();
            QTRY_COMPARE(host.ofType(u"NBIRTH"_s).size(), times + 1);
            QCOMPARE(bdSeqOf(host.ofType(u"NBIRTH"_s).last()), times); // another one each time
        }
        machine.endGateway();
        QTRY_COMPARE(host.ofType(u"NDEATH"_s).size(), 4);
        QCOMPARE(bdSeqOf(host.ofType(u"NDEATH"_s).last()), 3);
    }

    void aRebirthIsAnsweredWithinOneSecond()
    {
        Mosquitto broker;
        Host host(broker);
        Machine machine(broker.port());
        QTRY_COMPARE(host.ofType(u"NBIRTH"_s).size(), 1);
        const double askedAtS = nowS();
        broker.publish(commandTopic,
                       commandOf({.name = u"Node Control/Rebirth"_s, .type = 11, .value = true}));
        QTRY_COMPARE(host.ofType(u"NBIRTH"_s).size(), 2);
        QVERIFY(host.ofType(u"NBIRTH"_s).last().timeS - askedAtS < 1);
        QCOMPARE(host.gap(), QString());
    }

    void commandsReachTheAuditTrailOnly()
    {
        Mosquitto broker;
        Host host(broker);
        Machine machine(broker.port());
        QTRY_VERIFY(machine.panel.hasGateway());
        QTRY_COMPARE(host.ofType(u"NBIRTH"_s).size(), 1);
        machine.panel.set(Metric::StateCurrent, whole(4));
        QTRY_VERIFY(!host.samplesOf(Metric::StateCurrent).isEmpty());
        broker.publish(commandTopic, "\xff\xff garbage");
        broker.publish(commandTopic, QByteArray(300'000, '\x12'));
        broker.publish(commandTopic,
                       commandOf({.name = u"Command/CntrlCmd"_s, .type = 3, .value = whole(2)}));
        broker.publish(u"spBv1.0/Hall/DCMD/P1/knife"_s,
                       commandOf({.name = u"x"_s, .type = 3, .value = whole(2)}));
        QTRY_COMPARE(machine.panel.commands.size(), 1);
        QCOMPARE(machine.panel.commands.first(), (plant::CommandMessage{u"Command/CntrlCmd"_s, u"2"_s}));
        QTRY_VERIFY(machine.log().contains(u"is not understood"_s));
        machine.panel.set(Metric::StateCurrent, whole(6));
        QTRY_COMPARE(host.samplesOf(Metric::StateCurrent).last().value, whole(6));
        QCOMPARE(host.ofType(u"NBIRTH"_s).size(), 1);
        QCOMPARE(host.ofType(u"NDEATH"_s).size(), 0);
    }

    // Commands and births that a broker keeps are from nobody who speaks now.
    void keptCommandsAndBirthsAreIgnored()
    {
        Mosquitto broker;
        broker.publish(commandTopic, commandOf({.name = u"Command/CntrlCmd"_s, .type = 3, .value = whole(2)}),
                       true);
        broker.publish(u"spBv1.0/Hall/NBIRTH/P1"_s,
                       commandOf({.name = u"CamPanel/Gateway/Instance"_s, .type = 12, .value = u"0"_s}),
                       true);
        Machine machine(broker.port());
        QTRY_VERIFY(machine.panel.hasGateway());
        broker.publish(commandTopic,
                       commandOf({.name = u"Command/CntrlCmd"_s, .type = 3, .value = whole(3)}));
        QTRY_COMPARE(machine.panel.commands, (QList<plant::CommandMessage>{{u"Command/CntrlCmd"_s, u"3"_s}}));
        QVERIFY2(!machine.log().contains(u"Another program"_s), qPrintable(machine.log()));
    }

    // Whoever may publish commands: the log stays short, each of its lines is the gateway's own, and no value
    // is lost.
    void aFloodOfCommandsCostsNoValue()
    {
        Mosquitto broker;
        Host host(broker);
        Machine machine(broker.port());
        QTRY_VERIFY(machine.panel.hasGateway());
        QTRY_COMPARE(host.ofType(u"NBIRTH"_s).size(), 1);
        broker.publish(commandTopic, commandOf({.name = u"x\ncampanel-gateway: forged\u2028"_s +
                                                        QString(100'000, u'y').left(9000),
                                                .type = 3,
                                                .value = whole(2)}));
        QTRY_VERIFY(machine.log().contains(u"Refused: x\\u000acampanel-gateway: forged"_s));
        const QTemporaryDir folder;
        QFile commands(folder.filePath(u"commands"_s));
        QVERIFY(commands.open(QIODevice::WriteOnly));
        constexpr int flood = 20'000;
        for (int i = 0; i < flood; ++i)
            commands.write("not a command\n");
        commands.close();
        QProcess publisher;
        publisher.setStandardInputFile(commands.fileName());
        publisher.start(u"mosquitto_pub"_s, {u"-h"_s, u"127.0.0.1"_s, u"-p"_s, QString::number(broker.port()),
                                             u"-t"_s, commandTopic, u"-l"_s});
        machine.panel.countBags(1, 1000);
        QTRY_VERIFY_WITH_TIMEOUT(publisher.state() == QProcess::NotRunning, longWaitMs);
        machine.panel.countBags(1001, 2000);
        QTRY_COMPARE_WITH_TIMEOUT(countsOf(host.samplesOf(Metric::ProdProcessedCount)), upTo(2000),
                                  longWaitMs);
        QCOMPARE(host.gap(), QString());
        machine.endGateway();
        QStringList lines = machine.log().split(u'\n', Qt::SkipEmptyParts);
        lines.removeIf([](const QString& line) { return line.startsWith(u"QStandardPaths: "); });
        QVERIFY2(lines.size() <= 12, qPrintable(machine.log()));
        for (const QString& line : lines)
            QVERIFY2(line.startsWith(u"campanel-gateway: "_s) && line.size() < 400, qPrintable(line));
    }

    // The host says when it hears, so that nothing is sent to nobody.
    void whatHappensWhileTheBrokerIsAwayComesLater()
    {
        Mosquitto broker;
        auto host = std::make_unique<Host>(broker);
        Machine machine(broker.port(), "primary_host = \"scada\"");
        broker.publish(stateTopic, R"({"online":true,"timestamp":1000})", true);
        QTRY_COMPARE(host->ofType(u"NBIRTH"_s).size(), 1);
        constexpr int before = 200;
        constexpr int away = 3000;
        machine.panel.countBags(1, before);
        QTRY_VERIFY(host->samplesOf(Metric::ProdProcessedCount).size() >= before);
        const double killedAtS = nowS();
        broker.kill();
        machine.panel.countBags(before + 1, away);
        QTRY_VERIFY(machine.log().contains(u"The connection to the broker is lost"_s));
        auto samples = host->samplesOf(Metric::ProdProcessedCount, true);
        QVERIFY(countsOf(samples).size() < away);
        broker.start();
        host = std::make_unique<Host>(broker);
        broker.publish(stateTopic, R"({"online":true,"timestamp":2000})", true);
        const auto all = [&] { return countsOf(samples + host->samplesOf(Metric::ProdProcessedCount)); };
        QTRY_VERIFY_WITH_TIMEOUT(all().size() == away, longWaitMs);
        QCOMPARE(all(), upTo(away));
        QCOMPARE(host->gap(), QString());
        std::int64_t last = 0;
        for (const PayloadMetric& sample : host->samplesOf(Metric::ProdProcessedCount)) {
            QVERIFY(sample.isHistorical);
            QVERIFY(numberOf(sample) > last); // in order, with their own times
            last = numberOf(sample);
            if (last > before)
                QVERIFY(double(sample.timestampMs) / 1000 >= killedAtS - 1);
        }
    }

    void withoutItsPrimaryHostNothingIsSent()
    {
        Mosquitto broker;
        Host host(broker);
        Machine machine(broker.port(), "primary_host = \"scada\"");
        QTRY_VERIFY(machine.log().contains(u"Connected"_s));
        machine.panel.countBags(1, 10);
        broker.publish(stateTopic, R"({"online":false,"timestamp":1000})", true);
        QTest::qWait(300);
        QVERIFY(host.messages().isEmpty());
        broker.publish(stateTopic, R"({"online":true,"timestamp":2000})", true);
        QTRY_COMPARE(countsOf(host.samplesOf(Metric::ProdProcessedCount)), upTo(10));
        broker.publish(stateTopic, R"({"online":false,"timestamp":2000})", true);
        QTRY_COMPARE(host.ofType(u"NDEATH"_s).size(), 1);
        machine.panel.countBags(11, 20);
        broker.publish(stateTopic, R"({"online":true,"timestamp":3000})", true);
        QTRY_COMPARE_WITH_TIMEOUT(countsOf(host.samplesOf(Metric::ProdProcessedCount)), upTo(20), longWaitMs);
    }

    void aPanelThatHangsIsStaleWithinTwoSeconds()
    {
        Mosquitto broker;
        Host host(broker);
        Machine machine(broker.port());
        QTRY_VERIFY(machine.panel.hasGateway());
        QTRY_COMPARE(host.ofType(u"NBIRTH"_s).size(), 1);
        machine.panel.set(Metric::StateCurrent, whole(6));
        QTRY_VERIFY(!host.samplesOf(Metric::StateCurrent).isEmpty());
        const double hangsSinceS = nowS();
        machine.panel.hang();
        QTRY_COMPARE(host.samplesOf(Metric::StateCurrent).last().value, MetricValue());
        const double tookS = host.ofType(u"NDATA"_s).last().timeS - hangsSinceS;
        qInfo("null %.0f ms after the panel hangs", tookS * 1000);
        QVERIFY(tookS < 2);
        QCOMPARE(host.samplesOf(Metric::PanelPresent).last().value, MetricValue(false));
        machine.panel.recover();
        QTRY_COMPARE(host.samplesOf(Metric::StateCurrent).last().value, whole(6)); // all values come again
        QTRY_COMPARE(host.samplesOf(Metric::PanelPresent).last().value, MetricValue(true));
    }

    void ofTwoPanelsWithOneNodeNameOneStays()
    {
        Mosquitto broker;
        Host host(broker);
        Machine first(broker.port());
        QTRY_COMPARE(host.ofType(u"NBIRTH"_s).size(), 1);
        Machine second(broker.port());
        const auto hasLeft = [](Machine& machine) { return machine.log().contains(u"this one leaves"_s); };
        QTRY_VERIFY(hasLeft(first) || hasLeft(second));
        Machine& loser = hasLeft(first) ? first : second;
        Machine& winner = hasLeft(first) ? second : first;
        QTRY_VERIFY(winner.panel.hasGateway());
        winner.panel.countBags(1, 5);
        loser.panel.countBags(100, 105);
        QTRY_COMPARE(countsOf(host.samplesOf(Metric::ProdProcessedCount)), upTo(5));
        QTest::qWait(500);
        QVERIFY(host.ofType(u"NDEATH"_s).isEmpty()); // hosts would take it for that of the other one
        QVERIFY(loser.isGatewayRunning() && winner.isGatewayRunning());
    }

    void fiftyMachinesAtOneBroker()
    {
        const int machines = qEnvironmentVariableIntValue("CAMPANEL_GATEWAYS") > 0
                                 ? qEnvironmentVariableIntValue("CAMPANEL_GATEWAYS")
                                 : 50;
        const int seconds = qMax(2, qEnvironmentVariableIntValue("CAMPANEL_GATEWAY_SECONDS"));
        Mosquitto broker;
        Host host(broker);
        std::vector<std::unique_ptr<Machine>> hall;
        for (int i = 0; i < machines; ++i)
            hall.push_back(std::make_unique<Machine>(broker.port(), QByteArray(), u"M%1"_s.arg(i)));
        for (int i = 0; i < machines; ++i) {
            QTRY_VERIFY_WITH_TIMEOUT(hall[std::size_t(i)]->panel.hasGateway(), longWaitMs);
            QTRY_VERIFY_WITH_TIMEOUT(!host.ofType(u"NBIRTH"_s, u"M%1"_s.arg(i)).isEmpty(), longWaitMs);
        }
        // Five bags a second each, as a fast packer.
        int bags = 0;
        for (int round = 0; round < 5 * seconds; ++round) {
            ++bags;
            for (const auto& machine : hall)
                machine->panel.countBags(bags, bags);
            QTest::qWait(200);
        }
        for (int i = 0; i < machines; ++i) {
            const QString node = u"M%1"_s.arg(i);
            QTRY_COMPARE_WITH_TIMEOUT(
                countsOf(host.samplesOf(Metric::ProdProcessedCount, false, node)).size(), qsizetype(bags),
                longWaitMs);
            QCOMPARE(countsOf(host.samplesOf(Metric::ProdProcessedCount, false, node)), upTo(bags));
            QCOMPARE(host.gap(node), QString());
        }
        qInfo("%d gateways, %d s, %d bags each: all counters equal", machines, seconds, bags);
    }
};

CAMPANEL_TEST(TestGatewayAndBroker)

} // namespace test_gateway_and_broker

#include "test_gateway_and_broker.moc"
