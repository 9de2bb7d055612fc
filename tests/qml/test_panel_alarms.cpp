// SPDX-License-Identifier: Apache-2.0
// An alarm by touch: it calls, is opened, acknowledged, returns and is found in the history.
#include "panel_test.h"
#include "tests/support/test_program.h"

namespace test_panel_alarms {

using Situation = campanel::looks::DemoLink::Situation;
namespace panel = campanel::panel;

class TestPanelAlarms : public campanel::test::PanelTest {
    Q_OBJECT

    panel::Alarms& alarms() { return m_window->panel().alarms(); }
    void show(Situation situation)
    {
        m_window->link().show(situation);
        m_window->settle();
    }
    bool isShown(const char* name) { return m_window->find(QString::fromLatin1(name)) != nullptr; }

private slots:
    void quietPanelSaysSo()
    {
        QVERIFY(!isShown("navCalls"));
        QVERIFY(!isShown("urgentAlarm"));
        tap("nav_alarms");
        QCOMPARE(textOf("alarmsEmpty"), QStringLiteral("No alarm is active or waiting for acknowledgment."));
        QVERIFY(!isShown("alarmsAcknowledgeAll"));
        tap("alarmsShelved");
        QVERIFY(textOf("alarmsEmpty").startsWith(QStringLiteral("No alarm is shelved.")));
    }

    void fromTheFaultToTheHistory()
    {
        m_window->panel().records().open();
        show(Situation::Fault);
        QCOMPARE(textOf("navCalls"), QStringLiteral("1"));
        QCOMPARE(textOf("urgentAlarm"), QStringLiteral("Following error too large"));
        QVERIFY(isShown("banner"));
        tap("nav_alarms");
        QCOMPARE(textOf("alarmState"), QStringLiteral("C-01 · Active, not acknowledged"));
        tap("liveAlarm0");
        QCOMPARE(textOf("alarmCause"), QStringLiteral("The axis cannot follow its setpoint."));
        QCOMPARE(textOf("alarmAction"), QStringLiteral("Check for a jam, then reset the fault and home."));
        QCOMPARE(textOf("alarmReturned"), QStringLiteral("still active"));
        QVERIFY2(!isShown("alarmShelve1"), "what stops the machine cannot be shelved");
        tap("alarmAcknowledge");
        QVERIFY(!isShown("sheetPanel"));
        QVERIFY(!isShown("navCalls"));
        QVERIFY2(!isShown("banner"), "who has acknowledged it has seen it");
        QCOMPARE(textOf("alarmState"), QStringLiteral("C-01 · Active, acknowledged"));
        QCOMPARE(textOf("urgentAlarm"), QStringLiteral("Following error too large"));
        show(Situation::Running);
        QVERIFY(!isShown("liveAlarm0"));
        QVERIFY(!isShown("urgentAlarm"));
        tap("alarmsHistory");
        QTRY_COMPARE(textOf("alarmState"), QStringLiteral("C-01 · Cleared, acknowledged"));
        tap("pastAlarm0");
        QCOMPARE(textOf("alarmReturned"), QStringLiteral("14:06:58"));
        QVERIFY(!isShown("alarmAcknowledge"));
        tap("sheetClose");
        tap("nav_run");
        QVERIFY2(!alarms().history()->watched(), "nothing is read while nobody looks");
    }

    // The devices of Qt, as on a machine: a touchscreen is unplugged.
    void aTouchscreenIsUnplugged()
    {
        std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
        alarms().check();
        QVERIFY(!isShown("urgentAlarm"));
        screen.reset();
        alarms().check();
        m_window->settle();
        QCOMPARE(textOf("urgentAlarm"), QStringLiteral("Touchscreen missing"));
        screen.reset(QTest::createTouchDevice());
        alarms().check();
        m_window->settle();
        QVERIFY(!isShown("urgentAlarm"));
    }

    void bannerPutAsideStaysOnThePage()
    {
        show(Situation::Fault);
        tap("bannerButton");
        QVERIFY(!isShown("banner"));
        QCOMPARE(textOf("navCalls"), QStringLiteral("1"));
        tap("nav_alarms");
        tap("alarmsAcknowledgeAll");
        QVERIFY(!isShown("navCalls"));
        QVERIFY(!isShown("alarmsAcknowledgeAll"));
        QVERIFY(isShown("liveAlarm0"));
    }

