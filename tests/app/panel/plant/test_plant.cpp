// SPDX-License-Identifier: Apache-2.0
// The panel's values for the plant's network, its local socket, and the commands that are refused.
#include "app/panel/audit/audit_words.h"
#include "app/panel/plant/plant_feed.h"
#include "tests/app/panel/orders/order_rig.h"
#include "tests/app/panel/plant/plant_rig.h"
#include "tests/support/packer_image.h"
#include "tests/support/test_program.h"

#include <QLocalSocket>
#include <QSignalSpy>

namespace test_plant {

using namespace campanel;
using namespace std::chrono_literals;
using namespace Qt::StringLiterals;
using panel::PlantFeed;
using panel::PlantValues;
using plant::Metric;
using plant::MetricReading;
using plant::MetricValue;
using test::PlantRig;

namespace {

MetricReading readingOf(PlantValues& values, Metric metric)
{
    for (const MetricReading& reading : values.readings()) {
        if (reading.metric == metric)
            return reading;
    }
    return {};
}

MetricValue whole(std::int64_t value)
{
    return value;
}

// A gateway of the test.
struct Client {
    QLocalSocket socket;
    plant::LocalReader reader;
    QList<plant::ValueMessage> messages;

    explicit Client(const QString& path)
    {
        QObject::connect(&socket, &QLocalSocket::readyRead, &socket, [this] {
            reader.add(socket.readAll());
            while (const auto message = reader.next())
                messages << std::get<plant::ValueMessage>(*message);
        });
        socket.connectToServer(path);
    }

    [[nodiscard]] MetricValue last(Metric metric) const
    {
        MetricValue value;
        for (const plant::ValueMessage& message : messages) {
            for (const MetricReading& reading : message.readings) {
                if (reading.metric == metric)
                    value = reading.value;
            }
        }
        return value;
    }
};

} // namespace

class TestPlant : public QObject {
    Q_OBJECT

private slots:
    void statesAreThoseOfPackml_data()
    {
        QTest::addColumn<int>("state");
        QTest::addColumn<int>("mode");
        QTest::addColumn<int>("packml");
        const auto row = [](const char* name, modbus::State state, int mode, int packml) {
            QTest::newRow(name) << static_cast<int>(state) << mode << packml;
        };
        row("Idle", modbus::State::Idle, 1, 2);
        row("Ready", modbus::State::Ready, 1, 4);
        row("Running", modbus::State::Running, 1, 6);
        row("Stopping", modbus::State::Stopping, 1, 7);
        row("Jogging", modbus::State::Jogging, 3, 6);
        row("Homing", modbus::State::Homing, 1, 15);
        row("Fault", modbus::State::Fault, 1, 9);
    }
    void statesAreThoseOfPackml()
    {
        QFETCH(int, state);
        QFETCH(int, mode);
        QFETCH(int, packml);
        PlantRig rig;
        PlantValues values(rig.sources, nullptr);
        rig.connectIdle();
        rig.link.status.state = static_cast<modbus::State>(state);
        rig.link.sendStatus(rig.now);
        QCOMPARE(readingOf(values, Metric::UnitModeCurrent).value, whole(mode));
        QCOMPARE(readingOf(values, Metric::StateCurrent).value, whole(packml));
        QVERIFY(std::ranges::any_of(
            plant::packmlStates, [packml](const plant::PackmlState& each) { return each.code == packml; }));
    }

