// SPDX-License-Identifier: Apache-2.0
// Stops by touch: the question on Run, the page of a shift, a later answer, explanations, files, settings.
#include "panel_test.h"
#include "tests/looks/screens.h"
#include "tests/support/test_program.h"

#include <QEventLoop>
#include <QFile>
#include <QTemporaryDir>

namespace test_panel_stops {

using campanel::panel::ShiftView;
using campanel::panel::Stops;

class TestPanelStops : public campanel::test::PanelTest {
    Q_OBJECT

    Stops& stops() { return m_window->panel().stops(); }
    ShiftView& shift() { return *stops().shift(); }
    void enter(const char* name)
    {
        for (const auto& screen : campanel::looks::allScreens()) {
            if (screen.name == QLatin1String(name))
                campanel::looks::enterScreen(*m_window, screen);
        }
    }
    void settle()
    {
        for (int round = 0; round < 2; ++round) {
            QEventLoop untilAnswered;
            m_window->panel().records().store().run(
                &untilAnswered, [](campanel::store::Database&) { return true; },
                [&](bool) { untilAnswered.quit(); });
            untilAnswered.exec();
        }
        m_window->settle();
    }
    QString setting(const char* name)
    {
        for (const campanel::panel::SettingRow& row : campanel::panel::settingTable) {
            if (row.name == name)
                return m_window->panel().settings().values().text(row);
        }
        return {};
    }

private slots:
    void theQuestionIsAnsweredByTwoTouches()
    {
        enter("run-stop-question");
        QVERIFY(stops().asking());
        QVERIFY(m_window->find(QStringLiteral("stopQuestion")));
        QCOMPARE(textOf("stopQuestionTitle"), QStringLiteral("Why is the machine stopped?"));
        tap("reason_material");
        QCOMPARE(textOf("stopQuestionTitle"), QStringLiteral("Material"));
        tap("stopQuestionBack");
        tap("reason_machine");
        tap("reason_machine/knife");
        QVERIFY(!m_window->find(QStringLiteral("stopQuestion")));
        QCOMPARE(stops().reasonText(), QStringLiteral("Machine · Knife, jaws"));
    }

    void aMistappedReasonIsUndone()
    {
        enter("run-stop-question");
        tap("reason_cleaning");
        QVERIFY(!m_window->find(QStringLiteral("stopQuestion")));
        QCOMPARE(textOf("bannerText"), QStringLiteral("Stop reason: Cleaning."));
        QTest::qWait(3000); // somebody reads
        tap("bannerWay");
        QVERIFY(stops().reason().isEmpty());
        QVERIFY(m_window->find(QStringLiteral("stopQuestion")));
        tap("reason_break");
        QTest::qWait(6000);
        QVERIFY(!m_window->find(QStringLiteral("bannerWay")));
        QCOMPARE(stops().reason(), QStringLiteral("break"));
    }

    void theQuestionNeverCoversTheCommands()
    {
        enter("run-stop-question");
        const QQuickItem* question = m_window->find(QStringLiteral("stopQuestion"));
        const QRectF place = question->mapRectToScene(question->boundingRect());
        for (const char* name : {"startKey", "stopKey"}) {
            const QQuickItem* key = m_window->find(QString::fromLatin1(name));
            QVERIFY(!place.intersects(key->mapRectToScene(key->boundingRect())));
        }
    }

    void theQuestionGoesWhenTheMachineRuns()
    {
        enter("run-stop-question");
        m_window->link().show(campanel::looks::DemoLink::Situation::Running);
        m_window->settle();
        QVERIFY(!m_window->find(QStringLiteral("stopQuestion")));
        enter("run-stop-question");
        tap("stopQuestionLater");
        QVERIFY(!m_window->find(QStringLiteral("stopQuestion")));
    }

    void theQuestionLeadsToTheShift()
    {
        enter("run-stop-question");
        tap("stopQuestionShift");
        QVERIFY(m_window->find(QStringLiteral("stateBar")));
        tap("shiftTrends");
        QVERIFY(m_window->find(QStringLiteral("trendStops")));
    }

    void aShiftIsShownWithItsFigures()
    {
        enter("stops");
        QVERIFY2(textOf("shiftTitle").endsWith(QStringLiteral("06:00 – 14:00")),
                 qPrintable(textOf("shiftTitle")));
        QCOMPARE(shift().stops()->count(), 7);
        QCOMPARE(shift().openStops(), 1); // the other one is short
        QCOMPARE(textOf("reasonText0"), QStringLiteral("Break (planned)"));
        QCOMPARE(textOf("reasonTime0"), QStringLiteral("30 min · 1×"));
        QVERIFY(shift().oee() > 0.5 && shift().oee() < 1);
        tap("shiftNext");
        settle();
        QVERIFY(shift().isPresent());
        QVERIFY(!m_window->find(QStringLiteral("shiftNext"))->isEnabled());
        enter("stops-nothing");
        QVERIFY(!m_window->find(QStringLiteral("shiftCsv"))->isEnabled());
        tap("shiftNow");
        settle();
        QVERIFY(shift().isPresent());
    }

