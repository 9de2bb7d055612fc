// SPDX-License-Identifier: Apache-2.0
// Every kind of program from the recipe to the motion: the panel's own classes and campanelctl on one side,
// campanel-controller on its pseudo-terminal on the other, its machine several times as fast as a real one.
#include "app/link/threaded_link.h"
#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/settings/settings.h"
#include "profile/segments/segment_cam.h"
#include "tests/support/controller_process.h"
#include "tests/support/places.h"
#include "tests/support/stored_recipe.h"
#include "tests/support/test_program.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>

namespace test_kinds_and_controller {

using namespace campanel;
using panel::Controller;
using panel::Editor;
using panel::ProgramDownload;
using profile::Field;
using profile::ProgramKind;
using test::ControllerProcess;

namespace {

constexpr int timeoutMs = 15'000;

struct Panel {
    explicit Panel(const QString& port)
        : machine(link, settings, nullptr)
        , editor(machine, test::withStoredRecipe(folder.path()), nullptr)
    {
        panel::ConnectionChoice choice;
        choice.simulated = false;
        choice.portName = port;
        settings.overrideConnection(choice);
        machine.open();
    }

    [[nodiscard]] const modbus::StatusBlock& status() const { return *machine.status(); }

    QTemporaryDir folder;
    link::ThreadedLink link{nullptr};
    panel::Settings settings{folder.filePath("settings.ini"), nullptr};
    Controller machine;
    Editor editor;
};

// Returns campanelctl's output, or its error line.
QByteArray ctl(const QStringList& words, const QString& port)
{
    QProcess process;
    process.start(campanel::test::programPath("campanelctl"), words + QStringList{"--port", port});
    if (!process.waitForFinished(timeoutMs) || process.exitCode() != 0)
        return process.readAllStandardError();
    return process.readAllStandardOutput();
}

QJsonObject statusOf(const QString& port)
{
    return QJsonDocument::fromJson(ctl({"status", "--format", "json"}, port)).object();
}

QStringList fast(double speed)
{
    return {"--no-pacing", "--speed", QString::number(speed)};
}

} // namespace

class TestKindsAndController : public QObject {
    Q_OBJECT

private slots:
    void aMoveEndsAtItsPulses_data();
    void aMoveEndsAtItsPulses();
    void aSpeedIsHeldUntilTheStop_data();
    void aSpeedIsHeldUntilTheStop();
    void anotherPanelSeesTheKnots_data();
    void anotherPanelSeesTheKnots();
    void anotherPanelSeesTheSegments();
    void aStrokeStopsWhereItShould();
    void aMissingWorkPieceIsAFault();

private:
    // Downloads and starts with the panel's own buttons, and waits until it runs.
    static void begin(Panel& panel)
    {
        QTRY_VERIFY2_WITH_TIMEOUT(panel.editor.programDownload()->canDownload(),
                                  qPrintable(panel.editor.programDownload()->text()), timeoutMs);
        panel.editor.download();
        QTRY_COMPARE_WITH_TIMEOUT(panel.editor.programDownload()->state(), ProgramDownload::State::Applied,
                                  timeoutMs);
        QTRY_VERIFY2_WITH_TIMEOUT(panel.machine.canStart(), qPrintable(panel.machine.startBlockedReason()),
                                  timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.machine.active().isPresent, timeoutMs);
        panel.machine.start();
    }
};

void TestKindsAndController::aMoveEndsAtItsPulses_data()
{
    QTest::addColumn<QStringList>("words");
    QTest::addColumn<int>("pulses");
    QTest::newRow("quintic as points") << QStringList{"--distance-mm", "6000"} << 60'000;
    QTest::newRow("backwards") << QStringList{"--distance-mm", "-1234.5", "--law", "modified_sine"}
                               << -12'345;
    QTest::newRow("as intervals") << QStringList{"--distance-mm", "600", "--execution", "intervals"} << 6000;
}

// Twice: from its position, the same distance again.
void TestKindsAndController::aMoveEndsAtItsPulses()
{
    QFETCH(QStringList, words);
    QFETCH(int, pulses);
    const ControllerProcess controller(fast(10));
    const QByteArray loaded =
        ctl(QStringList{"download", "--kind", "position_move", "--verify", "--format", "json"} + words,
            controller.port());
    QVERIFY2(QJsonDocument::fromJson(loaded).object()["generation"].toInt() == 1, loaded.constData());
    QJsonObject status = statusOf(controller.port());
    const QJsonObject program = status["program"].toObject();
    QCOMPARE(program["kind"].toString(), "position_move");
    QCOMPARE(program["distance_mm"].toDouble(), words[1].toDouble());
    for (int run = 1; run <= 2; ++run) {
        QCOMPARE(ctl({"start"}, controller.port()), QByteArray("Started.\n"));
        QTRY_VERIFY_WITH_TIMEOUT((status = statusOf(controller.port()))["state"].toString() == "Ready" &&
                                     status["commanded_position_pulses"].toInt() == run * pulses,
                                 timeoutMs);
        // The axis follows with a lag.
        QTRY_COMPARE_WITH_TIMEOUT(statusOf(controller.port())["axis_position_pulses"].toInt(), run * pulses,
                                  timeoutMs);
    }
    QCOMPARE(status["cycle_count"].toInt(), 2);
    QVERIFY(status["faults"].toArray().isEmpty());
}

void TestKindsAndController::aSpeedIsHeldUntilTheStop_data()
{
    QTest::addColumn<int>("execution");
    QTest::addColumn<double>("speed");
    QTest::newRow("as points") << 0 << 5000.0;
    QTest::newRow("as points, backwards") << 0 << -5000.0;
    QTest::newRow("as intervals") << 1 << 5000.0;
    QTest::newRow("as intervals, slowly") << 1 << 100.0;
}

void TestKindsAndController::aSpeedIsHeldUntilTheStop()
{
    QFETCH(int, execution);
    QFETCH(double, speed);
    const ControllerProcess controller(fast(3));
    Panel panel(controller.port());
    panel.editor.newProgram(static_cast<int>(ProgramKind::SpeedMove));
    panel.editor.item(Field::EndSpeed)->set(speed);
    panel.editor.setChoice(1, execution);
    QTRY_VERIFY2(panel.editor.feasible(), qPrintable(panel.editor.verdict()));
    begin(panel);
    if (QTest::currentTestFailed())
        return;
    // The commanded frequency is that of whole pulses in 2 ms.
    const double expectedHz = 10 * speed;
    const auto isHeld = [&] {
        return panel.machine.state() == Controller::State::Running &&
               std::abs(panel.status().commandedFrequencyHz - expectedHz) <= 0.06 * std::abs(expectedHz);
    };
    QTRY_VERIFY2_WITH_TIMEOUT(isHeld(), qPrintable(QString::number(panel.status().commandedFrequencyHz)),
                              timeoutMs);
    // By the pulses within two seconds of the machine, more exact than by the frequency.
    const auto begin = panel.status();
    QTRY_VERIFY_WITH_TIMEOUT(
        static_cast<std::uint16_t>(panel.status().sampleTimeMs - begin.sampleTimeMs) >= 2000, timeoutMs);
    const auto end = panel.status();
    const double seconds = static_cast<std::uint16_t>(end.sampleTimeMs - begin.sampleTimeMs) / 1000.0;
    const double meanHz = (end.commandedPositionPulses - begin.commandedPositionPulses) / seconds;
    // The status is some milliseconds old.
    QVERIFY2(std::abs(meanHz - expectedHz) < 0.005 * std::abs(expectedHz),
             qPrintable(QString::number(meanHz)));
    QVERIFY(isHeld());
    panel.machine.stop();
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.state(), Controller::State::Ready, timeoutMs);
    QCOMPARE(panel.status().commandedFrequencyHz, 0);
    QVERIFY2(panel.machine.alarmText().isEmpty(), qPrintable(panel.machine.alarmText()));
}

