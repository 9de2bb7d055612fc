// SPDX-License-Identifier: Apache-2.0
// The edge node against a broker and clocks of the test.
#include "gateway/sparkplug_node.h"
#include "tests/gateway/fake_broker.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <memory>

namespace test_sparkplug_node {

using namespace campanel;
using namespace campanel::gateway;
using namespace std::chrono_literals;
using namespace Qt::StringLiterals;
using plant::Metric;
using plant::MetricValue;
using test::FakeBroker;
using test::metricIn;

namespace {

const QString commandTopic = u"spBv1.0/Hall/NCMD/P7"_s;
const QString birthTopic = u"spBv1.0/Hall/NBIRTH/P7"_s;

MetricValue whole(std::int64_t value)
{
    return value;
}

struct Rig {
    explicit Rig(const QString& primaryHost = {}, std::size_t ringCapacity = ValueRing::standardCapacity)
        : node({u"Hall"_s, u"P7"_s, primaryHost, u"5"_s}, broker,
               {.steady = [this] { return steady; }, .wallMs = [this] { return wallMs; }},
               {[this](const plant::CommandMessage& command) { commands << command; }, [this] { ++stales; },
                [this](LogKind, const QString& sentence) { reports << sentence; }},
               ringCapacity)
    {
    }

    void pass(std::chrono::milliseconds time)
    {
        steady += time;
        wallMs += time.count();
        node.tick();
    }
    void send(Metric metric, const MetricValue& value, std::int64_t ageMs = 0)
    {
        node.takeValues({{{metric, value, ageMs}}});
    }
    // Sends bags that are counted from..to.
    void countBags(int from, int to)
    {
        for (int bag = from; bag <= to; ++bag)
            send(Metric::ProdProcessedCount, whole(bag));
    }
    void command(const QList<PayloadMetric>& metrics)
    {
        node.takeMessage(commandTopic, encodedPayload({wallMs, {}, metrics}));
    }
    void rebirth() { command({{.name = u"Node Control/Rebirth"_s, .type = 11, .value = true}}); }
    // Answers all barriers until nothing is under way, while the panel is alive.
    void settle()
    {
        for (int answered = broker.barriers - 1; answered < broker.barriers;) {
            answered = broker.barriers;
            node.barrierPassed();
            pass(1s);
            node.takeValues({});
        }
    }
    // Returns the samples of a metric in all data so far.
    [[nodiscard]] QList<PayloadMetric> samplesOf(Metric metric) const
    {
        QList<PayloadMetric> samples;
        for (const FakeBroker::Message& data : broker.ofType("NDATA")) {
            for (const PayloadMetric& each : data.payload.metrics) {
                if (each.alias == static_cast<std::uint64_t>(metric))
                    samples << each;
            }
        }
        return samples;
    }

    std::chrono::steady_clock::time_point steady{1h};
    std::int64_t wallMs = 1'790'000'000'000;
    FakeBroker broker;
    QList<plant::CommandMessage> commands;
    QStringList reports;
    int stales = 0;
    SparkplugNode node;
};

} // namespace

class TestSparkplugNode : public QObject {
    Q_OBJECT

private slots:
    void theBirthHasEveryMetric()
    {
        Rig rig;
        rig.node.takeValues({{{Metric::StateCurrent, whole(6), 40}, {Metric::CurMachSpeed, 61.5, 0}}});
        QVERIFY(rig.broker.messages.isEmpty());
        rig.node.brokerOpened(17);
        QVERIFY(rig.broker.topics.contains(commandTopic));
        const auto births = rig.broker.ofType("NBIRTH");
        QCOMPARE(births.size(), 1);
        QCOMPARE(births.first().topic, birthTopic);
        QCOMPARE(births.first().qos, 0);
        const Payload& birth = births.first().payload;
        QCOMPARE(birth.seq, 0);
        QCOMPARE(birth.metrics.size(), qsizetype(plant::metricCount) + 2);
        QCOMPARE(metricIn(birth, u"bdSeq"_s).value, whole(17));
        QCOMPARE(metricIn(birth, u"Node Control/Rebirth"_s).value, MetricValue(false));
        QCOMPARE(metricIn(birth, Metric::StateCurrent).value, whole(6));
        QCOMPARE(metricIn(birth, Metric::StateCurrent).name, u"Status/StateCurrent"_s);
        QCOMPARE(metricIn(birth, Metric::StateCurrent).timestampMs, rig.wallMs - 40);
        QCOMPARE(metricIn(birth, Metric::CurMachSpeed).unit, u"bags/min"_s);
        QCOMPARE(metricIn(birth, Metric::RecipeName).value, MetricValue());
        QCOMPARE(metricIn(birth, Metric::PanelPresent).value, MetricValue(true));
        // The will of the same connection.
        const Payload death = *decodedPayload(rig.node.deathFor(17).payload);
        QCOMPARE(metricIn(death, u"bdSeq"_s).value, whole(17));
        QVERIFY(!death.seq);
        QCOMPARE(rig.node.deathFor(17).qos, 1);
    }

