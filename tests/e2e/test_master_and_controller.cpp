// SPDX-License-Identifier: Apache-2.0
// A machine that follows the line of somebody else, by finger: its master set to the encoder, a download, the
// line started and stopped in mid-bag on Maintenance > Faults. campanel-controller is the panel's own
// simulated machine.
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_master_and_controller {

using namespace campanel;
using panel::Controller;
using test::PanelWindow;

namespace {

constexpr int timeoutMs = 60'000;
// Of the simulated faults.
constexpr int lineRow = 12;
constexpr int swapRow = 15;
constexpr int noiseRow = 16;

void followTheEncoder(PanelWindow& panel)
{
    QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(panel.controller().masterSetting()->hasInput(), timeoutMs);
    QVERIFY(!panel.controller().masterSetting()->followsEncoder());
    for (const char* name : {"nav_maintenance", "maintenanceLine", "maintenance2"})
        panel.tap(name);
    panel.maintenance().inspector()->setGroup(QStringLiteral("master"));
    panel.touchDriver().settle();
    for (const char* name : {"register0", "registerWrite"})
        panel.tap(name);
    panel.tapDigits(QStringLiteral("1"));
    panel.tap("keypadAccept");
    QCOMPARE(panel.complaints(), QStringList());
    QTRY_VERIFY_WITH_TIMEOUT(panel.controller().masterSetting()->followsEncoder(), timeoutMs);
}

// Taps a key of the simulated faults, and waits until the machine has taken it.
void setFault(PanelWindow& panel, int row, const char* key)
{
    for (const char* name : {"nav_maintenance", "maintenanceLine", "maintenance4"})
        panel.tap(name);
    QQuickItem* list = panel.touchDriver().find(QStringLiteral("faultList"));
    QVERIFY(list);
    constexpr int atCenter = 1;
    QMetaObject::invokeMethod(list, "positionViewAtIndex", Q_ARG(int, row), Q_ARG(int, atCenter));
    panel.touchDriver().settle();
    panel.tap(qPrintable(QStringLiteral("fault%1%2").arg(row).arg(QLatin1String(key))));
    const auto& rows = *panel.maintenance().simulatedFaults()->rows();
    const int wanted = qstrcmp(key, "off") == 0 ? panel::SimulatedFaults::Off : panel::SimulatedFaults::Often;
    QTRY_COMPARE_WITH_TIMEOUT(rows.row(row).level, wanted, timeoutMs);
}

int engagement(PanelWindow& panel)
{
    panel::Parameter& state = panel.controller().parameter("master_status.state");
    state.read();
    return std::isnan(state.lastValue()) ? -1 : static_cast<int>(state.lastValue());
}

} // namespace

class TestMasterAndController : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }

    void theMachineFollowsTheLine()
    {
        PanelWindow panel{QString()};
        Controller& controller = panel.controller();
        followTheEncoder(panel);
        if (QTest::currentTestFailed())
            return;
        panel.tap("nav_motion");
        QVERIFY2(panel.texts().contains(QStringLiteral("Rate at max. line speed")),
                 qPrintable(panel.texts()));
        // A recipe for the clock is not downloaded.
        for (const char* name : {"more", "toolChoice0", "choice_1"})
            panel.tap(name);
        QTRY_COMPARE_WITH_TIMEOUT(panel.editor().programDownload()->state(),
                                  panel::ProgramDownload::State::Blocked, timeoutMs);
        QVERIFY2(panel.editor().programDownload()->text().startsWith(
                     QStringLiteral("This recipe is for the clock, but an encoder leads the machine.")),
                 qPrintable(panel.editor().programDownload()->text()));
        for (const char* name : {"more", "toolChoice0", "choice_2"})
            panel.tap(name);
        QCOMPARE(panel.complaints(), QStringList());
        panel.download();
        if (QTest::currentTestFailed())
            return;

        panel.tap("nav_run");
        QTRY_VERIFY_WITH_TIMEOUT(panel.touchDriver().find(QStringLiteral("packingRate")), timeoutMs);
        panel.tap("packingRate");
        QTRY_VERIFY2_WITH_TIMEOUT(panel.texts().contains(QStringLiteral("The line sets the rate")),
                                  qPrintable(panel.texts()), timeoutMs);
        QVERIFY(!panel.touchDriver().find(QStringLiteral("keypad")));
        controller.dismissMessage();
        setFault(panel, lineRow, "full");
        if (QTest::currentTestFailed())
            return;
        panel.tap("nav_run");
        QTRY_VERIFY_WITH_TIMEOUT(controller.canStart(), timeoutMs);
        panel.start();
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Running, timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(controller.bags().count >= 5, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(engagement(panel), int{static_cast<int>(modbus::MasterState::Engaged)},
                                  timeoutMs);
        QVERIFY(std::abs(controller.live().rateBagsPerMin - 60) < 1);

        setFault(panel, lineRow, "off");
        QTRY_COMPARE_WITH_TIMEOUT(controller.live().rateBagsPerMin, 0.0, timeoutMs);
        QCOMPARE(controller.state(), Controller::State::Running);
        const double bags = controller.bags().count;
        setFault(panel, lineRow, "full");
        if (QTest::currentTestFailed())
            return;
        QTRY_VERIFY_WITH_TIMEOUT(controller.bags().count >= bags + 5, timeoutMs);
        QVERIFY2(std::abs(controller.bags().lengthMm - 250) < 1,
                 qPrintable(QString::number(controller.bags().lengthMm)));
        QCOMPARE(controller.state(), Controller::State::Running);

        panel.tap("stopKey");
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Ready, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(engagement(panel), int{static_cast<int>(modbus::MasterState::Off)},
                                  timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
    }

    void aDisturbedSignalIsAFault()
    {
        PanelWindow panel{QString()};
        Controller& controller = panel.controller();
        followTheEncoder(panel);
        if (QTest::currentTestFailed())
            return;
        panel.tap("nav_motion");
        panel.download();
        setFault(panel, lineRow, "full");
        if (QTest::currentTestFailed())
            return;
        panel.tap("nav_run");
        QTRY_VERIFY_WITH_TIMEOUT(controller.canStart(), timeoutMs);
        panel.start();
        QTRY_VERIFY_WITH_TIMEOUT(controller.bags().count >= 3, timeoutMs);

        setFault(panel, noiseRow, "on");
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Fault, timeoutMs);
        QCOMPARE(panel.statuses().back().faultBits,
                 1U << static_cast<unsigned>(modbus::FaultBit::MasterSignal));
        panel.tap("nav_alarms");
        QTRY_VERIFY2_WITH_TIMEOUT(panel.texts().contains(QStringLiteral("C-10")), qPrintable(panel.texts()),
                                  timeoutMs);
        setFault(panel, noiseRow, "off");
        panel.tap("nav_run");
        panel.hold("middleKey"); // Reset
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Ready, timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(controller.canStart(), timeoutMs);
        const double bags = controller.bags().count;
        panel.start();
        QTRY_VERIFY_WITH_TIMEOUT(controller.bags().count >= bags + 3, timeoutMs);
        QCOMPARE(controller.state(), Controller::State::Running);
    }

    void swappedWiresAreSaid()
    {
        PanelWindow panel{QString()};
        Controller& controller = panel.controller();
        followTheEncoder(panel);
        if (QTest::currentTestFailed())
            return;
        panel.tap("nav_motion");
        panel.download();
        setFault(panel, swapRow, "on");
        setFault(panel, lineRow, "full");
        if (QTest::currentTestFailed())
            return;
        panel.tap("nav_run");
        QTRY_VERIFY_WITH_TIMEOUT(controller.canStart(), timeoutMs);
        panel.start();
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Fault, timeoutMs);
        QCOMPARE(panel.statuses().back().faultBits,
                 1U << static_cast<unsigned>(modbus::FaultBit::MasterBackward));
        panel.tap("nav_alarms");
        QTRY_VERIFY2_WITH_TIMEOUT(panel.texts().contains(QStringLiteral("Exchange wires A and B")),
                                  qPrintable(panel.texts()), timeoutMs);
        setFault(panel, swapRow, "off");
        panel.tap("nav_run");
        panel.hold("middleKey"); // Reset
        QTRY_VERIFY_WITH_TIMEOUT(controller.canStart(), timeoutMs);
        panel.start();
        QTRY_VERIFY_WITH_TIMEOUT(controller.bags().count >= 3, timeoutMs);
        QCOMPARE(controller.state(), Controller::State::Running);
    }
};

CAMPANEL_TEST(TestMasterAndController)

} // namespace test_master_and_controller

#include "test_master_and_controller.moc"