void TestKindsAndController::anotherPanelSeesTheKnots_data()
{
    QTest::addColumn<double>("rate");
    QTest::newRow("forwards") << 120.0;
    QTest::newRow("backwards") << -120.0;
}

void TestKindsAndController::anotherPanelSeesTheKnots()
{
    QFETCH(double, rate);
    const ControllerProcess controller(fast(5));
    std::vector<profile::Knot> knots;
    {
        Panel panel(controller.port());
        panel.editor.newProgram(static_cast<int>(ProgramKind::PointCam));
        panel.editor.item(Field::MasterRate)->set(rate);
        panel.editor.setRecipeName("Petal");
        panel.editor.knots()->select(1);
        panel.editor.knots()->slave()->set(23.456);
        panel.editor.knots()->insertAfterSelected();
        knots = std::get<profile::PointCamProgram>(panel.editor.recipe().program).knots;
        QCOMPARE(knots.size(), std::size_t{6});
        begin(panel);
        if (QTest::currentTestFailed())
            return;
        QTRY_VERIFY_WITH_TIMEOUT(panel.machine.live().cycleCount >= 5, timeoutMs);
        QCOMPARE(panel.machine.state(), Controller::State::Running);
        // The slave stays within the span of its cam.
        QVERIFY(panel.status().axisPositionPulses > -30 && panel.status().axisPositionPulses < 550);
        panel.machine.stop();
        QTRY_COMPARE_WITH_TIMEOUT(panel.machine.state(), Controller::State::Ready, timeoutMs);
        QCOMPARE(panel.status().commandedPositionPulses, 0); // a closed cam ends where it began
        QVERIFY2(panel.machine.alarmText().isEmpty(), qPrintable(panel.machine.alarmText()));
    }
    Panel other(controller.port());
    QTRY_VERIFY_WITH_TIMEOUT(other.machine.active().isPresent, timeoutMs);
    const program::Recipe& shown = other.machine.program()->recipe;
    QCOMPARE(shown.kind(), ProgramKind::PointCam);
    QCOMPARE(other.machine.active().name, "Petal");
    const auto& cam = std::get<profile::PointCamProgram>(shown.program);
    QCOMPARE(cam.masterRateRevPerMin, rate);
    QCOMPARE(cam.knots.size(), knots.size());
    for (std::size_t i = 0; i < knots.size(); ++i) {
        QVERIFY(std::abs(cam.knots[i].masterDeg - knots[i].masterDeg) <= 0.5e-4);
        QVERIFY(std::abs(cam.knots[i].slaveMm - knots[i].slaveMm) <= 0.5e-3);
    }
    QVERIFY(other.machine.active().curves.isValid());
    QCOMPARE(other.machine.active().cycleSeconds, 0.5);
}

