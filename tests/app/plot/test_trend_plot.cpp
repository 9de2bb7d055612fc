// SPDX-License-Identifier: Apache-2.0
// The plot of trends: ticks of local time, requests of gestures, the drawing, the cursor.
#include "app/plot/time_axis.h"
#include "app/plot/trend_plot.h"
#include "tests/support/test_program.h"

#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QQuickWindow>
#include <QSignalSpy>
#include <QTest>

#include <cmath>
#include <memory>

namespace test_trend_plot {

using namespace campanel::plot;
using namespace Qt::StringLiterals;

namespace {

constexpr double startMs = 1'800'000'000'000;
constexpr double minuteMs = 60'000;
constexpr double hourMs = 60 * minuteMs;

QVariant curvesOf(const QList<QList<QPointF>>& lines)
{
    return QVariant::fromValue(std::make_shared<const QList<QList<QPointF>>>(lines));
}

// A mean of 0.1 in a band of 0.2 to both sides, a point a second, without the 20 seconds in the middle.
QVariant withAPause(int seconds)
{
    QList<QList<QPointF>> lines(3);
    for (int i = 0; i < seconds; ++i) {
        const bool isPause = i >= seconds / 2 && i < seconds / 2 + 20;
        if (isPause && i != seconds / 2)
            continue;
        const double x = startMs + 1000 * i;
        lines[0] << QPointF(x, isPause ? std::nan("") : 0.1);
        lines[1] << QPointF(x, isPause ? std::nan("") : -0.1);
        lines[2] << QPointF(x, isPause ? std::nan("") : 0.3);
    }
    return curvesOf(lines);
}

std::unique_ptr<TrendPlot> plotOf(const QVariant& curves, double spanMs)
{
    auto plot = std::make_unique<TrendPlot>();
    plot->setSize({600, 300});
    plot->setProperty("curves", curves);
    plot->setProperty("lanes", 1);
    plot->setProperty("headerHeight", 20);
    plot->setProperty("fromMs", startMs);
    plot->setProperty("toMs", startMs + spanMs);
    plot->setProperty("laneColors", QVariant::fromValue(QList<QColor>{Qt::blue}));
    plot->setProperty("tolerances", QVariant::fromValue(QList<double>{0.5}));
    plot->setProperty("toleranceColor", QColor(Qt::red));
    return plot;
}

QImage painted(TrendPlot& plot)
{
    QImage image(plot.size().toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    plot.paint(&painter);
    return image;
}

bool isBlueAt(const QImage& image, double x)
{
    for (int y = 0; y < image.height(); ++y) {
        const QColor color = image.pixelColor(static_cast<int>(x), y);
        if (color.blue() > 200 && color.red() < 150)
            return true;
    }
    return false;
}

} // namespace

class TestTrendPlot : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { qputenv("TZ", "Europe/Berlin"); }

    void ticksStandOnRoundTimes_data()
    {
        QTest::addColumn<double>("span");
        QTest::addColumn<QStringList>("texts");
        QTest::newRow("a minute") << minuteMs
                                  << QStringList{u"09:00:00"_s, u"09:00:15"_s, u"09:00:30"_s, u"09:00:45"_s,
                                                 u"09:01:00"_s};
        QTest::newRow("an hour") << hourMs
                                 << QStringList{u"09:00"_s, u"09:15"_s, u"09:30"_s, u"09:45"_s, u"10:00"_s};
        QTest::newRow("a day") << 24 * hourMs << QStringList{u"12:00"_s, u"18:00"_s, u"16 Jan"_s, u"06:00"_s};
        QTest::newRow("a month") << 30 * 24 * hourMs << QStringList{u"19 Jan"_s, u"24 Jan"_s, u"29 Jan"_s,
                                                                    u"3 Feb"_s,  u"8 Feb"_s,  u"13 Feb"_s};
    }

    void ticksStandOnRoundTimes()
    {
        QFETCH(double, span);
        QStringList texts;
        for (const TimeTick& tick :
             timeTicks(startMs, startMs + span, span > 25 * hourMs ? 7 : 5, QLocale::c()))
            texts << tick.text;
        QTEST(texts, "texts");
    }

    // On the day on which the clock is put forward.
    void ticksFollowTheClockOverSummerTime()
    {
        const QDateTime midnight(QDate(2027, 3, 28), QTime(0, 0));
        const auto from = static_cast<double>(midnight.toMSecsSinceEpoch());
        QStringList texts;
        for (const TimeTick& tick : timeTicks(from, from + 23 * hourMs, 9, QLocale::c()))
            texts << tick.text;
        QCOMPARE(texts, QStringList({u"28 Mar"_s, u"03:00"_s, u"06:00"_s, u"09:00"_s, u"12:00"_s, u"15:00"_s,
                                     u"18:00"_s, u"21:00"_s, u"29 Mar"_s}));
    }

