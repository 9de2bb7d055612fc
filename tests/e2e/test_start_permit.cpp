// SPDX-License-Identifier: Apache-2.0
// A start that the panel would block is refused by the controller itself, whoever sends it.
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/controller_process.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QProcess>
#include <QTest>

#include <memory>

namespace test_start_permit {

using namespace campanel;
using namespace Qt::StringLiterals;
using panel::Controller;
using panel::RecipeCodes;
using test::ControllerProcess;
using test::PanelWindow;

namespace {

constexpr int timeoutMs = 20'000;

// Runs campanelctl; returns what it prints, an error behind its exit code.
QString ctl(const QStringList& words, const QString& port)
{
    QProcess process;
    process.start(test::programPath("campanelctl"), words + QStringList{u"--port"_s, port});
    if (!process.waitForFinished(timeoutMs))
        return u"no end"_s;
    return process.exitCode() == 0 ? QString::fromUtf8(process.readAllStandardOutput()).trimmed()
                                   : u"%1: %2"_s.arg(process.exitCode())
                                         .arg(QString::fromUtf8(process.readAllStandardError()))
                                         .trimmed();
}

// Downloads a recipe that needs this film.
void downloadWithFilm(PanelWindow& panel, const QString& film)
{
    QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
    panel::Recipes& recipes = panel.panel().recipes();
    QTRY_COMPARE_WITH_TIMEOUT(recipes.total(), 1, timeoutMs);
    recipes.chooseId(recipes.newest().front().recipeId);
    recipes.codes()->enter(RecipeCodes::Code::Film);
    recipes.codes()->setWanted(film);
    recipes.codes()->store();
    QTRY_COMPARE_WITH_TIMEOUT(recipes.codes()->filmText(), film, timeoutMs);
    panel.touchDriver().settle();
    panel.tap("nav_motion");
    panel.download();
    QTRY_COMPARE_WITH_TIMEOUT(panel.panel().scan().film()->neededCode(), film, timeoutMs);
}

void turnOn(PanelWindow& panel)
{
    panel.tap("nav_settings");
    panel.tap("section2");
    panel.tap("openPermit");
    QTRY_COMPARE_WITH_TIMEOUT(panel.controller().startPermit()->value("parameter.permit_needed"), 0.0,
                              timeoutMs);
    panel.touchDriver().settle();
    panel.tap("startPermit0choice1");
    QTRY_VERIFY2_WITH_TIMEOUT(panel.controller().startPermit()->unsaved(), qPrintable(panel.texts()), timeoutMs);
}

// Sends a Start past the panel's own rules; returns the controller's reason.
modbus::Refusal sentStart(PanelWindow& panel)
{
    std::optional<link::CommandOutcome> ended;
    const auto context = std::make_unique<QObject>();
    QObject::connect(&panel.controller(), &Controller::commandEnded, context.get(),
                     [&ended](const link::CommandOutcome& outcome) { ended = outcome; });
    panel.controller().send(modbus::Command::Start);
    if (!QTest::qWaitFor([&ended] { return ended.has_value(); }, timeoutMs))
        return modbus::Refusal::UnknownCommand;
    return ended->reason;
}

} // namespace

class TestStartPermit : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }

    void aWrongFilmIsRefusedByTheControllerItself()
    {
        const ControllerProcess controller;
        auto panel = std::make_unique<PanelWindow>(controller.port());
        downloadWithFilm(*panel, u"PE 30"_s);
        turnOn(*panel);
        panel->panel().scan().takeCode(u"PP 40"_s);
        QVERIFY(!panel->controller().canStart());
        QCOMPARE(sentStart(*panel), modbus::Refusal::WrongFilm);
        QCOMPARE(panel->controller().state(), Controller::State::Ready);
        panel->panel().scan().takeCode(u"PE 30"_s);
        QTRY_VERIFY_WITH_TIMEOUT(panel->controller().canStart(), timeoutMs);
        QCOMPARE(sentStart(*panel), modbus::Refusal::None);
        QTRY_COMPARE_WITH_TIMEOUT(panel->controller().state(), Controller::State::Running, timeoutMs);
        // The wrong reel in the middle of a run does not end it.
        panel->panel().scan().takeCode(u"PP 40"_s);
        QTRY_VERIFY_WITH_TIMEOUT(panel->controller().bags().count > 0, timeoutMs);
        QCOMPARE(panel->controller().state(), Controller::State::Running);
        panel->controller().stop();
        QTRY_COMPARE_WITH_TIMEOUT(panel->controller().state(), Controller::State::Ready, timeoutMs);
        QCOMPARE(sentStart(*panel), modbus::Refusal::WrongFilm);
        QCOMPARE(panel->complaints(), QStringList());
        panel.reset();

        // Nobody at the panel: what campanelctl does not permit is missing.
        const QString sentence =
            u"1: campanelctl: The controller needs a panel's permit, which lacks %1. Use the panel, or "
            u"permit it yourself with --permit all."_s;
        QCOMPARE(ctl({u"start"_s}, controller.port()),
                 sentence.arg(u"Warm, Film, Recipe, Clean, PanelAgrees"_s));
        QCOMPARE(ctl({u"start"_s, u"--permit"_s, u"warm,recipe,clean,panelagrees"_s}, controller.port()),
                 sentence.arg(u"Film"_s));
        QCOMPARE(ctl({u"home"_s}, controller.port()), sentence.arg(u"Clean"_s));
        QCOMPARE(ctl({u"start"_s, u"--permit"_s, u"all"_s}, controller.port()), u"Started."_s);
        QCOMPARE(ctl({u"stop"_s, u"--now"_s}, controller.port()), u"Stopping now."_s);
    }

    // As today; Settings > Machine says why the controller cannot refuse.
    void anOlderControllerStartsWithoutPermit()
    {
        const ControllerProcess controller({u"--map-minor"_s, u"4"_s});
        PanelWindow panel(controller.port());
        downloadWithFilm(panel, u"PE 30"_s);
        panel.tap("nav_settings");
        panel.tap("section2");
        panel.touchDriver().settle();
        QVERIFY(panel.touchDriver().find(u"field_knife_radius_mm"_s));
        panel.tap("openPermit");
        QTRY_VERIFY2_WITH_TIMEOUT(panel.texts().contains(u"Not in this controller. Update its firmware."_s),
                                  qPrintable(panel.texts()), timeoutMs);
        panel.panel().scan().takeCode(u"PP 40"_s);
        QVERIFY(!panel.controller().canStart());
        QCOMPARE(sentStart(panel), modbus::Refusal::None);
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Running, timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
    }
};

CAMPANEL_TEST(TestStartPermit)

} // namespace test_start_permit

#include "test_start_permit.moc"
