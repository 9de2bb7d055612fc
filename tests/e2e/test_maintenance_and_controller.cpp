// SPDX-License-Identifier: Apache-2.0
// The Service page touched like a technician does, campanel-controller at the other end of the line. A
// register written and read back, its figures and frames, a diagnosis, and a wrong unit number found and
// corrected.
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_service_and_controller {

using namespace campanel;
using panel::Controller;
using test::ControllerProcess;
using test::PanelWindow;

namespace {

constexpr int timeoutMs = 20'000;

// Returns the lamp of an input or output, not of the alarm with the same name.
panel::IoList::Lamp lampOf(PanelWindow& panel, const char* name)
{
    for (const panel::IoList::Row& row : panel.maintenance().io()->rows()->rows()) {
        if (row.name == QLatin1String(name) && row.side < panel::IoList::Side::Fault)
            return row.lamp;
    }
    return panel::IoList::Lamp::None;
}

QString rampTime(PanelWindow& panel)
{
    const panel::RegisterModel& registers = *panel.maintenance().inspector()->registers();
    return registers.data(registers.index(2), panel::RegisterModel::ValueRole).toString();
}

} // namespace

class TestMaintenanceAndController : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }

    void aParameterIsWrittenAndSeenOnTheWire()
    {
        ControllerProcess controller;
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        for (const char* name : {"nav_maintenance", "maintenanceLine", "maintenance2", "registerGroup",
                                 "choice_parameter", "register2"})
            panel.tap(name);
        QTRY_COMPARE_WITH_TIMEOUT(rampTime(panel), "800 ms", timeoutMs);
        panel.tap("registerWrite");
        panel.tapDigits(QStringLiteral("900"));
        panel.tap("keypadAccept");
        QTRY_COMPARE_WITH_TIMEOUT(panel.maintenance().inspector()->selectedText(),
                                  "Written and read back from the controller: 900\u00a0ms.", timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(rampTime(panel), "900 ms", timeoutMs);

        panel.tap("maintenance1");
        const panel::LineFigures& figures = *panel.maintenance().figures();
        QTRY_VERIFY_WITH_TIMEOUT(!figures.stripAnswers().isEmpty(), timeoutMs);
        QVERIFY(figures.stripAnswers().last() > 0);
        QVERIFY(panel.maintenance().figures()->times()->rows()[2].value.endsWith(" ms"));

        panel.tap("maintenance3");
        panel.tap("framesWrites");
        panel::FrameList& frames = *panel.maintenance().frames();
        QTRY_VERIFY_WITH_TIMEOUT(frames.count() >= 2, timeoutMs);
        QCOMPARE(frames.data(frames.index(0), panel::FrameList::WordsRole).toString(),
                 "Write parameter.ramp_time = 900 ms");
        QCOMPARE(frames.data(frames.index(1), panel::FrameList::WordsRole).toString(), "Response: done");
        QCOMPARE(panel.complaints(), QStringList());
    }

    void aCamSwitchIsSetAndADriveAlarmIsSeen()
    {
        ControllerProcess controller(
            {QStringLiteral("--control"), QStringLiteral("--pins"), QStringLiteral("limit-forward")});
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        for (const char* name : {"nav_maintenance", "maintenanceMachine", "maintenanceIo"})
            panel.tap(name);
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Limit switch, forward"), panel::IoList::Lamp::On, timeoutMs);
        QCOMPARE(lampOf(panel, "Drive enable"), panel::IoList::Lamp::On);
        QCOMPARE(lampOf(panel, "Emergency stop"), panel::IoList::Lamp::Off);

        panel.tap("ioSwitches");
        panel.tap("ioSwitch");
        panel.tap("choice_3");
        panel::CamSwitches& switches = *panel.maintenance().switches();
        QTRY_COMPARE_WITH_TIMEOUT(switches.value("parameter.switch3_every"), 1.0, timeoutMs);
        panel.tap("camSwitch0choice1");
        QTRY_COMPARE_WITH_TIMEOUT(switches.value("parameter.switch3_mode"), 1.0, timeoutMs);
        panel.tap("camSwitch2");
        panel.tapDigits(QStringLiteral("120"));
        panel.tap("keypadAccept");
        QTRY_COMPARE_WITH_TIMEOUT(switches.value("parameter.switch3_off_angle"), 120.0, timeoutMs);
        QCOMPARE(switches.outcomeText(), "Cam switch 3: off angle: 120°, read back from the controller.");
        panel.tap("ioSwitch");
        panel.tap("choice_9");
        QTRY_COMPARE_WITH_TIMEOUT(switches.value("parameter.drive_enable"), 1.0, timeoutMs);
        panel.tap("ioBack");

        controller.tell("pin emergency-stop on");
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Emergency stop"), panel::IoList::Lamp::Warning, timeoutMs);
        controller.tell("pin drive-alarm on");
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Fault, timeoutMs);
        QCOMPARE(panel.statuses().back().faultBits,
                 1U << static_cast<unsigned>(modbus::FaultBit::DriveAlarm));
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Drive alarm"), panel::IoList::Lamp::Bad, timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
    }

    void theAxisMovesWhileAFingerHoldsTheKey()
    {
        ControllerProcess controller;
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        for (const char* name : {"nav_maintenance", "maintenanceMachine", "maintenanceJog"})
            panel.tap(name);
        panel::Jog& jog = *panel.maintenance().jog();
        QTRY_COMPARE_WITH_TIMEOUT(
            panel.controller().parameterField(QStringLiteral("parameter.jog_frequency"))->value(), 1000.0,
            timeoutMs);
        panel.touchDriver().touch(QStringLiteral("jogForward"));
        QTRY_VERIFY_WITH_TIMEOUT(jog.positionPulses() > 500, timeoutMs); // longer than the validity of a key
        QCOMPARE(panel.controller().state(), Controller::State::Jogging);
        panel.touchDriver().lift();
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        const double stoodAt = jog.positionPulses();

        // The page disappears under the finger.
        panel.touchDriver().touch(QStringLiteral("jogReverse"));
        QTRY_VERIFY_WITH_TIMEOUT(jog.positionPulses() < stoodAt - 300, timeoutMs);
        QMetaObject::invokeMethod(panel.touchDriver().frame(), "openPage",
                                  Q_ARG(QString, QStringLiteral("run")));
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        panel.touchDriver().lift();
        QCOMPARE(panel.complaints(), QStringList());
    }

    void anOutputIsOnWhileAFingerHoldsTheKey()
    {
        ControllerProcess controller({QStringLiteral("--control")});
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        for (const char* name : {"nav_maintenance", "maintenanceMachine", "maintenanceIo"})
            panel.tap(name);
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Cam switch 3"), panel::IoList::Lamp::Off, timeoutMs);
        panel.touchDriver().touch(QStringLiteral("try2"));
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Cam switch 3"), panel::IoList::Lamp::On, timeoutMs);
        QTest::qWait(1000); // longer than the controller leaves it on by itself
        QCOMPARE(lampOf(panel, "Cam switch 3"), panel::IoList::Lamp::On);
        QCOMPARE(lampOf(panel, "Cam switch 2"), panel::IoList::Lamp::Off);
        panel.touchDriver().lift();
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Cam switch 3"), panel::IoList::Lamp::Off, timeoutMs);

        // The emergency stop ends it, and the page says why.
        panel.touchDriver().touch(QStringLiteral("try2"));
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Cam switch 3"), panel::IoList::Lamp::On, timeoutMs);
        controller.tell("pin emergency-stop on");
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Cam switch 3"), panel::IoList::Lamp::Off, timeoutMs);
        QCOMPARE(panel.maintenance().outputTry()->held(), -1);
        QVERIFY(panel.maintenance().outputTry()->text().contains("The emergency stop is pressed."));
        panel.touchDriver().lift();
        QCOMPARE(panel.complaints(), QStringList());
    }

    void anOlderControllerHasTheLampsAndNoKeys()
    {
        ControllerProcess controller({QStringLiteral("--map-minor"), QStringLiteral("4")});
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        for (const char* name : {"nav_maintenance", "maintenanceMachine", "maintenanceIo"})
            panel.tap(name);
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Drive enable"), panel::IoList::Lamp::On, timeoutMs);
        QVERIFY(!panel.touchDriver().find(QStringLiteral("try2")));
        QCOMPARE(panel.touchDriver().find(QStringLiteral("ioText"))->property("text").toString(),
                 "A filled lamp means on. This controller cannot try outputs; update its firmware.");
        panel.tap("ioSwitches");
        panel.maintenance().switches()->choose(panel::CamSwitches::drives() + 1);
        panel::CamSwitches& contact = *panel.maintenance().switches();
        QTRY_COMPARE_WITH_TIMEOUT(contact.data(contact.index(0), panel::CamSwitches::NoteRole).toString(),
                                  "Not in this controller. Update its firmware.", timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
    }

    void aWrongUnitNumberIsFoundAndMended()
    {
        ControllerProcess controller;
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        for (const char* name : {"nav_maintenance", "maintenanceLine", "maintenance0", "doctorDiagnose"})
            panel.tap(name);
        const panel::LinkDoctor& doctor = *panel.maintenance().doctor();
        QTRY_VERIFY_WITH_TIMEOUT(doctor.resultText().startsWith("The connection in use works"), timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().connection(), Controller::Connection::Connected,
                                  timeoutMs);

        panel::ConnectionChoice wrong = panel.settings().connection();
        wrong.unit = 9;
        panel.settings().overrideConnection(wrong);
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().connection() != Controller::Connection::Connected,
                                 timeoutMs);
        panel.tap("doctorDiagnose");
        QTRY_VERIFY_WITH_TIMEOUT(doctor.canTake(), timeoutMs);
        panel.tap("doctorTake");
        QCOMPARE(panel.settings().connection().unit, 1);
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().connection(), Controller::Connection::Connected,
                                  timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
    }
};

CAMPANEL_TEST(TestMaintenanceAndController)

} // namespace test_service_and_controller

#include "test_maintenance_and_controller.moc"
