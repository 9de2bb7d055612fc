// SPDX-License-Identifier: Apache-2.0
// Link doctor, figures and reports of the Service page, on a fake link.
#include "app/panel/maintenance/figures_csv.h"
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QSet>
#include <QTest>

#include <cmath>

namespace test_service {

using namespace campanel;
using namespace std::chrono_literals;
using modbus::LineCondition;
using test::PanelRig;
using Depth = modbus::ScanPlan::Depth;

namespace {

modbus::LineFinding finding(LineCondition condition)
{
    modbus::LineFinding finding;
    finding.condition = condition;
    finding.port = "/dev/ttyUSB1";
    finding.line = {19200, modbus::Parity::Even, 2};
    finding.unit = 7;
    finding.group = "dialout";
    finding.bytesSeen = 12;
    return finding;
}

link::ScanReport found()
{
    link::ScanReport report;
    report.depth = Depth::Search;
    report.findings = {finding(LineCondition::NoBytes), finding(LineCondition::WrongUnit)};
    link::ConnectionSettings settings;
    settings.simulated = false;
    settings.port = QStringLiteral("/dev/ttyUSB1");
    settings.line = {19200, modbus::Parity::Even, 2};
    settings.unit = 7;
    report.found = settings;
    return report;
}

} // namespace

class TestMaintenance : public QObject {
    Q_OBJECT

private slots:
    void doctorLeavesAMovingMachineAlone_data()
    {
        QTest::addColumn<int>("state");
        QTest::addColumn<bool>("begins");
        QTest::newRow("idle") << static_cast<int>(modbus::State::Idle) << true;
        QTest::newRow("ready") << static_cast<int>(modbus::State::Ready) << true;
        QTest::newRow("fault") << static_cast<int>(modbus::State::Fault) << true;
        QTest::newRow("running") << static_cast<int>(modbus::State::Running) << false;
        QTest::newRow("stopping") << static_cast<int>(modbus::State::Stopping) << false;
        QTest::newRow("jogging") << static_cast<int>(modbus::State::Jogging) << false;
        QTest::newRow("homing") << static_cast<int>(modbus::State::Homing) << false;
    }
    void doctorLeavesAMovingMachineAlone()
    {
        QFETCH(int, state);
        QFETCH(bool, begins);
        PanelRig rig;
        rig.connectIdle();
        rig.link.status.state = static_cast<modbus::State>(state);
        rig.link.sendStatus(rig.now);
        QCOMPARE(rig.maintenance.doctor()->blockedReason().isEmpty(), begins);
        rig.maintenance.doctor()->search();
        rig.maintenance.doctor()->diagnose();
        QCOMPARE(rig.link.scans.size(), begins ? 2 : 0);
    }

    void doctorLeavesADownloadAlone()
    {
        PanelRig rig;
        rig.connectIdle();
        link::DownloadReport report;
        emit rig.link.downloadReported(report);
        QVERIFY(!rig.maintenance.doctor()->canBegin());
        report.isInterrupted = true; // waits for the doctor's result
        emit rig.link.downloadReported(report);
        QVERIFY(rig.maintenance.doctor()->canBegin());
        report = {};
        report.stage = link::DownloadStage::Active;
        emit rig.link.downloadReported(report);
        QVERIFY(rig.maintenance.doctor()->canBegin());
    }

    void aStopEndsTheSearch()
    {
        PanelRig rig;
        link::LinkReport report;
        report.isScanning = true;
        emit rig.link.reported(report);
        QCOMPARE(rig.link.scanCancels, 0);
        QVERIFY(rig.machine.connectionText().startsWith("The diagnostics are using the ports."));
        report.pendingStop = modbus::Command::StopNow;
        emit rig.link.reported(report);
        QCOMPARE(rig.link.scanCancels, 1);
        QVERIFY(!rig.maintenance.doctor()->canBegin());
    }

    void searchSaysHowFarItIs()
    {
        PanelRig rig;
        panel::LinkDoctor& doctor = *rig.maintenance.doctor();
        doctor.search();
        QCOMPARE(rig.link.scans, QList<Depth>{Depth::Search});
        link::ScanReport report;
        report.depth = Depth::Search;
        report.isRunning = true;
        report.progress = {30, 120, "/dev/ttyUSB1", {19200, modbus::Parity::Even, 2}, 7, 11500ms};
        emit rig.link.scanReported(report);
        QVERIFY(doctor.running());
        QCOMPARE(doctor.triedText(), "Trying /dev/ttyUSB1: 19200 baud, 8E2, unit 7");
        QCOMPARE(doctor.progressText(), "30 of 120, max. 12 s left");
        QCOMPARE(doctor.progress(), 0.25);
        report.progress.remaining = 301s;
        emit rig.link.scanReported(report);
        QCOMPARE(doctor.progressText(), "30 of 120, max. 6 min left");
        doctor.cancel();
        QCOMPARE(rig.link.scanCancels, 1);
        report.isRunning = false;
        report.isCanceled = true;
        emit rig.link.scanReported(report);
        QVERIFY(!doctor.running() && !doctor.canTake());
    }

