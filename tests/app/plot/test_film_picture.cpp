// SPDX-License-Identifier: Apache-2.0
// The ink of FilmPicture, and its movement between two reports.
#include "samples.h"

#include "app/plot/film/film_picture.h"
#include "tests/support/test_program.h"

#include <QFontMetricsF>
#include <QTest>

#include <limits>

namespace campanel::plot::test_film_picture {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const QColor black(0, 0, 0);
const QColor red(255, 0, 0);
const QColor green(0, 160, 0);
const QColor blue(0, 0, 255);
const QColor magenta(255, 0, 255);

using Places = QList<QPointF>;

// Bags of 250 mm, the sensor at 900 mm, in a picture of 800 x 160; the clock is set by hand.
struct Rig {
    FilmPicture picture;
    double timeS = 100;

    Rig()
    {
        picture.setSize({800, 160});
        picture.setClock([this] { return timeS; });
        for (const char* name : {"filmColor", "edgeColor"})
            picture.setProperty(name, QColor(Qt::white));
        picture.setProperty("markColor", black);
        picture.setProperty("windowColor", QColor(Qt::cyan));
        picture.setProperty("productColor", green);
        picture.setProperty("cutColor", blue);
        picture.setProperty("skippedColor", red);
        picture.setProperty("knifeColor", magenta);
        picture.setProperty("textColor", QColor(Qt::gray));
        picture.setProperty("bagLength", 250.0);
        picture.setProperty("sensor", 900.0);
        picture.setProperty("window", 6.0);
        picture.setProperty("position", 1000.0);
    }

    void set(const char* name, const Places& places)
    {
        picture.setProperty(name, QVariant::fromValue(places));
    }
    void report(double positionMm, double speedMmPerS)
    {
        picture.setProperty("position", positionMm);
        picture.setProperty("speed", speedMmPerS);
        paint();
    }
    QImage paint() { return test::paintItem(picture); }
    // Returns the ink in a strip of this many mm around a place.
    int inkAt(const QImage& image, double distanceMm, const QColor& color, int reach = 8)
    {
        const int x = qRound(picture.xOf(distanceMm));
        return test::inkIn(image, {x - reach, 0, 2 * reach + 1, image.height()}, color);
    }
};

} // namespace

class TestFilmPicture : public QObject {
    Q_OBJECT
private slots:
    void theKnifeIsAtTheRightAndTheFilmFlowsToIt()
    {
        Rig rig;
        QVERIFY(rig.picture.xOf(0) > 700 && rig.picture.xOf(0) < 800);
        QVERIFY(rig.picture.xOf(900) > 0 && rig.picture.xOf(900) < rig.picture.xOf(500));
        QVERIFY2(rig.picture.xOf(900 + 250) > 0, "where the next mark is expected is in sight");
        const QImage image = rig.paint();
        const int blade = rig.inkAt(image, 0, magenta);
        QVERIFY2(blade > 50, qPrintable(QString::number(blade)));
        rig.picture.setProperty("knifeOpen", true);
        QVERIFY2(rig.inkAt(rig.paint(), 0, magenta) < 0.9 * blade, "open, it is hollow");
        QCOMPARE(test::inkIn(image, QRect(0, 0, 600, 160), magenta), 0);
    }

    void marksAreFullAndReckonedOnesHollow()
    {
        Rig rig;
        QCOMPARE(test::inkIn(rig.paint(), QRect(0, 0, 800, 160), black), 0);
        rig.set("marks", {{200, 0}, {600, 1}});
        const QImage image = rig.paint();
        const int seen = rig.inkAt(image, 200, black);
        const int reckoned = rig.inkAt(image, 600, black);
        QVERIFY2(seen > 80, qPrintable(QString::number(seen)));
        QVERIFY2(reckoned > 20 && reckoned < 0.75 * seen, qPrintable(QString::number(reckoned)));
        QCOMPARE(rig.inkAt(image, 400, black), 0);
    }

    // Bags that will be scrap are hatched from the knife on; a skipped cut ends none.
    void scrapIsHatched()
    {
        Rig rig;
        rig.set("cuts", {{100, 0}, {350, 1}, {600, 0}, {850, 0}});
        const auto hatched = [&](double mm) { return rig.inkAt(rig.paint(), mm, red, 12) > 30; };
        QVERIFY(!hatched(50) && !hatched(225) && !hatched(-40));
        rig.picture.setProperty("scrap", QPointF(2, 0));
        QVERIFY2(hatched(50), "the bag in the making");
        QVERIFY2(hatched(225) && hatched(475), "the next one, of two lengths");
        QVERIFY(!hatched(725) && !hatched(-40));
        rig.picture.setProperty("scrap", QPointF(0, 1));
        QVERIFY2(hatched(-40), "the last bag, behind the knife");
        QVERIFY(!hatched(50));
    }

