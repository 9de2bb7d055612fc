// SPDX-License-Identifier: Apache-2.0
// The page Trends by touch: opened, span selected, moved away and back, a time selected, curves selected,
// exported to a stick.
#include "panel_test.h"
#include "tests/looks/screens.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTemporaryDir>

#include <cmath>

namespace test_panel_trends {

using campanel::panel::Trends;

class TestPanelTrends : public campanel::test::PanelTest {
    Q_OBJECT

    Trends& trends() { return m_window->panel().trends(); }
    void enter(const char* name)
    {
        for (const auto& screen : campanel::looks::allScreens()) {
            if (screen.name == QLatin1String(name))
                campanel::looks::enterScreen(*m_window, screen);
        }
    }
    void drag(int byPx)
    {
        const QPoint from = centerOf(QStringLiteral("trendPlot"));
        QTest::mousePress(&m_window->window(), Qt::LeftButton, {}, from);
        for (int step = 1; step <= 4; ++step)
            QTest::mouseMove(&m_window->window(), from + QPoint(byPx * step / 4, 0));
        QTest::mouseRelease(&m_window->window(), Qt::LeftButton, {}, from + QPoint(byPx, 0));
        m_window->waitForTrends();
    }

private slots:
    void emptyPageSaysWhatToDo()
    {
        enter("trends-empty");
        QVERIFY2(!textOf("trendEmpty").contains(QStringLiteral("Start")), "the machine runs");
        m_window->link().show(campanel::looks::DemoLink::Situation::Stopped);
        m_window->checkClock();
        QVERIFY2(textOf("trendEmpty").contains(QStringLiteral("Press Start")),
                 qPrintable(textOf("trendEmpty")));
        m_window->panel().settings().set("access.hold_to_start", QStringLiteral("on"));
        QVERIFY2(textOf("trendEmpty").contains(QStringLiteral("Hold Start")),
                 qPrintable(textOf("trendEmpty")));
        QVERIFY(!m_window->find(QStringLiteral("trendExport"))->isEnabled());
    }

    void bagsOfAClockThatIsNotSetAreNamedBesideTheRange()
    {
        enter("trends");
        QVERIFY(!textOf("trendRange").contains(QStringLiteral("clock")));
        enter("trends-clock-unset");
        QVERIFY2(textOf("trendRange").endsWith(QStringLiteral("clock not set")),
                 qPrintable(textOf("trendRange")));
    }

    void spanIsChosenByOneTap()
    {
        enter("trends");
        QVERIFY(trends().watched());
        QVERIFY2(textOf("trendFigures0").startsWith(QStringLiteral("n 531 · mean ")),
                 qPrintable(textOf("trendFigures0")));
        tap("span7d");
        QCOMPARE(trends().spanMs(), 7 * 86400e3);
        m_window->waitForTrends();
        QVERIFY(!textOf("trendFigures0").startsWith(QStringLiteral("n 531 ")));
        tap("trendShorter");
        QCOMPARE(trends().spanMs(), 3.5 * 86400e3);
        tap("trendLonger");
        QCOMPARE(trends().spanMs(), 7 * 86400e3);
    }

    void aDragGoesBackInTimeAndNowReturns()
    {
        enter("trends");
        const double now = trends().toMs();
        QVERIFY(!m_window->find(QStringLiteral("trendNow"))->isEnabled());
        drag(200);
        QVERIFY(!trends().live());
        QVERIFY2(trends().toMs() < now - 60'000, qPrintable(QString::number(now - trends().toMs())));
        QCOMPARE(trends().spanMs(), 600'000.0);
        tap("trendNow");
        QVERIFY(trends().live());
        QCOMPARE(trends().toMs(), now);
        drag(-200); // not into the future
        QVERIFY(trends().live());
        QCOMPARE(trends().toMs(), now);
    }

    void aTapReadsAValueAndTheNextPutsItAway()
    {
        enter("trends-cursor");
        QVERIFY2(textOf("trendFigures0").contains(QStringLiteral("15 Jan 14:0")),
                 qPrintable(textOf("trendFigures0")));
        tap("trendPlot");
        QVERIFY(textOf("trendFigures0").startsWith(QStringLiteral("n ")));
    }

    void aHeldHeadingSaysHowItsFiguresComeAbout()
    {
        enter("trends");
        m_window->hold(QStringLiteral("trendFigures0"));
        const QQuickItem* sheet = m_window->find(QStringLiteral("sheetPanel"));
        QVERIFY(sheet);
        const QString text = textOf("explanationText"); // the mean, which comes first
        QVERIFY2(text.contains(QStringLiteral("sum of the values / n")), qPrintable(text));
        QVERIFY2(text.contains(QStringLiteral(" / 531\n= ")), qPrintable(text));
        const QVariantMap found = trends().statistics().first().toMap();
        QVERIFY2(text.endsWith(QStringLiteral("= %1 mm").arg(found.value(QStringLiteral("mean")).toDouble(),
                                                             0, 'f', 2)),
                 qPrintable(text));
        QCOMPARE(m_window->panel().explanations().ofTrend(0).size(), 4);
        QCOMPARE(m_window->panel().explanations().ofTrend(1).size(), 3); // marks have no tolerance
        QVERIFY(m_window->panel().explanations().ofTrend(2).isEmpty());
        tap("sheetClose");
        QVERIFY(trends().live());
        enter("trends-cursor");
        m_window->hold(QStringLiteral("trendFigures1"));
        QVERIFY2(textOf("explanationText").contains(QStringLiteral("covers 2 s")),
                 qPrintable(textOf("explanationText")));
        enter("trends-nothing-here");
        QVERIFY(m_window->panel().explanations().ofTrend(0).isEmpty());
    }

    void curvesAreChosen()
    {
        enter("trends-curves");
        tap("curve4");
        QCOMPARE(trends().chosen(), QList<int>({Trends::Deviation, Trends::MarkError, Trends::Rate}));
        tap("curve1");
        tap("sheetClose");
        QCOMPARE(trends().chosen(), QList<int>({Trends::MarkError, Trends::Rate}));
        QVERIFY(m_window->find(QStringLiteral("trendFigures1")));
        QVERIFY(!m_window->find(QStringLiteral("trendFigures2")));
    }

    void whatIsShownIsExported()
    {
        const QTemporaryDir stick;
        enter("trends");
        auto& files = *m_window->panel().maintenance().files();
        files.setScanner([&](const QString&) {
            return QList<campanel::store::Place>{{stick.path(), QStringLiteral("stick"), false}};
        });
        tap("trendExport");
        m_window->waitForTrends();
        m_window->waitFor(files);
        tap("offer0");
        tap("offerGo");
        m_window->waitFor(files);
        QVERIFY2(!files.failed(), qPrintable(files.message()));
        QFile bags(stick.filePath(QStringLiteral("bags.csv")));
        QVERIFY(bags.open(QIODevice::ReadOnly));
        QCOMPARE(bags.readAll().count('\n'), 61); // sixty bags and the heading
        QVERIFY(QFile::exists(stick.filePath(QStringLiteral("trends.csv"))));
    }

    void anotherPageAsksForNothing()
    {
        enter("trends");
        tap("nav_run");
        QVERIFY(!trends().watched());
    }
};

CAMPANEL_TEST(TestPanelTrends)

} // namespace test_panel_trends

#include "test_panel_trends.moc"
