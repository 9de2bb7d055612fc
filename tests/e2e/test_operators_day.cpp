// SPDX-License-Identifier: Apache-2.0
// The work of operators from the first start on, by touches alone, with campanel-controller at the other end
// of the line.
#include "app/shell/fonts.h"
#include "panel_window.h"
#include "tests/support/controller_process.h"
#include "tests/support/test_program.h"

#include <QDir>
#include <QFile>
#include <QTest>

namespace test_operators_day {

using namespace campanel;
using panel::Controller;
using panel::Editor;
using panel::ProgramDownload;
using test::ControllerProcess;
using test::PanelWindow;

namespace {

constexpr int timeoutMs = 20'000;

void typeText(PanelWindow& panel, const QString& text)
{
    for (const QChar letter : text)
        panel.tap(letter == u' ' ? "textSpace" : qPrintable(QStringLiteral("key_") + letter));
}

void typePin(PanelWindow& panel, const QString& digits)
{
    for (const QChar digit : digits)
        panel.tap(qPrintable(QStringLiteral("pin") + digit));
    panel.tap("pinAccept");
}

void enter(PanelWindow& panel, const char* field, const QString& digits)
{
    panel.tap(field);
    panel.tapDigits(digits);
    panel.tap("keypadAccept");
}

void waitForRecipes(PanelWindow& panel, int total)
{
    QTRY_COMPARE_WITH_TIMEOUT(panel.panel().recipes().total(), total, timeoutMs);
    panel.touchDriver().settle();
}

bool fileHas(const QString& path, const char* text)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) && file.readAll().contains(text);
}

// The panel of a new machine: nobody saved anything.
struct NewPanel : PanelWindow {
    explicit NewPanel(const QString& port)
        : PanelWindow(port, QStringLiteral("en"), Library::Empty)
    {
    }
};

void beginFirstStart(PanelWindow& panel)
{
    QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
    QTRY_VERIFY_WITH_TIMEOUT(panel.panel().recipes().ready(), timeoutMs);
    QCOMPARE(panel.panel().recipes().total(), 0);
    panel.settings().beginFirstStart();
    panel.touchDriver().settle();
}

} // namespace

