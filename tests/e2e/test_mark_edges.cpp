// SPDX-License-Identifier: Apache-2.0
// The page with the edges of the mark sensor, opened by a finger on a running machine whose film has false
// and missing marks: campanel-controller at the other end of the line.
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_mark_edges {

using namespace campanel;
using panel::Controller;
using panel::MarkEdgeList;
using test::ControllerProcess;
using test::PanelWindow;

namespace {

constexpr int timeoutMs = 30'000;

QString textOf(PanelWindow& panel, const char* name)
{
    const QQuickItem* item = panel.touchDriver().find(QString::fromLatin1(name));
    return item ? item->property("text").toString().remove(QChar(0x2060)).replace(QChar(0xA0), u' ')
                : QString();
}

} // namespace

class TestMarkEdges : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }

    void aMarkOutsideItsWindowIsSeen()
    {
        ControllerProcess controller({QStringLiteral("--marks-false"), QStringLiteral("0.3"),
                                      QStringLiteral("--marks-missing"), QStringLiteral("0.1"),
                                      QStringLiteral("--speed"), QStringLiteral("5")});
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        for (const char* name :
             {"nav_maintenance", "maintenanceMachine", "maintenancePacking", "packingEdges"})
            panel.tap(name);
        QTRY_VERIFY_WITH_TIMEOUT(
            textOf(panel, "edgesEmpty").contains(QStringLiteral("No packing machine data")), timeoutMs);
        panel.tap("sheetClose");
        panel.tap("nav_motion");
        panel.download();
        if (QTest::currentTestFailed())
            return;
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().canStart(), timeoutMs);
        panel.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Running, timeoutMs);
        panel.tap("nav_maintenance");
        panel.tap("packingEdges");
        QTRY_VERIFY_WITH_TIMEOUT(textOf(panel, "edgeNewest").startsWith(QStringLiteral("Taken: ")),
                                 timeoutMs);
        QTRY_VERIFY2_WITH_TIMEOUT(textOf(panel, "edgeRejected").startsWith(QStringLiteral("Not taken: ")),
                                  qPrintable(textOf(panel, "edgeRejected")), timeoutMs);

        // A paused page stays while the machine runs on.
        panel.tap("edgesPause");
        const QString rejected = textOf(panel, "edgeRejected");
        const QString newest = textOf(panel, "edgeNewest");
        const QString counts = textOf(panel, "edgeVerdict0") + textOf(panel, "edgeVerdict1");
        QTest::qWait(5'000);
        QCOMPARE(textOf(panel, "edgeRejected"), rejected);
        QCOMPARE(textOf(panel, "edgeNewest"), newest);
        QCOMPARE(textOf(panel, "edgeVerdict0") + textOf(panel, "edgeVerdict1"), counts);
        QVERIFY2(rejected.contains(QStringLiteral("expected mark; the window is ±6 mm")),
                 qPrintable(rejected));
        QVERIFY2(textOf(panel, "edgeVerdict1") != QStringLiteral("outside the window: 0"),
                 qPrintable(counts));
        panel.tap("edgesPause");
        QTRY_VERIFY_WITH_TIMEOUT(textOf(panel, "edgeVerdict0") + textOf(panel, "edgeVerdict1") +
                                         textOf(panel, "edgeNewest") !=
                                     counts + newest,
                                 timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
    }
};

CAMPANEL_TEST(TestMarkEdges)

} // namespace test_mark_edges

#include "test_mark_edges.moc"
