// SPDX-License-Identifier: Apache-2.0
// The link's functions for the service pages, with the real controller program over a pseudo-terminal.
#include "link_panel.h"
#include "tests/support/controller_process.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <signal.h>

namespace test_link_service {

using namespace campanel;
using link::ComparisonStage;
using link::LinkState;
using link::ReadEnd;
using modbus::Command;
using modbus::LineCondition;
using test::ControllerProcess;
using test::imageOf;
using test::Panel;
using test::portSettings;
using test::timeoutMs;
using Depth = modbus::ScanPlan::Depth;

static QString noPort()
{
    return QStringLiteral("/dev/no-such-port");
}

class TestLinkService : public QObject {
    Q_OBJECT

private slots:
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
        QVERIFY(!panel.status->activeCrc); // a partial download is not active
        const auto image = imageOf(300);
        panel.link.download(image.registers);
        QTRY_COMPARE_WITH_TIMEOUT(panel.download.stage, link::DownloadStage::Active, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(panel.status->activeCrc, image.crc, timeoutMs);
    }

    void readsRegistersBetweenThePolls()
    {
        const auto span = *modbus::findSpan("parameter.ramp_time");
        Panel unconnected(portSettings(noPort()));
        unconnected.link.readRegisters({1, span.address, span.count});
        QTRY_COMPARE_WITH_TIMEOUT(unconnected.reads.size(), 1, timeoutMs);
        QCOMPARE(unconnected.reads[0].end, ReadEnd::NotSent);
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
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
        Panel unconnected(portSettings(noPort()));
        unconnected.link.compareProgram({});
        QTRY_VERIFY_WITH_TIMEOUT(unconnected.comparisonEnded(), timeoutMs);
        QVERIFY(unconnected.comparisons.last().isConnectionMissing);
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
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
        // The same program after another power-up: the controller decides if its generation is the same.
        QVERIFY(panel.comparisons.last().stage == ComparisonStage::Equal ||
                panel.comparisons.last().stage == ComparisonStage::ProgramChanged);
    }

    void faultsHaveOneOutcomeAndOutliveARestart()
    {
        const QTemporaryDir folder;
        // Prints its process id and becomes the controller.
        QFile script(folder.filePath(QStringLiteral("controller.sh")));
        QVERIFY(script.open(QIODevice::WriteOnly));
        script.write("#!/bin/sh\necho $$ > '" + folder.path().toUtf8() + "/pid'\nexec '" +
                     campanel::test::programPath("campanel-controller").toUtf8() + "' \"$@\"\n");
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
        QCOMPARE(panel.faults.size(), 3); // no answers for unrequested ones
    }

    // A fault of the machine is no rule of the connection: it goes in a line of its own, when it changes.
    void statementsAboutTheMachineAreSentAlone()
    {
        const QTemporaryDir folder;
        QFile script(folder.filePath(QStringLiteral("controller.sh")));
        QVERIFY(script.open(QIODevice::WriteOnly));
        script.write("#!/bin/sh\necho /dev/nothing\nwhile read -r line; do\n  echo \"$line\" >>'" +
                     folder.path().toUtf8() +
                     "/lines'\n  case $line in jam*|line*) echo \"$line\" ;; *) echo 'ok 0' ;; esac\ndone\n");
        script.close();
        script.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        link::ConnectionSettings settings;
        settings.simulatorProgram = script.fileName();
        Panel panel(settings);
        const auto simulate = [&panel](const QStringList& rules) {
            const qsizetype before = panel.faults.size();
            QTRY_VERIFY_WITH_TIMEOUT(
                (panel.link.simulateFaults(rules), QTest::qWait(100),
                 panel.faults.size() > before && panel.faults.last().end == link::FaultsEnd::Accepted),
                timeoutMs);
        };
        simulate({});
        simulate({QStringLiteral("noise every=7"), QStringLiteral("jam on"), QStringLiteral("late every=9")});
        simulate({QStringLiteral("jam on")});
        simulate({});
        simulate({QStringLiteral("line start 125"), QStringLiteral("line lose 7")});
        simulate({QStringLiteral("line start 250"), QStringLiteral("line lose 7")});
        simulate({});
        QFile lines(folder.filePath(QStringLiteral("lines")));
        QVERIFY(lines.open(QIODevice::ReadOnly));
        QByteArrayList told = lines.readAll().trimmed().split('\n');
        told.erase(std::unique(told.begin(), told.end()), told.end()); // a slow machine asks more than once
        QCOMPARE(told, (QByteArrayList{"clear", "jam on", "noise every=7; late every=9", "clear", "jam off",
                                       "clear", "line start 125", "line lose 7", "clear", "line stop",
                                       "line start 250", "clear", "line stop", "line lose 0", "clear"}));
    }