    void changesAreSentByAliasAndCounted()
    {
        Rig rig;
        rig.node.brokerOpened(0);
        rig.countBags(1, 600);
        const auto data = rig.broker.ofType("NDATA");
        QCOMPARE(data.size(), 600);
        for (int i = 0; i < 600; ++i) {
            QCOMPARE(data[i].payload.seq, (i + 1) % 256);
            QCOMPARE(data[i].qos, 0);
            const PayloadMetric& last = data[i].payload.metrics.last();
            QVERIFY(last.name.isEmpty() && !last.isHistorical);
            QCOMPARE(last.value, whole(i + 1));
        }
        QCOMPARE(rig.broker.messages.first().payload.seq, 0);
    }

    void smallChangesAreNotSent()
    {
        Rig rig;
        rig.node.brokerOpened(0);
        for (const double rate : {60.0, 60.2, 60.4, 60.6, 60.3, 60.0})
            rig.send(Metric::CurMachSpeed, rate);
        rig.send(Metric::CurMachSpeed, {});
        rig.send(Metric::CurMachSpeed, {});
        QList<MetricValue> values;
        for (const PayloadMetric& sample : rig.samplesOf(Metric::CurMachSpeed))
            values << sample.value;
        QCOMPARE(values, (QList<MetricValue>{60.0, 60.6, 60.0, {}}));
    }

    // The old number is never sent as new.
    void aSilentPanelBecomesNullWithinTwoSeconds()
    {
        Rig rig;
        rig.node.brokerOpened(0);
        rig.node.takeValues({{{Metric::StateCurrent, whole(6), 0}, {Metric::RecipeName, u"Biscuit"_s, 0}}});
        const auto silentSince = rig.steady;
        while (rig.stales == 0)
            rig.pass(100ms);
        QVERIFY(rig.steady - silentSince <= 2s);
        QCOMPARE(rig.samplesOf(Metric::StateCurrent).last().value, MetricValue());
        QCOMPARE(rig.samplesOf(Metric::RecipeName).last().value, MetricValue());
        QCOMPARE(rig.samplesOf(Metric::PanelPresent).last().value, MetricValue(false));
        rig.rebirth();
        rig.pass(1s);
        QCOMPARE(metricIn(rig.broker.ofType("NBIRTH").last().payload, Metric::StateCurrent).value,
                 MetricValue());
        rig.send(Metric::StateCurrent, whole(4));
        QCOMPARE(rig.samplesOf(Metric::StateCurrent).last().value, whole(4));
        QCOMPARE(rig.samplesOf(Metric::PanelPresent).last().value, MetricValue(true));
        rig.node.panelLost();
        QCOMPARE(rig.samplesOf(Metric::StateCurrent).last().value, MetricValue());
    }

    // An alive panel that has nothing new.
    void valuesThatHoldStay()
    {
        Rig rig;
        rig.node.brokerOpened(0);
        rig.send(Metric::StateCurrent, whole(6));
        for (int i = 0; i < 100; ++i) {
            rig.pass(500ms);
            rig.node.takeValues({});
        }
        QCOMPARE(rig.samplesOf(Metric::StateCurrent).size(), 1);
        QCOMPARE(rig.stales, 0);
    }

