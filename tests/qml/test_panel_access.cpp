// SPDX-License-Identifier: Apache-2.0
// Users and logins by touch: the first PIN, the restrictions, a wrong PIN, the logout.
#include "panel_test.h"
#include "tests/looks/screen_lists.h"
#include "tests/support/test_program.h"

#include <QCoreApplication>

namespace test_panel_access {

using Access = campanel::panel::Access;
using namespace Qt::StringLiterals;

class TestPanelAccess : public campanel::test::PanelTest {
    Q_OBJECT

    auto& access() { return m_window->panel().access(); }
    void enter(const char* name)
    {
        for (const auto& screen : campanel::looks::allScreens()) {
            if (screen.name == QLatin1String(name))
                campanel::looks::enterScreen(*m_window, screen);
        }
    }
    void typeDigits(const char* pin)
    {
        for (const char* digit = pin; *digit != '\0'; ++digit)
            tap((QByteArray("pin") + *digit).constData());
    }
    void typePin(const char* pin)
    {
        typeDigits(pin);
        tap("pinAccept");
        while (access().busy())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        m_window->settle();
    }
    bool isOn(const char* name) { return m_window->find(QString::fromLatin1(name)) != nullptr; }

private slots:
    void theFirstUserIsAddedByTaps()
    {
        enter("users-none");
        access().open();
        QTRY_COMPARE(access().level(), Access::Service);
        QVERIFY(textOf("usersNobody").startsWith(u"No PIN is set"));
        tap("userAdd");
        QVERIFY(!isOn("level1")); // level Service, without a choice
        tap("userPin");
        typePin("123456");
        QVERIFY2(textOf("pinHint").startsWith(u"Sequences such as"), qPrintable(textOf("pinHint")));
        typePin("258036");
        typePin("258136");
        QVERIFY(textOf("pinHint").startsWith(u"The two PINs differ"));
        typePin("258036");
        typePin("258036");
        QTRY_VERIFY(access().protectedByPins());
        QTRY_COMPARE(access().userName(), u"Service"_s);
        m_window->settle();
        QVERIFY(!isOn("pinAccept"));
        QCOMPARE(textOf("userName"), u"Service"_s);
        QVERIFY(textOf("usersNow").startsWith(u"Service"));
    }

    void somethingRestrictedAsksWhoItIs()
    {
        enter("users-logged-out");
        tap("nav_motion");
        tap("field_bag_length_mm"); // the operator's
        QVERIFY(!isOn("loginUsers"));
        tap("keypadCancel");
        tap("curvesButton");
        tap("field_base_speed_mm_per_s");
        QVERIFY(isOn("loginUsers"));
        QVERIFY(isOn("login_Li Wei"));
        QVERIFY(isOn("login_Anna"));
        QVERIFY(!isOn("login_Tom")); // an operator lacks the level too
        QVERIFY(!m_window->find(u"pinAccept"_s)->isEnabled());
        const qsizetype stops = m_window->link().stopRequests();
        tap("stopKey");
        QCOMPARE(m_window->link().stopRequests(), stops + 1);
        tap("login_Li Wei");
        typePin("1111");
        QVERIFY(!access().loggedIn());
        QVERIFY2(textOf("pinHint").startsWith(u"Wrong PIN. Try again in"), qPrintable(textOf("pinHint")));
        QVERIFY(!m_window->find(u"pinAccept"_s)->isEnabled());
        tap("pin2");
        QVERIFY(!m_window->find(u"pinAccept"_s)->isEnabled());
        tap("pinBackspace");
        QTRY_COMPARE(textOf("pinHint"), u"Wrong PIN. Try again."_s);
        typePin("258036");
        QCOMPARE(access().userName(), u"Li Wei"_s);
        QVERIFY(!isOn("loginUsers"));
        QCOMPARE(textOf("userLevel"), u"Technician"_s);
        QVERIFY(isOn("keypadAccept")); // of the field that was tapped
    }