    // 02:00 to 03:00 comes twice on the day on which the clock is put back.
    void theRepeatedHourHasItsTicksAndZones_data()
    {
        QTest::addColumn<double>("fromHour"); // of UTC
        QTest::addColumn<double>("hours");
        QTest::addColumn<QStringList>("texts");
        QTest::addRow("in the first pass")
            << 0.0 << 0.5 << QStringList{u"02:00 CEST"_s, u"02:10"_s, u"02:20"_s, u"02:30"_s};
        QTest::addRow("in the second pass")
            << 1.0 << 0.5 << QStringList{u"02:00 CET"_s, u"02:10"_s, u"02:20"_s, u"02:30"_s};
        QTest::addRow("over the change")
            << 0.5 << 1.0 << QStringList{u"02:30 CEST"_s, u"02:45"_s, u"02:00 CET"_s, u"02:15"_s, u"02:30"_s};
        QTest::addRow("hours") << -1.0 << 4.0
                               << QStringList{u"01:00"_s, u"02:00 CEST"_s, u"02:00 CET"_s, u"03:00"_s,
                                              u"04:00"_s};
        QTest::addRow("a day") << -2.0 << 25.0
                               << QStringList{u"31 Oct"_s, u"06:00"_s, u"12:00"_s, u"18:00"_s, u"1 Nov"_s};
    }
    void theRepeatedHourHasItsTicksAndZones()
    {
        QFETCH(double, fromHour);
        QFETCH(double, hours);
        const QDateTime midnight(QDate(2027, 10, 31), QTime(0, 0), Qt::UTC);
        const double from = static_cast<double>(midnight.toMSecsSinceEpoch()) + fromHour * hourMs;
        QStringList texts;
        for (const TimeTick& tick : timeTicks(from, from + hours * hourMs, 6, QLocale::c()))
            texts << tick.text;
        QTEST(texts, "texts");
    }

    void aTimeThatComesTwiceNamesItsZone()
    {
        const QDateTime midnight(QDate(2027, 10, 31), QTime(0, 0), Qt::UTC);
        const auto at = [&midnight](double hour) {
            return momentText(static_cast<double>(midnight.toMSecsSinceEpoch()) + hour * hourMs, 24 * hourMs,
                              QLocale::c());
        };
        QCOMPARE(at(-0.5), u"31 Oct 01:30"_s);
        QCOMPARE(at(0.5), u"31 Oct 02:30 CEST"_s);
        QCOMPARE(at(1), u"31 Oct 02:00 CET"_s);
        QCOMPARE(at(2), u"31 Oct 03:00"_s);
    }

    void datesAreWrittenAsTheLanguageDoes()
    {
        QCOMPARE(shortDate({2026, 1, 15}, QLocale(QLocale::Chinese)), u"1月15日"_s);
        QCOMPARE(shortDate({2026, 1, 15}, QLocale(QLocale::English)), u"15 Jan"_s);
        QCOMPARE(momentText(startMs, hourMs, QLocale::c()), u"15 Jan 09:00:00"_s);
        QCOMPARE(momentText(startMs, 24 * hourMs, QLocale::c()), u"15 Jan 09:00"_s);
    }

    void oneFingerMovesTwoZoom()
    {
        WindowGesture gesture;
        gesture.begin({100}, {1000, 2000}, 500);
        QCOMPARE(gesture.moved({95}).fromMs, 1000.0); // a tremor
        QVERIFY(!gesture.hasMoved());
        QCOMPARE(gesture.moved({150}).fromMs, 900.0);
        QVERIFY(gesture.hasMoved());
        QCOMPARE(gesture.moved({100}).fromMs, 1000.0);

        gesture.begin({100, 300}, {1000, 2000}, 500);
        const WindowGesture::Window wide = gesture.moved({300, 500}); // moved together
        QCOMPARE(wide.fromMs, 600.0);
        QCOMPARE(wide.toMs, 1600.0);
        const WindowGesture::Window near = gesture.moved({0, 400}); // apart: the times stay under the fingers
        QCOMPARE(near.fromMs, 1200.0);
        QCOMPARE(near.toMs, 1700.0);
        QVERIFY(gesture.moved({200, 200}).toMs < 1e6); // without limit otherwise
    }

