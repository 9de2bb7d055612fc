// SPDX-License-Identifier: Apache-2.0
// The panel's reports on the line: lost and restored, a waiting Stop, the proof of the active program, and
// the faults of a simulated line.
#include "tests/app/panel/panel_rig.h"
#include "tests/support/test_program.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>

namespace test_line_honesty {

using namespace campanel;
using link::CommandEnd;
using link::ComparisonReport;
using link::ComparisonStage;
using modbus::Command;
using panel::Controller;
using panel::ProgramProof;
using panel::SimulatedFaults;
using test::PanelRig;
using namespace std::chrono_literals;

class TestLineHonesty : public QObject {
    Q_OBJECT

private slots:
    void lostLineSaysSinceWhenAndWhatIsTried();
    void stopWaitsAndIsToldOf_data();
    void stopWaitsAndIsToldOf();
    void stopPressedAgainIsMoreUrgent();
    void othersAreNeverSentLater();
    void changesMeanwhileAreTold();
    void positionGoesOnWhereItsRegisterWraps();
    void valuesOfAnotherProgramAreNotScaled();
    void lostLineClaimsNothingOfTheController();
    void proofComparesWithWhatWasDownloaded();
    void proofIsRebuiltFromTheController_data();
    void proofIsRebuiltFromTheController();
    void proofNamesTheFirstDifference();
    void proofEndsInWords_data();
    void proofEndsInWords();
    void proofIsOfOneProgram();
    void faultsAreThoseThatTheControllerTook();
    void faultsEndWithTheirController();

private:
    static link::CommandOutcome outcomeOf(const link::CommandRequest& request, CommandEnd end,
                                          modbus::Refusal reason = modbus::Refusal::None)
    {
        return {request.id, request.command, end, reason, std::nullopt};
    }
};

void TestLineHonesty::lostLineSaysSinceWhenAndWhatIsTried()
{
    PanelRig rig;
    rig.machine.setWallClock([] { return QDateTime(QDate(2026, 1, 15), QTime(14, 7, 5)); });
    rig.connectRunning();
    rig.link.becomeLost();
    rig.machine.setWallClock([] { return QDateTime(QDate(2026, 1, 15), QTime(14, 8, 0)); });
    rig.link.becomeLost(); // tried again
    const QString text = rig.machine.connectionText();
    for (const char* words : {"since 14:07:05", "/dev/fake", "reconnects automatically"})
        QVERIFY2(text.contains(QLatin1String(words)), qPrintable(text));
    // The age increases.
    rig.now += 4s;
    QCOMPARE(rig.machine.ageMs(), 4000.0);
    rig.now += 60s;
    QCOMPARE(rig.machine.ageMs(), 64000.0);
}

void TestLineHonesty::stopWaitsAndIsToldOf_data()
{
    QTest::addColumn<int>("end");
    QTest::addColumn<int>("reason");
    QTest::addColumn<QString>("words");
    const auto none = static_cast<int>(modbus::Refusal::None);
    QTest::newRow("sent") << static_cast<int>(CommandEnd::Done) << none
                          << "Connection restored: Stop was sent, and the controller accepted the command.";
    QTest::newRow("no longer running")
        << static_cast<int>(CommandEnd::Refused) << static_cast<int>(modbus::Refusal::NotRunning)
        << "Connection restored: Stop was sent, but the machine was no longer running.";
    QTest::newRow("withdrawn") << static_cast<int>(CommandEnd::Withdrawn) << none
                               << "Stop was withdrawn and will not be sent.";
    QTest::newRow("another machine") << static_cast<int>(CommandEnd::NotSent) << none
                                     << "Stop was not sent: a different machine is connected now.";
}

void TestLineHonesty::stopWaitsAndIsToldOf()
{
    QFETCH(int, end);
    QFETCH(int, reason);
    QFETCH(QString, words);
    PanelRig rig;
    rig.connectRunning();
    rig.link.becomeLost();
    rig.machine.stop();
    QCOMPARE(rig.link.requests.size(), 1);
    QCOMPARE(rig.link.requests.last().command, Command::StopAtCycleEnd);
    rig.link.becomeLost(Command::StopAtCycleEnd);
    QVERIFY(rig.machine.stopWaits());
    QVERIFY2(rig.machine.stopWaitsText().startsWith("Stop is not sent yet."),
             qPrintable(rig.machine.stopWaitsText()));
    rig.machine.withdrawStop();
    QCOMPARE(rig.link.withdrawals, 1);
    rig.link.becomeConnected(); // the waiting Stop is being sent
    QVERIFY(!rig.machine.stopWaits());
    emit rig.link.commandEnded(outcomeOf(rig.link.requests.last(), static_cast<CommandEnd>(end),
                                         static_cast<modbus::Refusal>(reason)));
    QCOMPARE(rig.machine.commandMessage(), words);
}

void TestLineHonesty::stopPressedAgainIsMoreUrgent()
{
    PanelRig rig;
    rig.connectRunning();
    rig.link.becomeLost();
    rig.machine.stop();
    rig.link.becomeLost(Command::StopAtCycleEnd);
    rig.now += std::chrono::milliseconds(400);
    rig.machine.stop();
    QCOMPARE(rig.link.requests.last().command, Command::StopNow);
    // The replaced one ends first, without a report.
    emit rig.link.commandEnded(outcomeOf(rig.link.requests.first(), CommandEnd::Withdrawn));
    QVERIFY(rig.machine.commandMessage().isEmpty());
}

void TestLineHonesty::othersAreNeverSentLater()
{
    PanelRig rig;
    rig.connectRunning();
    rig.link.becomeLost();
    rig.machine.start();
    QVERIFY(rig.link.requests.isEmpty());
    QCOMPARE(rig.machine.commandMessage(), "There is no connection to the controller.");
    rig.machine.home();
    emit rig.link.commandEnded(outcomeOf(rig.link.requests.last(), CommandEnd::NotSent));
    QCOMPARE(rig.machine.commandMessage(),
             "Reference run was not sent: there is no connection to the controller.");
    rig.link.becomeConnected();
    rig.link.sendStatus(rig.now);
    QCOMPARE(rig.link.requests.size(), 1);
}

void TestLineHonesty::changesMeanwhileAreTold()
{
    PanelRig rig;
    rig.connectRunning();
    rig.link.becomeLost();
    rig.link.becomeConnected();
    rig.link.sendStatus(rig.now);
    QVERIFY2(rig.machine.commandMessage().isEmpty(), qPrintable(rig.machine.commandMessage()));
    rig.link.becomeLost();
    rig.link.status.state = modbus::State::Ready;
    rig.link.becomeConnected();
    rig.link.sendStatus(rig.now);
    QCOMPARE(rig.machine.commandMessage(), "Connection restored. Before: Running. Now: Ready.");
    QCOMPARE(rig.machine.state(), Controller::State::Ready);
    rig.link.becomeLost(); // the return is over
    QVERIFY2(rig.machine.commandMessage().isEmpty(), qPrintable(rig.machine.commandMessage()));
}

// The registers have 32 bits: an axis that turns one way for ever counts through their end.
void TestLineHonesty::positionGoesOnWhereItsRegisterWraps()
{
    PanelRig rig;
    rig.connectRunning();
    const auto stepTo = [&rig](std::int64_t pulses) {
        rig.link.status.axisPositionPulses = static_cast<std::int32_t>(pulses);
        rig.link.status.commandedPositionPulses = static_cast<std::int32_t>(pulses + 1);
        rig.link.sendStatus(rig.now);
    };
    stepTo(1'000'000'000);
    const double mmPerPulse = rig.machine.live().positionMm / 1e9;
    for (std::int64_t pulses = 1'000'000'000; pulses < 9'000'000'000; pulses += 500'000'000) {
        stepTo(pulses);
        QVERIFY(std::abs(rig.machine.live().positionMm - static_cast<double>(pulses) * mmPerPulse) < 0.01);
        QCOMPARE(rig.machine.axisPosition().commandedPulses(), std::optional(pulses + 1));
    }
    for (std::int64_t pulses = 9'000'000'000; pulses > -9'000'000'000; pulses -= 1'000'000'000)
        stepTo(pulses);
    QCOMPARE(rig.machine.axisPosition().actualPulses(), std::optional<std::int64_t>(-8'000'000'000));
    QCOMPARE(rig.maintenance.jog()->positionPulses(), -8e9);
    rig.link.status.state = modbus::State::Homing;
    stepTo(0);
    rig.link.status.state = modbus::State::Ready;
    stepTo(7);
    QCOMPARE(rig.machine.axisPosition().actualPulses(), std::optional<std::int64_t>(7));
    stepTo(9'000'000);
    rig.link.status.uptimeS = 100;
    stepTo(9'000'001);
    rig.link.status.uptimeS = 1; // restarted
    stepTo(3);
    QCOMPARE(rig.machine.axisPosition().actualPulses(), std::optional<std::int64_t>(3));
}

void TestLineHonesty::valuesOfAnotherProgramAreNotScaled()
{
    PanelRig rig;
    rig.connectRunning();
    rig.link.status.axisPositionPulses = 5000;
    rig.link.sendStatus(rig.now);
    QVERIFY(!std::isnan(rig.machine.live().positionMm));
    ++rig.link.status.generation; // its header is still to be read
    rig.link.sendStatus(rig.now);
    QVERIFY(std::isnan(rig.machine.live().positionMm));
    QVERIFY(std::isnan(rig.machine.live().knifeSpeedMmPerS));
    QVERIFY(std::isnan(rig.machine.live().followingErrorMm));
    QVERIFY(std::isnan(rig.machine.live().rateBagsPerMin));
}

void TestLineHonesty::lostLineClaimsNothingOfTheController()
{
    PanelRig rig;
    rig.connectRunning();
    rig.editor.download();
    QVERIFY(rig.editor.programDownload()->controllerText().contains("identical"));
    rig.link.becomeLost();
    QCOMPARE(rig.editor.programDownload()->controllerText(),
             "No connection. Last known program in the controller: generation 1");
    QVERIFY(!rig.editor.programDownload()->canDownload());
    QCOMPARE(rig.editor.programDownload()->text(), "There is no connection to the controller.");
    QVERIFY(!rig.editor.programDownload()->canSave());
    QVERIFY(!rig.editor.programDownload()->proof()->canCompare());
}

void TestLineHonesty::proofComparesWithWhatWasDownloaded()
{
    PanelRig rig;
    rig.connectIdle();
    QVERIFY(!rig.editor.programDownload()->proof()->canCompare());
    const auto image = rig.image();
    rig.editor.download();
    QCOMPARE(rig.link.banks.size(), 1);
    link::DownloadReport active;
    active.stage = link::DownloadStage::Active;
    active.crc = image.crc;
    rig.link.activate(image, rig.now);
    emit rig.link.downloadReported(active);
    ProgramProof& proof = *rig.editor.programDownload()->proof();
    QVERIFY(proof.canCompare());
    proof.compare();
    QVERIFY(proof.running());
    QCOMPARE(rig.link.comparisons.size(), 1);
    QVERIFY(rig.link.comparisons.last() == image.registers);
    ComparisonReport report;
    report.fraction = 0.5;
    report.generation = rig.link.status.generation;
    emit rig.link.comparisonReported(report);
    QCOMPARE(proof.progress(), 0.5);
    report.isInterrupted = true;
    emit rig.link.comparisonReported(report);
    QCOMPARE(proof.text(), "The connection is lost. The comparison continues when it is restored.");
    proof.cancel();
    QCOMPARE(rig.link.comparisonCancels, 1);
    report.stage = ComparisonStage::Equal;
    report.readCrc = image.crc;
    emit rig.link.comparisonReported(report);
    QCOMPARE(proof.result(), ProgramProof::Result::Equal);
    QVERIFY2(proof.text().contains(QString::number(image.registers.size()) +
                                   " registers of generation 1 match what this panel downloaded"),
             qPrintable(proof.text()));
    QVERIFY(proof.text().contains(QString::number(image.crc, 16).toUpper()));
}

void TestLineHonesty::proofIsRebuiltFromTheController_data()
{
    QTest::addColumn<int>("kind");
    for (const program::KindInfo& kind : program::kinds())
        QTest::addRow("kind %d", static_cast<int>(kind.kind)) << static_cast<int>(kind.kind);
}

void TestLineHonesty::proofIsRebuiltFromTheController()
{
    QFETCH(int, kind);
    PanelRig rig;
    rig.connectIdle();
    auto recipe = program::defaultRecipe(static_cast<profile::ProgramKind>(kind));
    recipe.machine = program::withController(recipe.machine, test::FakeLink::identity());
    const auto image = program::buildProgram(recipe);
    QVERIFY(image);
    rig.link.activate(*image, rig.now);
    rig.editor.programDownload()->proof()->compare();
    QCOMPARE(rig.link.comparisons.size(), 1);
    QVERIFY(rig.link.comparisons.last() == image->registers);
}

void TestLineHonesty::proofNamesTheFirstDifference()
{
    PanelRig rig;
    rig.connectRunning();
    ProgramProof& proof = *rig.editor.programDownload()->proof();
    proof.compare();
    ComparisonReport report;
    report.stage = ComparisonStage::Different;
    report.generation = rig.link.status.generation;
    report.differingRegisters = 3;
    const modbus::RegisterSpan span = modbus::findSpan("program.bag_length").value();
    report.firstDifference = {static_cast<quint16>(span.address - modbus::activeBankBase), 0x10, 0x1F};
    emit rig.link.comparisonReported(report);
    QCOMPARE(proof.result(), ProgramProof::Result::Different);
    for (const char* words : {"Different: 3 of ", "first program.bag_length: 0x001F instead of 0x0010"})
        QVERIFY2(proof.text().contains(QLatin1String(words)), qPrintable(proof.text()));
    proof.compare();
    report.differingRegisters = 1;
    report.firstDifference->offset = modbus::bankHeaderRegisters + 6;
    emit rig.link.comparisonReported(report);
    QVERIFY2(proof.text().contains("first register 7 of the rows"), qPrintable(proof.text()));
    proof.compare();
    report.firstDifference.reset();
    report.readCrc = 0xAB;
    emit rig.link.comparisonReported(report);
    QVERIFY2(proof.text().contains("has CRC-32 0x000000AB"), qPrintable(proof.text()));
}

void TestLineHonesty::proofEndsInWords_data()
{
    QTest::addColumn<int>("stage");
    QTest::addColumn<QString>("words");
    QTest::newRow("changed") << static_cast<int>(ComparisonStage::ProgramChanged)
                             << "The controller's program changed during the comparison. Compare again.";
    QTest::newRow("none") << static_cast<int>(ComparisonStage::NoProgram)
                          << "The controller has no program. Download a recipe first.";
    QTest::newRow("canceled") << static_cast<int>(ComparisonStage::Canceled) << "Canceled without a result.";
    QTest::newRow("no connection") << static_cast<int>(ComparisonStage::Failed)
                                   << "Not compared: there is no connection to the controller.";
}

void TestLineHonesty::proofEndsInWords()
{
    QFETCH(int, stage);
    QFETCH(QString, words);
    PanelRig rig;
    rig.connectRunning();
    rig.editor.programDownload()->proof()->compare();
    ComparisonReport report;
    report.stage = static_cast<ComparisonStage>(stage);
    report.generation = rig.link.status.generation;
    report.isConnectionMissing = report.stage == ComparisonStage::Failed;
    emit rig.link.comparisonReported(report);
    QVERIFY(!rig.editor.programDownload()->proof()->running());
    QCOMPARE(rig.editor.programDownload()->proof()->result(), ProgramProof::Result::Undecided);
    QCOMPARE(rig.editor.programDownload()->proof()->text(), words);
}

void TestLineHonesty::proofIsOfOneProgram()
{
    PanelRig rig;
    rig.connectRunning();
    ProgramProof& proof = *rig.editor.programDownload()->proof();
    proof.compare();
    ComparisonReport report;
    report.stage = ComparisonStage::Equal;
    report.generation = rig.link.status.generation;
    emit rig.link.comparisonReported(report);
    QCOMPARE(proof.result(), ProgramProof::Result::Equal);
    rig.link.activate(rig.image(), rig.now);
    QCOMPARE(proof.result(), ProgramProof::Result::None);
    proof.compare();
    report.generation = rig.link.status.generation;
    emit rig.link.comparisonReported(report);
    QCOMPARE(proof.result(), ProgramProof::Result::Equal);
    rig.link.becomeLost();
    QCOMPARE(proof.result(), ProgramProof::Result::None);
}

void TestLineHonesty::faultsAreThoseThatTheControllerTook()
{
    PanelRig rig;
    SimulatedFaults& faults = *rig.maintenance.simulatedFaults();
    const auto level = [&](int row) { return faults.rows()->row(row).level; };
    QVERIFY(faults.rows()->count() >= 8);
    faults.setLevel(0, SimulatedFaults::Often);
    QCOMPARE(level(0), int{SimulatedFaults::Off}); // not yet answered
    faults.setLevel(7, SimulatedFaults::Sometimes);
    QCOMPARE(rig.link.faults.size(), 1);
    emit rig.link.faultsSimulated({});
    QCOMPARE(level(0), int{SimulatedFaults::Often});
    QCOMPARE(rig.link.faults.size(), 2); // the second change was sent after the first answer
    QCOMPARE(rig.link.faults.last().size(), 2);
    emit rig.link.faultsSimulated({});
    QCOMPARE(faults.activeCount(), 2);
    QCOMPARE(faults.text(), "Active: Late responses, Silence");
    faults.setLevel(1, SimulatedFaults::Often);
    emit rig.link.faultsSimulated({link::FaultsEnd::Refused, "line 1: 'x' is wrong"});
    QCOMPARE(level(1), int{SimulatedFaults::Off});
    QVERIFY(faults.errorText().contains("line 1: 'x' is wrong"));
    const int jam = faults.rows()->count() - 1; // of the machine: off or on
    QVERIFY(faults.rows()->row(jam).isSwitch() && !faults.rows()->row(0).isSwitch());
    const qsizetype before = rig.link.faults.size();
    faults.setLevel(jam, SimulatedFaults::Sometimes);
    QCOMPARE(rig.link.faults.size(), before);
    faults.setLevel(jam, SimulatedFaults::Often);
    QVERIFY(rig.link.faults.last().contains("jam on"));
    emit rig.link.faultsSimulated({});
    QCOMPARE(faults.text(), "Active: Late responses, Silence, Something under the jaws");
    faults.clear();
    QVERIFY(rig.link.faults.last().isEmpty());
    emit rig.link.faultsSimulated({});
    QCOMPARE(faults.activeCount(), 0);
    QVERIFY(faults.errorText().isEmpty());
}

void TestLineHonesty::faultsEndWithTheirController()
{
    PanelRig rig;
    SimulatedFaults& faults = *rig.maintenance.simulatedFaults();
    faults.setLevel(2, SimulatedFaults::Often);
    emit rig.link.faultsSimulated({});
    link::LinkReport report;
    report.simulator = link::SimulatorState::Ended; // restarted with its faults
    emit rig.link.reported(report);
    QCOMPARE(faults.activeCount(), 1);
    report.simulator = link::SimulatorState::Starting;
    emit rig.link.reported(report);
    QCOMPARE(faults.activeCount(), 0);
}

CAMPANEL_TEST(TestLineHonesty)

} // namespace test_line_honesty

#include "test_line_honesty.moc"