    // The first start asks before the long search.
    void aUsualSearchWithoutAControllerOffersTheLongOne()
    {
        PanelRig rig;
        panel::LinkDoctor& doctor = *rig.maintenance.doctor();
        doctor.searchUsual();
        QCOMPARE(rig.link.scans, QList<Depth>{Depth::Usual});
        link::ScanReport report;
        report.depth = Depth::Usual;
        report.isRunning = true;
        emit rig.link.scanReported(report);
        QVERIFY(!doctor.offersSearch());
        report.isRunning = false;
        emit rig.link.scanReported(report);
        QVERIFY(!doctor.offersSearch()); // there is no port
        report.findings = {modbus::LineFinding{}};
        emit rig.link.scanReported(report);
        QVERIFY(doctor.offersSearch());
        report.isCanceled = true;
        emit rig.link.scanReported(report);
        QVERIFY(!doctor.offersSearch());
        report.isCanceled = false;
        report.depth = Depth::Search;
        emit rig.link.scanReported(report);
        QVERIFY(!doctor.offersSearch()); // nothing is left to try
    }

    void aFoundConnectionIsTakenOver()
    {
        PanelRig rig;
        rig.machine.open();
        panel::LinkDoctor& doctor = *rig.maintenance.doctor();
        emit rig.link.scanReported(found());
        QVERIFY(doctor.canTake());
        QCOMPARE(doctor.foundText(), "/dev/ttyUSB1, 19200 baud, 8E2, unit 7");
        doctor.take();
        QCOMPARE(rig.link.connections.size(), 2);
        const link::ConnectionSettings& used = rig.link.connections.last();
        QVERIFY(!used.simulated);
        QCOMPARE(used.port, "/dev/ttyUSB1");
        QCOMPARE(used.line.baud, 19200U);
        QCOMPARE(used.line.parity, modbus::Parity::Even);
        QCOMPARE(used.line.stopBits, std::uint8_t{2});
        QCOMPARE(used.unit, 7);
        QVERIFY(!doctor.canTake()); // already in use
        const panel::Settings stored(rig.folder.filePath(QStringLiteral("settings.ini")), nullptr);
        QCOMPARE(stored.connection(), rig.settings.connection());
    }

    void everyConditionHasItsSentence()
    {
        PanelRig rig;
        QStringList sentences;
        QStringList titles;
        for (int i = 0; i <= static_cast<int>(LineCondition::PortGone); ++i) {
            link::ScanReport report;
            report.findings = {finding(static_cast<LineCondition>(i))};
            emit rig.link.scanReported(report);
            titles << rig.maintenance.doctor()->findings()->row(0).title;
            sentences << rig.maintenance.doctor()->findings()->row(0).detail;
            QVERIFY2(sentences.last().endsWith(u'.'), qPrintable(titles.last()));
        }
        QCOMPARE(QSet<QString>(sentences.begin(), sentences.end()).size(), sentences.size());
        QCOMPARE(QSet<QString>(titles.begin(), titles.end()).size(), titles.size());
    }

    void findingsNameWhatToDo()
    {
        PanelRig rig;
        const auto detail = [&rig](const modbus::LineFinding& finding) {
            link::ScanReport report;
            report.findings = {finding};
            emit rig.link.scanReported(report);
            return rig.maintenance.doctor()->findings()->row(0).detail;
        };
        auto busy = finding(LineCondition::PortBusy);
        busy.holders = {{812, "screen"}};
        QVERIFY(detail(busy).contains("screen (process 812)"));
        QVERIFY(detail(finding(LineCondition::PortNotPermitted)).contains("\"dialout\""));
        auto slow = finding(LineCondition::Controller);
        slow.latencyTimerMs = 16;
        QVERIFY(detail(slow).contains("16 ms"));
        slow.latencyTimerMs = 1;
        QVERIFY(!detail(slow).contains("latency timer"));
    }