    // Behind the boundary of a change the cuts are of the next program, and its first bags scrap.
    void cutsOfTheNextProgramAreOfAnotherColor()
    {
        Rig rig;
        rig.picture.setProperty("sensor", nan);
        rig.picture.setProperty("windowColor", QColor(Qt::cyan));
        rig.set("cuts", {{150, 0}, {420, 3}, {620, 3}, {820, 2}});
        rig.picture.setProperty("nextText", QStringLiteral("200"));
        const QImage image = rig.paint();
        QVERIFY(rig.inkAt(image, 150, blue) > 40 && rig.inkAt(image, 150, QColor(Qt::cyan)) == 0);
        for (const double mm : {420.0, 620.0, 820.0})
            QVERIFY(rig.inkAt(image, mm, blue) == 0 && rig.inkAt(image, mm, QColor(Qt::cyan)) > 40);
        const auto hatched = [&](double mm) { return rig.inkAt(image, mm, red, 12) > 30; };
        QVERIFY(!hatched(75) && hatched(285) && hatched(520) && !hatched(720));
        const double text = QFontMetricsF(rig.picture.property("textFont").value<QFont>()).height();
        const QRect place(qRound(rig.picture.xOf(420)) - 60, 0, 60, qRound(text));
        QVERIFY2(test::inkIn(image, place, QColor(Qt::cyan)) > 5, "the length, left of the first cut");
        // Without a bag length all of them are visible.
        rig.picture.setProperty("bagLength", nan);
        QVERIFY(qAbs(rig.picture.xOf(820)) < 1);
    }

    void aFaultOfTheKnifeHasARing()
    {
        Rig rig;
        QCOMPARE(rig.inkAt(rig.paint(), 0, green, 60), 0);
        rig.picture.setProperty("faultColor", green);
        QVERIFY(rig.inkAt(rig.paint(), 0, green, 60) > 100);
    }

    void productsLieWhereTheirEdgesAre()
    {
        Rig rig;
        rig.set("products", {{100, 250}});
        const QImage image = rig.paint();
        QVERIFY(rig.inkAt(image, 175, green) > 200);
        QCOMPARE(rig.inkAt(image, 80, green, 4), 0);
        QCOMPARE(rig.inkAt(image, 270, green, 4), 0);
    }

    void aSkippedCutLooksOtherwise()
    {
        Rig rig;
        rig.set("cuts", {{100, 0}, {350, 1}, {600, 0}});
        const QImage image = rig.paint();
        for (const double distance : {100.0, 600.0}) {
            QVERIFY(rig.inkAt(image, distance, blue) > 60);
            QCOMPARE(rig.inkAt(image, distance, red), 0);
        }
        QCOMPARE(rig.inkAt(image, 350, blue), 0);
        // Not only by its color: its line is broken.
        rig.picture.setProperty("skippedColor", blue);
        const QImage sameColor = rig.paint();
        const int broken = rig.inkAt(sameColor, 350, blue);
        QVERIFY(broken > 20);
        QVERIFY(broken < 0.8 * rig.inkAt(sameColor, 100, blue));
    }

    void cutsThatAreMadeAreGone()
    {
        Rig rig;
        rig.set("cuts", {{20, 0}});
        rig.report(1000, 200);
        QVERIFY(test::inkIn(rig.paint(), QRect(0, 0, 800, 160), blue) > 60);
        rig.timeS += 0.2; // 40 mm: past the knife
        QCOMPARE(test::inkIn(rig.paint(), QRect(0, 0, 800, 160), blue), 0);
    }

    void theWindowIsWhereTheNextMarkIsExpected()
    {
        Rig rig;
        rig.picture.setProperty("sensor", nan);
        QCOMPARE(test::inkIn(rig.paint(), QRect(0, 0, 800, 160), Qt::cyan), 0);
        rig.picture.setProperty("nextMark", 400.0);
        QVERIFY(rig.inkAt(rig.paint(), 400, Qt::cyan, 20) > 40);
        rig.picture.setProperty("window", nan);
        QCOMPARE(test::inkIn(rig.paint(), QRect(0, 0, 800, 160), Qt::cyan), 0);
    }

    void aFarSensorIsNamedAtTheEdge()
    {
        Rig rig;
        rig.picture.setProperty("windowColor", red);
        rig.picture.setProperty("sensor", 5000.0);
        const QImage image = rig.paint();
        QVERIFY(rig.picture.xOf(5000) < 0);
        QVERIFY(test::inkIn(image, QRect(0, 0, 20, 60), red) > 20);
    }

