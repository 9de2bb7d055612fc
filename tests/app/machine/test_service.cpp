// SPDX-License-Identifier: Apache-2.0
// What the Service page shows, on a fake link: doctor, figures, registers, frames.
#include "modbus/crc16.h"
#include "panel_rig.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTest>

using namespace campanel;
using namespace std::chrono_literals;
using machine::FrameList;
using machine::RegisterModel;
using modbus::FrameVerdict;
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

QString textAt(const QAbstractItemModel& model, int row, int role)
{
    return model.data(model.index(row, 0), role).toString();
}

// A whole frame; its number follows that of the last one.
modbus::FrameRecord frame(quint64 number, FrameVerdict verdict, std::vector<std::uint8_t> bytes,
                          modbus::RegisterSpan read = {})
{
    modbus::FrameRecord record;
    record.number = number;
    record.at = link::SteadyTime(std::chrono::milliseconds(number));
    record.verdict = verdict;
    record.readAddress = read.address;
    record.readCount = read.count;
    if (!bytes.empty()) {
        const std::uint16_t crc = modbus::crc16(bytes);
        bytes.push_back(static_cast<std::uint8_t>(crc & 0xFF));
        bytes.push_back(static_cast<std::uint8_t>(crc >> 8));
    }
    record.length = static_cast<std::uint16_t>(bytes.size());
    std::ranges::copy(bytes, record.data.begin());
    return record;
}

modbus::FrameRecord statusQuestion(quint64 number)
{
    return frame(number, FrameVerdict::Sent, {1, 23, 1, 0, 0, 40, 2, 0, 0, 3, 6, 0, 5, 0, 42, 0, 0});
}

modbus::FrameRecord startCommand(quint64 number)
{
    return frame(number, FrameVerdict::Sent,
                 {1, 23, 2, 0x30, 0, 4, 2, 0x20, 0, 6, 12, 0, 9, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0});
}

modbus::FrameRecord rampWrite(quint64 number)
{
    return frame(number, FrameVerdict::Sent, {1, 16, 0, 0x82, 0, 1, 2, 3, 0x84});
}

QStringList words(const FrameList& frames)
{
    QStringList all;
    for (int i = 0; i < frames.count(); ++i)
        all << textAt(frames, i, FrameList::WordsRole);
    return all;
}

struct InspectorRig : PanelRig {
    InspectorRig()
    {
        connectIdle();
        service.inspector()->setGroup(QStringLiteral("parameter"));
        service.inspector()->setVisibleRows(0, 2);
        service.inspector()->setWatched(true);
    }

    [[nodiscard]] machine::RegisterInspector& inspector() { return *service.inspector(); }
    [[nodiscard]] RegisterModel& registers() { return *inspector().registers(); }
    void answer(std::vector<std::uint16_t> values)
    {
        emit link.registersRead({link.reads.last(), link::ReadEnd::Done, std::move(values), now, {}});
    }
};

} // namespace