    void filmThatWaitsForAProductIsSuspended()
    {
        PlantRig rig;
        PlantValues values(rig.sources, nullptr);
        rig.connectRunning();
        link::LinkReport report = rig.machine.report();
        report.identity->mapMinor = modbus::mapMinor;
        emit rig.link.reported(report);
        const auto answerPacker = [&rig](modbus::GateState filmGate) {
            rig.machine.packing()->noteConnection(); // asks when nothing is asked
            test::PackerImage packer;
            packer.set("packer.film_gate", static_cast<double>(filmGate));
            const link::ReadRequest request{0, modbus::packerAddress, modbus::packerRegisters()};
            emit rig.link.registersRead(
                {request, link::ReadEnd::Done, packer.registers(), rig.now, std::nullopt});
        };
        answerPacker(modbus::GateState::Standing);
        QCOMPARE(readingOf(values, Metric::StateCurrent).value, whole(5));
        QCOMPARE(readingOf(values, Metric::FilmSaved).value, MetricValue(0.0));
        answerPacker(modbus::GateState::Running);
        QCOMPARE(readingOf(values, Metric::StateCurrent).value, whole(6));
    }

    void valuesAreThoseOfThePanel()
    {
        PlantRig rig;
        PlantValues values(rig.sources, nullptr);
        rig.connectRunning();
        rig.link.status.bagCount = 1234;
        rig.link.sendStatus(rig.now);
        rig.now += 300ms;
        QCOMPARE(readingOf(values, Metric::ProdProcessedCount).value, whole(1234));
        QCOMPARE(readingOf(values, Metric::ProdProcessedCount).ageMs, 300);
        QCOMPARE(readingOf(values, Metric::RecipeName).value, MetricValue(rig.machine.active().name));
        QCOMPARE(readingOf(values, Metric::RecipeVersion).value, whole(1));
        QCOMPARE(readingOf(values, Metric::RecipeCrc).value, whole(rig.image().crc));
        QCOMPARE(readingOf(values, Metric::RecipeGeneration).value, whole(rig.link.status.generation));
        QCOMPARE(readingOf(values, Metric::MachSpeed).value,
                 MetricValue(rig.machine.active().rateBagsPerMin));
        QCOMPARE(readingOf(values, Metric::CurMachSpeed).value,
                 MetricValue(rig.machine.live().rateBagsPerMin));
        QCOMPARE(readingOf(values, Metric::Alarm).value, MetricValue(rig.alarms.urgentCode()));
        QCOMPARE(readingOf(values, Metric::ProdDefectiveCount).value, MetricValue()); // nothing recorded
    }

    void theOrderIsThatOfTheController()
    {
        test::OrderRig rig;
        panel::Stops stops(rig.machine, rig.settings, rig.records, nullptr);
        PlantValues values({rig.machine, rig.alarms, stops, *rig.orders}, nullptr);
        rig.connectRunning();
        QCOMPARE(readingOf(values, Metric::OrderState).value, MetricValue());
        rig.enter(5000, QStringLiteral("L17"), QStringLiteral("4711"));
        QVERIFY(rig.orders->addAndStart());
        rig.answer();
        rig.count(1240, 3, 2);
        rig.pass();
        rig.now += 300ms;
        QCOMPARE(readingOf(values, Metric::OrderName).value, MetricValue(QStringLiteral("4711")));
        QCOMPARE(readingOf(values, Metric::OrderLot).value, MetricValue(QStringLiteral("L17")));
        QCOMPARE(readingOf(values, Metric::OrderState).value, MetricValue(QStringLiteral("under_way")));
        QCOMPARE(readingOf(values, Metric::OrderQuantity).value, whole(5000));
        QCOMPARE(readingOf(values, Metric::OrderGood).value, whole(1240));
        QCOMPARE(readingOf(values, Metric::OrderGood).ageMs, 300);
        QCOMPARE(readingOf(values, Metric::OrderRejected).value, whole(3));
        QCOMPARE(readingOf(values, Metric::OrderEmpty).value, whole(2));
    }

