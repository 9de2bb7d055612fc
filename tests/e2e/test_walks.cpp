// SPDX-License-Identifier: Apache-2.0
// Walks of the operator and of who makes programs, by the fewest touches, each with its maximum number of
// touches: first start, length and rate, motion, cams, recipes, a lost line, a keyboard.
#include "app/shell/fonts.h"
#include "tests/support/test_program.h"
#include "walking_panel.h"

#include <QTest>

#include <cmath>

namespace test_walks {

using namespace campanel;
using panel::Controller;
using test::PanelWindow;
using test::run;
using test::waitForController;
using test::Walk;
using test::WalkingPanel;

namespace {

constexpr auto used = PanelWindow::Library::OneRecipe;
constexpr auto isNew = PanelWindow::Library::Empty;

void openMotion(WalkingPanel& panel)
{
    waitForController(panel);
    panel.tap("Motion");
}

void openKind(WalkingPanel& panel, const char* kind)
{
    openMotion(panel);
    panel.tap("View and tools");
    panel.tap("Program");
    panel.tap(QString::fromLatin1(kind));
}

void waitForRecipes(WalkingPanel& panel, int total)
{
    panel.waitFor("the recipes", [&] { return panel.window().panel().recipes().total() == total; });
}

void openRecipes(WalkingPanel& panel)
{
    waitForController(panel);
    waitForRecipes(panel, 1);
    panel.tap("Recipes");
}

void addWafer(WalkingPanel& panel)
{
    openRecipes(panel);
    panel.tap(QStringLiteral("New …"));
    panel.tap("Rotary cutter");
    panel.keys("wafer");
    panel.tap("Confirm");
    waitForRecipes(panel, 2);
}

void beginFirstStart(WalkingPanel& panel)
{
    waitForController(panel);
    panel.window().settings().beginFirstStart();
}

// 180 mm, 80 a minute.
void makeTheFirstRecipe(WalkingPanel& panel)
{
    panel.keys("180"); // its keypad is open
    panel.tap("Rate");
    panel.keys("80");
    panel.tap("Download");
    panel.waitFor("a program", [&] { return panel.controller().canStart(); });
    panel.hold("Start");
    panel.waitFor("a good bag", [&] { return std::abs(panel.controller().bags().meanMm - 180) < 1; });
}

void change(WalkingPanel& panel, const char* field, const char* digits)
{
    panel.tap(QString::fromLatin1(field));
    panel.tap("Keypad");
    panel.keys(QString::fromLatin1(digits));
    panel.tap("OK");
    panel.tap("Apply at the next bag");
}

const Walk walks[] = {
    {"1a", "first start to a good bag: 180 mm, 80 a minute, no PIN", 12, isNew, beginFirstStart,
     [](WalkingPanel& panel) {
         for (int step = 0; step < 4; ++step)
             panel.tap("Next");
         makeTheFirstRecipe(panel);
     }},
    {"1b", "the same with a PIN of six digits", 28, isNew, beginFirstStart,
     [](WalkingPanel& panel) {
         panel.tap("Next");
         panel.tap("Next");
         panel.tap("Set the first PIN");
         panel.tap("Next: PIN");
         panel.keys("258036");
         panel.tap("OK");
         panel.keys("258036");
         panel.tap("OK");
         panel.waitFor("a user", [&] { return panel.window().panel().access().protectedByPins(); });
         panel.tap("Next");
         panel.tap("Next");
         makeTheFirstRecipe(panel);
     }},
    {"2a", "the bag length 1 mm longer while the machine runs", 3, used, run,
     [](WalkingPanel& panel) {
         panel.tap("Change: Bag length");
         panel.tap("More");
         panel.tap("Apply at the next bag");
         panel.waitFor("251 mm", [&] { return panel.controller().active().bagLengthMm == 251; });
     }},
    {"2b", "the rate 1 a minute higher while the machine runs", 3, used, run,
     [](WalkingPanel& panel) {
         panel.tap("Change: Rate");
         panel.tap("More");
         panel.tap("Apply at the next bag");
         panel.waitFor("61 a minute",
                       [&] { return std::abs(panel.controller().active().rateBagsPerMin - 61) < 0.01; });
     }},
    {"2c", "a bag length of three digits while the machine runs", 7, used, run,
     [](WalkingPanel& panel) {
         change(panel, "Change: Bag length", "220");
         panel.waitFor("220 mm", [&] { return panel.controller().active().bagLengthMm == 220; });
     }},
    {"3", "a length too small, too large, then a valid one", 7, used, openMotion,
     [](WalkingPanel& panel) {
         panel.tap("Bag length");
         panel.keys("5");
         panel.waitFor("no OK", [&] { return !panel.window().touchDriver().findNamed("OK"); });
         panel.keys("000");
         panel.waitForText("The maximum is ");
         panel.tap("Delete");
         panel.tap("OK");
         panel.waitFor("500 mm", [&] { return panel.editor().bagLength()->value() == 500; });
     }},
    {"4a", "gentle ratios", 2, used, openMotion,
     [](WalkingPanel& panel) {
         panel.tap("Ratio k1, Ratio k2, Ratio k3, Ratio k4");
         panel.tap("Gentle");
         panel.waitForText("Ratios: gentle");
     }},
    {"4b", "another speed law", 3, used, openMotion,
     [](WalkingPanel& panel) {
         panel.tap("Speed law");
         panel.tap("Harmonic");
         panel.tap("Close");
         panel.waitForText("Harmonic");
     }},
    {"4c", "another point of the regime map, and undo", 4, used, openMotion,
     [](WalkingPanel& panel) {
         panel.tap("View and tools");
         panel.tap("Regime map");
         panel.drag("regimeDot", {60, 0});
         panel.waitFor("another recipe", [&] { return panel.editor().edited(); });
         panel.tap("Undo");
         panel.waitFor("the recipe again", [&] { return !panel.editor().edited(); });
     }},
    {"5a", "two more knots of a point cam", 3, used,
     [](WalkingPanel& panel) { openKind(panel, "Point cam"); },
     [](WalkingPanel& panel) {
         panel.tap("Knots");
         panel.tap("Add after");
         panel.tap("Add after");
         panel.waitFor("7 knots", [&] { return panel.editor().knots()->count() == 7; });
     }},
    {"5b", "a move by intervals instead of points", 3, used,
     [](WalkingPanel& panel) { openKind(panel, "Position move"); },
     [](WalkingPanel& panel) {
         panel.tap("Next: Curve");
         panel.tap("Execution");
         panel.tap("Intervals");
         panel.waitFor("intervals", [&] {
             return std::get<profile::PositionMoveProgram>(panel.editor().recipe().program).execution ==
                    profile::Execution::Intervals;
         });
     }},
    {"6a", "a recipe found by its name", 4, used, addWafer,
     [](WalkingPanel& panel) {
         panel.tap("Search");
         panel.keys("bi");
         panel.tap("Biscuit 250");
         panel.waitFor("the recipe",
                       [&] { return panel.window().panel().recipes().chosenName() == u"Biscuit 250"; });
     }},
    {"6b", "a recipe renamed to one letter", 3, used, openRecipes,
     [](WalkingPanel& panel) {
         panel.tap(QStringLiteral("Rename …"));
         panel.keys("x");
         panel.tap("Confirm");
         panel.waitFor("the name", [&] { return panel.window().panel().recipes().chosenName() == u"x"; });
     }},
    {"6c", "the changes of a version", 3, used,
     [](WalkingPanel& panel) {
         run(panel);
         change(panel, "Change: Rate", "80");
         panel.waitFor("two versions", [&] { return panel.editor().recipe().version == 2; });
         panel.tap("Recipes");
     },
     [](WalkingPanel& panel) {
         panel.tap("Versions");
         panel.tap("Version 1");
         panel.tap("To newest");
         panel.waitForText("60.0 bags/min");
     }},
    {"6d", "a recipe deleted and restored", 4, used, addWafer,
     [](WalkingPanel& panel) {
         panel.tap("Biscuit 250");
         panel.tap(QStringLiteral("Delete …"));
         panel.tap("Delete");
         waitForRecipes(panel, 1);
         panel.tap("Restore");
         waitForRecipes(panel, 2);
     }},
    {"6e", "a recipe written to a file", 3, used, openRecipes,
     [](WalkingPanel& panel) {
         panel.tap(QStringLiteral("Export …"));
         panel.tap("This panel");
         panel.tap("Write file");
         panel.waitForText("Biscuit 250.json");
     }},
    {"13a", "the controller is back after a power cut", 0, used, run,
     [](WalkingPanel& panel) {
         panel.process().kill();
         panel.waitFor("a lost line",
                       [&] { return panel.controller().connection() != Controller::Connection::Connected; });
         panel.process().start();
         panel.waitFor("the line",
                       [&] { return panel.controller().connection() == Controller::Connection::Connected; });
     }},
    {"13b", "Stop without a line, withdrawn", 2, used,
     [](WalkingPanel& panel) {
         run(panel);
         panel.process().kill();
         panel.waitForText("no connection");
     },
     [](WalkingPanel& panel) {
         panel.tap("Stop");
         panel.waitForText("not sent yet");
         panel.tap("Withdraw");
         panel.waitForText("Stop was withdrawn");
     }},
    {"15", "another length by the digits of a keyboard", 1, used, openMotion,
     [](WalkingPanel& panel) {
         panel.tap("Bag length");
         QQuickWindow& keyboard = panel.window().panel().window();
         for (const char digit : {'1', '8', '0'})
             QTest::keyClick(&keyboard, digit);
         QTest::keyClick(&keyboard, Qt::Key_Return);
         panel.waitFor("180 mm", [&] { return panel.editor().bagLength()->value() == 180; });
     }},
};

} // namespace

class TestWalks : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }

    void walk_data()
    {
        QTest::addColumn<const Walk*>("row");
        for (const Walk& each : walks)
            QTest::newRow(each.number) << &each;
    }
    void walk()
    {
        QFETCH(const Walk*, row);
        test::doWalk(*row);
    }
};

CAMPANEL_TEST(TestWalks)

} // namespace test_walks

#include "test_walks.moc"
