// SPDX-License-Identifier: Apache-2.0
// What the link does for the service pages, and a Stop that waits for the line, against the real controller
// program over a pseudo-terminal.
#include "app/link/threaded_link.h"
#include "app/program/program_image.h"
#include "tests/support/controller_process.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <optional>
#include <signal.h>

using namespace campanel;
using link::CommandEnd;
using link::ComparisonStage;
using link::LinkState;
using link::ReadEnd;
using modbus::Command;
using modbus::LineCondition;
using test::ControllerProcess;
using Depth = modbus::ScanPlan::Depth;

namespace {

constexpr int timeoutMs = 15000;

link::ConnectionSettings portSettings(const QString& port, int unit = 1)
{
    link::ConnectionSettings settings;
    settings.simulated = false;
    settings.port = port;
    settings.unit = unit;
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

// A link and everything that it says.
class Panel : public QObject {
public:
    explicit Panel(const link::ConnectionSettings& settings)
    {
        connect(&link, &link::Link::reported, this, [this](const link::LinkReport& said) { report = said; });
        connect(&link, &link::Link::statusReceived, this, [this](const link::StatusBatch& batch) {
            if (!batch.samples.isEmpty())
                status = batch.samples.last().status;
            statuses += batch.samples.size();
        });
        connect(&link, &link::Link::commandEnded, this, [this](const link::CommandOutcome& outcome) {
            if (outcome.id != 0) // what the link does by itself
                outcomes << outcome;
        });
        connect(&link, &link::Link::downloadReported, this,
                [this](const link::DownloadReport& said) { download = said; });
        connect(&link, &link::Link::registersRead, this,
                [this](const link::ReadOutcome& outcome) { reads << outcome; });
        connect(&link, &link::Link::comparisonReported, this,
                [this](const link::ComparisonReport& said) { comparisons << said; });
        connect(&link, &link::Link::scanReported, this,
                [this](const link::ScanReport& said) { scans << said; });
        connect(&link, &link::Link::figuresReported, this,
                [this](const link::FiguresReport& said) { figures << said; });
        connect(&link, &link::Link::framesRecorded, this,
                [this](const QList<modbus::FrameRecord>& recorded) { frames += recorded; });
        connect(&link, &link::Link::faultsSimulated, this,
                [this](const link::FaultsOutcome& outcome) { faults << outcome; });
        link.connectTo(settings);
    }

    [[nodiscard]] bool isConnected() const { return report.state == LinkState::Connected && status; }
    [[nodiscard]] bool isIn(modbus::State state) const { return status && status->state == state; }
    [[nodiscard]] bool scanEnded() const { return !scans.isEmpty() && !scans.last().isRunning; }
    [[nodiscard]] bool comparisonEnded() const
    {
        return !comparisons.isEmpty() && comparisons.last().stage != ComparisonStage::Reading;
    }

    void run(const program::ProgramImage& image)
    {
        link.download(image.registers);
        QTRY_COMPARE_WITH_TIMEOUT(download.stage, link::DownloadStage::Active, timeoutMs);
        link.request({1, Command::Start, {}});
        QTRY_VERIFY_WITH_TIMEOUT(isIn(modbus::State::Running), timeoutMs);
        outcomes.clear();
    }

    link::ThreadedLink link{nullptr};
    link::LinkReport report;
    std::optional<modbus::StatusBlock> status;
    qsizetype statuses = 0;
    QList<link::CommandOutcome> outcomes;
    link::DownloadReport download;
    QList<link::ReadOutcome> reads;
    QList<link::ComparisonReport> comparisons;
    QList<link::ScanReport> scans;
    QList<link::FaultsOutcome> faults;
    QList<link::FiguresReport> figures;
    QList<modbus::FrameRecord> frames;
};

} // namespace

class TestLinkService : public QObject {
    Q_OBJECT

private slots:
    void stopWaitsForTheLineAndIsSentOnce()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        controller.kill();
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.state, LinkState::Lost, timeoutMs);
        panel.link.request({1, Command::StopAtCycleEnd, {}});
        panel.link.request({2, Command::StopNow, {}});
        panel.link.request({3, Command::StopAtCycleEnd, {}});
        panel.link.request({4, Command::Start, {}});
        QTRY_COMPARE_WITH_TIMEOUT(panel.outcomes.size(), 3, timeoutMs);
        QCOMPARE(panel.report.pendingStop, Command::StopNow);
        QCOMPARE(panel.outcomes[0].id, 1u); // replaced by the more urgent one
        QCOMPARE(panel.outcomes[0].end, CommandEnd::Withdrawn);
        QCOMPARE(panel.outcomes[1].id, 3u); // less urgent than the one that waits
        QCOMPARE(panel.outcomes[1].end, CommandEnd::Withdrawn);
        QCOMPARE(panel.outcomes[2].id, 4u); // anything else is not kept
        QCOMPARE(panel.outcomes[2].end, CommandEnd::NotSent);
        controller.start();
        QElapsedTimer sinceReturn;
        sinceReturn.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel.outcomes.size(), 4, timeoutMs);
        QVERIFY2(sinceReturn.elapsed() < 2000, qPrintable(QString::number(sinceReturn.elapsed())));
        QCOMPARE(panel.outcomes[3].id, 2u);
        QCOMPARE(panel.outcomes[3].end, CommandEnd::Refused); // it reached a controller that stands
        QCOMPARE(panel.outcomes[3].reason, modbus::Refusal::NotRunning);
        QTRY_VERIFY_WITH_TIMEOUT(!panel.report.pendingStop, timeoutMs);
    }

    void withdrawnStopIsNotSent()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        controller.kill();
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.state, LinkState::Lost, timeoutMs);
        panel.link.request({1, Command::StopNow, {}});
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.pendingStop, Command::StopNow, timeoutMs);
        panel.link.withdrawStop();
        QTRY_COMPARE_WITH_TIMEOUT(panel.outcomes.size(), 1, timeoutMs);
        QCOMPARE(panel.outcomes[0].end, CommandEnd::Withdrawn);
        QTRY_VERIFY_WITH_TIMEOUT(!panel.report.pendingStop, timeoutMs);
        controller.start();
        panel.status.reset();
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected() && panel.statuses > 20, timeoutMs);
        QCOMPARE(panel.outcomes.size(), 1);
        QVERIFY(panel.status->commandCounter <= 1); // at most the clock was set
    }

    void stopForAnotherConnectionIsNotKept()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        controller.kill();
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.state, LinkState::Lost, timeoutMs);
        panel.link.request({1, Command::StopNow, {}});
        panel.link.connectTo(portSettings(QStringLiteral("/dev/ttyThatIsNotThere")));
        QTRY_COMPARE_WITH_TIMEOUT(panel.outcomes.size(), 1, timeoutMs);
        QCOMPARE(panel.outcomes[0].end, CommandEnd::NotSent);
        // Nobody was connected here, so there is nothing to stop.
        panel.link.request({2, Command::StopNow, {}});
        QTRY_COMPARE_WITH_TIMEOUT(panel.outcomes.size(), 2, timeoutMs);
        QCOMPARE(panel.outcomes[1].end, CommandEnd::NotSent);
    }

    void stopIsSentAfterAScan()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        panel.run(imageOf(250));
        panel.link.startScan(Depth::Diagnosis);
        panel.link.request({7, Command::StopNow, {}});
        QTRY_COMPARE_WITH_TIMEOUT(panel.outcomes.size(), 1, timeoutMs);
        QCOMPARE(panel.outcomes[0].id, 7u);
        QCOMPARE(panel.outcomes[0].end, CommandEnd::Done);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isIn(modbus::State::Ready), timeoutMs);
    }

    void noticesAtOnceThatThePortHungUp()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        QElapsedTimer sinceGone;
        controller.kill();
        sinceGone.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.state, LinkState::Lost, timeoutMs);
        QVERIFY2(sinceGone.elapsed() < 500, qPrintable(QString::number(sinceGone.elapsed())));
        QCOMPARE(panel.report.error->kind, modbus::LinkErrorKind::PortGone);
        controller.start();
        QElapsedTimer sinceReturn;
        sinceReturn.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.state, LinkState::Connected, timeoutMs);
        qInfo("connected %lld ms after the port's return", sinceReturn.elapsed());
        QVERIFY2(sinceReturn.elapsed() < 2000, qPrintable(QString::number(sinceReturn.elapsed())));
    }

    void downloadBeginsAnewAfterARestartOfThePanel()
    {
        ControllerProcess controller({QStringLiteral("--baud"), QStringLiteral("9600")});
        link::ConnectionSettings settings = portSettings(controller.port());
        settings.line.baud = 9600;
        {
            Panel panel(settings);
            QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
            panel.link.download(imageOf(250).registers);
            QTRY_VERIFY_WITH_TIMEOUT(panel.download.fraction > 0.3, timeoutMs);
        }
        Panel panel(settings);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        QVERIFY(!panel.status->activeCrc); // what was half sent is not active
        const auto image = imageOf(300);
        panel.link.download(image.registers);
        QTRY_COMPARE_WITH_TIMEOUT(panel.download.stage, link::DownloadStage::Active, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(panel.status->activeCrc, image.crc, timeoutMs);
    }

    void readsRegistersBetweenThePolls()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        const auto span = *modbus::findSpan("parameter.ramp_time");
        panel.link.readRegisters({1, span.address, span.count});
        QTRY_COMPARE_WITH_TIMEOUT(panel.reads.size(), 1, timeoutMs);
        QCOMPARE(panel.reads[0].end, ReadEnd::NotSent); // not connected yet
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        panel.reads.clear();
        panel.statuses = 0;
        constexpr int count = 20;
        for (quint32 id = 1; id <= count; ++id)
            panel.link.readRegisters({id, span.address, span.count});
        QTRY_COMPARE_WITH_TIMEOUT(panel.reads.size(), count, timeoutMs);
        for (quint32 id = 1; id <= count; ++id) {
            const link::ReadOutcome& read = panel.reads[id - 1];
            QCOMPARE(read.request.id, id);
            QCOMPARE(read.end, ReadEnd::Done);
            QCOMPARE(modbus::namedValues(span.address, read.registers).front().text(), std::string("800 ms"));
        }
        QVERIFY2(panel.statuses >= count / 2, qPrintable(QString::number(panel.statuses)));
    }

    void rangeThatCannotBeReadHasOneOutcome()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        panel.link.readRegisters({1, 0xF800, 4});
        panel.link.readRegisters({2, 0, modbus::readbackRegisters + 1});
        panel.link.readRegisters({3, 0, 1});
        QTRY_COMPARE_WITH_TIMEOUT(panel.reads.size(), 3, timeoutMs);
        QCOMPARE(panel.reads[0].end, ReadEnd::Failed);
        QCOMPARE(panel.reads[0].error->kind, modbus::LinkErrorKind::RangeNotReadable);
        QCOMPARE(panel.reads[1].error->kind, modbus::LinkErrorKind::ValueRefused);
        QCOMPARE(panel.reads[2].registers, std::vector<std::uint16_t>{modbus::deviceType});
    }

    void tooManyReadsAreRefusedAndAllEnd()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        constexpr quint32 count = 200;
        for (quint32 id = 1; id <= count; ++id)
            panel.link.readRegisters({id, 0, 1});
        controller.kill();
        QTRY_COMPARE_WITH_TIMEOUT(panel.reads.size(), static_cast<qsizetype>(count), timeoutMs);
        QVERIFY(std::ranges::count(panel.reads, ReadEnd::NotSent, &link::ReadOutcome::end) > 100);
    }

    void comparesTheProgramThatRuns()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        panel.link.compareProgram({});
        QTRY_VERIFY_WITH_TIMEOUT(panel.comparisonEnded(), timeoutMs);
        QCOMPARE(panel.comparisons.last().stage, ComparisonStage::NoProgram);
        const auto image = imageOf(250);
        panel.run(image);

        for (const std::vector<std::uint16_t>& expected : {image.registers, std::vector<std::uint16_t>{}}) {
            panel.comparisons.clear();
            panel.link.compareProgram(expected);
            QTRY_VERIFY_WITH_TIMEOUT(panel.comparisonEnded(), timeoutMs);
            const link::ComparisonReport last = panel.comparisons.last();
            QCOMPARE(last.stage, ComparisonStage::Equal);
            QCOMPARE(last.readCrc, image.crc);
            QCOMPARE(last.controllerCrc, image.crc);
            QCOMPARE(last.fraction, 1.0);
            QVERIFY(panel.comparisons.size() > 3); // with progress
        }

        std::vector<std::uint16_t> other = image.registers;
        other[100] = static_cast<std::uint16_t>(other[100] ^ 1u);
        other[200] = static_cast<std::uint16_t>(other[200] ^ 1u);
        panel.comparisons.clear();
        panel.link.compareProgram(other);
        QTRY_VERIFY_WITH_TIMEOUT(panel.comparisonEnded(), timeoutMs);
        const link::ComparisonReport last = panel.comparisons.last();
        QCOMPARE(last.stage, ComparisonStage::Different);
        QCOMPARE(last.differingRegisters, 2);
        QCOMPARE(last.firstDifference->offset, quint16{100});
        QCOMPARE(last.firstDifference->actual, image.registers[100]);
        QVERIFY(last.readCrc != last.expectedCrc);
    }

    void comparisonEndsWhenTheProgramChanges()
    {
        ControllerProcess controller({QStringLiteral("--baud"), QStringLiteral("9600")});
        link::ConnectionSettings settings = portSettings(controller.port());
        settings.line.baud = 9600;
        Panel panel(settings);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        const auto first = imageOf(250);
        panel.link.download(first.registers);
        QTRY_COMPARE_WITH_TIMEOUT(panel.download.stage, link::DownloadStage::Active, timeoutMs);
        panel.download = {};
        panel.link.download(imageOf(300).registers);
        QTRY_VERIFY_WITH_TIMEOUT(panel.download.fraction > 0.3, timeoutMs);
        panel.link.compareProgram(first.registers);
        QTRY_VERIFY_WITH_TIMEOUT(panel.comparisonEnded(), timeoutMs);
        QCOMPARE(panel.comparisons.last().stage, ComparisonStage::ProgramChanged);
    }

    void comparisonCanBeCanceledAndIsOneAtATime()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        panel.link.compareProgram({});
        QTRY_VERIFY_WITH_TIMEOUT(panel.comparisonEnded(), timeoutMs);
        QVERIFY(panel.comparisons.last().isConnectionMissing);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        const auto image = imageOf(250);
        panel.run(image);
        panel.comparisons.clear();
        panel.link.compareProgram(image.registers);
        panel.link.compareProgram(image.registers);
        panel.link.cancelComparison();
        QTRY_VERIFY_WITH_TIMEOUT(!panel.comparisons.isEmpty() &&
                                     panel.comparisons.last().stage == ComparisonStage::Canceled,
                                 timeoutMs);
        QCOMPARE(std::ranges::count(panel.comparisons, true, &link::ComparisonReport::isBusy), 1);
        QCOMPARE(
            std::ranges::count(panel.comparisons, ComparisonStage::Canceled, &link::ComparisonReport::stage),
            1);
    }

    void comparisonGoesOnAfterABreak()
    {
        ControllerProcess controller({QStringLiteral("--baud"), QStringLiteral("9600")});
        link::ConnectionSettings settings = portSettings(controller.port());
        settings.line.baud = 9600;
        Panel panel(settings);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        const auto image = imageOf(250);
        panel.link.download(image.registers);
        QTRY_COMPARE_WITH_TIMEOUT(panel.download.stage, link::DownloadStage::Active, timeoutMs);
        panel.link.request({1, Command::SaveToFlash, {}});
        QTRY_COMPARE_WITH_TIMEOUT(panel.outcomes.size(), 1, timeoutMs);
        panel.link.compareProgram(image.registers);
        QTRY_VERIFY_WITH_TIMEOUT(!panel.comparisons.isEmpty() && panel.comparisons.last().fraction > 0.2,
                                 timeoutMs);
        controller.kill();
        QTRY_VERIFY_WITH_TIMEOUT(panel.comparisons.last().isInterrupted, timeoutMs);
        controller.start();
        QTRY_VERIFY_WITH_TIMEOUT(panel.comparisonEnded(), timeoutMs);
        // The same program, but of another power-up: whether its generation is the same is the controller's.
        QVERIFY(panel.comparisons.last().stage == ComparisonStage::Equal ||
                panel.comparisons.last().stage == ComparisonStage::ProgramChanged);
    }

    void faultsHaveOneOutcomeAndOutliveARestart()
    {
        const QTemporaryDir folder;
        // Tells its process id and becomes the controller.
        QFile script(folder.filePath(QStringLiteral("controller.sh")));
        QVERIFY(script.open(QIODevice::WriteOnly));
        script.write("#!/bin/sh\necho $$ > '" + folder.path().toUtf8() +
                     "/pid'\nexec '" CAMPANEL_CONTROLLER "' \"$@\"\n");
        script.close();
        script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        link::ConnectionSettings settings;
        settings.simulatorProgram = script.fileName();
        settings.simulatorStateDir = folder.filePath(QStringLiteral("state"));
        Panel panel(settings);
        panel.link.simulateFaults({QStringLiteral("lost-answer")}); // before it serves
        QTRY_COMPARE_WITH_TIMEOUT(panel.faults.size(), 1, timeoutMs);
        QCOMPARE(panel.faults.last().end, link::FaultsEnd::NotServing);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);

        panel.link.simulateFaults({QStringLiteral("lost-answer probability=often")});
        QTRY_COMPARE_WITH_TIMEOUT(panel.faults.size(), 2, timeoutMs);
        QCOMPARE(panel.faults.last().end, link::FaultsEnd::Refused);
        QVERIFY2(panel.faults.last().detail.contains(QStringLiteral("'probability=often' is wrong")),
                 qPrintable(panel.faults.last().detail));

        panel.link.simulateFaults(
            {QStringLiteral("exception code=4 every=3"), QStringLiteral("noise every=7")});
        QTRY_COMPARE_WITH_TIMEOUT(panel.faults.size(), 3, timeoutMs);
        QCOMPARE(panel.faults.last().end, link::FaultsEnd::Accepted);
        const auto exceptions = [&panel] {
            return panel.figures.isEmpty()
                       ? 0U
                       : panel.figures.last().figures.errors(modbus::LinkErrorKind::Exception);
        };
        panel.link.watchFigures(true);
        QTRY_VERIFY_WITH_TIMEOUT(exceptions() > 3, timeoutMs);
        QFile pid(folder.filePath(QStringLiteral("pid")));
        QVERIFY(pid.open(QIODevice::ReadOnly));
        QCOMPARE(::kill(pid.readAll().trimmed().toInt(), SIGKILL), 0);
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.state, LinkState::Lost, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.state, LinkState::Connected, timeoutMs);
        const auto before = exceptions();
        QTRY_VERIFY_WITH_TIMEOUT(exceptions() > before + 3, timeoutMs);
        QCOMPARE(panel.faults.size(), 3); // nobody asked for the last ones
    }

    void faultsAreNotForARealLine()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        panel.link.simulateFaults({});
        QTRY_COMPARE_WITH_TIMEOUT(panel.faults.size(), 1, timeoutMs);
        QCOMPARE(panel.faults.last().end, link::FaultsEnd::NotSimulated);
    }

    void diagnosisOfAGoodLine()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        panel.link.startScan(Depth::Diagnosis);
        QTRY_VERIFY_WITH_TIMEOUT(panel.scanEnded(), timeoutMs);
        const link::ScanReport last = panel.scans.last();
        QCOMPARE(last.findings.size(), 1);
        QCOMPARE(last.findings[0].condition, LineCondition::Controller);
        QVERIFY(last.findings[0].identity);
        QVERIFY(panel.scans.first().isRunning);
        panel.status.reset();
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected() && !panel.report.isScanning, timeoutMs); // by itself
    }

    void wrongUnitIsFoundAndTakenOverInOneCall()
    {
        ControllerProcess controller({QStringLiteral("--unit"), QStringLiteral("3")});
        Panel panel(portSettings(controller.port(), 17));
        panel.link.startScan(Depth::Diagnosis);
        QTRY_VERIFY_WITH_TIMEOUT(panel.scanEnded(), timeoutMs);
        const link::ScanReport last = panel.scans.last();
        QCOMPARE(last.findings[0].condition, LineCondition::WrongUnit);
        QVERIFY(last.found);
        QCOMPARE(last.found->unit, 3);
        panel.link.connectTo(*last.found);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
    }

    void searchGoesThroughTheUnitsWithProgressAndCanBeCanceled()
    {
        ControllerProcess controller({QStringLiteral("--unit"), QStringLiteral("4")});
        Panel panel(portSettings(controller.port()));
        panel.link.startScan(Depth::Search);
        QTRY_VERIFY_WITH_TIMEOUT(!panel.scans.isEmpty() && panel.scans.last().progress.done > 3, timeoutMs);
        QVERIFY(panel.report.isScanning);
        const modbus::ScanProgress progress = panel.scans.last().progress;
        QVERIFY(progress.total >= 30 * 247);
        QVERIFY(progress.remaining > std::chrono::minutes{1});
        QCOMPARE(QString::fromStdString(progress.port), controller.port());
        panel.link.cancelScan();
        QTRY_VERIFY_WITH_TIMEOUT(panel.scanEnded(), timeoutMs);
        QVERIFY(panel.scans.last().isCanceled);
        QTRY_VERIFY_WITH_TIMEOUT(!panel.report.isScanning, timeoutMs);

        panel.link.startScan(Depth::Search);
        QTRY_VERIFY_WITH_TIMEOUT(panel.scanEnded() && panel.scans.last().found, timeoutMs);
        QVERIFY(!panel.scans.last().isCanceled);
        QCOMPARE(panel.scans.last().found->unit, 4);
    }

    void figuresAndFramesAreShownWhileWatched()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        QVERIFY(panel.figures.isEmpty() && panel.frames.isEmpty());
        panel.link.watchFigures(true);
        panel.link.watchFrames(true);
        QTRY_VERIFY_WITH_TIMEOUT(panel.figures.size() >= 3 && panel.frames.size() > 100, timeoutMs);
        const modbus::LinkFigures& last = panel.figures.last().figures;
        QVERIFY(last.answers() > panel.figures.first().figures.answers());
        QCOMPARE(last.requests(), last.answers());
        QVERIFY(last.controller() && last.controller()->requests > 0);
        QVERIFY(*last.wireShare() > 0.8 && *last.wireShare() < 1.05);
        QVERIFY(panel.figures.last().answerAllowance >= modbus::AnswerAllowance::shortest);
        for (qsizetype i = 1; i < panel.frames.size(); ++i)
            QCOMPARE(panel.frames[i].number, panel.frames[i - 1].number + 1);
        QCOMPARE(panel.frames.first().number, std::uint64_t{1}); // what was before it was watched, too
        panel.link.resetFigures();
        QTRY_VERIFY_WITH_TIMEOUT(panel.figures.last().figures.requests() < last.requests(), timeoutMs);
    }

    void figuresGoOnOverAReconnection()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        panel.link.watchFigures(true);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.figures.last().figures.answers() > 20, timeoutMs);
        const auto before = panel.figures.last().figures.answers();
        controller.kill();
        QTRY_COMPARE_WITH_TIMEOUT(panel.report.state, LinkState::Lost, timeoutMs);
        controller.start();
        QTRY_VERIFY_WITH_TIMEOUT(panel.figures.last().figures.answers() > before + 20, timeoutMs);
        QVERIFY(panel.figures.last().figures.errors(modbus::LinkErrorKind::PortGone) >= 1);
    }
};

QTEST_GUILESS_MAIN(TestLinkService)
#include "test_link_service.moc"