class TestOperatorsDay : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { shell::applyFonts(); }

    void firstStart()
    {
        const ControllerProcess controller;
        NewPanel panel(controller.port());
        beginFirstStart(panel);
        panel.tap("firstLanguage_zh_CN");
        QVERIFY2(panel.texts().contains(QStringLiteral("首次启动")), qPrintable(panel.texts()));
        panel.tap("firstLanguage_en");
        panel.tap("firstNext");
        QVERIFY2(panel.texts().contains(QStringLiteral("Find the controller")), qPrintable(panel.texts()));
        panel.tap("firstNext");

        panel.tap("firstSetPin");
        panel.tap("userPin");
        typePin(panel, QStringLiteral("258036"));
        typePin(panel, QStringLiteral("258036"));
        QTRY_VERIFY_WITH_TIMEOUT(panel.panel().access().protectedByPins(), timeoutMs);
        panel.touchDriver().settle();
        panel.tap("firstNext");

        enter(panel, "first_knife_radius_mm", QStringLiteral("62"));
        panel.tap("firstNext");
        panel.tapDigits(QStringLiteral("180")); // its keypad is open
        panel.tap("keypadAccept");
        QCOMPARE(panel.editor().recipeName(), QStringLiteral("Bag 180"));
        QVERIFY2(!panel.texts().contains(QStringLiteral(" v")), qPrintable(panel.texts()));
        panel.tap("firstName");
        typeText(panel, QStringLiteral("rusk large"));
        panel.tap("textAccept");
        QTRY_COMPARE_WITH_TIMEOUT(panel.editor().recipeName(), QStringLiteral("rusk large"), timeoutMs);
        panel.touchDriver().settle();
        enter(panel, "first_bag_length_mm", QStringLiteral("260"));
        panel.tap("firstFinish");
        QVERIFY(!panel.settings().firstStart());
        QTRY_VERIFY_WITH_TIMEOUT(!panel.editor().edited(), timeoutMs);
        QCOMPARE(panel.editor().bagLength()->value(), 260.0);
        QCOMPARE(panel.editor().recipe().machine.knifeRadiusMm, 62.0);
        waitForRecipes(panel, 1);
        QCOMPARE(panel.panel().recipes().chosenName(), QStringLiteral("rusk large"));
        QCOMPARE(panel.panel().recipes().chosenRecipe()->version, 1);
        QTRY_VERIFY_WITH_TIMEOUT(panel.editor().programDownload()->canDownload(), timeoutMs);
        panel.tap("downloadAgain"); // of the Run page
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().active().name, QStringLiteral("rusk large"), timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
    }

    // A copy of the folder is what a power cut leaves.
    void aPowerCutInTheFirstStartKeepsWhatWasEntered()
    {
        const ControllerProcess controller;
        const QTemporaryDir left;
        {
            NewPanel panel(controller.port());
            beginFirstStart(panel);
            for (int step = 1; step <= 3; ++step)
                panel.tap("firstNext");
            enter(panel, "first_knife_radius_mm", QStringLiteral("62"));
            panel.tap("firstNext");
            panel.tapDigits(QStringLiteral("180"));
            panel.tap("first_rate_bags_per_min"); // takes the length
            QCOMPARE(panel.complaints(), QStringList());
            QTRY_VERIFY_WITH_TIMEOUT(fileHas(panel.folder() + QStringLiteral("/working_copy.json"), "180"),
                                     timeoutMs);
            for (const QFileInfo& file : QDir(panel.folder()).entryInfoList(QDir::Files))
                QVERIFY(QFile::copy(file.filePath(), left.filePath(file.fileName())));
        }
        PanelWindow panel(controller.port(), QStringLiteral("en"), PanelWindow::Library::Empty, left.path());
        QTRY_VERIFY_WITH_TIMEOUT(panel.panel().recipes().ready(), timeoutMs);
        panel.settings().offerFirstStart(panel.panel().wasSetUp());
        QVERIFY(panel.settings().firstStart());
        panel.touchDriver().settle();
        for (int step = 1; step <= 4; ++step)
            panel.tap("firstNext");
        QCOMPARE(panel.editor().bagLength()->value(), 180.0);
        QCOMPARE(panel.editor().recipe().machine.knifeRadiusMm, 62.0);
        QCOMPARE(panel.editor().recipeName(), QStringLiteral("Bag 180"));
        QCOMPARE(panel.complaints(), QStringList());
    }

    // The finger sets inches, types a length in them and downloads it; the controller has millimeters.
    void aLengthInInches()
    {
        const ControllerProcess controller;
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        waitForRecipes(panel, 1);
        for (const char* name : {"nav_settings", "section0", "unitsChoice", "choice_inch", "nav_motion"})
            panel.tap(name);
        enter(panel, "field_bag_length_mm", QStringLiteral("7.0866"));
        QVERIFY2(panel.texts().contains(QStringLiteral("7.0866")), qPrintable(panel.texts()));
        panel.download();
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().program(), timeoutMs);
        const auto& registers = panel.controller().program()->registers;
        const modbus::RegisterReader reader(registers, 0);
        QCOMPARE(reader.physical("program.bag_length"), 180.0);
        QCOMPARE(panel.complaints(), QStringList());
    }

    // The minimum setup of a new panel, with Start pressed before it can work.
    void theFirstBagTakesElevenTouches()
    {
        const ControllerProcess controller;
        NewPanel panel(controller.port());
        beginFirstStart(panel);
        int touches = 0;
        const auto touch = [&](const char* name) {
            panel.tap(name);
            ++touches;
        };
        const QString refusal = QStringLiteral("The controller has no program. Download a recipe first.");
        touch("startKey");
        QVERIFY2(panel.texts().contains(refusal), qPrintable(panel.texts()));
        touch("bannerButton"); // is under the finger, not under the first start
        QVERIFY2(!panel.texts().contains(refusal), qPrintable(panel.texts()));
        while (!panel.touchDriver().find("firstDownload") && touches < 12)
            touch("firstNext");
        touch("startKey"); // beside the keypad of the length, which the last step has opened
        QVERIFY2(panel.texts().contains(refusal), qPrintable(panel.texts()));
        QTRY_VERIFY_WITH_TIMEOUT(panel.editor().programDownload()->canDownload(), timeoutMs);
        touch("bannerButton");
        touch("firstDownload");
        QTRY_COMPARE_WITH_TIMEOUT(panel.editor().programDownload()->state(), ProgramDownload::State::Applied,
                                  timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().canStart(), timeoutMs);
        panel.touchDriver().settle();
        QVERIFY2(!panel.touchDriver().find("keypad"), qPrintable(panel.texts()));
        QVERIFY2(!panel.texts().contains(refusal), qPrintable(panel.texts()));
        QVERIFY2(panel.texts().contains(QStringLiteral("Hold Start to run this recipe.")),
                 qPrintable(panel.texts()));
        QVERIFY(panel.touchDriver().find("middleKey")); // the reference run, which the controller accepts now
        const bool hasPermit = panel.controller().identity()->hasRegister("exchange.permit");
        QCOMPARE(panel.controller().parameter("parameter.permit_needed").value(),
                 hasPermit ? std::optional(1.0) : std::nullopt); // by the first start
        touch("startKey");
        QTest::qWait(200);
        QCOMPARE(panel.controller().state(), Controller::State::Ready); // a tap is too short
        QVERIFY2(panel.texts().contains(QStringLiteral("hold longer")), qPrintable(panel.texts()));
        panel.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Running, timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().bags().count > 0, timeoutMs);
        QVERIFY(!panel.settings().firstStart()); // Start has ended it, on the Run page
        QVERIFY(panel.touchDriver().find("filmCard"));
        QVERIFY2(touches <= 11, qPrintable(QString::number(touches)));
        QCOMPARE(panel.complaints(), QStringList());
    }

    // From power-on of a new panel to the first bag of another length, by the names that a screen reader
    // says.
    void theFirstBagOfAnotherLengthTakesNineTouches()
    {
        const ControllerProcess controller;
        NewPanel panel(controller.port());
        beginFirstStart(panel);
        int touches = 0;
        const auto touch = [&](const char* name) {
            panel.touchDriver().tapNamed(QString::fromUtf8(name));
            ++touches;
        };
        for (int step = 1; step <= 4; ++step)
            touch("Next");
        for (const char* digit : {"2", "6", "5"})
            touch(digit);
        QTRY_VERIFY_WITH_TIMEOUT(panel.editor().programDownload()->canDownload(), timeoutMs);
        touch("Download");
        QTRY_COMPARE_WITH_TIMEOUT(panel.editor().programDownload()->state(), ProgramDownload::State::Applied,
                                  timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().canStart(), timeoutMs);
        panel.touchDriver().settle();
        QVERIFY(panel.touchDriver().findNamed(QStringLiteral("Start")));
        panel.start();
        ++touches;
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Running, timeoutMs);
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().bags().count > 0, timeoutMs);
        QCOMPARE(panel.controller().active().name, panel.editor().recipeName());
        QCOMPARE(panel.editor().bagLength()->value(), 265.0);
        // The first bags may be start-up scrap, which has no part in the mean.
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(panel.controller().bags().meanMm - 265) < 1, timeoutMs);
        QVERIFY2(touches <= 9, qPrintable(QString::number(touches)));
        QCOMPARE(panel.complaints(), QStringList());
    }

    void aRecipeHasAChineseName()
    {
        const ControllerProcess controller;
        PanelWindow panel(controller.port());
        waitForRecipes(panel, 1);
        panel.tap("nav_recipes");
        panel.tap("recipeRename");
        panel.tap("textChinese");
        typeText(panel, QStringLiteral("binggan"));
        QVERIFY2(panel.texts().contains(QStringLiteral("bing'gan")), qPrintable(panel.texts()));
        panel.tap("textAccept"); // the most likely
        panel.tap("textChinese");
        typeText(panel, QStringLiteral(" xl"));
        panel.tap("textAccept");
        QTRY_COMPARE_WITH_TIMEOUT(panel.editor().recipeName(), QStringLiteral("饼干 xl"), timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
    }

    void aNewRecipeRunsAndIsChanged()
    {
        const ControllerProcess controller;
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        waitForRecipes(panel, 1);
        panel.tap("nav_recipes");
        panel.tap("recipeNew");
        panel.tap("choice_1");
        typeText(panel, QStringLiteral("wafer"));
        panel.tap("textAccept");
        waitForRecipes(panel, 2);
        QCOMPARE(panel.editor().recipeName(), QStringLiteral("wafer"));
        panel.tap("nav_motion");
        enter(panel, "field_bag_length_mm", QStringLiteral("240"));
        panel.download();
        panel.tap("nav_run");
        QTRY_VERIFY_WITH_TIMEOUT(panel.controller().canStart(), timeoutMs);
        panel.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Running, timeoutMs);
        panel.tap("nav_motion");
        enter(panel, "field_bag_length_mm", QStringLiteral("250"));
        panel.download();
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().active().bagLengthMm, 250.0, timeoutMs);
        QCOMPARE(panel.controller().state(), Controller::State::Running);
        QVERIFY2(panel.texts().contains(QStringLiteral("Downloaded. The machine is running this recipe.")),
                 qPrintable(panel.texts()));
        // Both downloads are versions of it.
        QTRY_COMPARE_WITH_TIMEOUT(panel.panel().recipes().list()->rows().first().version, 3, timeoutMs);
        panel.tap("stopKey");
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Ready, timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
    }

    void anAlarmIsAcknowledged()
    {
        ControllerProcess controller;
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        controller.kill();
        QTRY_COMPARE_WITH_TIMEOUT(panel.panel().alarms().unacknowledged(), 1, timeoutMs);
        panel.tap("nav_alarms");
        panel.touchDriver().settle();
        QVERIFY2(panel.texts().contains(QStringLiteral("Connection lost")), qPrintable(panel.texts()));
        panel.tap("liveAlarm0");
        panel.tap("alarmAcknowledge");
        QTRY_COMPARE_WITH_TIMEOUT(panel.panel().alarms().unacknowledged(), 0, timeoutMs);
        QVERIFY2(panel.texts().contains(QStringLiteral("Connection lost")), qPrintable(panel.texts()));
        controller.start();
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().connection(), Controller::Connection::Connected,
                                  timeoutMs);
        panel.touchDriver().settle();
        QTRY_VERIFY2_WITH_TIMEOUT(!panel.texts().contains(QStringLiteral("Connection lost")),
                                  qPrintable(panel.texts()), timeoutMs);
        panel.tap("alarmsHistory");
        QTRY_VERIFY2_WITH_TIMEOUT(panel.texts().contains(QStringLiteral("Connection lost")),
                                  qPrintable(panel.complaints().join(u'|') + panel.texts()), timeoutMs);
        QCOMPARE(panel.complaints(), QStringList());
    }

    void aWrongPinIsRefused()
    {
        const ControllerProcess controller;
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        waitForRecipes(panel, 1); // the database is open
        panel::Access& access = panel.panel().access();
        access.addUser(QStringLiteral("Anna"), panel::Access::Service, QStringLiteral("258036"));
        QTRY_VERIFY_WITH_TIMEOUT(access.loggedIn(), timeoutMs);
        access.logOut();
        panel.tap("nav_motion");
        panel.tap("curvesButton");
        panel.tap("field_base_speed_mm_per_s");
        panel.tap("login_Anna");
        typePin(panel, QStringLiteral("1379"));
        QTRY_VERIFY_WITH_TIMEOUT(access.waits(), timeoutMs);
        QVERIFY(!access.loggedIn());
        panel.touchDriver().settle();
        panel.tap("stopKey"); // never needs a login
        QTRY_VERIFY_WITH_TIMEOUT(!access.waits(), timeoutMs);
        panel.touchDriver().settle();
        QTRY_VERIFY_WITH_TIMEOUT(!panel.texts().contains(QStringLiteral("Try again in")), timeoutMs);
        typePin(panel, QStringLiteral("258036"));
        QTRY_VERIFY2_WITH_TIMEOUT(access.loggedIn(),
                                  qPrintable(panel.complaints().join(u'|') + panel.texts()), timeoutMs);
        panel.touchDriver().settle();
        const double before = panel.editor().baseSpeed()->value();
        enter(panel, "field_base_speed_mm_per_s", QStringLiteral("500"));
        QVERIFY(before != panel.editor().baseSpeed()->value());
        QCOMPARE(panel.complaints(), QStringList());
    }

    void aBadFileIsRefused()
    {
        const ControllerProcess controller;
        PanelWindow panel(controller.port());
        waitForRecipes(panel, 1);
        QDir(panel.folder()).mkpath(QStringLiteral("recipes"));
        QFile file(panel.folder() + QStringLiteral("/recipes/broken.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\"format\": \"campanel-recipe\", \"format_version\": 1, \"name\": ");
        file.close();
        panel.tap("nav_recipes");
        panel.tap("recipeImport");
        QTRY_COMPARE_WITH_TIMEOUT(panel.panel().recipes().files()->files()->count(), 1, timeoutMs);
        panel.touchDriver().settle();
        panel.tap("offer0");
        QVERIFY2(panel.texts().contains(QStringLiteral("broken.json is damaged")), qPrintable(panel.texts()));
        QVERIFY(!panel.touchDriver().find(QStringLiteral("offerGo"))->isEnabled());
        panel.tap("sheetClose");
        QCOMPARE(panel.panel().recipes().total(), 1);
        QVERIFY(panel.panel().recipes().message().isEmpty());
        QCOMPARE(panel.complaints(), QStringList());
    }

    void theLanguageChangesInTheMiddleOfAnEdit()
    {
        const ControllerProcess controller;
        PanelWindow panel(controller.port());
        QTRY_COMPARE_WITH_TIMEOUT(panel.controller().state(), Controller::State::Idle, timeoutMs);
        panel.tap("nav_motion");
        enter(panel, "field_bag_length_mm", QStringLiteral("270"));
        panel.tap("field_rate_bags_per_min");
        panel.tapDigits(QStringLiteral("4"));
        panel.settings().set("display.language",
                             QStringLiteral("zh_CN")); // by another person, in another way
        panel.touchDriver().settle();
        panel.tapDigits(QStringLiteral("5"));
        panel.tap("keypadAccept");
        QCOMPARE(panel.editor().rate()->value(), 45.0);
        QCOMPARE(panel.editor().bagLength()->value(), 270.0);
        QVERIFY(panel.editor().edited());
        QVERIFY2(panel.texts().contains(QStringLiteral("已修改")), qPrintable(panel.texts()));
        panel.tap("nav_settings");
        panel.tap("section0");
        panel.tap("languageChoice");
        panel.tap("choice_en");
        QVERIFY2(panel.texts().contains(QStringLiteral("edited")), qPrintable(panel.texts()));
        panel.tap("nav_motion");
        panel.tap("undo");
        panel.tap("undo");
        QVERIFY(!panel.editor().edited());
        QCOMPARE(panel.complaints(), QStringList());
    }
};

CAMPANEL_TEST(TestOperatorsDay)

} // namespace test_operators_day

#include "test_operators_day.moc"