    void figuresComeWhileWatched()
    {
        PanelRig rig;
        panel::LineFigures& figures = *rig.maintenance.figures();
        figures.setWatched(true);
        QVERIFY(rig.link.areFiguresWatched);
        QCOMPARE(figures.times()->rows().first().value, "--");
        link::FiguresReport report;
        report.answerAllowance = 50ms;
        const std::chrono::system_clock::time_point at{std::chrono::minutes(29'000'000)};
        for (int i = 0; i < 10; ++i) {
            report.figures.noteRequest(20, false);
            report.figures.noteAnswer(8ms, 6ms, 8ms, at);
        }
        report.figures.noteError(modbus::LinkErrorKind::BadChecksum, 8ms, at + 2min);
        report.figures.noteStrays(5);
        report.figures.noteFollowedAnswer(7);
        emit rig.link.figuresReported(report);
        QCOMPARE(figures.exchanges()->rows()[0].value, "10");
        QCOMPARE(figures.exchanges()->rows()[4].value, "12");
        QVERIFY(figures.exchanges()->rows()[4].isNotable);
        QCOMPARE(figures.exchanges()->rows()[5].value, "68.2 %");
        QCOMPARE(figures.errors()->rows()[1].value, "1");
        QVERIFY(figures.errors()->rows()[1].isNotable && !figures.errors()->rows()[0].isNotable);
        QCOMPARE(figures.times()->rows()[3].value, "8.0 ms");
        QCOMPARE(figures.times()->rows()[4].value, "50 ms");
        QCOMPARE(figures.controller()->rows()[0].value, "--");
        QCOMPARE(figures.stripEnd(), QDateTime::fromSecsSinceEpoch(29'000'002LL * 60));
        const qsizetype last = figures.stripErrors().size() - 1;
        QCOMPARE(figures.stripErrors()[last], 1.0);
        QVERIFY(std::isnan(figures.stripP99Ms()[last]));
        QVERIFY(std::isnan(figures.stripAnswers()[last - 1])); // no exchange in that minute
        QCOMPARE(figures.stripAnswers()[last - 2], 10.0);
        figures.reset();
        QCOMPARE(rig.link.figuresResets, 1);
        figures.setWatched(false);
        QVERIFY(!rig.link.areFiguresWatched);
    }

    void figuresAreWrittenAsCsv()
    {
        PanelRig rig;
        link::FiguresReport report;
        report.figures.noteRequest(20, false);
        emit rig.link.figuresReported(report);
        panel::ReportFiles& files = *rig.maintenance.files();
        files.setScanner([](const QString& folder) { return store::exchangePlaces(folder).last(1); });
        rig.maintenance.figures()->exportCsv();
        QTRY_VERIFY(!files.busy());
        files.write(0);
        QTRY_VERIFY(!files.busy());
        QVERIFY2(!files.failed(), qPrintable(files.message()));
        const QDir folder(rig.folder.filePath(QStringLiteral("reports")));
        QCOMPARE(folder.entryList(QDir::Files), (QStringList{"link 24 hours.csv", "link statistics.csv"}));
        QFile file(folder.filePath(QStringLiteral("link statistics.csv")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readLine(), QByteArray("\xEF\xBB\xBF"
                                             "figure,value\n")); // for a spreadsheet
        QVERIFY(file.readAll().contains("requests,1\n"));
    }

    void figuresHaveOneLineEach()
    {
        using namespace std::chrono_literals;
        modbus::LinkFigures figures;
        const QByteArray empty = panel::figuresCsv(figures);
        QVERIFY(empty.contains("\nlatency_p99_ms,\n")); // unknown is not zero
        QVERIFY(empty.contains("\nwire_share,\n"));
        const modbus::LinkFigures::WallTime at{std::chrono::minutes{29'000'000}};
        figures.noteRequest(19, false);
        figures.noteAnswer(12'500us, 10ms, 12'500us, at);
        figures.noteError(modbus::LinkErrorKind::BadChecksum, 1ms, at);
        const QByteArray text = panel::figuresCsv(figures);
        QVERIFY(text.startsWith("figure,value\nrequests,1\nanswers,1\n"));
        QVERIFY(text.contains("\nbad_checksum,1\n"));
        QVERIFY(text.contains("\nlatency_max_ms,12.500\n"));
        const QList<QByteArray> strip = panel::stripCsv(figures).trimmed().split('\n');
        QCOMPARE(strip.size(), qsizetype(1 + modbus::LinkFigures::stripMinutes));
        QCOMPARE(strip.last(), QByteArray("2025-02-19T21:20Z,1,0,1,0,0,0,0,12.500,12.500"));
        QCOMPARE(strip[1].count(','), strip[0].count(','));
        const QByteArray german = panel::stripCsv(figures, store::spreadsheetDialect(QLocale::German));
        QVERIFY2(german.endsWith("\n2025-02-19T21:20Z;1;0;1;0;0;0;0;12,500;12,500\n"), german.right(80));
    }

    void aPlaceThatCannotBeWrittenIsSaid()
    {
        PanelRig rig;
        panel::ReportFiles& files = *rig.maintenance.files();
        const QString nowhere = rig.folder.filePath(QStringLiteral("nowhere"));
        files.setScanner([nowhere](const QString&) {
            return QList<store::Place>{{nowhere, QStringLiteral("NOWHERE"), false}};
        });
        rig.maintenance.figures()->exportCsv();
        QTRY_VERIFY(!files.busy());
        files.write(0);
        QTRY_VERIFY(!files.busy());
        QVERIFY(files.failed());
        QVERIFY2(files.message().contains("choose another location"), qPrintable(files.message()));
    }
};

CAMPANEL_TEST(TestMaintenance)

} // namespace test_service

#include "test_maintenance.moc"