    void manyAlarmsStayInTheirFrame_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<QSize>("size");
        QTest::addColumn<QString>("page");
        for (const char* language : {"en", "zh_CN", "long"}) {
            for (const QSize size : {QSize(800, 480), QSize(1024, 600), QSize(1280, 800)}) {
                for (const char* page : {"nav_run", "nav_motion"})
                    QTest::addRow("%s %d %s", language, size.width(), page)
                        << QString::fromLatin1(language) << size << QString::fromLatin1(page);
            }
        }
    }

    void manyAlarmsStayInTheirFrame()
    {
        QFETCH(QString, language);
        QFETCH(QSize, size);
        QFETCH(QString, page);
        m_window = std::make_unique<campanel::looks::TestWindow>(
            campanel::looks::Variant{language, QStringLiteral("light"), size});
        show(Situation::ManyAlarms);
        m_window->tap(page);
        const QQuickItem* text = m_window->find(QStringLiteral("bannerText"));
        QVERIFY(text);
        const QString told = text->property("text").toString();
        QVERIFY2(told.section(u'\n', 1).contains(QStringLiteral("14")), qPrintable(told));
        QVERIFY2(!text->property("truncated").toBool(), qPrintable(told));
        QVERIFY(text->property("contentHeight").toDouble() <= text->height() + 1);
        QVERIFY(text->property("contentWidth").toDouble() <= text->width() + 1);
        const QQuickItem* banner = m_window->find(QStringLiteral("banner"));
        const QRectF frame = banner->mapRectToScene(banner->boundingRect());
        QVERIFY(frame.contains(text->mapRectToScene(text->boundingRect())));
        QVERIFY(QRectF(QPointF(), QSizeF(size)).contains(frame));
        tap("bannerWay");
        QVERIFY(isShown("liveAlarm0"));
    }

    void alarmUnderAFingerTakesNoKeyAway()
    {
        tap("nav_alarms");
        const double place = m_window->find(QStringLiteral("alarmsShelved"))->mapToScene({}).x();
        m_window->touch(QStringLiteral("alarmsShelved"));
        show(Situation::Fault);
        QCOMPARE(alarms().active(), 1);
        m_window->lift();
        m_window->settle();
        QVERIFY(textOf("alarmsEmpty").startsWith(QStringLiteral("No alarm is shelved.")));
        tap("alarmsLive");
        QVERIFY(isShown("alarmsAcknowledgeAll"));
        QCOMPARE(m_window->find(QStringLiteral("alarmsShelved"))->mapToScene({}).x(), place);
    }

    void warningIsShelvedAndTakenBack()
    {
        show(Situation::Lost);
        tap("nav_alarms");
        tap("liveAlarm0");
        tap("alarmShelve8");
        QVERIFY(!isShown("navCalls"));
        QVERIFY2(!isShown("banner"), "nobody wants to be called for it");
        QCOMPARE(textOf("alarmState"), QStringLiteral("L-03 · Active, shelved"));
        tap("alarmsShelved");
        QCOMPARE(textOf("shelvedState"), QStringLiteral("L-03 · until 22:06:58"));
        tap("unshelve0");
        QCOMPARE(textOf("navCalls"), QStringLiteral("1"));
        QVERIFY(isShown("banner"));
    }

    void sheetFollowsWhatBecomesOfIt()
    {
        show(Situation::Lost);
        tap("nav_alarms");
        tap("liveAlarm0");
        QCOMPARE(textOf("alarmReturned"), QStringLiteral("still active"));
        show(Situation::Running);
        QCOMPARE(textOf("alarmReturned"), QStringLiteral("14:06:58"));
        QVERIFY(isShown("alarmAcknowledge"));
    }

    void languageIsSwitchedInTheSheet()
    {
        show(Situation::Fault);
        tap("nav_alarms");
        tap("liveAlarm0");
        m_window->panel().settings().setLanguage(QStringLiteral("zh_CN"));
        m_window->settle();
        QCOMPARE(textOf("alarmAction"), QStringLiteral("请检查是否卡阻，然后复位故障并回零。"));
        QCOMPARE(textOf("urgentAlarm"), QStringLiteral("跟随误差过大"));
    }
};

CAMPANEL_TEST(TestPanelAlarms)

} // namespace test_panel_alarms

#include "test_panel_alarms.moc"
