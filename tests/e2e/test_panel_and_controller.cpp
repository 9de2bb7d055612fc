// SPDX-License-Identifier: Apache-2.0
// The panel's window touched like an operator does, campanel-controller at the other end of the line, and
// campanelctl as a witness of the controller's state.
#include "app/program/program_image.h"
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/controller_process.h"
#include "tests/support/places.h"
#include "tests/support/scripted_slave.h"
#include "tests/support/test_program.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include <algorithm>
#include <cmath>

namespace test_panel_and_controller {

using namespace campanel;
using modbus::State;
using modbus::StatusBlock;
using panel::Controller;
using panel::Editor;
using panel::PackingLine;
using panel::ProgramDownload;
using test::ControllerProcess;
using test::PanelWindow;

namespace {

constexpr int timeoutMs = 20'000;
constexpr std::int32_t pulsesPerCycle = 10000;

QJsonObject statusFromOutside(const QString& port)
{
    QProcess process;
    process.start(campanel::test::programPath("campanelctl"), {"status", "--format", "json", "--port", port});
    if (!process.waitForFinished() || process.exitCode() != 0)
        qWarning("%s", process.readAllStandardError().constData());
    return QJsonDocument::fromJson(process.readAllStandardOutput()).object();
}

double highestFrequencyHz(const program::Recipe& recipe)
{
    const auto image = program::buildProgram(recipe);
    if (!image)
        qFatal("%s", program::describe(image.error()).c_str());
    double highest = 0;
    for (const profile::StepRow& row : image->stepTable().rows)
        highest = std::max(highest, profile::frequencyHz(row, image->recipe.machine));
    return highest;
}

bool moves(const StatusBlock& status)
{
    return status.state == State::Running || status.state == State::Stopping;
}

// Returns an empty text, or the error of the motion: backward, or faster than the fastest row.
QString faultOfMotion(const std::vector<StatusBlock>& statuses, double highestHz)
{
    for (std::size_t i = 1; i < statuses.size(); ++i) {
        const StatusBlock& before = statuses[i - 1];
        const StatusBlock& now = statuses[i];
        if (!moves(before) || !moves(now))
            continue;
        const int step = now.commandedPositionPulses - before.commandedPositionPulses;
        const auto passedMs = static_cast<std::uint16_t>(now.sampleTimeMs - before.sampleTimeMs);
        const double longest = highestHz * (passedMs + 1) / 1000 + 1; // the time is a whole number of ms
        if (step < 0 || step > longest)
            return QStringLiteral("%1 pulses in %2 ms at pulse %3, at most %4 are right")
                .arg(step)
                .arg(passedMs)
                .arg(before.commandedPositionPulses)
                .arg(longest);
    }
    return {};
}

} // namespace

class TestPanelAndController : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }
    void theMainJob();
    void aScanChangesOver();
    void theMasterIsTurnedRound();
    void aBusyPortIsTakenWhenItIsFree();
    void badPorts_data();
    void badPorts();
    void otherDevices_data();
    void otherDevices();

private:
    static void enterLength(PanelWindow& panel, const QString& digits)
    {
        panel.tap("nav_motion");
        panel.tap("field_bag_length_mm");
        panel.tapDigits(digits);
        panel.tap("keypadAccept");
    }
    static void runLength(PanelWindow& panel);
    static void changeWhileItRuns(PanelWindow& panel);
    static void readFromOutsideAndAgain(const QString& port);
};

void TestPanelAndController::theMainJob()
{
    const ControllerProcess controller;
    {
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().connection(), Controller::Connection::Connected,
                                  timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        runLength(panel);
        if (!QTest::currentTestFailed())
            changeWhileItRuns(panel);
        QCOMPARE(panel.complaints(), QStringList());
        if (QTest::currentTestFailed())
            return;
    }
    readFromOutsideAndAgain(controller.port());
}

void scanCode(PanelWindow& panel, const QString& code)
{
    for (const QChar key : QStringLiteral("~~") + code)
        QTest::sendKeyEvent(QTest::Click, &panel.panel().window(), QTest::asciiToKey(key.toLatin1()),
                            QString(key), key.isUpper() ? Qt::ShiftModifier : Qt::NoModifier);
    QTest::keyClick(&panel.panel().window(), Qt::Key_Return);
    panel.touchDriver().settle();
}

