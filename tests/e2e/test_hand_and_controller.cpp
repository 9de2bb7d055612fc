// SPDX-License-Identifier: Apache-2.0
// The operator's hand on a running machine, by finger: slower, back to full speed, and what the next run
// keeps. campanel-controller is the panel's own simulated machine.
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <limits>

namespace test_hand_and_controller {

using namespace campanel;
using panel::Controller;
using test::PanelWindow;

namespace {

constexpr int timeoutMs = 60'000;

// Returns how far behind its printed mark the last bag was cut, as a ruler shows it, mm.
double behindMark(Controller& controller)
{
    double mm = std::numeric_limits<double>::quiet_NaN();
    QObject context;
    QObject::connect(&controller.link(), &link::Link::rulerRead, &context,
                     [&mm](const link::RulerOutcome& outcome) { mm = outcome.behindMarkMm; });
    controller.link().measureSimulatedBag();
    (void)QTest::qWaitFor([&mm] { return !std::isnan(mm); }, timeoutMs);
    return mm;
}

} // namespace

class TestHandAndController : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }

    void theMachineRunsAsFastAsTheHandSays()
    {
        PanelWindow panel{QString()};
        Controller& controller = panel.controller();
        const auto runsAt = [&controller](double percent) {
            return std::abs(controller.live().rateBagsPerMin -
                            controller.active().rateBagsPerMin * percent / 100) < 0.5;
        };
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Idle, timeoutMs);
        panel.tap("nav_motion");
        panel.download();
        if (QTest::currentTestFailed())
            return;
        panel.tap("nav_run");
        QVERIFY(!panel.touchDriver().find(QStringLiteral("speedKey")));
        QTRY_VERIFY_WITH_TIMEOUT(controller.canStart(), timeoutMs);
        panel.start();
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Running, timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(runsAt(100), timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.touchDriver().find(QStringLiteral("speedKey")), timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(controller.bags().counted > 5, timeoutMs);
        const int scrap = controller.bags().scrap; // of the start after power-up

        panel.tap("speedKey");
        for (int step = 0; step < 8; ++step)
            panel.tap("speedSlower");
        QCOMPARE(panel.complaints(), QStringList());
        QVERIFY2(panel.texts().contains(QStringLiteral("60")), qPrintable(panel.texts()));
        QTRY_VERIFY_WITH_TIMEOUT(runsAt(60), timeoutMs);

        // The next run is as slow, and says so before it starts.
        controller.stop();
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Ready, timeoutMs);
        panel.tap("sheetClose");
        QVERIFY2(panel.texts().contains(QStringLiteral("Slowed to")), qPrintable(panel.texts()));
        panel.start();
        QTRY_VERIFY_WITH_TIMEOUT(runsAt(60), timeoutMs);
        panel.tap("speedKey");
        panel.tap("speedFull");
        QTRY_VERIFY_WITH_TIMEOUT(runsAt(100), timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
        QCOMPARE(controller.bags().scrap, scrap);
    }

    // The cut is seen early: one touch opens the sheet, one held moves it, and the third bag is right.
    void theCutComesWhereTheHandPutsIt()
    {
        PanelWindow panel{QString()};
        Controller& controller = panel.controller();
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Idle, timeoutMs);
        panel.tap("nav_motion");
        panel.download();
        if (QTest::currentTestFailed())
            return;
        panel.tap("nav_run");
        QTRY_VERIFY_WITH_TIMEOUT(controller.canStart(), timeoutMs);
        panel.start();
        QTRY_VERIFY_WITH_TIMEOUT(controller.packing()->markState() == panel::PackingLine::MarkState::Tracking,
                                 timeoutMs);
        const auto afterBags = [&controller](int bags) {
            const int wanted = controller.bags().counted + bags;
            QTRY_VERIFY_WITH_TIMEOUT(controller.bags().counted >= wanted, timeoutMs);
        };
        afterBags(3);
        const int scrap = controller.bags().scrap;
        const double before = behindMark(controller);
        const auto trimMm = [&controller] { return controller.parameter("hand.cut").lastValue(); };

        panel.tap("trimKey");
        panel.touchDriver().touch(QStringLiteral("trimLeft0"));
        QTRY_VERIFY_WITH_TIMEOUT(trimMm() >= 1.5, timeoutMs);
        panel.touchDriver().lift();
        QTRY_VERIFY_WITH_TIMEOUT(trimMm() >= 2.0, timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
        afterBags(3);
        const double moved = behindMark(controller) - before;
        QVERIFY2(std::abs(moved - trimMm()) < 0.4, qPrintable(QString::number(moved)));
        QCOMPARE(controller.bags().scrap, scrap);

        // Saved with the recipe, it is in the library and in the editor.
        panel.tap("trimSave");
        QTRY_COMPARE_WITH_TIMEOUT(panel.editor().recipe().trims[0], trimMm(), timeoutMs);
        panel.tap("trimReset0");
        QTRY_COMPARE_WITH_TIMEOUT(trimMm(), 0.0, timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
    }

    // Not saved, the trim is there behind a power cut of the controller, and is still named as not saved.
    void anUnsavedTrimSurvivesAPowerCut()
    {
        test::ControllerProcess process;
        PanelWindow panel{process.port()};
        Controller& controller = panel.controller();
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Idle, timeoutMs);
        panel.tap("nav_motion");
        panel.download();
        if (QTest::currentTestFailed())
            return;
        panel.editor().saveToFlash();
        QTRY_VERIFY_WITH_TIMEOUT(panel.editor().programDownload()->isSaved(), timeoutMs);
        panel.tap("nav_run");
        QTRY_VERIFY_WITH_TIMEOUT(controller.canStart(), timeoutMs);
        panel.start();
        panel::HandTrims& trims = panel.panel().handTrims();
        QTRY_VERIFY_WITH_TIMEOUT(trims.offered(), timeoutMs);
        panel.tap("trimKey");
        for (int touch = 0; touch < 3; ++touch)
            panel.tap("trimLeft0");
        QTRY_COMPARE_WITH_TIMEOUT(controller.parameter("hand.cut").lastValue(), 1.5, timeoutMs);
        panel.tap("sheetClose");
        QCOMPARE(panel.complaints(), QStringList()); // the lost line is one

        process.kill();
        process.start();
        QTRY_VERIFY_WITH_TIMEOUT(controller.fresh() && controller.state() != Controller::State::Running,
                                 timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(trims.offered(), timeoutMs);
        QCOMPARE(trims.mm(), (QList<double>{1.5, 0.0, 0.0}));
        QVERIFY(trims.unsaved());
        QVERIFY2(panel.texts().contains(QStringLiteral("not saved")), qPrintable(panel.texts()));
        panel.tap("trimKey");
        panel.tap("trimSave");
        QTRY_VERIFY_WITH_TIMEOUT(!trims.unsaved(), timeoutMs);
        QCOMPARE(trims.mm().first(), 1.5);
    }

    // One bag after the other, held as Start is; a cut through a product is refused with its sentence.
    void oneBagIsMadeByFinger()
    {
        PanelWindow panel{QString()};
        Controller& controller = panel.controller();
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Idle, timeoutMs);
        panel.tap("nav_motion");
        panel.download();
        if (QTest::currentTestFailed())
            return;
        panel.tap("nav_run");
        QTRY_VERIFY_WITH_TIMEOUT(controller.canStart(), timeoutMs);
        const auto canTrim = [&panel] {
            const QQuickItem* key = panel.touchDriver().find(QStringLiteral("trimKey"));
            return key && key->isEnabled();
        };
        QTRY_VERIFY_WITH_TIMEOUT(canTrim(), timeoutMs);
        panel.tap("trimKey");
        panel.hold("bagKey");
        QVERIFY2(panel.texts().contains(QStringLiteral("Make a reference run first")),
                 qPrintable(panel.texts()));
        panel.tap("sheetClose");
        panel.start();
        QTRY_VERIFY_WITH_TIMEOUT(controller.bags().counted > 5, timeoutMs);
        panel.tap("trimKey");
        panel.tap("takeKey"); // the simulated machine has no reject gate as shipped
        QTRY_VERIFY2_WITH_TIMEOUT(panel.texts().contains(QStringLiteral("No cam switch rejects bags")),
                                  qPrintable(panel.texts()), timeoutMs);
        panel.tap("stopKey");
        QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Ready, timeoutMs);
        for (int i = 0; i < 2; ++i) {
            const int scrap = controller.bags().scrap;
            panel.hold("bagKey");
            QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Ready, timeoutMs);
            QTRY_COMPARE_WITH_TIMEOUT(controller.bags().scrap, scrap + 1, timeoutMs);
        }
        panel.hold("cutKey");
        QTRY_VERIFY2_WITH_TIMEOUT(panel.texts().contains(QStringLiteral("A product is under the knife")),
                                  qPrintable(panel.texts()), timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
    }
};

CAMPANEL_TEST(TestHandAndController)

} // namespace test_hand_and_controller

#include "test_hand_and_controller.moc"
