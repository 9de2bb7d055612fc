// SPDX-License-Identifier: Apache-2.0
// Keypads and keyboards leave in sight what they serve, and speak when there is something to say: places,
// limits, names, PINs, the search.
#include "panel_test.h"

#include "tests/looks/screen_lists.h"
#include "tests/support/test_program.h"

#include <QCoreApplication>
#include <QSignalSpy>

#include <algorithm>

namespace test_panel_entries {

using namespace campanel;
using namespace Qt::StringLiterals;

class TestPanelEntries : public test::PanelTest {
    Q_OBJECT

    void open(const QSize& size, bool gloves)
    {
        m_window = std::make_unique<looks::TestWindow>(looks::Variant{u"en"_s, u"light"_s, size, gloves});
        m_window->panel().settings().set("display.gloves", panel::settingText(gloves));
        m_window->settle();
    }
    void enter(const QString& name)
    {
        for (const looks::Screen& screen : looks::allScreens()) {
            if (screen.name == name)
                looks::enterScreen(*m_window, screen);
        }
    }
    bool isOn(const char* name) { return m_window->find(QString::fromLatin1(name)) != nullptr; }
    QRectF rectOf(const char* name)
    {
        const QQuickItem* item = m_window->find(QString::fromLatin1(name));
        return item ? item->mapRectToScene(item->boundingRect()) : QRectF();
    }
    void clickPin(const char* pin)
    {
        for (const char* digit = pin; *digit != '\0'; ++digit)
            tap((QByteArray("pin") + *digit).constData());
        tap("pinAccept");
        while (m_window->panel().access().busy())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        m_window->settle();
    }
    qsizetype dots()
    {
        qsizetype count = 0;
        for (const QQuickItem* child : m_window->find(u"pinDots"_s)->childItems())
            count += child->isVisible() && child->inherits("QQuickRectangle") ? 1 : 0;
        return count;
    }
    static void addSizes()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("gloves");
        for (const bool gloves : {false, true}) {
            for (const QSize size : {QSize(800, 480), QSize(1024, 600), QSize(1280, 800)})
                QTest::addRow("%dx%d%s", size.width(), size.height(), gloves ? " gloves" : "")
                    << size << gloves;
        }
    }

private slots:
    void theFirstStartStaysBesideItsKeypad_data() { addSizes(); }
    void theFirstStartStaysBesideItsKeypad()
    {
        QFETCH(QSize, size);
        QFETCH(bool, gloves);
        open(size, gloves);
        enter(u"first-recipe"_s);
        for (const char* field : {"first_rate_bags_per_min", "first_bag_length_mm"}) {
            tap(field);
            const QRectF keypad = rectOf("keypad");
            for (const char* seen : {"firstTitle", "first_bag_length_mm", "first_rate_bags_per_min"}) {
                const QRectF place = rectOf(seen);
                QVERIFY2(place.left() >= 0 && place.width() > 0 && place.bottom() <= size.height(), seen);
                QVERIFY2(!place.intersects(keypad), seen);
            }
        }
        m_window->type(u"180"_s);
        tap("firstDownload"); // takes the number and downloads
        QCOMPARE(editor().bagLength()->value(), 180.0);
        QVERIFY(!isOn("keypad"));
        tap("firstFinish");
        QVERIFY(!isOn("firstTitle"));
    }

    void theFirstStartAsksBeforeTheLongSearch()
    {
        enter(u"first-controller-none"_s);
        QVERIFY(!isOn("firstTake"));
        QVERIFY(!isOn("firstSearchCancel"));
        tap("firstSearchAll");
        QVERIFY(isOn("firstSearchCancel"));
        QVERIFY(!isOn("firstSearchAll"));
        m_window->link().endScan(true);
        m_window->settle();
        tap("firstTake");
        QCOMPARE(m_window->panel().settings().connection().portName, u"/dev/ttyUSB1"_s);
    }