// From the scanner's keys to the program in the controller, with two touches. A wrong film reel keeps the
// machine from starting.
void TestPanelAndController::aScanChangesOver()
{
    const ControllerProcess controller;
    PanelWindow panel(controller.port());
    panel.settings().overrideValue("scanner.prefix", QStringLiteral("~~"));
    panel.settings().overrideValue("scanner.key_time_ms", QStringLiteral("1000")); // for a busy computer
    QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
    panel::Recipes& recipes = panel.panel().recipes();
    QTRY_COMPARE_WITH_TIMEOUT(recipes.total(), 1, timeoutMs);
    recipes.setWantedName(QStringLiteral("Soap"));
    recipes.create(1);
    QTRY_COMPARE_WITH_TIMEOUT(panel.editor().recipeName(), QStringLiteral("Soap"), timeoutMs);
    scanCode(panel, QStringLiteral("Biscuit 250"));
    QCOMPARE(panel.editor().recipeName(), QStringLiteral("Biscuit 250"));
    QVERIFY(!panel.controller().active().isPresent); // nothing without a touch
    panel.tap("downloadStart");
    QTRY_COMPARE_WITH_TIMEOUT(panel.editor().programDownload()->state(), ProgramDownload::State::Applied,
                              timeoutMs);
    QTRY_COMPARE_WITH_TIMEOUT(panel.controller().active().name, QStringLiteral("Biscuit 250"), timeoutMs);

    recipes.codes()->enter(panel::RecipeCodes::Code::Film);
    recipes.codes()->setWanted(QStringLiteral("PE 30"));
    recipes.codes()->store();
    QTRY_COMPARE_WITH_TIMEOUT(panel.editor().recipe().filmCode, std::string("PE 30"), timeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(panel.controller().canStart(), timeoutMs);
    scanCode(panel, QStringLiteral("PP 40"));
    panel.tap("confirmCancel");
    panel.start();
    QTest::qWait(300); // some polls
    QCOMPARE(panel.controller().state(), Controller::State::Ready);
    panel.tap("confirm_override");
    for (const QChar key : QStringLiteral("same width"))
        QTest::sendKeyEvent(QTest::Click, &panel.panel().window(), QTest::asciiToKey(key.toLatin1()),
                            QString(key), Qt::NoModifier);
    panel.tap("textAccept");
    panel.start();
    QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Running, timeoutMs);
    QStringList films;
    panel.panel().records().store().run(
        &panel.panel(),
        [](store::Database& database) {
            return store::auditTable().page(database, 0, 10, {.area = QStringLiteral("film")});
        },
        [&films](const auto& rows) {
            for (const store::AuditRow& row : rows.value())
                films << row.entry.what + u' ' + row.entry.after + u' ' + row.entry.outcome;
        });
    QTRY_COMPARE_WITH_TIMEOUT(films,
                              QStringList({QStringLiteral("film.override PP 40: same width done"),
                                           QStringLiteral("film.scan PP 40 refused")}),
                              timeoutMs);
    QCOMPARE(panel.complaints(), QStringList());
}

void TestPanelAndController::runLength(PanelWindow& panel)
{
    enterLength(panel, "260");
    QCOMPARE(panel.editor().bagLength()->value(), 260.0);
    panel.download();
    QTRY_COMPARE_WITH_TIMEOUT(panel.controller().active().bagLengthMm, 260.0, timeoutMs);
    QCOMPARE(panel.controller().generation(), 1.0);

    panel.tap("nav_run");
    QTRY_VERIFY_WITH_TIMEOUT(panel.controller().canStart(), timeoutMs);
    panel.start();
    QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Running, timeoutMs);
    const double angle = panel.controller().live().knifeAngleDeg;
    QVERIFY(!std::isnan(angle));
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(panel.controller().live().knifeAngleDeg - angle) > 10, timeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(panel.controller().bags().count >= 2, timeoutMs);
    // The first bags of a run are shifted onto the marks.
    QTRY_COMPARE_WITH_TIMEOUT(panel.controller().packing()->markState(), PackingLine::MarkState::Tracking,
                              timeoutMs);
    QTRY_VERIFY2_WITH_TIMEOUT(std::abs(panel.controller().bags().lengthMm - 260) <
                                  panel.controller().bags().toleranceMm,
                              qPrintable(QString::number(panel.controller().bags().lengthMm)), timeoutMs);
    QCOMPARE(panel.controller().state(), Controller::State::Running);
}

