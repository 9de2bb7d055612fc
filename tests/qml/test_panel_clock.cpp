// SPDX-License-Identifier: Apache-2.0
// The clock of the computer by touch: moved, followed by a time server, another zone, and without the
// service.
#include "panel_test.h"
#include "tests/support/test_program.h"

namespace test_panel_clock {

using namespace Qt::StringLiterals;

class TestPanelClock : public campanel::test::PanelTest {
    Q_OBJECT

    campanel::test::TimeService& service() { return m_window->timeService(); }
    campanel::panel::SystemClock& clock() { return m_window->panel().systemClock(); }
    void openClock()
    {
        for (const char* name : {"nav_settings", "section0", "sectionSystem", "setClock"})
            tap(name);
        QTRY_VERIFY(clock().available());
        m_window->settle();
    }

private slots:
    void clockIsMovedAndFollowsATimeServer()
    {
        openClock();
        tap("clockLaterHour");
        QTRY_COMPARE(service().m_movedUs, 3'600'000'000);
        QTRY_VERIFY(clock().movable());
        tap("clockEarlier");
        QTRY_COMPARE(service().m_movedUs, 3'540'000'000);
        QTRY_VERIFY(!clock().busy());
        tap("clockServerOn");
        QTRY_VERIFY(clock().usesTimeServer());
        m_window->settle();
        QVERIFY2(!m_window->find(u"clockLater"_s)->isEnabled(), "a time server sets the clock");
        tap("sheetClose");
        QVERIFY2(!clock().watched(), "nothing is asked while nobody looks");
    }

    // One record of a clock that ran ahead marks the next ones until a person sets the clock.
    void recordsAreMarkedUntilTheClockIsSet()
    {
        auto& panel = m_window->panel();
        panel.records().setClockState([] { return campanel::store::ClockState::Unproven; });
        QList<bool> marks;
        connect(&panel.trail(), &campanel::panel::AuditTrail::appended, this,
                [&marks](const campanel::store::AuditRow& row) { marks << row.entry.isClockDoubtful; });
        campanel::store::AuditEntry ahead;
        ahead.what = u"user.login"_s;
        ahead.timeMs = QDateTime::currentMSecsSinceEpoch() + 31'536'000'000;
        panel.records().store().run(
            this,
            [ahead](campanel::store::Database& database) {
                return campanel::store::appendAudit(database, ahead);
            },
            [](const auto&) {});
        panel.trail().note(ahead);
        QTRY_COMPARE(marks, QList<bool>{true});
        openClock();
        tap("clockEarlier");
        QTRY_COMPARE(service().m_movedUs, -60'000'000);
        QTRY_VERIFY(clock().movable());
        QTRY_VERIFY(marks.size() > 1); // the moved clock is in the trail, too
        panel.trail().note(ahead);
        QTRY_VERIFY(marks.size() > 2);
        QVERIFY(!marks.last());
    }

    void zoneIsChosenByRegionAndCity()
    {
        openClock();
        tap("clockZone");
        tap("choice_Asia");
        m_window->tap(u"choice_Asia/Aden"_s);
        QTRY_COMPARE(service().m_zone, u"Asia/Aden"_s);
        QTRY_COMPARE(clock().zone(), u"Asia/Aden"_s);
    }

    void clockCannotBeSetWithoutTheService()
    {
        clock().setBus({[] { return QDBusConnection(u"nowhere"_s); }, {}});
        for (const char* name : {"nav_settings", "section0", "sectionSystem", "setClock"})
            tap(name);
        QTRY_VERIFY(clock().stateText().startsWith(u"systemd-timedated does not respond."));
        QVERIFY(!m_window->find(u"clockLater"_s)->isEnabled());
    }
};

CAMPANEL_TEST(TestPanelClock)

} // namespace test_panel_clock

#include "test_panel_clock.moc"
