// SPDX-License-Identifier: Apache-2.0
// Stops of the real controller, with a finger: a fault brings its own reason, an operator's stop is asked
// about and answered, and both are on the page and in the CSV file.
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTest>

namespace test_stops_and_controller {

using namespace campanel;
using panel::Controller;
using test::ControllerProcess;
using test::PanelWindow;

namespace {

constexpr int timeoutMs = 20'000;

} // namespace

class TestStopsAndController : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }

    void aFaultAndAnOperatorsStop()
    {
        ControllerProcess controller({QStringLiteral("--control")});
        PanelWindow panel(controller.port());
        panel::Stops& stops = panel.panel().stops();
        panel.settings().overrideValue("stops.ask_after_seconds", QStringLiteral("1"));
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(panel.panel().recipes().total(), 1, timeoutMs);
        QTest::qWait(1500);
        QVERIFY(!stops.asking()); // there is no program to run
        panel.touchDriver().settle();
        panel.tap("nav_motion");
        panel.download();
        panel.tap("nav_run");
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().canStart(), timeoutMs);
        panel.start(); // also while the question is on the page
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Running, timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().bags().count > 2, timeoutMs);
        QCOMPARE(stops.reason(), QString());

        controller.tell("pin drive-alarm on");
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Fault, timeoutMs);
        QTRY_COMPARE_WITH_TIMEOUT(stops.reason(), QStringLiteral("C-08"), timeoutMs);
        QTest::qWait(1500);
        QVERIFY(!stops.asking());
        controller.tell("pin drive-alarm off");
        panel.touchDriver().settle();
        panel.hold("middleKey"); // Reset
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().state() != Controller::State::Fault, timeoutMs);
        panel.touchDriver().settle();
        panel.hold("middleKey"); // the reference run
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Homing, timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().canStart(), timeoutMs);
        panel.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Running, timeoutMs);

        panel.tap("stopKey");
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Ready, timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(stops.asking(), timeoutMs);
        panel.touchDriver().settle();
        QVERIFY2(panel.texts().contains(QStringLiteral("Why is the machine stopped?")),
                 qPrintable(panel.texts()));
        panel.tap("reason_material");
        panel.tap("reason_material/film_change");
        QVERIFY(!stops.asking());
        QCOMPARE(stops.reason(), QStringLiteral("material/film_change"));
        panel.touchDriver().settle();
        QVERIFY(!panel.touchDriver().find(QStringLiteral("stopQuestion")));

        panel.tap("nav_trends");
        panel.tap("trendStops");
        QTRY_VERIFY_WITH_TIMEOUT(stops.shift()->stops()->count() >= 2, timeoutMs);
        panel.touchDriver().settle();
        panel.tap("shiftStops");
        const QString texts = panel.texts();
        QVERIFY2(texts.contains(QStringLiteral("Drive alarm (C-08)")), qPrintable(texts));
        QVERIFY2(texts.contains(QStringLiteral("Material · Film change")), qPrintable(texts));
        panel.tap("sheetClose");
        QVERIFY(stops.shift()->availability() > 0 && stops.shift()->availability() < 1);
        QVERIFY(stops.shift()->summary().production.pieces > 2);

        panel::ReportFiles& files = *panel.maintenance().files();
        const QString folder = panel.folder();
        files.setScanner([folder](const QString&) {
            return QList<store::Place>{{folder, QStringLiteral("stick"), false}};
        });
        panel.tap("shiftCsv");
        QTRY_VERIFY_WITH_TIMEOUT(panel.touchDriver().find(QStringLiteral("offer0")), timeoutMs);
        panel.tap("offer0");
        panel.tap("offerGo");
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder + QStringLiteral("/stops.csv")), timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(!files.busy(), timeoutMs);
        QFile csv(folder + QStringLiteral("/stops.csv"));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        const QByteArray text = csv.readAll();
        QVERIFY2(text.contains(",fault,C-08,no,"), text);
        QVERIFY2(text.contains(",ready,material/film_change,no,"), text);
        QCOMPARE(panel.complaints(), QStringList());
    }
};

CAMPANEL_TEST(TestStopsAndController)

} // namespace test_stops_and_controller

#include "test_stops_and_controller.moc"
