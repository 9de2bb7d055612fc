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
    void typeInto(const char* text)
    {
        m_window->find(QStringLiteral("textInput"))->setProperty("text", QString());
        for (const char* letter = text; *letter; ++letter) {
            const bool isDigit = *letter >= '0' && *letter <= '9';
            if (isDigit)
                tap("textSigns");
            m_window->tap(QStringLiteral("key_") + QLatin1Char(*letter));
            if (isDigit)
                tap("textSigns");
        }
    }
    // Writes two alarms a day from 13 to 15 January; the newest one with a clock that was not set.
    void fillHistory()
    {
        namespace store = campanel::store;
        store::AlarmChanges changes;
        const QStringList codes{QStringLiteral("C-01"), QStringLiteral("M-01"), QStringLiteral("L-03"),
                                QStringLiteral("M-04"), QStringLiteral("M-01"), QStringLiteral("C-01")};
        const QList<QDateTime> times{
            QDateTime(QDate(2026, 1, 13), QTime(8, 0)),  QDateTime(QDate(2026, 1, 14), QTime(0, 0)),
            QDateTime(QDate(2026, 1, 14), QTime(12, 0)), QDateTime(QDate(2026, 1, 14), QTime(23, 59)),
            QDateTime(QDate(2026, 1, 15), QTime(0, 0)),  QDateTime(QDate(2026, 1, 15), QTime(8, 0))};
        for (int i = 0; i < 6; ++i) {
            store::AlarmRow row;
            row.id = i + 1;
            row.code = codes[i];
            row.raisedMs = times[i].toMSecsSinceEpoch();
            row.end = store::AlarmRow::End::Returned;
            row.returnedMs = row.raisedMs + 5000;
            row.isClockDoubtful = i == 5;
            changes.rows << row;
        }
        m_window->panel().records().store().run(
            nullptr,
            [changes](store::Database& database) {
                const auto emptied = database.execute(QStringLiteral("DELETE FROM alarm"));
                return emptied && store::AlarmLog::write(database, changes);
            },
            [](bool) {});
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
        QVERIFY(isShown("faultCard"));
        tap("nav_alarms");
        QCOMPARE(textOf("alarmsLive"), QStringLiteral("Active, 1 new")); // the number at the page's key
        QCOMPARE(textOf("alarmState"), QStringLiteral("C-01 · Active, not acknowledged"));
        tap("liveAlarm0");
        QCOMPARE(textOf("alarmCause"), QStringLiteral("The axis cannot follow its setpoint."));
        QCOMPARE(textOf("alarmAction"),
                 QStringLiteral("Check for a jam, reset the fault, then start the reference run."));
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

    // One flow: the card on Run leads to the fault, and its Reset is all that the fault asks for.
    void aFaultIsResetWhereItIsRead()
    {
        using campanel::modbus::Command;
        show(Situation::Fault);
        tap("faultCard");
        QCOMPARE(textOf("alarmCause"), QStringLiteral("The axis cannot follow its setpoint."));
        QVERIFY2(textOf("alarmDetail").startsWith(QStringLiteral("Axis: following error ")),
                 qPrintable(textOf("alarmDetail")));
        m_window->link().requests.clear();
        holdFor("alarmReset", 60);
        QVERIFY(m_window->link().requests.isEmpty());
        holdFor("alarmReset", 700);
        QCOMPARE(m_window->link().requests.size(), 1);
        QCOMPARE(m_window->link().requests.first().command, Command::ResetFault);
        show(Situation::Stopped);
        QTest::qWait(1000);
        QVERIFY(!isShown("navCalls"));
        QVERIFY(!isShown("banner"));
        tap("nav_alarms");
        QCOMPARE(textOf("alarmsEmpty"), QStringLiteral("No alarm is active or waiting for acknowledgment."));
    }

    void historyIsFilteredJumpedAndExported()
    {
        m_window->panel().records().open();
        fillHistory();
        tap("nav_alarms");
        tap("alarmsHistory");
        panel::AlarmHistory& history = *alarms().history();
        QTRY_COMPARE(history.rows()->count(), 6);
        QVERIFY(!isShown("filterSummary"));

        tap("alarmsFilter");
        tap("filterId");
        typeInto("m01");
        tap("textAccept");
        QTRY_COMPARE(history.rows()->count(), 2);
        tap("filterShow");
        QVERIFY(!isShown("sheetPanel"));
        QCOMPARE(textOf("filterSummary"), QStringLiteral("Only: m01"));
        tap("filterClear");
        QTRY_COMPARE(history.rows()->count(), 6);
        QVERIFY(!isShown("filterSummary"));

        // A day back from today, which is 15 January.
        tap("alarmsFilter");
        tap("filterEarlierDay");
        tap("filterDay");
        QTRY_COMPARE(history.rows()->count(), 3);
        tap("filterShow");
        QCOMPARE(textOf("filterSummary"), QStringLiteral("Only: 2026-01-14 00:00 to 2026-01-15 00:00"));

        const QTemporaryDir stick;
        auto& files = *m_window->panel().maintenance().files();
        files.setScanner([path = stick.path()](const QString&) {
            return QList<campanel::store::Place>{{path, QStringLiteral("stick"), false}};
        });
        tap("alarmsCsv");
        QTRY_VERIFY(isShown("offer0"));
        m_window->waitFor(files);
        tap("offer0");
        tap("offerGo");
        m_window->waitFor(files);
        QVERIFY2(!files.failed(), qPrintable(files.message()));
        QFile file(stick.filePath(QStringLiteral("alarms.csv")));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray csv = file.readAll();
        QCOMPARE(csv.count('\n'), 1 + 3);
        QVERIFY2(csv.contains("L-03") && csv.contains("M-04") && !csv.contains("C-01"), csv.constData());
        tap("sheetClose");

        // The words are those on the screen.
        tap("filterClear");
        tap("alarmsFilter");
        tap("filterWord");
        typeInto("following");
        tap("textAccept");
        tap("filterShow");
        QTRY_COMPARE(history.rows()->count(), 2);
        QCOMPARE(textOf("filterSummary"), QStringLiteral("Only: “following”"));
        QCOMPARE(history.rows()->row(0).code(), QStringLiteral("C-01"));
    }

    void recordsOfAClockThatWasNotSetAreMarked()
    {
        m_window->panel().records().open();
        fillHistory();
        tap("nav_alarms");
        tap("alarmsHistory");
        QTRY_VERIFY(isShown("alarmClock"));
        QCOMPARE(textOf("alarmClock"), QStringLiteral("clock not set"));
        tap("pastAlarm0");
        QVERIFY2(textOf("alarmRaised").endsWith(QStringLiteral(" · clock not set")),
                 qPrintable(textOf("alarmRaised")));
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
        tap("nav_motion");
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
        // Run tells a fault on the page itself.
        const bool isRun = page == QStringLiteral("nav_run");
        const QQuickItem* text =
            m_window->find(isRun ? QStringLiteral("faultFacts") : QStringLiteral("bannerText"));
        QVERIFY(text);
        const QString told = text->property("text").toString();
        QVERIFY2(told.contains(QStringLiteral("15")), qPrintable(told));
        QVERIFY2(!text->property("truncated").toBool(), qPrintable(told));
        QVERIFY(text->property("contentHeight").toDouble() <= text->height() + 1);
        QVERIFY(text->property("contentWidth").toDouble() <= text->width() + 1);
        const QQuickItem* banner =
            m_window->find(isRun ? QStringLiteral("faultCard") : QStringLiteral("banner"));
        const QRectF frame = banner->mapRectToScene(banner->boundingRect());
        QVERIFY(frame.contains(text->mapRectToScene(text->boundingRect())));
        QVERIFY(QRectF(QPointF(), QSizeF(size)).contains(frame));
        tap(isRun ? "faultCard" : "bannerWay");
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
        m_window->panel().settings().set("display.language", QStringLiteral("zh_CN"));
        m_window->settle();
        QCOMPARE(textOf("alarmAction"), QStringLiteral("请检查是否卡阻，然后复位故障并回零。"));
        QCOMPARE(textOf("urgentAlarm"), QStringLiteral("跟随误差过大"));
    }
};

CAMPANEL_TEST(TestPanelAlarms)

} // namespace test_panel_alarms

#include "test_panel_alarms.moc"
