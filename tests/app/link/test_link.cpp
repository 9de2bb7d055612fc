// SPDX-License-Identifier: Apache-2.0
// The link thread against the real controller program over a pseudo-terminal.
#include "app/link/link_worker.h"
#include "app/link/threaded_link.h"
#include "app/program/program_image.h"
#include "scripted_slave.h"
#include "tests/support/controller_process.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>

#include <csignal>
#include <memory>

namespace test_link {

using namespace campanel;
using link::DownloadStage;
using link::LinkState;
using modbus::Command;
using test::ControllerProcess;

namespace {

constexpr int timeoutMs = 15000;

link::ConnectionSettings portSettings(const QString& port, std::uint32_t baud = 115200)
{
    link::ConnectionSettings settings;
    settings.simulated = false;
    settings.port = port;
    settings.line.baud = baud;
    return settings;
}

program::ProgramImage imageOf(double bagLengthMm)
{
    program::Recipe recipe;
    recipe.cutter().bagLengthMm = bagLengthMm;
    const auto image = program::buildProgram(recipe);
    if (!image)
        qFatal("%s", program::describe(image.error()).c_str());
    return *image;
}

// Records the signals of a link.
class Listener : public QObject {
public:
    explicit Listener(link::Link& link)
    {
        connect(&link, &link::Link::reported, this, [this](const link::LinkReport& report) {
            last = report;
            states << report.state;
        });
        connect(&link, &link::Link::statusReceived, this, [this](const link::StatusBatch& batch) {
            for (const link::StatusSample& sample : batch.samples) {
                const bool isChange = !samples.isEmpty() && isOther(sample.status, samples.last().status);
                lateChanges += isChange && &sample != &batch.samples.last() ? 1 : 0;
                samples << sample;
            }
        });
        connect(&link, &link::Link::programRead, this,
                [this](const link::ActiveProgram& read) { programs << read; });
        connect(&link, &link::Link::commandEnded, this, [this](const link::CommandOutcome& outcome) {
            if (outcome.id != 0) // the link's own command
                outcomes << outcome;
        });
        connect(&link, &link::Link::parameterEnded, this,
                [this](const link::ParameterOutcome& outcome) { parameters << outcome; });
        connect(&link, &link::Link::downloadReported, this,
                [this](const link::DownloadReport& report) { downloads << report; });
    }

    [[nodiscard]] static bool isOther(const modbus::StatusBlock& one, const modbus::StatusBlock& other)
    {
        return one.state != other.state || one.stagedState != other.stagedState ||
               one.generation != other.generation || one.activeCrc != other.activeCrc;
    }
    [[nodiscard]] bool isConnected() const { return last.state == LinkState::Connected; }
    [[nodiscard]] bool isIn(modbus::State state) const
    {
        return !samples.isEmpty() && samples.last().status.state == state;
    }
    [[nodiscard]] bool downloadEnded() const
    {
        return !downloads.isEmpty() && downloads.last().stage >= DownloadStage::Active;
    }

    [[nodiscard]] link::DownloadReport download() const { return downloads.value(downloads.size() - 1); }
    [[nodiscard]] link::ActiveProgram program() const { return programs.value(programs.size() - 1); }

    link::LinkReport last;
    QList<LinkState> states;
    QList<link::StatusSample> samples;
    int lateChanges = 0; // of state or program, that waited for a later status
    QList<link::ActiveProgram> programs;
    QList<link::CommandOutcome> outcomes;
    QList<link::ParameterOutcome> parameters;
    QList<link::DownloadReport> downloads;
};

} // namespace

class TestLink : public QObject {
    Q_OBJECT

private slots:
    void startsTheSimulatedControllerAndConnects()
    {
        QTemporaryDir state;
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link::ConnectionSettings settings;
        settings.simulatorProgram = campanel::test::programPath("campanel-controller");
        settings.simulatorStateDir = state.path();
        link.connectTo(settings);
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected(), timeoutMs);
        QCOMPARE(listener.states.first(), LinkState::Searching);
        QVERIFY(listener.last.identity);
        QCOMPARE(listener.last.identity->mapMajor, modbus::mapMajor);
        QTRY_VERIFY_WITH_TIMEOUT(!listener.programs.isEmpty(), timeoutMs);
        QVERIFY(listener.programs.first().isEmpty()); // its flash is empty
    }

