// SPDX-License-Identifier: Apache-2.0
// The machine around the knife, by its own buttons and by finger: the Start button, an open door, and a horn
// that a technician sets and an operator silences.
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_signals_and_controller {

using namespace campanel;
using panel::Controller;
using test::ControllerProcess;
using test::PanelWindow;
using Lamp = panel::IoList::Lamp;

namespace {

constexpr int timeoutMs = 60'000;

Lamp lampOf(PanelWindow& panel, const char* name)
{
    for (const panel::IoList::Row& row : panel.maintenance().io()->rows()->rows()) {
        if (row.name == QLatin1String(name) && row.side < panel::IoList::Side::Fault)
            return row.lamp;
    }
    return Lamp::None;
}

void pressStart(ControllerProcess& controller)
{
    controller.tell("pin start-button on");
    QTest::qWait(200);
    controller.tell("pin start-button off");
}

} // namespace

class TestSignalsAndController : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }

    void theMachineIsStartedAndHeardBesideThePanel()
    {
        ControllerProcess controller({QStringLiteral("--control")});
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        panel.tap("nav_motion");
        panel.download();
        if (QTest::currentTestFailed())
            return;

        // Fault, horn: On, then off.
        for (const char* name : {"nav_settings", "section2", "openTower"})
            panel.tap(name);
        panel::TowerFields& tower = *panel.maintenance().tower();
        QTRY_COMPARE_WITH_TIMEOUT(tower.value("signal.fault_horn"), 0.0, timeoutMs);
        panel.tap("tower3");
        panel.tap("choice_4");
        QTRY_COMPARE_WITH_TIMEOUT(tower.value("signal.fault_horn"), 4.0, timeoutMs);

        for (const char* name : {"nav_maintenance", "maintenanceMachine", "maintenanceIo"})
            panel.tap(name);
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Machine runs"), Lamp::Off, timeoutMs);
        pressStart(controller);
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Running, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Machine runs"), Lamp::On, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Light tower, green"), Lamp::On, timeoutMs);

        controller.tell("pin door on");
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Ready, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Light tower, yellow"), Lamp::On, timeoutMs);
        pressStart(controller);
        panel.start();
        QTRY_VERIFY2_WITH_TIMEOUT(panel.texts().contains(QStringLiteral("The door is open. Close it.")),
                                  qPrintable(panel.texts()), timeoutMs);
        QCOMPARE(panel.controller().state(), Controller::State::Ready);
        controller.tell("pin door off");
        QTest::qWait(500);
        QCOMPARE(panel.controller().state(), Controller::State::Ready);
        pressStart(controller);
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Running, timeoutMs);

        controller.tell("pin drive-alarm on");
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Fault, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Horn"), Lamp::On, timeoutMs);
        panel.tap("nav_alarms");
        panel.tap("alarmsAcknowledgeAll");
        for (const char* name : {"nav_maintenance", "maintenanceMachine", "maintenanceIo"})
            panel.tap(name);
        QTRY_COMPARE_WITH_TIMEOUT(lampOf(panel, "Horn"), Lamp::Off, timeoutMs);
        QCOMPARE(panel.controller().state(), Controller::State::Fault);
    }
};

CAMPANEL_TEST(TestSignalsAndController)

} // namespace test_signals_and_controller

#include "test_signals_and_controller.moc"