    void valuesThatAreNotFreshAreEmpty()
    {
        PlantRig rig;
        PlantValues values(rig.sources, nullptr);
        for (const MetricReading& reading : values.readings())
            QVERIFY(!plant::isKnown(reading.value) || reading.metric == Metric::Alarm ||
                    reading.metric == Metric::LinkQuality);
        rig.connectRunning();
        QVERIFY(plant::isKnown(readingOf(values, Metric::StateCurrent).value));
        rig.now += panel::Controller::freshFor;
        rig.machine.setClock([&rig] { return rig.now; }); // as the timer of the age
        QCOMPARE(readingOf(values, Metric::StateCurrent).value, MetricValue());
        QCOMPARE(readingOf(values, Metric::RecipeName).value, MetricValue());
        QCOMPARE(readingOf(values, Metric::ProdProcessedCount).value, MetricValue());
        rig.link.sendStatus(rig.now);
        QVERIFY(plant::isKnown(readingOf(values, Metric::StateCurrent).value));
        rig.link.becomeLost();
        QCOMPARE(readingOf(values, Metric::StateCurrent).value, MetricValue());
        QCOMPARE(readingOf(values, Metric::LinkQuality).value, whole(0));
    }

    // After a download the header is read a moment after the status.
    void theNameOfTheLastProgramIsNotSentForTheNewOne()
    {
        PlantRig rig;
        PlantValues values(rig.sources, nullptr);
        rig.connectRunning();
        ++rig.link.status.generation;
        rig.link.status.activeCrc = 77;
        rig.link.sendStatus(rig.now);
        QCOMPARE(readingOf(values, Metric::RecipeCrc).value, whole(77));
        QCOMPARE(readingOf(values, Metric::RecipeName).value, MetricValue());
        QCOMPARE(readingOf(values, Metric::MachSpeed).value, MetricValue());
    }

    void timeInAStateIsCounted()
    {
        PlantRig rig;
        PlantValues values(rig.sources, nullptr);
        rig.connectRunning();
        const auto run = [&rig](modbus::State state, std::chrono::seconds time) {
            rig.link.status.state = state;
            rig.link.sendStatus(rig.now);
            for (auto passed = 0s; passed < time; passed += 1s) {
                rig.now += 1s;
                rig.link.sendStatus(rig.now);
            }
        };
        run(modbus::State::Running, 10s);
        QCOMPARE(readingOf(values, Metric::StateCurrentTime).value, whole(10));
        run(modbus::State::Fault, 5s);
        QCOMPARE(readingOf(values, Metric::StateCurrentTime).value, whole(5));
        QCOMPARE(readingOf(values, Metric::StateCumulativeTime).value, whole(5));
        run(modbus::State::Running, 7s);
        QCOMPARE(readingOf(values, Metric::StateCurrentTime).value, whole(7));
        QCOMPARE(readingOf(values, Metric::StateCumulativeTime).value, whole(17));
    }

    void theReasonOfTheStopIsThatOfTheStops()
    {
        PlantRig rig;
        rig.stops.setWallClock([&rig] { return rig.wallMs; });
        PlantValues values(rig.sources, nullptr);
        QSignalSpy changed(&values, &PlantValues::changed);
        rig.connectRunning();
        const auto pass = [&rig](modbus::State state, int seconds) {
            rig.link.status.state = state;
            for (int i = 0; i < seconds; ++i) {
                rig.now += 1s;
                rig.wallMs += 1000;
                rig.link.sendStatus(rig.now);
                rig.stops.check();
            }
        };
        pass(modbus::State::Running, 10);
        QCOMPARE(readingOf(values, Metric::StopReason).value, MetricValue(QString()));
        pass(modbus::State::Ready, 10);
        QCOMPARE(readingOf(values, Metric::StopReason).value, MetricValue(QString()));
        const auto before = changed.size();
        emit rig.stops.keys()->chosen({u"material"_s, u"film_change"_s, false});
        QVERIFY(changed.size() > before);
        QCOMPARE(readingOf(values, Metric::StopReason).value, MetricValue(u"material/film_change"_s));
        pass(modbus::State::Running, 2);
        QCOMPARE(readingOf(values, Metric::StopReason).value, MetricValue(QString()));
        rig.link.becomeLost();
        QCOMPARE(readingOf(values, Metric::StopReason).value, MetricValue());
    }