    void pauseIsNotBridged()
    {
        const auto plot = plotOf(withAPause(100), 100'000);
        const QImage image = painted(*plot);
        QVERIFY(isBlueAt(image, plot->xOfTime(startMs + 20'000)));
        QVERIFY(!isBlueAt(image, plot->xOfTime(startMs + 60'000)));
        QVERIFY(isBlueAt(image, plot->xOfTime(startMs + 90'000)));
        QCOMPARE(plot->valuesAt(0, startMs + 20'000), QList<double>({-0.1, 0.1, 0.3}));
        QVERIFY(std::isnan(plot->valuesAt(0, startMs + 52'000)[1]));
    }

    void toleranceIsInSightAndNothingIsDrawnOfNothing()
    {
        const auto plot = plotOf(withAPause(100), 100'000);
        const QImage image = painted(*plot);
        int red = 0;
        for (int y = 0; y < image.height(); ++y)
            red +=
                image.pixelColor(static_cast<int>(plot->plotArea().left()) + 1, y) == QColor(Qt::red) ? 1 : 0;
        QCOMPARE(red, 4); // two lines, two pixels each
        const auto empty = plotOf({}, 100'000);
        (void)painted(*empty);
        QVERIFY(std::isnan(empty->valuesAt(0, startMs)[1]));
        QVERIFY(std::isnan(empty->valuesAt(7, startMs)[1]));
    }

    void onlyTheWindowIsDrawn()
    {
        const auto plot = plotOf(withAPause(2000), 100'000);
        QVERIFY(plot->drawnPoints(0) <= 103);
    }

    void aTapPointsADragMoves()
    {
        QQuickWindow window;
        window.resize(600, 300);
        const auto plot = plotOf(withAPause(100), 100'000);
        plot->setParentItem(window.contentItem());
        window.show();
        QSignalSpy cursor(plot.get(), &TrendPlot::cursorWanted);
        QSignalSpy moved(plot.get(), &TrendPlot::windowWanted);
        QTest::mouseClick(&window, Qt::LeftButton, {}, {300, 100});
        QCOMPARE(cursor.size(), 1);
        QVERIFY(std::abs(cursor[0][0].toDouble() - plot->timeOfX(300)) < 1);
        QVERIFY(moved.isEmpty());
        QTest::mousePress(&window, Qt::LeftButton, {}, {300, 100});
        QTest::mouseMove(&window, {400, 100});
        QTest::mouseRelease(&window, Qt::LeftButton, {}, {400, 100});
        QCOMPARE(cursor.size(), 1);
        QVERIFY(!moved.isEmpty());
        QVERIFY(std::abs(moved.last()[0].toDouble() - (startMs - plot->timeOfX(100) + plot->timeOfX(0))) < 1);
        // A held finger points, and then moves the cursor.
        QTest::mousePress(&window, Qt::LeftButton, {}, {200, 100});
        QTRY_COMPARE(cursor.size(), 2);
        moved.clear();
        QTest::mouseMove(&window, {260, 100});
        QTest::mouseRelease(&window, Qt::LeftButton, {}, {260, 100});
        QVERIFY(std::abs(cursor.last()[0].toDouble() - plot->timeOfX(260)) < 1);
        QVERIFY(moved.isEmpty());
    }

    void aHeldHeaderAsksForItsLaneAndMovesNothing()
    {
        QQuickWindow window;
        window.resize(600, 300);
        const auto plot = plotOf(withAPause(100), 100'000);
        plot->setProperty("lanes", 2);
        plot->setProperty("headerReach", 40);
        plot->setParentItem(window.contentItem());
        window.show();
        QSignalSpy held(plot.get(), &TrendPlot::headerHeld);
        QSignalSpy cursor(plot.get(), &TrendPlot::cursorWanted);
        QSignalSpy moved(plot.get(), &TrendPlot::windowWanted);
        const int y = static_cast<int>(plot->laneTop(1)) + 10;
        QTest::mousePress(&window, Qt::LeftButton, {}, {300, y});
        QTRY_COMPARE(held.size(), 1);
        QCOMPARE(held[0][0].toInt(), 1);
        QTest::mouseMove(&window, {400, y});
        QTest::mouseRelease(&window, Qt::LeftButton, {}, {400, y});
        QVERIFY(cursor.isEmpty() && moved.isEmpty());
        // A tap and a drag there belong to the plot, and so does a hold below.
        QTest::mouseClick(&window, Qt::LeftButton, {}, {300, y});
        QCOMPARE(cursor.size(), 1);
        QTest::mousePress(&window, Qt::LeftButton, {}, {300, y + 40});
        QTRY_COMPARE(cursor.size(), 2);
        QTest::mouseRelease(&window, Qt::LeftButton, {}, {300, y + 40});
        QCOMPARE(held.size(), 1);
    }

    void twoFingersOnTheScreenZoom()
    {
        QQuickWindow window;
        window.resize(600, 300);
        const auto plot = plotOf(withAPause(100), 100'000);
        plot->setParentItem(window.contentItem());
        window.show();
        const std::unique_ptr<QPointingDevice> screen(QTest::createTouchDevice());
        QSignalSpy moved(plot.get(), &TrendPlot::windowWanted);
        QSignalSpy cursor(plot.get(), &TrendPlot::cursorWanted);
        auto touch = QTest::touchEvent(&window, screen.get(), false);
        touch.press(0, {250, 100}).commit();
        touch.stationary(0).press(1, {350, 100}).commit();
        touch.move(0, {150, 100}).move(1, {450, 100}).commit();
        QTRY_VERIFY(!moved.isEmpty()); // moves come with the next frame
        const double span = moved.last()[1].toDouble() - moved.last()[0].toDouble();
        QVERIFY2(std::abs(span - 100'000.0 / 3) < 1, qPrintable(QString::number(span)));
        touch.release(0, {150, 100}).stationary(1).commit();
        touch.release(1, {450, 100}).commit();
        QVERIFY(cursor.isEmpty());
    }
};

CAMPANEL_TEST(TestTrendPlot)

} // namespace test_trend_plot

#include "test_trend_plot.moc"