void TestPanelAndController::changeWhileItRuns(PanelWindow& panel)
{
    const double fastest = highestFrequencyHz(panel.editor().recipe());
    enterLength(panel, "300");
    QCOMPARE(panel.editor().programDownload()->differenceCount(), 1);
    panel.download();
    QTRY_COMPARE_WITH_TIMEOUT(panel.controller().active().bagLengthMm, 300.0, timeoutMs);
    QCOMPARE(panel.controller().generation(), 2.0);
    // The bag under the knife began with the old length, the next ones are shifted onto the marks.
    QTRY_COMPARE_WITH_TIMEOUT(panel.controller().packing()->markState(), PackingLine::MarkState::Tracking,
                              timeoutMs);
    QTRY_VERIFY2_WITH_TIMEOUT(std::abs(panel.controller().bags().lengthMm - 300) <
                                  panel.controller().bags().toleranceMm,
                              qPrintable(QString::number(panel.controller().bags().lengthMm)), timeoutMs);
    QCOMPARE(panel.controller().state(), Controller::State::Running);

    panel.tap("stopKey");
    QTRY_VERIFY2_WITH_TIMEOUT(panel.controller().state() == Controller::State::Ready,
                              qPrintable(panel.texts() + panel.complaints().join(u'\n')), timeoutMs);
    QVERIFY2(panel.controller().commandMessage().isEmpty(), qPrintable(panel.controller().commandMessage()));
    QVERIFY2(panel.controller().alarmText().isEmpty(), qPrintable(panel.controller().alarmText()));

    const auto& statuses = panel.statuses();
    const QString fault =
        faultOfMotion(statuses, std::max(fastest, highestFrequencyHz(panel.editor().recipe())));
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    const auto changed = std::ranges::adjacent_find(statuses, [](const auto& before, const auto& now) {
        return before.generation == 1 && now.generation == 2;
    });
    QVERIFY(changed != statuses.end());
    QCOMPARE(changed[0].state, std::optional(State::Running));
    QCOMPARE(changed[1].state, std::optional(State::Running));
    // A cycle's boundary is between both.
    const auto boundary = changed[1].commandedPositionPulses / pulsesPerCycle * pulsesPerCycle;
    QVERIFY2(boundary >= changed[0].commandedPositionPulses,
             qPrintable(QStringLiteral("changed between pulse %1 and %2")
                            .arg(changed[0].commandedPositionPulses)
                            .arg(changed[1].commandedPositionPulses)));
    QCOMPARE(statuses.back().commandedPositionPulses % pulsesPerCycle, 0);
}

// The first panel is gone, with all its knowledge.
void TestPanelAndController::readFromOutsideAndAgain(const QString& port)
{
    const QJsonObject outside = statusFromOutside(port);
    QCOMPARE(outside["generation"].toInt(), 2);
    QCOMPARE(outside["state"].toString(), "Ready");
    QCOMPARE(outside["program"]["bag_length_mm"].toDouble(), 300.0);
    QVERIFY(std::abs(outside["bag_length_mm"].toDouble() - 300) < 1);

    PanelWindow panel(port);
    QTRY_VERIFY_WITH_TIMEOUT(panel.controller().active().isPresent, timeoutMs);
    QCOMPARE(panel.controller().active().bagLengthMm, 300.0);
    QCOMPARE(panel.controller().active().name, outside["program"]["name"].toString());
    QCOMPARE(panel.controller().active().version, outside["program"]["version"].toDouble());
    QCOMPARE(panel.controller().generation(), 2.0);
    QCOMPARE(panel.controller().state(), Controller::State::Ready);
    panel.tap("nav_motion");
    QVERIFY2(panel.texts().contains("generation 2"), qPrintable(panel.texts()));
    QCOMPARE(panel.complaints(), QStringList());
}