    void offersArePassedOn()
    {
        PlantRig rig;
        PlantFeed feed(rig.sources, rig.trail, nullptr);
        const QString path = rig.folder.filePath(u"gateway.socket"_s);
        feed.open(path);
        QList<plant::OfferMessage> offers;
        connect(&feed, &PlantFeed::offerReceived, this,
                [&offers](const plant::OfferMessage& offer) { offers << offer; });
        Client client(path);
        const plant::OfferMessage offer{u"Biscuit"_s, QByteArray(plant::maxOfferBytes, 'x')};
        client.socket.write(plant::encoded(offer));
        client.socket.write(plant::encoded(plant::OfferMessage{}));
        QTRY_COMPARE(offers.size(), 2);
        QCOMPARE(offers.first(), offer);
        QCOMPARE(offers.last(), plant::OfferMessage());
        QVERIFY(rig.link.requests.isEmpty());
    }

    void defectiveBagsAreCounted()
    {
        PlantRig rig;
        PlantValues values(rig.sources, nullptr);
        rig.connectRunning();
        const auto record = [&rig](double deviationMm, bool isStartUp, bool isChangeOver) {
            modbus::BagRecord bag;
            bag.deviationMm = deviationMm;
            bag.isStartUp = isStartUp;
            bag.isChangeOver = isChangeOver;
            emit rig.machine.packing()->bagRecorded(bag);
        };
        record(0.1, false, false);
        QCOMPARE(readingOf(values, Metric::ProdDefectiveCount).value, whole(0));
        record(-0.6, false, false); // the tolerance is 0.5 mm
        record(0, true, false);
        record(0, false, true);
        QCOMPARE(readingOf(values, Metric::ProdDefectiveCount).value, whole(3));
    }

    void aGatewayGetsAllValuesAndThenChanges()
    {
        PlantRig rig;
        PlantFeed feed(rig.sources, rig.trail, nullptr);
        const QString path = rig.folder.filePath(u"gateway.socket"_s);
        feed.open(path);
        rig.connectRunning();
        Client client(path);
        QTRY_VERIFY(!client.messages.isEmpty());
        QCOMPARE(client.messages.first().readings.size(),
                 std::ranges::count(plant::metricTable, plant::MetricOwner::Panel, &plant::MetricRow::owner));
        client.messages.clear();
        QTRY_VERIFY(!client.messages.isEmpty()); // it is alive
        rig.link.status.bagCount = 5;
        rig.link.sendStatus(rig.now);
        QTRY_COMPARE(client.last(Metric::ProdProcessedCount), whole(5));
        for (const plant::ValueMessage& message : client.messages)
            QVERIFY(message.readings.size() <= 2);
        Client second(path); // of a gateway that was started again
        QTRY_COMPARE(second.last(Metric::ProdProcessedCount), whole(5));
        client.socket.abort();
        rig.link.status.bagCount = 6;
        rig.link.sendStatus(rig.now);
        QTRY_COMPARE(second.last(Metric::ProdProcessedCount), whole(6));
    }

    // The panel waits for nobody.
    void aGatewayThatDoesNotReadIsDisconnected()
    {
        PlantRig rig;
        panel::PlantServer server(nullptr);
        const QString path = rig.folder.filePath(u"gateway.socket"_s);
        QCOMPARE(server.listen(path), QString());
        QLocalSocket deaf;
        deaf.setReadBufferSize(1);
        deaf.connectToServer(path);
        QTRY_VERIFY(server.hasClients());
        const plant::ValueMessage message{{{Metric::RecipeName, QString(200, u'x'), 0}}};
        constexpr int flood = 20'000;
        for (int i = 0; i < flood && server.hasClients(); ++i)
            server.send(message);
        QTRY_VERIFY(!server.hasClients());
    }