    void theFirstStartTakesAPortThatSomebodyChooses()
    {
        enter(u"first-controller"_s);
        QVERIFY(!isOn("firstConnect"));
        tap("firstPort");
        QVERIFY(isOn("sheetPanel"));
        panel::Settings& settings = m_window->panel().settings();
        settings.setPortName(u"/dev/ttyS7"_s); // as a row of the list does
        tap("sheetClose");
        tap("firstConnect");
        QVERIFY(!settings.connection().simulated);
        QCOMPARE(settings.connection().portName, u"/dev/ttyS7"_s);
        QVERIFY(!isOn("firstConnect"));
    }

    void theOtherNumbersOfTheMachineHaveAWayBack()
    {
        enter(u"first-machine"_s);
        QVERIFY(!isOn("first_max_motor_rpm"));
        tap("firstOthers");
        QVERIFY(isOn("first_max_motor_rpm"));
        QVERIFY(!isOn("first_knives"));
        tap("firstBack");
        QVERIFY(isOn("first_knives"));
        QCOMPARE(textOf("firstTitle"), u"Machine"_s);
        tap("firstBack");
        QVERIFY(!isOn("first_knives"));
    }

    void theKeypadOfTheRatiosLeavesNavigationAndCurve_data() { addSizes(); }
    void theKeypadOfTheRatiosLeavesNavigationAndCurve()
    {
        QFETCH(QSize, size);
        QFETCH(bool, gloves);
        open(size, gloves);
        for (const char* name : {"nav_motion", "ratios", "ratioNumbers"})
            tap(name);
        for (const char* part : {"keypadTab0", "keypad"}) {
            const QRectF place = rectOf(part);
            QVERIFY2(!place.isEmpty(), part);
            for (const char* free : {"nav_run", "nav_motion", "nav_alarms", "motionPlot", "stopKey"})
                QVERIFY2(!place.intersects(rectOf(free)), free);
        }
        QVERIFY(rectOf("motionPlot").width() > 100);
    }

    void theSearchKeepsItsRecipesInSight()
    {
        enter(u"recipes"_s);
        auto& recipes = m_window->panel().recipes();
        tap("recipeSearch");
        m_window->type(u"rusk"_s);
        QCOMPARE(recipes.list()->count(), 1);
        tap("recipeOrder"); // the keys still reach the text
        for (int i = 0; i < 4; ++i)
            tap("textBackspace");
        QVERIFY(recipes.list()->count() > 2);
        const QList<panel::RecipeRow> rows = recipes.list()->rows();
        QVERIFY(std::ranges::is_sorted(
            rows, [](const QString& a, const QString& b) { return a.localeAwareCompare(b) < 0; },
            &panel::RecipeRow::name));
        m_window->type(u"rusk"_s);
        QCOMPARE(recipes.list()->count(), 1);
        QCOMPARE(textOf("found0"), u"Rusk 310"_s);
        QVERIFY(m_window->root().boundingRect().contains(rectOf("found0")));
        tap("found0");
        QVERIFY(!isOn("textInput"));
        QCOMPARE(recipes.chosenName(), u"Rusk 310"_s);
        QCOMPARE(recipes.search(), u"rusk"_s);
        tap("recipeSearchClear"); // one touch
        QCOMPARE(recipes.search(), QString());
        QVERIFY(recipes.list()->count() > 1);
        QVERIFY(!isOn("recipeSearchClear"));
    }

    void theRecipeUsedLastIsFirst()
    {
        enter(u"recipes"_s);
        shell::Panel& panel = m_window->panel();
        const auto names = [&panel] {
            QStringList each;
            for (const panel::RecipeRow& row : panel.recipes().list()->rows())
                each << row.name;
            return each;
        };
        const QString active = QString::fromStdString(panel.controller().program()->recipe.name);
        QStringList used = names();
        used.removeAll(active);
        QVERIFY(used.size() > 2);
        panel.trail().open();
        const QSignalSpy written(&panel.trail(), &panel::AuditTrail::appended);
        for (const QString& name : {used[1], used.last()})
            panel.trail().note({.what = u"program.download"_s, .object = name});
        QCOMPARE(propertyOf("recipeSearch", "rightText"), u"By date"_s);
        QTRY_COMPARE(written.count(), 2);
        panel.recipes().reload();
        tap("recipeSearch");
        tap("recipeOrder");
        QCOMPARE(textOf("recipeOrder"), u"By name"_s);
        tap("recipeOrder");
        QCOMPARE(textOf("recipeOrder"), u"By last use"_s);
        QTRY_COMPARE(names().mid(0, 3), QStringList({active, used.last(), used[1]}));
        tap("sheetClose");
        QCOMPARE(propertyOf("recipeSearch", "rightText"), u"By last use"_s);
        QCOMPARE(propertyOf("recipe1", "text"), used.last());
        const panel::Settings next(panel.settings().file().path(), nullptr); // after a restart
        QCOMPARE(next.values().text("recipes.order"), u"use"_s);
    }

