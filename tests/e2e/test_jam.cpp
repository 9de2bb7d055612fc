// SPDX-License-Identifier: Apache-2.0
// A jam by finger: the page of a machine whose monitoring is armed, something under the jaws, the fault on
// Run, Reset, Start. campanel-controller is the panel's own simulated machine.
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_jam {

using namespace campanel;
using panel::Controller;
using test::PanelWindow;

namespace {

constexpr int timeoutMs = 60'000;

QString textOf(PanelWindow& panel, const char* name)
{
    const QQuickItem* item = panel.touchDriver().find(QString::fromLatin1(name));
    return item ? item->property("text").toString().remove(QChar(0x2060)).replace(QChar(0xA0), u' ')
                : QString();
}

void openPacking(PanelWindow& panel)
{
    for (const char* name : {"nav_maintenance", "maintenanceMachine", "maintenancePacking"})
        panel.tap(name);
}

void switchOnDetection(PanelWindow& panel)
{
    auto& fields = *panel.maintenance().packing()->fields();
    QTRY_COMPARE_WITH_TIMEOUT(fields.value("parameter.jam_detection"), 0.0, timeoutMs);
    QQuickItem* list = panel.touchDriver().find(QStringLiteral("packingList"));
    QVERIFY(list);
    const QString name = panel::PackingFields::words(QStringLiteral("parameter.jam_detection"));
    for (int row = 0; row < fields.rowCount(); ++row) {
        if (fields.data(fields.index(row), panel::PackingFields::NameRole) != name)
            continue;
        constexpr int atBeginning = 0;
        QMetaObject::invokeMethod(list, "positionViewAtIndex", Q_ARG(int, row), Q_ARG(int, atBeginning));
        panel.touchDriver().settle();
        panel.tap(qPrintable(QStringLiteral("packing%1choice1").arg(row)));
    }
    QTRY_COMPARE_WITH_TIMEOUT(fields.value("parameter.jam_detection"), 1.0, timeoutMs);
}

// Puts something under the jaws of the simulated machine, or takes it out.
void setSomethingUnderTheJaws(PanelWindow& panel, bool isThere)
{
    for (const char* name : {"nav_maintenance", "maintenanceLine", "maintenance4"})
        panel.tap(name);
    QQuickItem* list = panel.touchDriver().find(QStringLiteral("faultList"));
    QVERIFY(list);
    constexpr int atCenter = 1;
    QMetaObject::invokeMethod(list, "positionViewAtIndex", Q_ARG(int, 11), Q_ARG(int, atCenter));
    panel.touchDriver().settle();
    panel.tap(isThere ? "fault11on" : "fault11off");
}

} // namespace

class TestJam : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }

    void theMachineGoesOnFromAJam()
    {
        PanelWindow panel{QString()};
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        panel.tap("nav_motion");
        panel.download();
        if (QTest::currentTestFailed())
            return;
        openPacking(panel);
        panel.tap("packingJam");
        QTRY_VERIFY_WITH_TIMEOUT(textOf(panel, "jamState").startsWith(QStringLiteral("Off.")), timeoutMs);
        panel.tap("sheetClose");
        switchOnDetection(panel);
        if (QTest::currentTestFailed())
            return;

        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().canStart(), timeoutMs);
        panel.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Running, timeoutMs);
        panel.tap("packingJam");
        QTRY_VERIFY2_WITH_TIMEOUT(textOf(panel, "jamState").startsWith(QStringLiteral("Learning ")),
                                  qPrintable(textOf(panel, "jamState")), timeoutMs);
        QTRY_VERIFY2_WITH_TIMEOUT(textOf(panel, "jamState").startsWith(QStringLiteral("Armed.")),
                                  qPrintable(textOf(panel, "jamState")), timeoutMs);
        QVERIFY(panel.maintenance().packing()->jam()->expected().size() > 10);
        QCOMPARE(textOf(panel, "jamLast"), QStringLiteral("No jam since power-up."));
        panel.tap("sheetClose");

        setSomethingUnderTheJaws(panel, true);
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Fault, timeoutMs);
        panel.tap("nav_run");
        QTRY_VERIFY2_WITH_TIMEOUT(
            panel.texts().contains(QStringLiteral("Take out what lies between the jaws")),
            qPrintable(panel.texts()), timeoutMs);
        openPacking(panel);
        panel.tap("packingJam");
        QTRY_VERIFY2_WITH_TIMEOUT(textOf(panel, "jamLast").contains(QStringLiteral(" before the cut")),
                                  qPrintable(textOf(panel, "jamLast")), timeoutMs);
        panel.tap("sheetClose");

        setSomethingUnderTheJaws(panel, false);
        QTRY_COMPARE_WITH_TIMEOUT(panel.maintenance().simulatedFaults()->activeCount(), 0, timeoutMs);
        panel.tap("nav_run");
        const int scrap = panel.controller().bags().scrap;
        const double bags = panel.controller().bags().count;
        panel.hold("middleKey"); // Reset
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Ready, timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().canStart(), timeoutMs);
        panel.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Running, timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().bags().count > bags + 5, timeoutMs);
        QCOMPARE(panel.controller().bags().scrap, scrap + 2);
        QCOMPARE(panel.controller().state(), Controller::State::Running);
        QCOMPARE(panel.complaints(), QStringList());
    }
};

CAMPANEL_TEST(TestJam)

} // namespace test_jam

#include "test_jam.moc"