    // The users are lost: the login states the reason, and Stop stays.
    void lostUsersOpenNothing()
    {
        enter("login-locked");
        QVERIFY(access().locked());
        QVERIFY2(textOf("pinSentence").contains(u"campanel.sqlite.setup"), qPrintable(textOf("pinSentence")));
        tap("pin2");
        tap("pin5");
        tap("pin8");
        tap("pin0");
        QVERIFY(!m_window->find(u"pinAccept"_s)->isEnabled());
        const qsizetype stops = m_window->link().stopRequests();
        tap("stopKey");
        QCOMPARE(m_window->link().stopRequests(), stops + 1);
        tap("pinCancel");
        QVERIFY(!isOn("keypadAccept"));
    }

    void aShortPinIsChangedAfterTheLogin()
    {
        enter("login-short-pin");
        QVERIFY(isOn("pinAccept"));
        typeDigits("2580"); // four digits are not accepted here
        QVERIFY(!m_window->find(u"pinAccept"_s)->isEnabled());
        for (int i = 0; i < 4; ++i)
            tap("pinBackspace");
        typePin("975310");
        typePin("975310");
        QTRY_VERIFY(!isOn("pinAccept"));
        QTRY_VERIFY(!access().busy());
        QCOMPARE(access().userName(), u"Anna"_s);
        access().logOut();
        access().login(u"975310"_s);
        QTRY_COMPARE(access().userName(), u"Anna"_s);
    }

    void aRefusalKeepsWhatWasOpen()
    {
        enter("users-logged-out");
        tap("nav_motion");
        tap("curvesButton");
        tap("lawButton");
        const QString before = editor().lawName();
        auto* list = m_window->find(u"lawList"_s);
        QVERIFY(list);
        editor().setLaw(u"harmonic"_s);
        m_window->settle();
        QCOMPARE(editor().lawName(), before);
        QVERIFY(isOn("loginUsers"));
        tap("pinCancel");
        QVERIFY(isOn("lawList"));
    }

    void whoLeavesComesBackToRun()
    {
        enter("users");
        QCOMPARE(access().userName(), u"Anna"_s);
        tap("user_Anna");
        QVERIFY(isOn("userRemove"));
        m_window->link().advance(std::chrono::minutes(5));
        m_window->checkClock();
        access().checkClock();
        m_window->settle();
        QVERIFY(!access().loggedIn());
        QVERIFY(!isOn("userRemove"));
        QCOMPARE(m_window->frame()->property("page").toString(), "run");
        QCOMPARE(textOf("userLevel"), u"Operator"_s);
    }

    void aUserIsRemovedByTwoTaps()
    {
        enter("user-remove");
        QVERIFY(isOn("userRemove"));
        tap("userRemove");
        while (access().busy())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        m_window->settle();
        QVERIFY(!isOn("user_Li Wei"));
        QVERIFY(isOn("user_Tom"));
    }

    void theTrailIsReadByTaps()
    {
        enter("audit");
        QVERIFY2(textOf("auditChain").startsWith(u"Checked: 9 rows, intact"),
                 qPrintable(textOf("auditChain")));
        tap("auditArea");
        tap("choice_parameter");
        QTRY_VERIFY(!m_window->panel().audit().log()->loading());
        m_window->settle();
        QCOMPARE(m_window->panel().audit().rows()->count(), 2);
        tap("audit1");
        QCOMPARE(textOf("auditDetail3"), u"900"_s);
        QCOMPARE(textOf("auditDetail5"), u"903.02"_s);
        tap("auditBack");
        QVERIFY(isOn("auditList"));
        enter("audit-filtered");
        QCOMPARE(textOf("filterSummary"), u"Only: 2026-01-15 00:00 to 2026-01-16 00:00 · “mark”"_s);
        QCOMPARE(m_window->panel().audit().rows()->count(), 1);
        QTRY_VERIFY(m_window->find(QStringLiteral("auditExport"))->isEnabled());
        tap("filterClear");
        QTRY_COMPARE(m_window->panel().audit().rows()->count(), 2); // the parameters
        QVERIFY(!isOn("filterSummary"));
        enter("audit-broken");
        QVERIFY2(textOf("auditChain").startsWith(u"Row 4 was altered"), qPrintable(textOf("auditChain")));
    }
};

CAMPANEL_TEST(TestPanelAccess)

} // namespace test_panel_access

#include "test_panel_access.moc"