    // The status of a machine at standstill is requested ten times a second instead of eighty.
    void restsWhileTheMachineStands()
    {
        QTemporaryDir state;
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link::ConnectionSettings settings;
        settings.simulatorProgram = campanel::test::programPath("campanel-controller");
        settings.simulatorStateDir = state.path();
        link.connectTo(settings);
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected(), timeoutMs);
        QSignalSpy batches(&link, &link::Link::statusReceived);
        QTest::qWait(1500); // until it rests
        batches.clear();
        QTest::qWait(2000);
        QVERIFY2(batches.size() <= 25, qPrintable(QString::number(batches.size())));
        QVERIFY(batches.size() >= 2);
    }

    void anotherControllerOnTheCableIsNoticed()
    {
        campanel::test::ScriptedSlave slave;
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link::ConnectionSettings settings;
        settings.simulated = false;
        settings.port = QString::fromStdString(slave.port());
        link.connectTo(settings);
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected(), timeoutMs);
        const std::uint64_t before = listener.last.identity->uniqueId;
        slave.setRegister(0x0009, static_cast<std::uint16_t>(slave.getRegister(0x0009) + 1));
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected() && listener.last.identity->uniqueId != before,
                                 timeoutMs);
        slave.setRegister(0x0001, modbus::mapMajor + 1);
        QTRY_COMPARE_WITH_TIMEOUT(listener.last.state, LinkState::WrongDevice, timeoutMs);
    }

    void saysWhereTheSimulatedControllerWasLookedFor()
    {
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link::ConnectionSettings settings;
        settings.simulatorProgram = QStringLiteral("/nonexistent/campanel-controller");
        link.connectTo(settings);
        QTRY_COMPARE_WITH_TIMEOUT(listener.last.simulator, link::SimulatorState::Ended, timeoutMs);
        QVERIFY(!listener.last.simulatorDetail.isEmpty());
    }

    void restartsTheSimulatedControllerWhenItIsKilled()
    {
        QTemporaryDir folder;
        // Prints its process id and becomes the controller.
        QFile script(folder.filePath(QStringLiteral("controller.sh")));
        QVERIFY(script.open(QIODevice::WriteOnly));
        script.write("#!/bin/sh\necho $$ > '" + folder.path().toUtf8() + "/pid'\nexec '" +
                     campanel::test::programPath("campanel-controller").toUtf8() + "' \"$@\"\n");
        script.close();
        script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);

        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link::ConnectionSettings settings;
        settings.simulatorProgram = script.fileName();
        settings.simulatorStateDir = folder.filePath(QStringLiteral("state"));
        link.connectTo(settings);
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected(), timeoutMs);
        QFile pid(folder.filePath(QStringLiteral("pid")));
        QVERIFY(pid.open(QIODevice::ReadOnly));
        listener.states.clear();
        QCOMPARE(::kill(pid.readAll().trimmed().toInt(), SIGKILL), 0);
        QTRY_VERIFY_WITH_TIMEOUT(listener.states.contains(LinkState::Lost), timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected(), timeoutMs);
    }

    void pollsWithoutPauses_data()
    {
        QTest::addColumn<std::uint32_t>("baud");
        QTest::addColumn<int>("samples");
        QTest::addColumn<double>("minPerSecond");
        // A quarter of the limit, so that a busy computer does not fail; the benchmark checks the rate
        // itself.
        QTest::newRow("115200 baud, wire limit 80/s") << 115200u << 160 << 20.0;
        QTest::newRow("9600 baud, wire limit 8.6/s") << 9600u << 12 << 2.0;
    }

    void pollsWithoutPauses()
    {
        QFETCH(std::uint32_t, baud);
        QFETCH(int, samples);
        QFETCH(double, minPerSecond);
        ControllerProcess controller({QStringLiteral("--baud"), QString::number(baud)});
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link.connectTo(portSettings(controller.port(), baud));
        // A request now and then, so that the link does not rest.
        QTimer requests;
        connect(&requests, &QTimer::timeout, &link, [&link] {
            link.exchange({1, "parameter.ramp_time", std::nullopt});
        });
        requests.start(500);
        QTRY_VERIFY_WITH_TIMEOUT(listener.samples.size() > samples, timeoutMs);
        // The first samples share the line with the reading of the program.
        const auto first = listener.samples[2].receivedAt;
        const double seconds =
            std::chrono::duration<double>(listener.samples[samples].receivedAt - first).count();
        const double perSecond = (samples - 2) / seconds;
        qInfo("%.1f status blocks a second at %u baud", perSecond, baud);
        QVERIFY2(perSecond >= minPerSecond, qPrintable(QString::number(perSecond)));
    }

    void downloadsAndChangesTheProgramAtTheEndOfACycle()
    {
        ControllerProcess controller;
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link.connectTo(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected() && !listener.samples.isEmpty(), timeoutMs);
        const auto before = listener.samples.last().status.generation;

        const auto first = imageOf(250);
        link.download(first.registers);
        QTRY_VERIFY_WITH_TIMEOUT(listener.downloadEnded(), timeoutMs);
        QCOMPARE(listener.download().stage, DownloadStage::Active);
        QCOMPARE(listener.download().crc, first.crc);
        QTRY_COMPARE_WITH_TIMEOUT(listener.program().crc, first.crc, timeoutMs);
        QCOMPARE(listener.program().generation, before + 1);
        const auto header = listener.program().header;
        QVERIFY(std::equal(header.begin(), header.end(), first.registers.begin()));

        link.request({1, Command::Start, {}});
        QTRY_COMPARE_WITH_TIMEOUT(listener.outcomes.size(), 1, timeoutMs);
        QCOMPARE(listener.outcomes.first().end, link::CommandEnd::Done);
        QTRY_VERIFY_WITH_TIMEOUT(listener.isIn(modbus::State::Running) &&
                                     listener.samples.last().status.cycleCount >= 2,
                                 timeoutMs);

        listener.samples.clear();
        listener.downloads.clear();
        const auto second = imageOf(300);
        link.download(second.registers);
        QTRY_VERIFY_WITH_TIMEOUT(listener.downloadEnded(), timeoutMs);
        QCOMPARE(listener.download().stage, DownloadStage::Active);
        QVERIFY(std::ranges::any_of(listener.downloads, [](const link::DownloadReport& report) {
            return report.stage == DownloadStage::Armed;
        }));
        QTRY_COMPARE_WITH_TIMEOUT(listener.program().crc, second.crc, timeoutMs);
        QCOMPARE(listener.program().generation, before + 2);
        // It changed between two cycles, and the knife never reversed.
        for (qsizetype i = 1; i < listener.samples.size(); ++i) {
            const auto& last = listener.samples[i - 1].status;
            const auto& next = listener.samples[i].status;
            QVERIFY(next.commandedPositionPulses >= last.commandedPositionPulses);
            // A cycle is counted with its last pulse, the programs change with the first pulse of the next
            // one: a status in between is at angle 0.
            if (next.generation != last.generation)
                QVERIFY(next.cycleCount > last.cycleCount || last.masterAngleDeg == 0.0);
        }
        QVERIFY(listener.isIn(modbus::State::Running));
    }

    // Also while statuses come faster than batches.
    void aChangeEndsItsBatch()
    {
        const ControllerProcess controller({QStringLiteral("--no-pacing")});
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link.connectTo(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected() && !listener.samples.isEmpty(), timeoutMs);
        link.download(imageOf(250).registers);
        QTRY_VERIFY_WITH_TIMEOUT(listener.downloadEnded(), timeoutMs);
        for (int i = 0; i < 8; ++i) {
            link.request({1, Command::Start, {}});
            QTRY_VERIFY_WITH_TIMEOUT(listener.isIn(modbus::State::Running), timeoutMs);
            link.request({1, Command::StopNow, {}});
            QTRY_VERIFY_WITH_TIMEOUT(listener.isIn(modbus::State::Ready), timeoutMs);
        }
        QCOMPARE(listener.lateChanges, 0);
    }

    void showsTheRunningProgramToAPanelThatComesLater()
    {
        ControllerProcess controller;
        const auto image = imageOf(200);
        std::uint32_t generation = 0;
        {
            link::ThreadedLink link(nullptr);
            Listener listener(link);
            link.connectTo(portSettings(controller.port()));
            QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected(), timeoutMs);
            link.download(image.registers);
            QTRY_VERIFY_WITH_TIMEOUT(listener.downloadEnded(), timeoutMs);
            link.request({1, Command::Start, {}});
            QTRY_VERIFY_WITH_TIMEOUT(listener.isIn(modbus::State::Running), timeoutMs);
            generation = listener.samples.last().status.generation;
        }
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link.connectTo(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(!listener.programs.isEmpty(), timeoutMs);
        QCOMPARE(listener.programs.first().crc, image.crc);
        QCOMPARE(listener.programs.first().generation, generation);
        QVERIFY(listener.isIn(modbus::State::Running));
    }

    void comesBackAfterTheControllerWasKilled()
    {
        ControllerProcess controller;
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link.connectTo(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected(), timeoutMs);
        controller.kill();
        QTRY_COMPARE_WITH_TIMEOUT(listener.last.state, LinkState::Lost, timeoutMs);
        QVERIFY(listener.last.error);
        link.request({7, Command::Start, {}});
        QTRY_COMPARE_WITH_TIMEOUT(listener.outcomes.size(), 1, timeoutMs);
        QCOMPARE(listener.outcomes.first().id, 7u);
        QCOMPARE(listener.outcomes.first().end, link::CommandEnd::NotSent);
        controller.start();
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected(), timeoutMs);
    }

    void readsAndWritesAParameterByItsName()
    {
        ControllerProcess controller;
        {
            link::ThreadedLink link(nullptr);
            Listener listener(link);
            link.connectTo(portSettings(controller.port()));
            QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected(), timeoutMs);
            link.exchange({1, "parameter.ramp_time", std::nullopt});
            link.exchange({2, "parameter.ramp_time", 651.3});
            link.exchange({3, "parameter.jog_frequency", 19'999});
            link.exchange({4, "identity.timer_clock", std::nullopt});
            QTRY_COMPARE_WITH_TIMEOUT(listener.parameters.size(), 4, timeoutMs);
            for (const link::ParameterOutcome& outcome : listener.parameters)
                QCOMPARE(outcome.end, link::ParameterEnd::Done);
            QCOMPARE(listener.parameters[0].value, 800.0);
            QCOMPARE(listener.parameters[1].value, 651.0); // as the register holds it
            QCOMPARE(listener.parameters[2].value, 19'999.0);
            QCOMPARE(listener.parameters[3].id, 4u);
            QCOMPARE(listener.parameters[3].name, "identity.timer_clock");
            QCOMPARE(listener.parameters[3].value, double(listener.last.identity->timerClockHz));
        }
        link::ThreadedLink later(nullptr);
        Listener listener(later);
        later.connectTo(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected(), timeoutMs);
        later.exchange({1, "parameter.ramp_time", std::nullopt});
        QTRY_COMPARE_WITH_TIMEOUT(listener.parameters.size(), 1, timeoutMs);
        QCOMPARE(listener.parameters[0].value, 651.0);
    }

    void refusesWhatIsNoParameterOrOutOfItsLimits_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("value");
        QTest::newRow("above the limit") << "parameter.master_direction" << 2.0;
        QTest::newRow("below the limit") << "parameter.ramp_time" << 49.0;
        QTest::newRow("not a number") << "parameter.ramp_time" << qQNaN();
        QTest::newRow("unknown") << "parameter.color" << 1.0;
        QTest::newRow("read only") << "status.state" << 1.0;
        QTest::newRow("part of a protocol") << "exchange.heartbeat" << 1.0;
        QTest::newRow("of a bank") << "bank.advance" << 1.0;
    }

    void refusesWhatIsNoParameterOrOutOfItsLimits()
    {
        QFETCH(QString, name);
        QFETCH(double, value);
        ControllerProcess controller;
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link.connectTo(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected(), timeoutMs);
        link.exchange({5, name.toStdString(), value});
        QTRY_COMPARE_WITH_TIMEOUT(listener.parameters.size(), 1, timeoutMs);
        QCOMPARE(listener.parameters[0].id, 5u);
        QCOMPARE(listener.parameters[0].end, link::ParameterEnd::Refused);
        QVERIFY(!listener.parameters[0].value);
        QVERIFY(listener.parameters[0].error);
        listener.samples.clear();
        QTRY_VERIFY_WITH_TIMEOUT(!listener.samples.isEmpty(), timeoutMs); // the line continues
        QCOMPARE(listener.parameters.size(), 1);
    }

    void aParameterEndsWithoutAConnectionToo()
    {
        ControllerProcess controller;
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link.exchange({1, "parameter.master_direction", 1});
        QTRY_COMPARE_WITH_TIMEOUT(listener.parameters.size(), 1, timeoutMs);
        QCOMPARE(listener.parameters[0].end, link::ParameterEnd::NotSent);
        link.connectTo(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected(), timeoutMs);
        controller.kill();
        QTRY_COMPARE_WITH_TIMEOUT(listener.last.state, LinkState::Lost, timeoutMs);
        link.exchange({2, "parameter.master_direction", std::nullopt});
        QTRY_COMPARE_WITH_TIMEOUT(listener.parameters.size(), 2, timeoutMs);
        QCOMPARE(listener.parameters[1].id, 2u);
        QCOMPARE(listener.parameters[1].end, link::ParameterEnd::NotSent);
        controller.start();
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected(), timeoutMs);
        link.exchange({3, "parameter.master_direction", std::nullopt});
        QTRY_COMPARE_WITH_TIMEOUT(listener.parameters.size(), 3, timeoutMs);
        QCOMPARE(listener.parameters[2].value, 0.0); // nothing is stored for a later write
    }

    void stopPressedDuringADownloadIsTheNextExchange()
    {
        ControllerProcess controller;
        bool isConnected = false;
        std::optional<modbus::StatusBlock> status;
        link::DownloadReport download;
        QList<link::CommandOutcome> outcomes;
        int exchangesBeforeStop = 0;
        bool isPressed = false;
        link::LinkWorker worker; // in this thread, so that its exchanges can be counted
        connect(&worker, &link::LinkWorker::reported, this,
                [&](const link::LinkReport& report) { isConnected = report.state == LinkState::Connected; });
        connect(&worker, &link::LinkWorker::statusReceived, this, [&](const link::StatusBatch& batch) {
            if (!batch.samples.isEmpty())
                status = batch.samples.last().status;
            if (isPressed && outcomes.isEmpty())
                ++exchangesBeforeStop;
        });
        connect(&worker, &link::LinkWorker::commandEnded, this, [&](const link::CommandOutcome& outcome) {
            if (outcome.id != 0)
                outcomes << outcome;
        });
        connect(&worker, &link::LinkWorker::downloadReported, this, [&](const link::DownloadReport& report) {
            download = report;
            if (isPressed && outcomes.isEmpty())
                ++exchangesBeforeStop;
        });
        worker.connectTo(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(isConnected && status, timeoutMs);
        worker.download(imageOf(250).registers);
        QTRY_COMPARE_WITH_TIMEOUT(download.stage, DownloadStage::Active, timeoutMs);
        worker.request({1, Command::Start, {}});
        QTRY_VERIFY_WITH_TIMEOUT(status->state == modbus::State::Running, timeoutMs);
        QCOMPARE(outcomes.size(), 1);
        outcomes.clear();

        // The press arrives by the event queue, as from another thread, during the transfer, after less
        // urgent requests.
        connect(&worker, &link::LinkWorker::downloadReported, &worker, [&] {
            if (isPressed || download.fraction < 0.3)
                return;
            isPressed = true;
            const auto press = [&worker] {
                worker.request({2, Command::DiscardStaged, {}});
                worker.request({3, Command::StopNow, {}});
            };
            QMetaObject::invokeMethod(&worker, press, Qt::QueuedConnection);
        });
        worker.download(imageOf(300).registers);
        QTRY_VERIFY_WITH_TIMEOUT(!outcomes.isEmpty(), timeoutMs);
        QCOMPARE(outcomes.first().id, 3u);
        QCOMPARE(outcomes.first().end, link::CommandEnd::Done);
        QCOMPARE(exchangesBeforeStop, 0);
        QVERIFY(download.fraction < 1);
        QTRY_VERIFY_WITH_TIMEOUT(
            status->state == modbus::State::Stopping || status->state == modbus::State::Ready, timeoutMs);
    }

    void downloadGoesOnAfterABreak()
    {
        ControllerProcess controller({QStringLiteral("--baud"), QStringLiteral("9600")});
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link.connectTo(portSettings(controller.port(), 9600));
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected() && !listener.samples.isEmpty(), timeoutMs);
        const auto image = imageOf(250);
        link.download(image.registers);
        QTRY_VERIFY_WITH_TIMEOUT(listener.download().fraction > 0.2, timeoutMs);
        controller.kill();
        QTRY_VERIFY_WITH_TIMEOUT(listener.download().isInterrupted, timeoutMs);
        controller.start();
        QTRY_VERIFY_WITH_TIMEOUT(listener.downloadEnded(), timeoutMs);
        QCOMPARE(listener.download().stage, DownloadStage::Active);
        QTRY_COMPARE_WITH_TIMEOUT(listener.samples.last().status.activeCrc, image.crc, timeoutMs);
    }

    void canceledDownloadLeavesTheProgram()
    {
        ControllerProcess controller({QStringLiteral("--baud"), QStringLiteral("9600")});
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link.connectTo(portSettings(controller.port(), 9600));
        QTRY_VERIFY_WITH_TIMEOUT(listener.isConnected() && !listener.samples.isEmpty(), timeoutMs);
        link.download(imageOf(250).registers);
        QTRY_VERIFY_WITH_TIMEOUT(listener.download().fraction > 0.2, timeoutMs);
        link.cancelDownload();
        QTRY_VERIFY_WITH_TIMEOUT(listener.downloadEnded(), timeoutMs);
        QCOMPARE(listener.download().stage, DownloadStage::Canceled);
        listener.samples.clear();
        QTRY_VERIFY_WITH_TIMEOUT(!listener.samples.isEmpty(), timeoutMs);
        QVERIFY(!listener.samples.last().status.activeCrc);
        QCOMPARE(listener.samples.last().status.stagedState, modbus::StagedState::Empty);
    }

    void namesWhyAPortCannotBeUsed_data()
    {
        QTest::addColumn<QString>("port");
        QTest::addColumn<LinkState>("state");
        QTest::addColumn<modbus::LinkErrorKind>("kind");
        QTest::newRow("absent") << "/dev/ttyThatIsNotThere" << LinkState::Searching
                                << modbus::LinkErrorKind::PortAbsent;
        QTest::newRow("not a serial port")
            << "/dev/null" << LinkState::PortProblem << modbus::LinkErrorKind::PortNotSerial;
    }

    void namesWhyAPortCannotBeUsed()
    {
        QFETCH(QString, port);
        QFETCH(LinkState, state);
        QFETCH(modbus::LinkErrorKind, kind);
        link::ThreadedLink link(nullptr);
        Listener listener(link);
        link.connectTo(portSettings(port));
        QTRY_VERIFY_WITH_TIMEOUT(listener.last.error.has_value(), timeoutMs);
        QCOMPARE(listener.last.state, state);
        QCOMPARE(listener.last.error->kind, kind);
    }

    void aPortInUseIsNotTakenAway()
    {
        ControllerProcess controller;
        link::ThreadedLink first(nullptr);
        Listener firstListener(first);
        first.connectTo(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(firstListener.isConnected(), timeoutMs);
        link::ThreadedLink second(nullptr);
        Listener secondListener(second);
        second.connectTo(portSettings(controller.port()));
        QTRY_COMPARE_WITH_TIMEOUT(secondListener.last.state, LinkState::PortProblem, timeoutMs);
        QCOMPARE(secondListener.last.error->kind, modbus::LinkErrorKind::PortBusy);
        firstListener.samples.clear();
        QTRY_VERIFY_WITH_TIMEOUT(firstListener.samples.size() > 5, timeoutMs);
        QVERIFY(firstListener.isConnected());
    }
};

CAMPANEL_TEST(TestLink)

} // namespace test_link

#include "test_link.moc"