    void aStopOfAClockThatIsNotSetSaysSo()
    {
        enter("stops-list-clock-unset");
        QCOMPARE(shift().note(), QStringLiteral("clock not set"));
        const QQuickItem* oldest = m_window->find(QStringLiteral("stop6"));
        QVERIFY(oldest);
        QCOMPARE(oldest->property("clockNote").toString(), QStringLiteral("clock not set"));
        QVERIFY(m_window->find(QStringLiteral("stop5"))->property("clockNote").toString().isEmpty());
    }

    void eachFigureIsExplained()
    {
        const std::pair<const char*, const char*> figures[]{
            {"figureOee", "availability × performance × quality"},
            {"figureAvailability", "385.0 min / 450.0 min"},
            {"figurePerformance", "sum of pieces × ideal time per piece / run time"},
            {"figureQuality", "good pieces / pieces"}};
        for (const auto& [figure, text] : figures) {
            enter("stops");
            m_window->hold(QString::fromLatin1(figure));
            QVERIFY2(textOf("explanationText").contains(QString::fromUtf8(text)),
                     qPrintable(textOf("explanationText")));
        }
    }

    void aStopIsAnsweredLater()
    {
        enter("stops-answer");
        tap("reason_quality");
        tap("stopListBack");
        tap("reason_cleaning");
        settle();
        QVERIFY(m_window->find(QStringLiteral("stopList")));
        QCOMPARE(shift().openStops(), 0);
        QCOMPARE(shift().stops()->row(0).reasonText(), QStringLiteral("Cleaning"));
    }

    void theShiftIsWrittenToAStick()
    {
        const QTemporaryDir stick;
        enter("stops");
        auto& files = *m_window->panel().maintenance().files();
        files.setScanner([&](const QString&) {
            return QList<campanel::store::Place>{{stick.path(), QStringLiteral("stick"), false}};
        });
        for (const char* key : {"shiftCsv", "shiftPdf"}) {
            tap(key);
            settle();
            m_window->waitFor(files);
            tap("offer0");
            tap("offerGo");
            m_window->waitFor(files);
            QVERIFY2(!files.failed(), qPrintable(files.message()));
            tap("sheetClose");
        }
        QFile csv(stick.filePath(QStringLiteral("stops.csv")));
        QVERIFY(csv.open(QIODevice::ReadOnly));
        const QByteArray text = csv.readAll();
        QCOMPARE(text.count('\n'), 8);
        QCOMPARE(text.count(",set\n"), 7);
        QVERIFY(text.contains(",1800.000,ready,break,yes,Ann,"));
        QVERIFY(QFile::exists(stick.filePath(QStringLiteral("states.csv"))));
        QFile pdf(stick.filePath(QStringLiteral("shift 2026-01-15 06-00.pdf")));
        QVERIFY(pdf.open(QIODevice::ReadOnly));
        QVERIFY(pdf.read(5) == "%PDF-");
        QVERIFY(pdf.size() > 5000);
    }

    void anotherPageAsksForNothing()
    {
        enter("stops");
        QVERIFY(shift().watched());
        tap("nav_run");
        QVERIFY(!shift().watched());
    }

    void shiftsAndReasonsAreSetByTouch()
    {
        enter("settings-stops-shifts");
        tap("shiftStart1");
        tap("startLaterHour");
        tap("startEarlier");
        QCOMPARE(setting("stops.shift_starts"), QStringLiteral("06:00 14:45 22:00"));
        tap("startRemove");
        QCOMPARE(setting("stops.shift_starts"), QStringLiteral("06:00 22:00"));
        tap("startAdd");
        QCOMPARE(setting("stops.shift_starts"), QStringLiteral("06:00 14:00 22:00"));
        tap("workingDay7");
        QCOMPARE(setting("stops.working_days"), QStringLiteral("123456"));
        tap("workingDay7");
        enter("settings-stops-reasons");
        tap("reasonRow3");
        tap("reasonPlanned");
        QVERIFY(setting("stops.reasons").contains(QStringLiteral("planned:changeover")));
        tap("reasonRemove");
        QVERIFY(!setting("stops.reasons").contains(QStringLiteral("changeover")));
        tap("reasonAdd");
        for (const char* letter : {"key_f", "key_o", "key_r", "key_k"})
            tap(letter);
        tap("textAccept");
        QVERIFY2(setting("stops.reasons").endsWith(QStringLiteral("\nfork")),
                 qPrintable(setting("stops.reasons")));
        QVERIFY(m_window->find(QStringLiteral("reasonRows")));
        tap("reasonStandard");
        tap("confirm_restore");
        QCOMPARE(setting("stops.reasons"), QString());
    }
};

CAMPANEL_TEST(TestPanelStops)

} // namespace test_panel_stops

#include "test_panel_stops.moc"
