// SPDX-License-Identifier: Apache-2.0
// An order by finger: new, started, counted by the controller also while the panel is restarted, complete at
// its quantity with the machine at a standstill; then the next one of the queue.
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <memory>

namespace test_order_and_controller {

using namespace campanel;
using panel::Controller;
using test::PanelWindow;

namespace {

constexpr int timeoutMs = 60'000;
constexpr int quantity = 12;

struct Line {
    test::ControllerProcess controller{{QStringLiteral("--speed"), QStringLiteral("2")}};
    QTemporaryDir folder;
    std::unique_ptr<PanelWindow> panel;

    Line() { startPanel(); }
    void startPanel()
    {
        panel = std::make_unique<PanelWindow>(controller.port(), QStringLiteral("en"),
                                              PanelWindow::Library::OneRecipe, folder.path());
    }
    [[nodiscard]] Controller& machine() { return panel->controller(); }
    [[nodiscard]] store::OrderRow order() { return panel->panel().orders().current().order; }
    [[nodiscard]] bool isShown(const char* name)
    {
        return panel->touchDriver().find(QString::fromLatin1(name)) != nullptr;
    }
    void enter(const char* field, const char* text)
    {
        panel->tap(field);
        for (const QChar letter : QString::fromLatin1(text))
            panel->tap(("key_" + QString(letter).toLatin1()).constData());
        panel->tap("textAccept");
    }
    void enterQuantity(const char* digits)
    {
        panel->tap("orderQuantity");
        panel->tapDigits(QString::fromLatin1(digits));
        panel->tap("keypadAccept");
    }
};

} // namespace

class TestOrderAndController : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }

    void anOrderEndsTheRunAndTheNextOneFollows()
    {
        Line line;
        QTRY_COMPARE_WITH_TIMEOUT(line.machine().state(), Controller::State::Idle, timeoutMs);
        line.panel->tap("nav_motion");
        line.panel->download();
        if (QTest::currentTestFailed())
            return;
        line.panel->tap("nav_run");
        QTRY_VERIFY_WITH_TIMEOUT(line.isShown("newOrder"), timeoutMs);
        line.panel->tap("newOrder");
        line.enterQuantity("12");
        line.enter("orderLot", "lot");
        line.enter("orderText", "a");
        line.panel->tap("orderStart");
        QCOMPARE(line.panel->complaints(), QStringList());
        QTRY_COMPARE_WITH_TIMEOUT(line.order().state, store::OrderRow::State::Active, timeoutMs);
        QCOMPARE(line.order().lot, QStringLiteral("lot"));
        QCOMPARE(line.order().recipe, QStringLiteral("Biscuit 250"));
        line.panel->tap("sheetClose");
        QTRY_VERIFY_WITH_TIMEOUT(line.machine().canStart(), timeoutMs);
        line.panel->start();
        QTRY_COMPARE_WITH_TIMEOUT(line.machine().state(), Controller::State::Running, timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(line.order().good >= 3, timeoutMs);
        QVERIFY2(line.panel->texts().contains(QStringLiteral("of 12 · ")), qPrintable(line.panel->texts()));

        // The panel is away while the controller counts on.
        line.panel.reset();
        line.startPanel();
        QTRY_VERIFY_WITH_TIMEOUT(line.order().good > 3, timeoutMs);
        QCOMPARE(line.order().text, QStringLiteral("a"));
        QTRY_COMPARE_WITH_TIMEOUT(line.order().state, store::OrderRow::State::Complete, timeoutMs);
        QCOMPARE(line.order().good, quantity);
        QTRY_COMPARE_WITH_TIMEOUT(line.machine().state(), Controller::State::Ready, timeoutMs);
        QCOMPARE(line.order().cut, line.order().good + line.order().rejected + line.order().empty);

        // The next one waits in the queue until a person starts it.
        line.panel->tap("nav_run");
        line.panel->tap("orderStrip");
        line.panel->tap("ordersNew");
        line.enterQuantity("5");
        line.enter("orderLot", "next");
        line.panel->tap("orderAdd");
        QVERIFY(line.isShown("queueStart0"));
        line.panel->tap("queueStart0");
        QTRY_COMPARE_WITH_TIMEOUT(line.order().lot, QStringLiteral("next"), timeoutMs);
        QVERIFY(!line.isShown("queueStart0"));
        line.panel->tap("sheetClose");
        QTRY_VERIFY_WITH_TIMEOUT(line.machine().canStart(), timeoutMs);
        line.panel->start();
        QTRY_COMPARE_WITH_TIMEOUT(line.order().state, store::OrderRow::State::Complete, timeoutMs);
        QCOMPARE(line.order().good, 5);
        QTRY_COMPARE_WITH_TIMEOUT(line.machine().state(), Controller::State::Ready, timeoutMs);

        line.panel->tap("orderStrip");
        line.panel->tap("ordersHistory");
        QTRY_VERIFY_WITH_TIMEOUT(line.isShown("order1"), timeoutMs);
        const QString texts = line.panel->texts();
        QVERIFY2(texts.contains(QStringLiteral("a · lot")) && texts.contains(QStringLiteral("12 of 12")) &&
                     texts.contains(QStringLiteral("5 of 5")),
                 qPrintable(texts));
        QCOMPARE(line.panel->complaints(), QStringList());
    }
};

CAMPANEL_TEST(TestOrderAndController)

} // namespace test_order_and_controller

#include "test_order_and_controller.moc"
