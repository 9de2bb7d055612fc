// SPDX-License-Identifier: Apache-2.0
// The approved windows of a recipe by touch: bad entries, a reason that is typed, a sheet that is left.
#include "app/panel/library/recipes.h"
#include "tests/qml/panel_test.h"
#include "tests/support/test_program.h"

namespace test_panel_windows {

using namespace campanel;
using namespace Qt::StringLiterals;
using Situation = looks::DemoLink::Situation;
using State = panel::ProgramDownload::State;

class TestPanelWindows : public test::PanelTest {
    Q_OBJECT

    panel::ProgramDownload& download() { return *editor().programDownload(); }
    panel::WindowReason& reasons() { return *download().windowReason(); }
    void type(const char* field, const QString& digits)
    {
        tap(field);
        m_window->type(digits);
        tap("keypadAccept");
    }
    // The running machine's rate is approved, a higher one is not.
    void narrow()
    {
        m_window->link().show(Situation::Running);
        m_window->settle();
        tap("nav_run");
        program::Recipe recipe = editor().recipe();
        recipe.windows[profile::Field::Rate] = {recipe.cutter().rateBagsPerMin - 5,
                                                recipe.cutter().rateBagsPerMin};
        editor().open(recipe);
        m_window->settle();
    }

private slots:
    void anUpsideDownWindowIsNotStored()
    {
        tap("nav_recipes");
        tap("recipeWindows");
        QVERIFY(!m_window->find(u"windowsSave"_s)->isEnabled());
        type("windowLowest_rate_bags_per_min", u"70"_s);
        type("windowHighest_rate_bags_per_min", u"55"_s);
        QCOMPARE(textOf("sheetNote"), u"Rate: the lowest value is above the highest. Correct one of them."_s);
        QVERIFY(!m_window->find(u"windowsSave"_s)->isEnabled());
        tap("windowClear_rate_bags_per_min");
        QVERIFY(textOf("sheetNote").startsWith(u"A value outside needs a reason."_s));
        tap("windowsCancel");
        QVERIFY(!m_window->find(u"sheetPanel"_s));
        tap("recipeWindows");
        QVERIFY(!m_window->panel().recipes().windows()->isTouched());
    }

    void aReasonIsTyped()
    {
        narrow();
        m_window->tap(u"packingRate"_s);
        tap("changeMore");
        QCOMPARE(download().state(), State::Unapproved);
        QVERIFY2(textOf("changeText").startsWith(u"Outside the approved window: Rate"_s),
                 qPrintable(textOf("changeText")));
        tap("changeReason");
        tap("choice_other");
        QVERIFY(!m_window->find(u"textAccept"_s)->isEnabled());
        m_window->find(u"textInput"_s)->setProperty("text", QString(5000, u'x'));
        m_window->settle();
        QCOMPARE(textOf("textProblem"), u"A reason has at most 120 characters. Shorten it."_s);
        QVERIFY(!m_window->find(u"textAccept"_s)->isEnabled());
        m_window->find(u"textInput"_s)->setProperty("text", u"trial"_s);
        m_window->settle();
        tap("textAccept");
        QCOMPARE(download().state(), State::Ready);
        tap("changeApply");
        QCOMPARE(download().state(), State::Transferring);
    }

    // A change that is not applied leaves no reason behind.
    void anotherValueNeedsAnotherReason()
    {
        narrow();
        m_window->tap(u"packingRate"_s);
        tap("changeMore");
        const double wanted = editor().rate()->value();
        tap("changeReason");
        tap("choice_trial");
        QCOMPARE(editor().rate()->value(), wanted);
        tap("changeMore"); // another value, another reason
        QVERIFY(m_window->find(u"changeReason"_s));
        tap("changeCancel");
        QCOMPARE(download().state(), State::NothingToDo);
        QVERIFY(reasons().line().isEmpty());
    }

    void theDownloadOfMotionAsks()
    {
        narrow();
        editor().rate()->set(editor().rate()->value() + 1);
        tap("nav_motion");
        tap("nextStep");
        QVERIFY(!m_window->find(u"downloadStart"_s));
        tap("downloadReason");
        tap("choice_material");
        tap("downloadStart");
        QCOMPARE(download().state(), State::Transferring);
    }

    // A window that was narrowed beneath the running machine has a key for the reason.
    void whatRunsOutsideIsExplainedLater()
    {
        narrow();
        program::Recipe recipe = editor().recipe();
        recipe.windows[profile::Field::Rate] = {1, 2};
        editor().open(recipe);
        m_window->settle();
        QVERIFY2(textOf("windowLine").endsWith(u"no reason given."_s), qPrintable(textOf("windowLine")));
        tap("windowReason");
        tap("choice_trial");
        QVERIFY2(textOf("windowLine").endsWith(u"Trial, approved by word"_s),
                 qPrintable(textOf("windowLine")));
        QVERIFY(!m_window->find(u"windowReason"_s));
    }
};

CAMPANEL_TEST(TestPanelWindows)

} // namespace test_panel_windows

#include "test_panel_windows.moc"