// During a run, by a touch; a later panel displays the controller's value.
void TestPanelAndController::theMasterIsTurnedRound()
{
    using Way = panel::MasterDirection::Way;
    const ControllerProcess controller;
    {
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        panel.editor().newProgram(static_cast<int>(profile::ProgramKind::PointCam));
        panel.tap("nav_motion");
        panel.download();
        if (QTest::currentTestFailed())
            return;
        const panel::MasterDirection& direction = *panel.controller().direction();
        QTRY_COMPARE_WITH_TIMEOUT(direction.way(), Way::Forward, timeoutMs);
        panel.tap("nav_run");
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().canStart(), timeoutMs);
        QVERIFY2(panel.texts().contains("starts forward"), qPrintable(panel.texts()));
        panel.start();
        QTRY_VERIFY_WITH_TIMEOUT(panel.texts().contains("runs forward"), timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().live().masterSpeedPercent, 100.0, timeoutMs);
        bool hasTurned = false;
        QObject::connect(&direction, &panel::MasterDirection::changed, &panel.controller(),
                         [&] { hasTurned |= direction.turning(); });
        const std::size_t before = panel.statuses().size();
        panel.hold("directionBackward");
        QTRY_VERIFY_WITH_TIMEOUT(panel.texts().contains("Changing to reverse"), timeoutMs);
        QCOMPARE(direction.way(), Way::Backward);
        QTRY_VERIFY_WITH_TIMEOUT(panel.texts().contains("runs in reverse"), timeoutMs);
        QVERIFY(hasTurned);
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().live().masterSpeedPercent, 100.0, timeoutMs);
        // Down by its ramp and up again, never stopped as a program.
        const auto& statuses = panel.statuses();
        double slowest = 100;
        for (std::size_t i = before; i < statuses.size(); ++i) {
            slowest = std::min(slowest, statuses[i].masterSpeedPercent);
            QCOMPARE(statuses[i].state, std::optional(State::Running));
        }
        QVERIFY2(slowest < 10, qPrintable(QString::number(slowest)));
        QVERIFY2(panel.controller().alarmText().isEmpty(), qPrintable(panel.controller().alarmText()));
        QCOMPARE(panel.complaints(), QStringList());
    }
    PanelWindow later(controller.port());
    QTRY_COMPARE_WITH_TIMEOUT(later.controller().direction()->way(), Way::Backward, timeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(later.texts().contains("runs in reverse"), timeoutMs);
    later.tap("stopKey");
    QTRY_COMPARE_WITH_TIMEOUT(later.controller().state(), Controller::State::Ready, timeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(later.texts().contains("starts in reverse"), timeoutMs);
    QCOMPARE(later.statuses().back().commandedPositionPulses, 0); // a closed cam ends where it began
    later.hold("directionForward");
    QTRY_VERIFY_WITH_TIMEOUT(later.texts().contains("starts forward"), timeoutMs);
    QCOMPARE(later.complaints(), QStringList());
}

void TestPanelAndController::aBusyPortIsTakenWhenItIsFree()
{
    const ControllerProcess controller;
    auto first = std::make_unique<PanelWindow>(controller.port());
    QTRY_COMPARE_WITH_TIMEOUT(first->controller().connection(), Controller::Connection::Connected, timeoutMs);
    PanelWindow second(controller.port());
    QTRY_COMPARE_WITH_TIMEOUT(second.controller().connection(), Controller::Connection::PortProblem,
                              timeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(second.texts().contains("is using port"), timeoutMs);
    QCOMPARE(first->controller().connection(), Controller::Connection::Connected);
    first.reset();
    QTRY_COMPARE_WITH_TIMEOUT(second.controller().connection(), Controller::Connection::Connected, timeoutMs);
}

void TestPanelAndController::badPorts_data()
{
    QTest::addColumn<QString>("port");
    QTest::addColumn<Controller::Connection>("connection");
    QTest::addColumn<QString>("words");
    // It may still be plugged in: the panel keeps searching.
    QTest::newRow("absent")
        << "/dev/ttyNONE7" << Controller::Connection::Searching
        << "Port /dev/ttyNONE7 does not exist. Plug the adapter in, or choose another port";
    QTest::newRow("no serial port") << "/dev/null" << Controller::Connection::PortProblem
                                    << "/dev/null is not a serial port. Choose another port";
}

void TestPanelAndController::badPorts()
{
    QFETCH(QString, port);
    QFETCH(Controller::Connection, connection);
    QFETCH(QString, words);
    PanelWindow panel(port);
    QTRY_VERIFY2_WITH_TIMEOUT(panel.texts().contains(words), qPrintable(panel.texts()), timeoutMs);
    QCOMPARE(panel.controller().connection(), connection);
    panel.start();
    QVERIFY2(panel.texts().contains("There is no connection to the controller."), qPrintable(panel.texts()));
}

void TestPanelAndController::otherDevices_data()
{
    QTest::addColumn<int>("deviceType");
    QTest::addColumn<bool>("answers");
    QTest::addColumn<Controller::Connection>("connection");
    QTest::addColumn<QString>("words");
    QTest::newRow("another device") << 0x1234 << true << Controller::Connection::WrongDevice
                                    << "is not a CamPanel controller. Choose another port or unit number.";
    QTest::newRow("nobody") << 0xCA3D << false << Controller::Connection::Connecting
                            << "Check cable, power, baud rate, parity and unit number.";
}

void TestPanelAndController::otherDevices()
{
    QFETCH(int, deviceType);
    QFETCH(bool, answers);
    QFETCH(Controller::Connection, connection);
    QFETCH(QString, words);
    test::ScriptedSlave device;
    device.setRegister(0, static_cast<std::uint16_t>(deviceType));
    if (!answers)
        device.script(std::vector<test::Fault>(10'000, test::Fault::LostRequest));
    PanelWindow panel(QString::fromStdString(device.port()));
    QTRY_VERIFY2_WITH_TIMEOUT(panel.texts().contains(words), qPrintable(panel.texts()), timeoutMs);
    QCOMPARE(panel.controller().connection(), connection);
    QCOMPARE(device.writes(), 0);
}

CAMPANEL_TEST(TestPanelAndController)

} // namespace test_panel_and_controller

#include "test_panel_and_controller.moc"
