// SPDX-License-Identifier: Apache-2.0
// Walks of the technician and of who looks after the panel, by the fewest touches, each with its maximum
// number of touches: alarms, stops, users, maintenance, settings, trends.
#include "app/shell/fonts.h"
#include "tests/support/test_program.h"
#include "walking_panel.h"

#include <QDir>
#include <QDirIterator>
#include <QTest>

namespace test_walks_upkeep {

using namespace campanel;
using namespace Qt::StringLiterals;
using panel::Controller;
using test::PanelWindow;
using test::run;
using test::waitForController;
using test::Walk;
using test::WalkingPanel;

namespace {

constexpr auto used = PanelWindow::Library::OneRecipe;

// Files that a walk has written into the panel's folder.
bool isWritten(WalkingPanel& panel, const char* filter)
{
    QDirIterator files(panel.window().folder(), {QString::fromLatin1(filter)}, QDir::Files,
                       QDirIterator::Subdirectories);
    return files.hasNext();
}

void writeTo(WalkingPanel& panel, const char* filter)
{
    panel.tap("This panel");
    panel.tap("Write file");
    panel.waitFor(filter, [&] { return isWritten(panel, filter); });
}

void raiseFault(WalkingPanel& panel)
{
    run(panel);
    panel.process().tell("pin drive-alarm on");
    panel.waitFor("a fault", [&] { return panel.controller().faulted(); });
    panel.process().tell("pin drive-alarm off");
}

void openAlarms(WalkingPanel& panel)
{
    waitForController(panel);
    panel.process().kill();
    panel.waitFor("an alarm", [&] { return panel.window().panel().alarms().unacknowledged() > 0; });
    panel.tap("Alarms");
}

void waitForTheQuestion(WalkingPanel& panel)
{
    panel.window().settings().overrideValue("stops.ask_after_seconds", QStringLiteral("1"));
    run(panel);
    panel.tap("Stop");
    panel.waitFor("the question", [&] { return panel.window().panel().stops().asking(); });
}

void openMaintenance(WalkingPanel& panel)
{
    waitForController(panel);
    panel.tap("Maintenance");
}

void openSettings(WalkingPanel& panel)
{
    waitForController(panel);
    panel.tap("Settings");
}

void addUser(WalkingPanel& panel)
{
    waitForController(panel);
    panel::Access& access = panel.window().panel().access();
    access.addUser(QStringLiteral("Anna"), panel::Access::Service, QStringLiteral("258036"));
    panel.waitFor("a user", [&] { return access.loggedIn(); });
    access.logOut();
    panel.tap("Motion");
    panel.tap("Curves");
}

const Walk walks[] = {
    {"7a", "from a fault to running", 3, used, raiseFault,
     [](WalkingPanel& panel) {
         panel.hold("Reset");
         panel.hold("Reference run");
         panel.waitFor("a reference", [&] { return panel.controller().canStart(); });
         panel.hold("Start");
         panel.waitFor("a run", [&] { return panel.controller().state() == Controller::State::Running; });
     }},
    {"7b", "an alarm read and acknowledged", 2, used, openAlarms,
     [](WalkingPanel& panel) {
         panel.tap("Connection lost");
         panel.tap("Acknowledge");
         panel.waitFor("no alarm", [&] { return panel.window().panel().alarms().unacknowledged() == 0; });
     }},
    {"7c", "an alarm shelved for an hour", 2, used, openAlarms,
     [](WalkingPanel& panel) {
         panel.tap("Connection lost");
         panel.tap("Shelve 1 h");
         panel.waitFor("a shelved one",
                       [&] { return panel.window().panel().alarms().shelved()->count() == 1; });
     }},
    {"7d", "the alarms of one day", 4, used, openAlarms,
     [](WalkingPanel& panel) {
         panel.tap("History");
         panel.tap("Filter");
         panel.tap("This day only");
         panel.tap("Show");
         panel.waitForText("Only: ");
     }},
    {"8a", "a stop answered", 2, used, waitForTheQuestion,
     [](WalkingPanel& panel) {
         panel.tap("Material");
         panel.tap("Film change");
         panel.waitFor("the reason",
                       [&] { return panel.window().panel().stops().reason() == u"material/film_change"; });
     }},
    {"8b", "the shift, and its report as a PDF", 5, used, waitForTheQuestion,
     [](WalkingPanel& panel) {
         panel.tap("Trends");
         panel.tap("Stops");
         panel.tap("PDF");
         writeTo(panel, "*.pdf");
     }},
    {"9a", "the first user", 17, used, openSettings,
     [](WalkingPanel& panel) {
         panel.tap("Users");
         panel.tap("First user");
         panel.tap("Next: PIN");
         panel.keys("258036");
         panel.tap("OK");
         panel.keys("258036");
         panel.tap("OK");
         panel.waitFor("a user", [&] { return panel.window().panel().access().protectedByPins(); });
     }},
    {"9b", "a field that needs a login", 9, used, addUser,
     [](WalkingPanel& panel) {
         panel.tap("Base speed v_a");
         panel.tap("Anna");
         panel.keys("258036");
         panel.tap("OK");
         panel.waitFor("its keypad", [&] { return panel.window().touchDriver().find("keypad") != nullptr; });
     }},
    {"10a", "the line diagnosed", 1, used, openMaintenance,
     [](WalkingPanel& panel) {
         panel.tap("Diagnose");
         panel.waitForText("Controller found");
     }},
    {"10b", "a register written", 9, used, openMaintenance,
     [](WalkingPanel& panel) {
         panel.tap("Registers");
         panel.tap("Group");
         panel.tap("Parameters");
         panel.tap("parameter.ramp_time");
         panel.tap(QStringLiteral("Write …"));
         panel.keys("900");
         panel.tap("OK");
         panel.waitForText("Written and read back from the controller: 900 ms.");
     }},
    {"10c", "jog", 2, used, openMaintenance,
     [](WalkingPanel& panel) {
         panel.tap("Machine");
         panel.hold("Forward");
         panel.waitFor("a movement",
                       [&] { return panel.window().statuses().back().commandedPositionPulses != 0; });
     }},
    {"10d", "a backup", 4, used, openMaintenance,
     [](WalkingPanel& panel) {
         panel.tap("Panel");
         panel.tap("Create backup");
         writeTo(panel, "*.zip");
     }},
    {"10e", "a commissioning report", 4, used, openMaintenance,
     [](WalkingPanel& panel) {
         panel.tap("Panel");
         panel.tap("Create report");
         writeTo(panel, "*.pdf");
     }},
    {"10f", "a bundle for the manufacturer", 4, used, openMaintenance,
     [](WalkingPanel& panel) {
         panel.tap("Panel");
         panel.tap("Create bundle");
         writeTo(panel, "*.zip");
     }},
    {"11a", "another language", 2, used, openSettings,
     [](WalkingPanel& panel) {
         panel.tap("Language");
         panel.tap("Deutsch");
         panel.waitForText("Einstellungen");
     }},
    {"11b", "the dark theme", 1, used, openSettings,
     [](WalkingPanel& panel) {
         panel.tap("Dark");
         panel.waitFor("the theme",
                       [&] { return panel.window().touchDriver().theme()->property("name") == u"dark"_s; });
     }},
    {"11c", "glove mode", 1, used, openSettings,
     [](WalkingPanel& panel) {
         panel.tap("On");
         panel.waitFor("large keys",
                       [&] { return panel.window().touchDriver().theme()->property("gloves").toBool(); });
     }},
    {"12", "another span and another curve of the trends", 3, used,
     [](WalkingPanel& panel) {
         run(panel);
         panel.tap("Trends");
     },
     [](WalkingPanel& panel) {
         panel.tap("1 h");
         panel.tap("Curves");
         panel.tap("Rate bags/min");
         panel.waitFor("a third curve", [&] { return panel.window().panel().trends().chosen().size() == 3; });
     }},
};

} // namespace

class TestWalksUpkeep : public QObject {
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

CAMPANEL_TEST(TestWalksUpkeep)

} // namespace test_walks_upkeep

#include "test_walks_upkeep.moc"