    void aLimitIsNamedWhenDigitsCannotHelp()
    {
        tap("nav_motion");
        tap("field_bag_length_mm"); // 10 to 2000 mm
        const auto refused = [this] { return textOf("keypadHint").startsWith(u"The m"); };
        m_window->type(u"1"_s);
        QVERIFY2(!refused(), "18, 180 and 1800 begin so");
        QVERIFY(!m_window->find(u"keypadAccept"_s)->isEnabled());
        QTest::keyClick(&m_window->window(), Qt::Key_Return);
        m_window->settle();
        QVERIFY(refused());
        m_window->type(u"80"_s);
        QVERIFY(!refused());
        m_window->type(u"000"_s);
        QVERIFY(refused());
        QCOMPARE(editor().bagLength()->value(), 250.0);
        tap("keypadCancel");
    }

    void aNameIsJudgedWhenSomethingIsTyped()
    {
        enter(u"recipes"_s);
        const QString name = m_window->panel().recipes().chosenName();
        tap("recipeRename");
        QCOMPARE(textOf("textProblem"), QString());
        QVERIFY(!m_window->find(u"textAccept"_s)->isEnabled());
        QTest::keyClick(&m_window->window(), Qt::Key_Return);
        m_window->settle();
        QCOMPARE(textOf("textProblem"), u"A recipe with this name already exists."_s);
        m_window->type(u"Toast"_s);
        QCOMPARE(textOf("textProblem"), QString());
        tap("textAccept");
        QTRY_VERIFY(m_window->panel().recipes().chosenName() != name);
    }

    void theReasonOfAWaitStays()
    {
        enter(u"login"_s); // two digits of Li Wei's PIN
        QCOMPARE(dots(), 2);
        tap("pinBackspace");
        tap("pinBackspace");
        QCOMPARE(dots(), 0);
        qint64 now = QDateTime(QDate(2026, 1, 15), QTime(14, 0)).toMSecsSinceEpoch();
        m_window->panel().access().setWallClock([&] { return now; });
        clickPin("1111");
        QCOMPARE(textOf("pinHint"), u"Wrong PIN. Try again in 1 s."_s);
        now += 5000;
        QTRY_COMPARE(textOf("pinHint"), u"Wrong PIN. Try again."_s);
        tap("login_Anna");
        tap("login_Li Wei");
        m_window->panel().access().setWallClock(&QDateTime::currentMSecsSinceEpoch);
        m_window->panel().access().clearMessage();
    }

    void aHardwareKeyboardTypesAfterANameWasTouched()
    {
        enter(u"login"_s);
        tap("login_Anna");
        QCOMPARE(dots(), 0);
        m_window->type(u"258036"_s);
        QCOMPARE(dots(), 6);
        QVERIFY(m_window->find(u"pinAccept"_s)->isEnabled());
        tap("pinCancel");
    }

    void theKeysReachTheKeypadAfterTheLogin()
    {
        tap("nav_motion");
        tap("field_bag_length_mm");
        emit m_window->panel().access().loginRequested(panel::Access::Technician);
        m_window->settle();
        tap("pinCancel");
        m_window->type(u"19"_s);
        QCOMPARE(textOf("keypadText"), u"19"_s);
    }
};

CAMPANEL_TEST(TestPanelEntries)

} // namespace test_panel_entries

#include "test_panel_entries.moc"