    void valuesWaitForTheBrokerAndComeAsHistorical()
    {
        Rig rig;
        rig.node.brokerOpened(0);
        rig.countBags(1, 10);
        rig.settle();
        rig.node.brokerClosed();
        const std::int64_t awaySinceMs = rig.wallMs;
        for (int bag = 11; bag <= 20; ++bag) {
            rig.pass(1s);
            rig.send(Metric::ProdProcessedCount, whole(bag));
        }
        QCOMPARE(rig.node.waiting(), 10U);
        rig.broker.messages.clear();
        rig.node.brokerOpened(1);
        QCOMPARE(metricIn(rig.broker.ofType("NBIRTH").first().payload, u"bdSeq"_s).value, whole(1));
        QCOMPARE(metricIn(rig.broker.ofType("NBIRTH").first().payload, Metric::ProdProcessedCount).value,
                 whole(20));
        const auto samples = rig.samplesOf(Metric::ProdProcessedCount);
        QCOMPARE(samples.size(), 10);
        for (int i = 0; i < 10; ++i) {
            QCOMPARE(samples[i].value, whole(11 + i));
            QCOMPARE(samples[i].timestampMs, awaySinceMs + 1000 * (i + 1));
            QVERIFY(samples[i].isHistorical);
        }
        rig.send(Metric::ProdProcessedCount, whole(21));
        QVERIFY(!rig.samplesOf(Metric::ProdProcessedCount).last().isHistorical);
    }

    // Values written to a connection that broke are sent again: they may not have arrived.
    void whatWasUnderWayIsSentAgain()
    {
        Rig rig;
        rig.node.brokerOpened(0);
        rig.countBags(1, 5);
        rig.settle();
        rig.countBags(6, 8);
        rig.node.brokerClosed();
        rig.broker.messages.clear();
        rig.node.brokerOpened(1);
        const auto samples = rig.samplesOf(Metric::ProdProcessedCount);
        QCOMPARE(samples.size(), 3);
        QCOMPARE(samples.first().value, whole(6));
        QVERIFY(samples.first().isHistorical);
    }

    void aFullRingDropsTheOldestAndCountsThem()
    {
        Rig rig({}, 1000);
        rig.countBags(1, 1500); // and PanelPresent
        QCOMPARE(rig.node.waiting(), 1000U);
        QCOMPARE(rig.node.dropped(), 501);
        rig.node.brokerOpened(0);
        QCOMPARE(metricIn(rig.broker.ofType("NBIRTH").first().payload, Metric::ValuesDropped).value,
                 whole(501));
        const auto samples = rig.samplesOf(Metric::ProdProcessedCount);
        QCOMPARE(samples.size(), 1000);
        QCOMPARE(samples.first().value, whole(501));
        QCOMPARE(samples.last().value, whole(1500));
    }

