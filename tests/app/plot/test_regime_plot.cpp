// SPDX-License-Identifier: Apache-2.0
// The regime map: fills, lines, marks and the mapping between finger and recipe.
#include "samples.h"

#include "app/plot/regime_plot.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace campanel::plot::test_regime_plot {

namespace {

const QColor green(0, 128, 0);
const QColor blue(0, 0, 255);
const QColor black(0, 0, 0);

std::shared_ptr<const profile::RegimeMap> mapOf(double contactAngleDeg, double minSealTimeMs)
{
    profile::RotaryCutterProgram program;
    profile::Machine machine;
    program.minSealTimeMs = minSealTimeMs;
    machine.contactAngleDeg = contactAngleDeg;
    const auto map = profile::regimeMap(program, machine, profile::regimeRange(program, machine), 200);
    return std::make_shared<const profile::RegimeMap>(map.value());
}

void setUp(RegimePlot& plot, const std::shared_ptr<const profile::RegimeMap>& map)
{
    plot.setSize({700, 400});
    plot.setProperty("map", QVariant::fromValue(map));
    plot.setProperty("limitNames", QStringList{QStringLiteral("acceleration"), QStringLiteral("seal time")});
    plot.setProperty("limitColors", QVariant::fromValue(QList<QColor>{green, blue}));
    plot.setProperty("insetColor", QColor(Qt::white));
    plot.setProperty("gridColor", QColor(Qt::white));
    plot.setProperty("inkColor", black);
}

// Returns the number of pixels that are not white.
int filledIn(const QImage& image, const QRect& area)
{
    return area.width() * area.height() - test::inkIn(image, area, Qt::white);
}

} // namespace

class TestRegimePlot : public QObject {
    Q_OBJECT
private slots:
    void regionEndsAtItsCurve();
    void linesAndMarksStandAtTheirLengths();
    void fingerAndMappingAgree();
    void scaleIncludesTheRecipe();
    void nothingIsKnown();
};

void TestRegimePlot::regionEndsAtItsCurve()
{
    const auto map = mapOf(20, 30);
    QCOMPARE(map->limits.size(), std::size_t{2});
    RegimePlot plot;
    setUp(plot, map);
    const QImage image = test::paintItem(plot);
    int checked = 0;
    for (const profile::RegimePoint& point : map->points) {
        if (static_cast<int>(point.bagLengthMm) % 7 != 0 || point.rateBagsPerMin <= 0)
            continue;
        const QColor color = point.limit == map->limits[0] ? green : blue;
        const double x = plot.xOfLength(point.bagLengthMm);
        QVERIFY2(test::inkIn(image, test::around(x, plot.yOfRate(point.rateBagsPerMin), 3), color) > 0,
                 qPrintable(QString::number(point.bagLengthMm)));
        ++checked;
    }
    QVERIFY(checked > 5);
    const double y = plot.yOfRate(85); // beside the grid
    QVERIFY(filledIn(image, test::around(plot.xOfLength(220), y, 4)) > 70); // inside of the region
    QVERIFY(filledIn(image, test::around(plot.xOfLength(60), y, 4)) < 10);  // the jaws do not fit
    QVERIFY(filledIn(image, test::around(plot.xOfLength(500), plot.yOfRate(150), 4)) < 10);
}

void TestRegimePlot::linesAndMarksStandAtTheirLengths()
{
    const auto map = mapOf(20, 30);
    RegimePlot plot;
    setUp(plot, map);
    plot.setProperty("marks", QVariant::fromValue(QList<double>{100, 460}));
    const QImage image = test::paintItem(plot);
    const QRectF canvas = plot.plotArea();
    for (const double length : {104.7, 377.0, 733.0}) { // L_min, h/c, L_crit
        const int x = qRound(plot.xOfLength(length));
        const QRect column(x - 1, qRound(canvas.top()) + 20, 3, qRound(canvas.height()) - 40);
        QVERIFY2(test::inkIn(image, column, black) > 60, qPrintable(QString::number(length)));
    }
    const auto markAt = [&](double length) {
        return test::inkIn(image, test::around(plot.xOfLength(length), canvas.bottom() - 2, 2), black);
    };
    QVERIFY(markAt(100) >= 4 && markAt(460) >= 4);
    QCOMPARE(markAt(560), 0);
}

void TestRegimePlot::fingerAndMappingAgree()
{
    RegimePlot plot;
    setUp(plot, mapOf(0, 0));
    for (const double length : {50.0, 250.0, 700.0})
        QVERIFY(std::abs(plot.lengthOfX(plot.xOfLength(length)) - length) < 1e-6);
    QVERIFY(std::abs(plot.rateOfY(plot.yOfRate(123)) - 123) < 1e-6);
    // Outside of the canvas the finger stays at its edge.
    const QRectF canvas = plot.plotArea();
    QCOMPARE(plot.lengthOfX(-100), plot.lengthOfX(canvas.left()));
    QCOMPARE(plot.rateOfY(1e4), 0.0);
}

void TestRegimePlot::scaleIncludesTheRecipe()
{
    RegimePlot plot;
    setUp(plot, mapOf(20, 30));
    QVERIFY(plot.yOfRate(580) < plot.plotArea().top());
    plot.setProperty("shownRate", 580.0);
    QVERIFY(plot.yOfRate(580) >= plot.plotArea().top());
}

void TestRegimePlot::nothingIsKnown()
{
    RegimePlot plot;
    setUp(plot, nullptr);
    plot.setProperty("map", QVariant());
    const QImage image = test::paintItem(plot);
    QCOMPARE(test::inkIn(image, image.rect(), green), 0);
}

CAMPANEL_TEST(TestRegimePlot)

} // namespace campanel::plot::test_regime_plot

#include "test_regime_plot.moc"