    void itGoesOnBetweenTwoReports()
    {
        Rig rig;
        rig.report(1000, 250);
        const double before = rig.picture.xOf(500);
        const double pxPerMm = (rig.picture.xOf(0) - before) / 500;
        rig.timeS += 0.1;
        QVERIFY(std::abs(rig.picture.xOf(500) - before - 25 * pxPerMm) < 1e-6);
        // At its end it waits for the next report.
        rig.timeS += 100;
        QVERIFY(std::abs(rig.picture.xOf(500) - before - 250 * pxPerMm) < 1e-6);
    }

    // Statuses come 33 times a second, reports six times.
    void itIsPaintedTenTimesASecond()
    {
        Rig rig;
        rig.set("cuts", {{400, 0}});
        rig.report(1000, 500);
        const double startS = rig.timeS;
        int paints = 0;
        for (double passedS = 0.03; passedS < 10; passedS += 0.03) {
            rig.timeS = startS + passedS;
            if (std::fmod(passedS, 0.16) < 0.03)
                rig.picture.setProperty("position", 1000 + 500 * passedS);
            if (!rig.picture.advance())
                continue;
            ++paints;
            rig.paint();
        }
        QVERIFY2(paints <= 100 && paints >= 75, qPrintable(QString::number(paints)));
        rig.report(6000, 0); // at standstill a report is painted at once
        QVERIFY(!rig.picture.advance());
    }

    void aReportThatDiffersALittleDoesNotJump()
    {
        Rig rig;
        rig.report(1000, 250);
        rig.timeS += 0.15; // displayed at 1037.5
        // The same place of the film: 500 mm before the knife at 1000 mm is 470 mm before it at 1030 mm.
        const double before = rig.picture.xOf(500);
        rig.report(1030, 250);
        QVERIFY(std::abs(rig.picture.xOf(470) - before) < 1e-6);
        rig.timeS += 0.1; // blended
        const double pxPerMm = rig.picture.xOf(0) - rig.picture.xOf(1);
        QVERIFY(std::abs(rig.picture.xOf(470) - (before + (25 - 7.5) * pxPerMm)) < 1e-6);
    }

    void aReportFromElsewhereJumps()
    {
        Rig rig;
        rig.report(1000, 0);
        const double before = rig.picture.xOf(500);
        rig.report(2000, 0);
        QCOMPARE(rig.picture.xOf(500), before);
    }

    void thePositionMayWrap()
    {
        Rig rig;
        rig.report(FilmMotion::wrapMm - 10, 100);
        rig.timeS += 0.15; // displayed 5 mm past the wrap
        const double before = rig.picture.xOf(500);
        rig.report(4, 100); // 14 mm farther
        QVERIFY(std::abs(rig.picture.xOf(486) - before) < 1e-3);
    }

    void itStandsWhenItIsNotLive()
    {
        Rig rig;
        rig.picture.setProperty("live", false);
        rig.report(1000, 250);
        const double before = rig.picture.xOf(500);
        rig.timeS += 0.5;
        QCOMPARE(rig.picture.xOf(500), before);
    }

    void staleIsGrey()
    {
        Rig rig;
        rig.set("marks", {{200, 0}});
        rig.set("cuts", {{350, 1}});
        rig.set("products", {{400, 500}});
        rig.picture.setProperty("stale", true);
        const QImage image = rig.paint();
        for (const QColor& color : {black, red, green, blue, magenta})
            QCOMPARE(test::inkIn(image, image.rect(), color), 0);
    }

    void nothingKnownIsAnEmptyFilm()
    {
        Rig rig;
        rig.set("marks", {{200, 0}});
        rig.set("cuts", {{350, 0}});
        rig.picture.setProperty("position", nan);
        const QImage image = rig.paint();
        QCOMPARE(test::inkIn(image, image.rect(), black), 0);
        QCOMPARE(test::inkIn(image, image.rect(), blue), 0);
    }

    // Names and numbers are complete at any width: their ink does not touch the edge.
    void textIsNeverClipped()
    {
        Rig rig;
        QFont font;
        font.setPixelSize(13);
        rig.picture.setProperty("textFont", font);
        rig.picture.setProperty("textColor", red);
        rig.picture.setProperty("sensorText", QStringLiteral("Mark sensor"));
        rig.picture.setProperty("knifeText", QStringLiteral("A long name of the knife"));
        for (const int width : {200, 350, 560, 1000}) {
            rig.picture.setSize({static_cast<double>(width), 100});
            const QImage image = rig.paint();
            QVERIFY(test::inkIn(image, image.rect(), red) > 50);
            for (const QRect& edge : {QRect(0, 0, width, 1), QRect(0, 99, width, 1)})
                QVERIFY2(test::inkIn(image, edge, red) == 0, qPrintable(QString::number(width)));
        }
    }
};

CAMPANEL_TEST(TestFilmPicture)

} // namespace campanel::plot::test_film_picture

#include "test_film_picture.moc"