    void onlyAFewClientsAreServed()
    {
        PlantRig rig;
        panel::PlantServer server(nullptr);
        const QString path = rig.folder.filePath(u"gateway.socket"_s);
        QCOMPARE(server.listen(path), QString());
        std::vector<std::unique_ptr<QLocalSocket>> clients;
        for (std::size_t i = 0; i < panel::PlantServer::maxClients + 3; ++i) {
            clients.push_back(std::make_unique<QLocalSocket>());
            clients.back()->connectToServer(path);
        }
        QTRY_COMPARE(std::ranges::count(clients, QLocalSocket::UnconnectedState,
                                        [](const auto& client) { return client->state(); }),
                     3);
    }

    void garbageEndsTheConnectionOnly()
    {
        PlantRig rig;
        PlantFeed feed(rig.sources, rig.trail, nullptr);
        const QString path = rig.folder.filePath(u"gateway.socket"_s);
        feed.open(path);
        Client client(path);
        QTRY_VERIFY(!client.messages.isEmpty());
        client.socket.write("\xff\xff\xff\xffstart the machine");
        QTRY_COMPARE(client.socket.state(), QLocalSocket::UnconnectedState);
        QVERIFY(rig.link.requests.isEmpty());
        Client next(path);
        QTRY_VERIFY(!next.messages.isEmpty());
    }

    void commandsAreWrittenIntoTheAuditTrailAndNothingElse()
    {
        PlantRig rig;
        rig.connectRunning();
        rig.addAnnaAndBo();
        rig.logIn(u"Bo"_s, u"1470"_s);
        auto feed = std::make_unique<PlantFeed>(rig.sources, rig.trail, nullptr);
        const QString path = rig.folder.filePath(u"gateway.socket"_s);
        feed->open(path);
        Client client(path);
        QTRY_VERIFY(!client.messages.isEmpty());
        const auto before = rig.entries().size();
        QSignalSpy appended(&rig.trail, &panel::AuditTrail::appended);
        constexpr int commands = 500;
        for (int i = 0; i < commands; ++i)
            client.socket.write(
                plant::encoded(plant::CommandMessage{u"Command/CntrlCmd"_s, QString::number(i)}));
        QTRY_COMPARE(appended.size(), PlantFeed::maxRowsPerMinute);
        QTRY_COMPARE(client.socket.bytesToWrite(), 0);
        QTest::qWait(100);
        feed.reset(); // as at the end of the minute
        const auto entries = rig.entries().sliced(before);
        QCOMPARE(entries.size(), PlantFeed::maxRowsPerMinute + 1);
        const store::AuditEntry& first = entries.first();
        QCOMPARE(first.what, u"network.command"_s);
        QCOMPARE(first.object, u"Command/CntrlCmd"_s);
        QCOMPARE(first.after, u"0"_s);
        QCOMPARE(first.outcome, u"refused"_s);
        QCOMPARE(first.who, QString()); // not Bo
        QCOMPARE(first.level, 0);
        QCOMPARE(first.timeMs, rig.wallMs);
        QCOMPARE(entries.last().object, u"+%1"_s.arg(commands - PlantFeed::maxRowsPerMinute));
        // A flood of years does not push the changes of people out of a trail of a million rows.
        const int rowsOfFiveYears =
            (PlantFeed::maxRowsPerMinute + 1) * 5 * 366 * 24 * 60 / int(PlantFeed::periodAfter(1).count());
        QVERIFY(rowsOfFiveYears < 500'000);
        QCOMPARE(PlantFeed::periodAfter(0), std::chrono::minutes(1));
        QCOMPARE(panel::AuditWords::what(first.what), u"Command from the network"_s);
        QVERIFY(rig.link.requests.isEmpty());
        QVERIFY(std::ranges::none_of(rig.link.parameters,
                                     [](const auto& request) { return request.value.has_value(); }));
    }
};

CAMPANEL_TEST(TestPlant)

} // namespace test_plant

#include "test_plant.moc"