// A segment is split and its end moved; what jumps is repaired, downloaded, run, and read back.
void TestKindsAndController::anotherPanelSeesTheSegments()
{
    const ControllerProcess controller(fast(5));
    std::vector<profile::CamSegment> segments;
    double topMm = 0;
    {
        Panel panel(controller.port());
        panel.editor.newProgram(static_cast<int>(ProgramKind::SegmentCam));
        panel.editor.setRecipeName("Lift");
        panel::SegmentModel& list = *panel.editor.segments();
        const auto count = list.rows()->count();
        list.select(0);
        list.split();
        QCOMPARE(list.rows()->count(), count + 1);
        panel::EditorField* const end = list.field("segmentEnd");
        QVERIFY(end);
        end->set(end->value() + 2);
        if (list.canRepair())
            list.repair();
        QVERIFY2(!list.canRepair(), qPrintable(list.jointText()));
        const auto& cam = std::get<profile::SegmentCamProgram>(panel.editor.recipe().program);
        segments = cam.segments;
        for (const double position : profile::jointPositionsMm(segments))
            topMm = std::max(topMm, position);
        begin(panel);
        if (QTest::currentTestFailed())
            return;
        QTRY_VERIFY_WITH_TIMEOUT(panel.machine.live().cycleCount >= 5, timeoutMs);
        QCOMPARE(panel.machine.state(), Controller::State::Running);
        panel.machine.stop();
        QTRY_COMPARE_WITH_TIMEOUT(panel.machine.state(), Controller::State::Ready, timeoutMs);
        QCOMPARE(panel.status().commandedPositionPulses, 0); // a closed cam ends where it began
        QVERIFY2(panel.machine.alarmText().isEmpty(), qPrintable(panel.machine.alarmText()));
    }
    QVERIFY(topMm > 0);
    Panel other(controller.port());
    QTRY_VERIFY_WITH_TIMEOUT(other.machine.active().isPresent, timeoutMs);
    QCOMPARE(other.machine.active().name, "Lift");
    const program::Recipe& shown = other.machine.program()->recipe;
    QCOMPARE(shown.kind(), ProgramKind::SegmentCam);
    QVERIFY(std::get<profile::SegmentCamProgram>(shown.program).segments == segments);
    QVERIFY(other.machine.active().curves.isValid());
}