class TestService : public QObject {
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
        QCOMPARE(rig.service.doctor()->blockedReason().isEmpty(), begins);
        rig.service.doctor()->search();
        rig.service.doctor()->diagnose();
        QCOMPARE(rig.link.scans.size(), begins ? 2 : 0);
    }

    void doctorLeavesADownloadAlone()
    {
        PanelRig rig;
        rig.connectIdle();
        link::DownloadReport report;
        emit rig.link.downloadReported(report);
        QVERIFY(!rig.service.doctor()->canBegin());
        report.isInterrupted = true; // it waits for what the doctor finds
        emit rig.link.downloadReported(report);
        QVERIFY(rig.service.doctor()->canBegin());
        report = {};
        report.stage = link::DownloadStage::Active;
        emit rig.link.downloadReported(report);
        QVERIFY(rig.service.doctor()->canBegin());
    }

    void aStopEndsTheSearch()
    {
        PanelRig rig;
        link::LinkReport report;
        report.isScanning = true;
        emit rig.link.reported(report);
        QCOMPARE(rig.link.scanCancels, 0);
        report.pendingStop = modbus::Command::StopNow;
        emit rig.link.reported(report);
        QCOMPARE(rig.link.scanCancels, 1);
        QVERIFY(!rig.service.doctor()->canBegin());
    }

    void searchSaysHowFarItIs()
    {
        PanelRig rig;
        machine::LinkDoctor& doctor = *rig.service.doctor();
        doctor.search();
        QCOMPARE(rig.link.scans, QList<Depth>{Depth::Search});
        link::ScanReport report;
        report.depth = Depth::Search;
        report.isRunning = true;
        report.progress = {30, 120, "/dev/ttyUSB1", {19200, modbus::Parity::Even, 2}, 7, 11500ms};
        emit rig.link.scanReported(report);
        QVERIFY(doctor.running());
        QCOMPARE(doctor.triedText(), "Trying /dev/ttyUSB1: 19200 baud, 8E2, unit 7");
        QCOMPARE(doctor.progressText(), "30 of 120, at most 12 s more");
        QCOMPARE(doctor.progress(), 0.25);
        report.progress.remaining = 301s;
        emit rig.link.scanReported(report);
        QCOMPARE(doctor.progressText(), "30 of 120, at most 6 min more");
        doctor.cancel();
        QCOMPARE(rig.link.scanCancels, 1);
        report.isRunning = false;
        report.isCanceled = true;
        emit rig.link.scanReported(report);
        QVERIFY(!doctor.running() && !doctor.canTake());
    }

    void aFoundConnectionIsTakenOver()
    {
        PanelRig rig;
        rig.machine.open();
        machine::LinkDoctor& doctor = *rig.service.doctor();
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
        QVERIFY(!doctor.canTake()); // it is in use
        const machine::Settings stored(rig.folder.filePath(QStringLiteral("settings.ini")), nullptr);
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
            titles << textAt(*rig.service.doctor()->findings(), 0, machine::OfferModel::TitleRole);
            sentences << textAt(*rig.service.doctor()->findings(), 0, machine::OfferModel::DetailRole);
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
            return textAt(*rig.service.doctor()->findings(), 0, machine::OfferModel::DetailRole);
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
        machine::LineFigures& figures = *rig.service.figures();
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
        emit rig.link.figuresReported(report);
        QCOMPARE(figures.exchanges()->rows()[0].value, "10");
        QCOMPARE(figures.exchanges()->rows()[4].value, "68.2 %");
        QCOMPARE(figures.errors()->rows()[1].value, "1");
        QVERIFY(figures.errors()->rows()[1].isNotable && !figures.errors()->rows()[0].isNotable);
        QCOMPARE(figures.times()->rows()[3].value, "8.0 ms");
        QCOMPARE(figures.times()->rows()[4].value, "50 ms");
        QCOMPARE(figures.controller()->rows()[0].value, "--");
        QCOMPARE(figures.stripEnd(), QDateTime::fromSecsSinceEpoch(29'000'002LL * 60));
        const qsizetype last = figures.stripErrors().size() - 1;
        QCOMPARE(figures.stripErrors()[last], 1.0);
        QVERIFY(std::isnan(figures.stripP99Ms()[last]));
        QVERIFY(std::isnan(figures.stripAnswers()[last - 1])); // nothing passed in that minute
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
        machine::ReportFiles& files = *rig.service.files();
        files.setLooker([](const QString& folder) { return store::exchangePlaces(folder).last(1); });
        rig.service.figures()->exportCsv();
        QTRY_VERIFY(!files.busy());
        files.write(0);
        QTRY_VERIFY(!files.busy());
        QVERIFY2(!files.failed(), qPrintable(files.message()));
        const QDir folder(rig.folder.filePath(QStringLiteral("reports")));
        QCOMPARE(folder.entryList(QDir::Files), (QStringList{"link 24 hours.csv", "link figures.csv"}));
        QFile file(folder.filePath(QStringLiteral("link figures.csv")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("requests,1\n"));
    }

    void aPlaceThatCannotBeWrittenIsSaid()
    {
        PanelRig rig;
        machine::ReportFiles& files = *rig.service.files();
        const QString nowhere = rig.folder.filePath(QStringLiteral("nowhere"));
        files.setLooker([nowhere](const QString&) {
            return QList<store::Place>{{nowhere, QStringLiteral("NOWHERE"), false}};
        });
        rig.service.figures()->exportCsv();
        QTRY_VERIFY(!files.busy());
        files.write(0);
        QTRY_VERIFY(!files.busy());
        QVERIFY(files.failed());
        QVERIFY2(files.message().contains("choose another place"), qPrintable(files.message()));
    }

    void onlyWhatIsInSightIsRead()
    {
        InspectorRig rig;
        QCOMPARE(rig.link.reads.size(), 1); // three registers in a row
        QCOMPARE(rig.link.reads[0].address, quint16{0x80});
        QCOMPARE(rig.link.reads[0].count, quint16{3});
        QCOMPARE(textAt(rig.registers(), 2, RegisterModel::ValueRole), "--");
        rig.answer({2000, 1, 900});
        QCOMPARE(textAt(rig.registers(), 2, RegisterModel::ValueRole), "900 ms");
        QCOMPARE(textAt(rig.registers(), 2, RegisterModel::RawRole), "0x0384");
        QTRY_COMPARE(rig.link.reads.size(), 2); // and again
        rig.inspector().setVisibleRows(3, 4);
        QCOMPARE(textAt(rig.registers(), 2, RegisterModel::ValueRole), "--"); // it would grow old unseen
        rig.answer({2000, 1, 900});
        QTRY_COMPARE(rig.link.reads.size(), 3);
        QCOMPARE(rig.link.reads[2].address, quint16{0x83});
        QCOMPARE(rig.link.reads[2].count, quint16{4}); // two of two registers each
        rig.answer({0, 1000, 0, 2000});
        rig.inspector().setWatched(false);
        const qsizetype before = rig.link.reads.size();
        InspectorRig other; // time enough for several rounds
        for (int round = 2; round < 5; ++round) {
            other.answer({2000, 1, 900});
            QTRY_COMPARE(other.link.reads.size(), round);
        }
        QCOMPARE(rig.link.reads.size(), before);
    }

    void valuesGrowOldWhenNothingComes()
    {
        InspectorRig rig;
        rig.answer({2000, 1, 900});
        QVERIFY(!rig.registers().data(rig.registers().index(0), RegisterModel::StaleRole).toBool());
        rig.link.becomeLost();
        rig.now += 1100ms;
        QTRY_VERIFY(rig.registers().data(rig.registers().index(0), RegisterModel::StaleRole).toBool());
        QCOMPARE(textAt(rig.registers(), 0, RegisterModel::ValueRole), "2000 ms");
    }

    void aRegisterThatIsNotThereIsSaid()
    {
        InspectorRig rig;
        link::ReadOutcome refused{rig.link.reads.last(), link::ReadEnd::Failed, {}, rig.now, {}};
        refused.error = modbus::LinkError{modbus::LinkErrorKind::RangeNotReadable, {}, {}, {}, 0};
        emit rig.link.registersRead(refused);
        QCOMPARE(textAt(rig.registers(), 0, RegisterModel::ValueRole), "cannot be read");
    }

    void registersAreFoundByName()
    {
        PanelRig rig;
        machine::RegisterInspector& inspector = *rig.service.inspector();
        inspector.setNameFilter(QStringLiteral("CRC"));
        QVERIFY(inspector.registers()->count() > 2);
        for (int i = 0; i < inspector.registers()->count(); ++i)
            QVERIFY(textAt(*inspector.registers(), i, RegisterModel::NameRole).contains("crc"));
        inspector.setNameFilter(QStringLiteral("press_force"));
        QCOMPARE(inspector.registers()->count(), 0); // no press runs
    }

    void registersFollowTheProgram()
    {
        PanelRig rig;
        rig.service.inspector()->setNameFilter(QStringLiteral("bag_length"));
        QCOMPARE(rig.service.inspector()->registers()->count(), 0);
        rig.connectRunning(); // a cutter
        QCOMPARE(rig.service.inspector()->registers()->count(), 2);
        QCOMPARE(rig.service.inspector()->registers()->rowAt(1)->address, quint16{0x4000 + 23});
    }

    void everyRegisterSaysWhetherItCanBeWritten()
    {
        PanelRig rig;
        rig.connectRunning();
        machine::RegisterInspector& inspector = *rig.service.inspector();
        int writable = 0;
        for (int i = 0; i < inspector.registers()->count(); ++i) {
            inspector.select(i);
            const bool isParameter = inspector.selectedName().startsWith(u"parameter.");
            QCOMPARE(inspector.canWrite(), isParameter);
            QCOMPARE(inspector.selectedText().startsWith(u"Read only:"), !isParameter);
            writable += isParameter ? 1 : 0;
        }
        QCOMPARE(writable, 7);
        QVERIFY(inspector.registers()->count() > 100);
    }

    void aWriteIsProvenBeforeItIsShown()
    {
        InspectorRig rig;
        machine::RegisterInspector& inspector = rig.inspector();
        inspector.select(2);
        QCOMPARE(inspector.selectedText(), "Can be written: 50 ms to 10000 ms, by default 800 ms.");
        QVERIFY(!inspector.check(49).isEmpty() && inspector.check(50).isEmpty());
        inspector.write(49);
        QCOMPARE(rig.link.parameters.size(), 0);
        inspector.write(900);
        QCOMPARE(rig.link.parameters.size(), 1);
        QCOMPARE(rig.link.parameters[0].name, "parameter.ramp_time");
        QCOMPARE(rig.link.parameters[0].value, std::optional(900.0));
        QVERIFY(!inspector.canWrite()); // one at a time
        emit rig.link.parameterEnded(
            {rig.link.parameters[0].id, "parameter.ramp_time", link::ParameterEnd::Done, 900.0, {}});
        QCOMPARE(inspector.selectedText(), "Written, and read back from the controller: 900 ms.");
        inspector.write(1000);
        emit rig.link.parameterEnded({rig.link.parameters[1].id,
                                      "parameter.ramp_time",
                                      link::ParameterEnd::OutcomeUnknown,
                                      std::nullopt,
                                      {}});
        QVERIFY(inspector.failed());
        QVERIFY2(inspector.selectedText().contains("no proof"), qPrintable(inspector.selectedText()));
    }

    void framesAreToldInWords()
    {
        PanelRig rig;
        FrameList& frames = *rig.service.frames();
        frames.setWatched(true);
        QVERIFY(rig.link.areFramesWatched);
        emit rig.link.framesRecorded(
            {statusQuestion(1), frame(2, FrameVerdict::Silence, {}), startCommand(3),
             frame(4, FrameVerdict::Answer, {1, 23, 8, 0, 9, 0, 1, 0, 1, 0, 0}, {0x230, 4}), rampWrite(5),
             frame(6, FrameVerdict::Answer, {1, 16, 0, 0x82, 0, 1}),
             frame(7, FrameVerdict::Sent, {1, 3, 0x10, 0, 0, 2}),
             frame(8, FrameVerdict::Exception, {1, 0x83, 2})});
        const QStringList all{"Status wanted, heartbeat 42",        "No answer in time",
                              "Command Start, counter 9",           "Command Start: Done",
                              "Write parameter.ramp_time = 900 ms", "Answer: done",
                              "Read 0x1000, 2 registers",           "Exception 2: illegal register address"};
        QCOMPARE(words(frames), all);
        frames.setFilter(FrameList::Filter::Errors);
        QCOMPARE(words(frames), (QStringList{all[0], all[1], all[6], all[7]}));
        frames.setFilter(FrameList::Filter::Commands);
        QCOMPARE(words(frames), all.mid(2, 2));
        frames.setFilter(FrameList::Filter::Writes);
        QCOMPARE(words(frames), all.mid(4, 2));
        frames.showDetail(0);
        QCOMPARE(frames.detailBytes(), "01 10 00 82 00 01 02 03 84 B8 E1");
        QVERIFY(frames.detailLines().contains("parameter.ramp_time = 900 ms"));
        QVERIFY(!frames.hasPrevious() && frames.hasNext());
        frames.showNext();
        QVERIFY(!frames.hasNext());
        // A question is listed with its error also when the error comes later.
        frames.setFilter(FrameList::Filter::Errors);
        emit rig.link.framesRecorded({statusQuestion(9)});
        QCOMPARE(frames.count(), 4);
        emit rig.link.framesRecorded({frame(10, FrameVerdict::Incomplete, {1, 23})});
        QCOMPARE(frames.count(), 6);
    }

    void framesNeverGrow()
    {
        PanelRig rig;
        FrameList& frames = *rig.service.frames();
        frames.setWatched(true);
        quint64 number = 0;
        for (int batch = 0; batch < 100; ++batch) {
            QList<modbus::FrameRecord> records;
            for (int i = 0; i < 50; ++i)
                records << statusQuestion(++number);
            emit rig.link.framesRecorded(records);
        }
        QCOMPARE(frames.count(), static_cast<int>(FrameList::capacity));
        frames.showDetail(frames.count() - 1);
        QVERIFY(frames.hasPrevious() && !frames.hasNext());
        frames.setFilter(FrameList::Filter::Errors);
        QCOMPARE(frames.count(), 0);
        frames.setFilter(FrameList::Filter::All);
        frames.clear();
        QCOMPARE(frames.count(), 0);
        emit rig.link.framesRecorded({statusQuestion(number), statusQuestion(number + 1)});
        QCOMPARE(frames.count(), 1); // the first one was cleared away
    }

    void aPauseHoldsTheFrames()
    {
        PanelRig rig;
        FrameList& frames = *rig.service.frames();
        frames.setWatched(true);
        emit rig.link.framesRecorded({statusQuestion(1)});
        frames.setPaused(true);
        QVERIFY(!rig.link.areFramesWatched);
        emit rig.link.framesRecorded({statusQuestion(2)}); // was on its way
        QCOMPARE(frames.count(), 1);
        frames.setPaused(false);
        QVERIFY(rig.link.areFramesWatched);
        emit rig.link.framesRecorded({statusQuestion(1), statusQuestion(2), statusQuestion(3)});
        QCOMPARE(frames.count(), 3);
        frames.setWatched(false);
        QVERIFY(!rig.link.areFramesWatched);
    }

    void framesAreWrittenAsText()
    {
        PanelRig rig;
        FrameList& frames = *rig.service.frames();
        frames.setWatched(true);
        emit rig.link.framesRecorded({statusQuestion(1), rampWrite(2)});
        frames.setFilter(FrameList::Filter::Writes);
        machine::ReportFiles& files = *rig.service.files();
        files.setLooker([](const QString& folder) { return store::exchangePlaces(folder).last(1); });
        frames.exportText();
        QTRY_VERIFY(!files.busy());
        files.write(0);
        QTRY_VERIFY(!files.busy());
        QFile file(rig.folder.filePath(QStringLiteral("reports/link frames.txt")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        QVERIFY2(text.contains("parameter.ramp_time = 900") && !text.contains("exchange.tag"),
                 text.constData());
    }

    void theInspectorTurnsTheMasterToo()
    {
        PanelRig rig;
        rig.editor.newProgram(static_cast<int>(profile::ProgramKind::PointCam));
        rig.connectRunning();
        emit rig.link.parameterEnded(
            {rig.link.parameters[0].id, "parameter.master_direction", link::ParameterEnd::Done, 0.0, {}});
        QCOMPARE(rig.machine.direction()->way(), machine::MasterDirection::Way::Forward);
        rig.service.inspector()->setNameFilter(QStringLiteral("master_direction"));
        rig.service.inspector()->select(0);
        rig.service.inspector()->write(1);
        emit rig.link.parameterEnded(
            {rig.link.parameters[1].id, "parameter.master_direction", link::ParameterEnd::Done, 1.0, {}});
        QCOMPARE(rig.machine.direction()->way(), machine::MasterDirection::Way::Backward);
    }
};

QTEST_GUILESS_MAIN(TestService)
#include "test_service.moc"