    void theRulerHasOneOutcome()
    {
        const QTemporaryDir folder;
        link::ConnectionSettings settings;
        settings.simulatorProgram = campanel::test::programPath("campanel-controller");
        settings.simulatorStateDir = folder.filePath(QStringLiteral("state"));
        Panel panel(settings);
        QList<link::RulerEnd> ends;
        QObject::connect(&panel.link, &link::Link::rulerRead, &panel.link,
                         [&ends](const link::RulerOutcome& outcome) { ends << outcome.end; });
        panel.link.measureSimulatedBag(); // before it serves
        QTRY_COMPARE_WITH_TIMEOUT(ends.size(), 1, timeoutMs);
        QCOMPARE(ends.last(), link::RulerEnd::NotServing);
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        panel.link.measureSimulatedBag();
        panel.link.simulateFaults({QStringLiteral("lost-answer limit=1")});
        panel.link.measureSimulatedBag();
        QTRY_COMPARE_WITH_TIMEOUT(ends.size(), 3, timeoutMs);
        QCOMPARE(ends, (QList{link::RulerEnd::NotServing, link::RulerEnd::NoBag, link::RulerEnd::NoBag}));
        QTRY_COMPARE_WITH_TIMEOUT(panel.faults.size(), 1, timeoutMs);
        QCOMPARE(panel.faults.last().end, link::FaultsEnd::Accepted);

        ControllerProcess controller;
        Panel real(portSettings(controller.port()));
        QObject::connect(&real.link, &link::Link::rulerRead, &real.link,
                         [&ends](const link::RulerOutcome& outcome) { ends << outcome.end; });
        real.link.measureSimulatedBag();
        QTRY_COMPARE_WITH_TIMEOUT(ends.size(), 4, timeoutMs);
        QCOMPARE(ends.last(), link::RulerEnd::NotSimulated);
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
        int losses = 0; // a diagnosis interrupts the line, nothing is lost
        connect(&panel.link, &link::Link::reported, this, [&losses](const link::LinkReport& said) {
            losses += said.state == link::LinkState::Lost && !said.isScanning ? 1 : 0;
        });
        panel.link.startScan(Depth::Diagnosis);
        QTRY_VERIFY_WITH_TIMEOUT(panel.scanEnded(), timeoutMs);
        const link::ScanReport last = panel.scans.last();
        QCOMPARE(last.findings.size(), 1);
        QCOMPARE(last.findings[0].condition, LineCondition::Controller);
        QVERIFY(last.findings[0].identity);
        QVERIFY(panel.scans.first().isRunning);
        panel.status.reset();
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected() && !panel.report.isScanning, timeoutMs); // automatically
        QCOMPARE(losses, 0);
    }

    void aSecondDiagnosisLosesNothingEither()
    {
        ControllerProcess controller;
        Panel panel(portSettings(controller.port()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected(), timeoutMs);
        int losses = 0;
        connect(&panel.link, &link::Link::reported, this, [&losses](const link::LinkReport& said) {
            losses += said.state == link::LinkState::Lost && !said.isScanning ? 1 : 0;
        });
        panel.link.startScan(Depth::Diagnosis);
        panel.link.startScan(Depth::Diagnosis); // before the first has ended
        QTRY_VERIFY_WITH_TIMEOUT(panel.scanEnded(), timeoutMs);
        panel.status.reset();
        QTRY_VERIFY_WITH_TIMEOUT(panel.isConnected() && !panel.report.isScanning, timeoutMs);
        QCOMPARE(losses, 0);
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
        const modbus::LinkFigures last = panel.figures.last().figures; // more arrive, and move the list
        QVERIFY(last.answers() > panel.figures.first().figures.answers());
        QCOMPARE(last.requests(), last.answers());
        QVERIFY(last.controller() && last.controller()->requests > 0);
        QVERIFY(*last.wireShare() > 0.1 && *last.wireShare() < 1.05); // the benchmark checks how near to 1
        QVERIFY(panel.figures.last().answerAllowance >= modbus::AnswerAllowance::shortest);
        for (qsizetype i = 1; i < panel.frames.size(); ++i)
            QCOMPARE(panel.frames[i].number, panel.frames[i - 1].number + 1);
        QCOMPARE(panel.frames.first().number, std::uint64_t{1}); // also earlier ones
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

CAMPANEL_TEST(TestLinkService)

} // namespace test_link_service

#include "test_link_service.moc"
