// SPDX-License-Identifier: Apache-2.0
// The approved window of a recipe, by finger: a technician sets it, an operator goes beyond it on Run, is
// asked for the reason, and the machine runs so; back within the window the line is gone.
#include "app/panel/audit/audit.h"
#include "app/panel/library/recipes.h"
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace test_approved_windows {

using namespace campanel;
using panel::Controller;
using profile::Field;
using test::PanelWindow;

namespace {

constexpr int timeoutMs = 60'000;

// Returns the rows of the audit trail of this kind.
QStringList trailOf(PanelWindow& panel, const QString& what)
{
    panel.panel().audit().open();
    QStringList found;
    (void)QTest::qWaitFor([&panel] { return panel.panel().audit().rows()->count() > 0; }, timeoutMs);
    for (const panel::AuditListRow& each : panel.panel().audit().rows()->rows()) {
        if (each.row.entry.what == what)
            found << each.row.entry.after;
    }
    return found;
}

} // namespace

class TestApprovedWindows : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }

    void aValueBeyondItsWindowNeedsAReason()
    {
        QTemporaryDir folder;
        {
            PanelWindow panel{QString(), QStringLiteral("en"), PanelWindow::Library::OneRecipe,
                              folder.path()};
            Controller& controller = panel.controller();
            QTRY_COMPARE_WITH_TIMEOUT(controller.state(), Controller::State::Idle, timeoutMs);

            // The technician approves 55 to 70 bags/min.
            panel.tap("nav_recipes");
            QTRY_VERIFY_WITH_TIMEOUT(panel.panel().recipes().chosen() >= 0, timeoutMs);
            panel.tap("recipeWindows");
            panel.tap("windowLowest_rate_bags_per_min");
            panel.tapDigits(QStringLiteral("55"));
            panel.tap("keypadAccept");
            panel.tap("windowHighest_rate_bags_per_min");
            panel.tapDigits(QStringLiteral("70"));
            panel.tap("keypadAccept");
            panel.tap("windowsSave");
            QTRY_VERIFY_WITH_TIMEOUT(!panel.editor().recipe().windows.empty(), timeoutMs);
            QVERIFY((panel.editor().recipe().windows.at(Field::Rate) == program::ApprovedWindow{55, 70}));
            QCOMPARE(panel.complaints(), QStringList());

            panel.tap("nav_motion");
            panel.download();
            if (QTest::currentTestFailed())
                return;
            panel.tap("nav_run");
            QTRY_VERIFY_WITH_TIMEOUT(controller.canStart(), timeoutMs);
            panel.start();
            QTRY_VERIFY_WITH_TIMEOUT(controller.bags().counted > 2, timeoutMs);

            // The operator wants 80.
            panel.tap("packingRate");
            panel.tap("changeMore");
            panel.tap("changeMore"); // 62
            QVERIFY(!panel.touchDriver().find(QStringLiteral("changeReason")));
            panel.tap("changeStep2");
            panel.tap("changeMore");
            panel.tap("changeMore"); // 82
            QVERIFY(!panel.touchDriver().find(QStringLiteral("changeApply")));
            panel.tap("changeReason");
            panel.tap("choice_line");
            panel.tap("changeApply");
            QTRY_VERIFY_WITH_TIMEOUT(std::abs(controller.live().rateBagsPerMin - 82) < 0.5, timeoutMs);
            QTRY_VERIFY_WITH_TIMEOUT(panel.touchDriver().find(QStringLiteral("windowLine")), timeoutMs);
            const QString texts = panel.texts().remove(QChar(0x2060)).replace(QChar(0xA0), QLatin1Char(' '));
            QVERIFY2(texts.contains(QStringLiteral("Rate 82.0 bags/min, approved 55.0 to 70.0 bags/min")) &&
                         texts.contains(QStringLiteral("Adapted to the line")),
                     qPrintable(texts));
            QCOMPARE(panel.complaints(), QStringList());
            const QStringList trail = trailOf(panel, QStringLiteral("recipe.outside"));
            QCOMPARE(trail.size(), 1);
            QVERIFY2(trail.first().startsWith(QStringLiteral("rate_bags_per_min 82.0: Adapted")),
                     qPrintable(trail.first()));
            panel.tap("nav_motion");
            QVERIFY(panel.touchDriver().find(QStringLiteral("windowLine")));

            // Back within the window.
            panel.tap("nav_run");
            panel.tap("packingRate");
            panel.tap("changeStep2");
            panel.tap("changeLess");
            panel.tap("changeLess"); // 62
            panel.tap("changeApply");
            QTRY_VERIFY_WITH_TIMEOUT(std::abs(controller.live().rateBagsPerMin - 62) < 0.5, timeoutMs);
            QTRY_VERIFY_WITH_TIMEOUT(!panel.touchDriver().find(QStringLiteral("windowLine")), timeoutMs);
            QCOMPARE(trailOf(panel, QStringLiteral("recipe.outside")).size(), 1);
            QCOMPARE(panel.complaints(), QStringList());
        }
    }
};

CAMPANEL_TEST(TestApprovedWindows)

} // namespace test_approved_windows

#include "test_approved_windows.moc"