    // 100 000 values are the ring's capacity. Not all may be under way at once.
    void aLongReplayIsPaced()
    {
        Rig rig;
        rig.countBags(1, 99'999);
        rig.node.brokerOpened(0);
        QCOMPARE(rig.samplesOf(Metric::ProdProcessedCount).size(), qsizetype(SparkplugNode::maxUnderWay) - 1);
        // Meanwhile the machine goes on. A host must see the present value as such.
        rig.countBags(100'000, 100'003);
        rig.settle();
        QCOMPARE(rig.node.waiting(), 0U);
        QCOMPARE(rig.node.dropped(), 0);
        const auto samples = rig.samplesOf(Metric::ProdProcessedCount);
        QCOMPARE(samples.size(), 100'004);
        for (int i = 0; i < 100'003; ++i)
            QVERIFY(samples[i].isHistorical && samples[i].value == whole(i + 1));
        QVERIFY(!samples.last().isHistorical);
        QCOMPARE(samples.last().value, whole(100'003));
        int seq = 0;
        for (const FakeBroker::Message& data : rig.broker.messages)
            QCOMPARE(data.payload.seq, seq++ % 256);
    }

    void aBrokerThatAnswersNothingIsLeft()
    {
        Rig rig;
        rig.node.brokerOpened(0);
        rig.countBags(1, 10);
        rig.pass(1s);
        QCOMPARE(rig.broker.barriers, 1);
        rig.pass(11s);
        QCOMPARE(rig.broker.drops, 1);
        rig.node.brokerClosed();
        QVERIFY(rig.node.waiting() >= 10);
    }

    void aRebirthIsAnsweredWithinOneSecond()
    {
        Rig rig;
        rig.node.brokerOpened(3);
        rig.countBags(1, 5);
        rig.rebirth();
        const auto askedAt = rig.steady;
        while (rig.broker.ofType("NBIRTH").size() < 2)
            rig.pass(100ms);
        QVERIFY(rig.steady - askedAt < 1s);
        const Payload birth = rig.broker.ofType("NBIRTH").last().payload;
        QCOMPARE(birth.seq, 0);
        QCOMPARE(metricIn(birth, u"bdSeq"_s).value, whole(3));
        QVERIFY(rig.commands.isEmpty());
        rig.countBags(6, 6);
        QCOMPARE(rig.broker.ofType("NDATA").last().payload.seq, 1);
        // A flood of them.
        for (int i = 0; i < 1000; ++i)
            rig.rebirth();
        rig.pass(1s);
        QVERIFY(rig.broker.ofType("NBIRTH").size() <= 4);
    }

    void aRebirthOfTheGroupIsAnsweredWithinOneSecond()
    {
        Rig rig;
        rig.node.brokerOpened(3);
        QVERIFY(rig.broker.topics.contains(u"campanel/Hall/rebirth"_s));
        rig.pass(1s);
        for (int i = 0; i < 1000; ++i)
            rig.node.takeMessage(u"campanel/Hall/rebirth"_s, "anything");
        rig.pass(500ms);
        QCOMPARE(rig.broker.ofType("NBIRTH").size(), 2);
        rig.node.takeMessage(u"campanel/Other/rebirth"_s, {});
        rig.pass(1s);
        QCOMPARE(rig.broker.ofType("NBIRTH").size(), 2);
        QVERIFY(rig.commands.isEmpty());
    }

    void commandsAreRefusedAndReported()
    {
        Rig rig;
        rig.node.brokerOpened(0);
        rig.send(Metric::StateCurrent, whole(4));
        const auto before = rig.broker.messages.size();
        rig.command({{.name = u"Command/CntrlCmd"_s, .type = 3, .value = whole(2)},
                     {.alias = 2, .type = 3, .value = whole(6)},
                     {.alias = 3, .type = 10, .value = 250.5},
                     {.alias = 77, .type = 12, .value = u"start"_s},
                     {.name = u"Node Control/Rebirth"_s, .type = 11, .value = false}});
        rig.pass(1s);
        QCOMPARE(rig.broker.messages.size(), before);
        QCOMPARE(rig.commands.size(), 5);
        QCOMPARE(rig.commands[0], (plant::CommandMessage{u"Command/CntrlCmd"_s, u"2"_s}));
        QCOMPARE(rig.commands[1], (plant::CommandMessage{u"Status/StateCurrent"_s, u"6"_s}));
        QCOMPARE(rig.commands[2], (plant::CommandMessage{u"Status/MachSpeed"_s, u"250.5"_s}));
        QCOMPARE(rig.commands[3], (plant::CommandMessage{u"alias 77"_s, u"start"_s}));
        rig.node.takeMessage(commandTopic, "start the machine");
        rig.node.takeMessage(commandTopic, {});
        rig.node.takeMessage(u"spBv1.0/Hall/NCMD/P8"_s, encodedPayload({}));
        QCOMPARE(rig.commands.size(), 5);
    }

    void thePrimaryHostIsObeyed_data()
    {
        QTest::addColumn<QString>("topic");
        QTest::addColumn<QByteArray>("online");
        QTest::addColumn<QByteArray>("offline");
        QTest::newRow("3.0") << u"spBv1.0/STATE/scada"_s << QByteArray(R"({"online":true,"timestamp":1000})")
                             << QByteArray(R"({"online":false,"timestamp":1000})");
        QTest::newRow("2.2") << u"STATE/scada"_s << QByteArray("ONLINE") << QByteArray("OFFLINE");
    }
    void thePrimaryHostIsObeyed()
    {
        QFETCH(QString, topic);
        QFETCH(QByteArray, online);
        QFETCH(QByteArray, offline);
        Rig rig(u"scada"_s);
        rig.node.brokerOpened(0);
        QVERIFY(rig.broker.topics.contains(topic));
        rig.countBags(1, 3);
        rig.node.takeMessage(topic, "garbage");
        rig.node.takeMessage(topic, offline); // retained
        rig.pass(1s);
        QVERIFY(rig.broker.messages.isEmpty());
        QVERIFY(rig.broker.leaves.isEmpty());
        rig.node.takeMessage(topic, online);
        QCOMPARE(rig.broker.ofType("NBIRTH").size(), 1);
        QCOMPARE(rig.samplesOf(Metric::ProdProcessedCount).size(), 3);
        rig.settle();
        rig.node.takeMessage(topic, offline);
        QCOMPARE(rig.broker.ofType("NDEATH").size(), 1);
        QCOMPARE(rig.broker.leaves.size(), 1);
        rig.node.brokerClosed();
        rig.countBags(4, 6);
        rig.node.brokerOpened(1);
        QCOMPARE(rig.broker.ofType("NBIRTH").size(), 1);
        rig.node.takeMessage(topic, online);
        QCOMPARE(rig.broker.ofType("NBIRTH").size(), 2);
        QCOMPARE(rig.samplesOf(Metric::ProdProcessedCount).last().value, whole(6));
    }

    // The death of an earlier run of the host may come late.
    void anOldStateOfTheHostIsIgnored()
    {
        Rig rig(u"scada"_s);
        rig.node.brokerOpened(0);
        const QString topic = u"spBv1.0/STATE/scada"_s;
        rig.node.takeMessage(topic, R"({"online":true,"timestamp":2000})");
        rig.node.takeMessage(topic, R"({"online":false,"timestamp":1000})");
        rig.node.takeMessage(u"STATE/scada"_s, "OFFLINE");
        rig.node.takeMessage(u"spBv1.0/STATE/other"_s, R"({"online":false,"timestamp":3000})");
        QVERIFY(rig.node.isBorn());
    }

    void ofTwoWithOneNameOneStays()
    {
        Rig rig; // instance 5
        rig.node.brokerOpened(0);
        const QByteArray own = encodedPayload(rig.broker.ofType("NBIRTH").first().payload);
        rig.node.takeMessage(birthTopic, own);
        rig.pass(1s);
        QVERIFY(rig.reports.isEmpty());
        QCOMPARE(rig.broker.ofType("NBIRTH").size(), 1);
        const auto birthOf = [](const QString& instance) {
            return encodedPayload(
                {0, 0, {{.name = u"CamPanel/Gateway/Instance"_s, .type = 12, .value = instance}}});
        };
        rig.node.takeMessage(birthTopic, birthOf(u"6"_s)); // the other one has to leave
        rig.pass(1s);
        QCOMPARE(rig.broker.ofType("NBIRTH").size(), 2); // hosts know this one again
        QVERIFY(rig.reports.last().contains(u"this one stays"_s));
        rig.node.takeMessage(birthTopic, birthOf(u"4"_s));
        QVERIFY(rig.reports.last().contains(u"asks"_s));
        rig.pass(1s);
        QCOMPARE(rig.broker.ofType("NBIRTH").size(), 3);
        rig.node.takeMessage(birthTopic, birthOf(u"4"_s)); // its answer
        QCOMPARE(rig.broker.leaves, QList<int>{SparkplugNode::twinPauseMs});
        QVERIFY(!rig.node.isBorn());
        QVERIFY(rig.broker.ofType("NDEATH").isEmpty()); // it would be that of the other one
        QVERIFY(rig.reports.last().contains(u"gateway.node"_s));
        rig.pass(10s);
        QCOMPARE(rig.broker.ofType("NBIRTH").size(), 3);
    }

    // Whoever may publish a birth once, or again and again, must not silence the machine for long.
    void aForgedBirthSilencesNobody()
    {
        Rig rig;
        rig.node.brokerOpened(0);
        const QByteArray forged = encodedPayload(
            {0, 0, {{.name = u"CamPanel/Gateway/Instance"_s, .type = 12, .value = QString()}}});
        const QByteArray lower =
            encodedPayload({0, 0, {{.name = u"CamPanel/Gateway/Instance"_s, .type = 12, .value = u"0"_s}}});
        rig.node.takeMessage(birthTopic, forged);
        for (int i = 0; i < 20; ++i) { // ten in one moment count as one, and so does one each six seconds
            for (int times = 0; times < 10; ++times)
                rig.node.takeMessage(birthTopic, lower);
            rig.pass(6s);
        }
        QVERIFY(rig.node.isBorn());
        QCOMPARE(rig.broker.leaves, QList<int>());
        QCOMPARE(rig.reports.size(), 201);
        // One who answers is believed, for a time that grows.
        for (int i = 0; i < 5; ++i) {
            rig.node.takeMessage(birthTopic, lower);
            rig.pass(1s);
            rig.node.takeMessage(birthTopic, lower);
            QVERIFY(!rig.node.isBorn());
            rig.node.brokerClosed();
            rig.node.brokerOpened(i);
            rig.pass(1s);
            QVERIFY(rig.node.isBorn());
        }
        QCOMPARE(rig.broker.leaves, (QList<int>{10'000, 20'000, 40'000, 60'000, 60'000}));
        rig.pass(20min);
        rig.node.takeMessage(birthTopic, lower);
        rig.pass(1s);
        rig.node.takeMessage(birthTopic, lower);
        QCOMPARE(rig.broker.leaves.last(), SparkplugNode::twinPauseMs);
    }

    void anotherProgramWithThisNameIsReportedOnly()
    {
        Rig rig;
        rig.node.brokerOpened(0);
        rig.node.takeMessage(birthTopic, encodedPayload({}));
        rig.pass(1s);
        QCOMPARE(rig.broker.ofType("NBIRTH").size(), 1);
        QCOMPARE(rig.reports.size(), 1);
    }

    // The wall clock gives times only; nothing waits for it.
    void aClockThatJumps()
    {
        Rig rig;
        rig.node.brokerOpened(0);
        rig.send(Metric::ProdProcessedCount, whole(1));
        rig.wallMs -= 3'600'000;
        for (int i = 0; i < 10; ++i) {
            rig.node.takeValues({});
            rig.pass(100ms);
        }
        rig.send(Metric::ProdProcessedCount, whole(2), 100);
        QCOMPARE(rig.samplesOf(Metric::ProdProcessedCount).last().timestampMs, rig.wallMs - 100);
        rig.node.brokerClosed();
        rig.wallMs += 86'400'000;
        rig.send(Metric::ProdProcessedCount, whole(3));
        rig.wallMs -= 2 * 86'400'000;
        rig.send(Metric::ProdProcessedCount, whole(4));
        rig.broker.messages.clear();
        rig.node.brokerOpened(1);
        QList<MetricValue> values;
        for (const PayloadMetric& sample : rig.samplesOf(Metric::ProdProcessedCount))
            values << sample.value;
        QCOMPARE(values, (QList<MetricValue>{whole(1), whole(2), whole(3), whole(4)}));
        QCOMPARE(rig.stales, 0);
        rig.rebirth();
        rig.node.takeValues({});
        rig.pass(1s);
        QCOMPARE(rig.broker.ofType("NBIRTH").size(), 2);
    }

    void theEndIsADeath()
    {
        Rig rig;
        rig.node.brokerOpened(9);
        rig.node.end();
        QCOMPARE(metricIn(rig.broker.ofType("NDEATH").last().payload, u"bdSeq"_s).value, whole(9));
        QCOMPARE(rig.broker.leaves, QList<int>{0});
    }
};

CAMPANEL_TEST(TestSparkplugNode)

} // namespace test_sparkplug_node

#include "test_sparkplug_node.moc"