void TestKindsAndController::aStrokeStopsWhereItShould()
{
    const ControllerProcess controller(fast(10));
    Panel panel(controller.port());
    panel.editor.newProgram(static_cast<int>(ProgramKind::Press));
    begin(panel);
    if (QTest::currentTestFailed())
        return;
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.strokes()->rows()->count(), 1, timeoutMs);
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.state(), Controller::State::Ready, timeoutMs);
    QVERIFY2(panel.machine.alarmText().isEmpty(), qPrintable(panel.machine.alarmText()));
    const auto& press = panel.status().press;
    QVERIFY(press.has_value());
    QCOMPARE(press->result, modbus::StrokeResult::Ok);
    QVERIFY2(std::abs(press->stopErrorPulses) <= 1, qPrintable(QString::number(press->stopErrorPulses)));
    // 25 mm into the work piece at 200 N/mm.
    QVERIFY2(press->stopForceN > 4500 && press->stopForceN < 5500,
             qPrintable(QString::number(press->stopForceN)));
    QCOMPARE(panel.status().commandedPositionPulses, 0); // back up
    QCOMPARE(panel.machine.strokes()->goodCount(), 1);
    const auto curve = panel.machine.strokes()->forceCurve();
    QVERIFY(curve.size() > 20);
    const auto deepest = std::ranges::max_element(curve, {}, &QPointF::x);
    QVERIFY2(std::abs(deepest->x() - 100) < 0.2, qPrintable(QString::number(deepest->x())));
    // One start is one stroke.
    panel.machine.start();
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.strokes()->rows()->count(), 2, timeoutMs);
}

void TestKindsAndController::aMissingWorkPieceIsAFault()
{
    const ControllerProcess controller(fast(10) + QStringList{"--work-piece-missing", "1"});
    Panel panel(controller.port());
    panel.editor.newProgram(static_cast<int>(ProgramKind::Press));
    begin(panel);
    if (QTest::currentTestFailed())
        return;
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.state(), Controller::State::Fault, timeoutMs);
    QVERIFY2(panel.machine.alarmText().contains("The press did not detect a workpiece."),
             qPrintable(panel.machine.alarmText()));
    QVERIFY(!panel.machine.canStart());
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.strokes()->rows()->count(), 1, timeoutMs);
    QCOMPARE(panel.machine.strokes()->goodCount(), 0);
    const auto& stroke = panel.machine.strokes()->rows()->row(0);
    QCOMPARE(stroke.resultText(), "No contact");
    panel.machine.resetFault();
    QTRY_COMPARE_WITH_TIMEOUT(panel.machine.state(), Controller::State::Ready, timeoutMs);
}

CAMPANEL_TEST(TestKindsAndController)

} // namespace test_kinds_and_controller

#include "test_kinds_and_controller.moc"
