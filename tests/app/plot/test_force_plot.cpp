// SPDX-License-Identifier: Apache-2.0
// The ink of ForcePlot: curve, gate, axes.
#include "samples.h"

#include "app/plot/force_plot.h"
#include "tests/support/test_program.h"

#include <QRegularExpression>
#include <QTest>

#include <limits>

namespace campanel::plot::test_force_plot {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const QColor blue(0, 0, 255);
const QColor red(255, 0, 0);

void setUp(ForcePlot& plot)
{
    plot.setSize({400, 300});
    plot.setProperty("curveColor", blue);
    plot.setProperty("gateColor", red);
    plot.setProperty("lineWidth", 3.0);
}

void setCurve(ForcePlot& plot, const QList<QPointF>& points)
{
    plot.setProperty("curve", QVariant::fromValue(points));
}

} // namespace

class TestForcePlot : public QObject {
    Q_OBJECT
private slots:
    void curveIsWhereItsPointsAre();
    void gateStandsAtThePressPosition();
    void gateIsInSightWithoutACurve();
    void whatLiesBeforeTheAxisIsNotShown();
    void everyPointIsInSight();
    void brokenPointsAreLeftOut();
    void nothingIsKnown();
};

void TestForcePlot::curveIsWhereItsPointsAre()
{
    ForcePlot plot;
    setUp(plot);
    setCurve(plot, {{60, 0}, {80, 1000}, {100, 4000}});
    const QImage image = test::paintItem(plot);
    QVERIFY(test::inkIn(image, test::around(plot.xOfPosition(80), plot.yOfForce(1000), 2), blue) > 8);
    // Half of the way between two points, half of the force.
    QVERIFY(test::inkIn(image, test::around(plot.xOfPosition(90), plot.yOfForce(2500), 2), blue) > 8);
    QCOMPARE(test::inkIn(image, test::around(plot.xOfPosition(70), plot.yOfForce(3000), 20), blue), 0);
    QVERIFY(plot.xOfPosition(100) > plot.xOfPosition(60) + 200);
    QVERIFY(plot.yOfForce(4000) < plot.yOfForce(0) - 100);
}

void TestForcePlot::gateStandsAtThePressPosition()
{
    ForcePlot plot;
    setUp(plot);
    setCurve(plot, {{60, 0}, {100, 3000}});
    plot.setProperty("gatePosition", 100.0);
    plot.setProperty("gateLow", 1000.0);
    plot.setProperty("gateHigh", 6000.0);
    const QImage image = test::paintItem(plot);
    const double x = plot.xOfPosition(100);
    QVERIFY(test::inkIn(image, test::around(x - 6, plot.yOfForce(1000), 1), red) >= 6);
    QVERIFY(test::inkIn(image, test::around(x - 6, plot.yOfForce(6000), 1), red) >= 6);
    QVERIFY(test::inkIn(image, test::around(x, plot.yOfForce(5000), 2), red) >= 8);
    QCOMPARE(test::inkIn(image, test::around(x - 6, plot.yOfForce(5000), 2), red), 0);
    QVERIFY2(plot.yOfForce(6000) >= 0, "the upper end is inside of the item");
}

void TestForcePlot::gateIsInSightWithoutACurve()
{
    ForcePlot plot;
    setUp(plot);
    plot.setProperty("fromPosition", 60.0);
    plot.setProperty("gatePosition", 100.0);
    plot.setProperty("gateLow", 1000.0);
    plot.setProperty("gateHigh", 6000.0);
    const QImage image = test::paintItem(plot);
    QVERIFY(test::inkIn(image, image.rect(), red) > 100);
    QCOMPARE(test::inkIn(image, image.rect(), blue), 0);
    QVERIFY(plot.xOfPosition(100) <= 400);
    QVERIFY(plot.xOfPosition(60) >= 0);
}

void TestForcePlot::whatLiesBeforeTheAxisIsNotShown()
{
    ForcePlot plot;
    setUp(plot);
    plot.setProperty("fromPosition", 60.0);
    setCurve(plot, {{0, 0}, {60, 0}, {100, 3000}});
    const QImage image = test::paintItem(plot);
    QVERIFY(test::inkIn(image, image.rect(), blue) > 300);
    const int left = qFloor(plot.xOfPosition(60)) - 4;
    QCOMPARE(test::inkIn(image, QRect(0, 0, left, 300), blue), 0);
}

void TestForcePlot::everyPointIsInSight()
{
    ForcePlot plot;
    setUp(plot);
    plot.setProperty("gatePosition", 100.0);
    plot.setProperty("gateLow", 1000.0);
    plot.setProperty("gateHigh", 6000.0);
    setCurve(plot, {{60, 0}, {104, 9000}, {60, 0}}); // beyond the gate, and back
    const QImage image = test::paintItem(plot);
    QVERIFY(test::inkIn(image, test::around(plot.xOfPosition(104), plot.yOfForce(9000), 3), blue) > 4);
}

void TestForcePlot::brokenPointsAreLeftOut()
{
    ForcePlot plot;
    setUp(plot);
    setCurve(plot, {{60, 0}, {nan, 5}, {80, nan}, {100, 4000}});
    const QImage image = test::paintItem(plot);
    QVERIFY(test::inkIn(image, test::around(plot.xOfPosition(80), plot.yOfForce(2000), 2), blue) > 8);
}

void TestForcePlot::nothingIsKnown()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
    ForcePlot plot;
    setUp(plot);
    plot.setProperty("gridColor", QColor(Qt::green));
    const QImage image = test::paintItem(plot);
    QCOMPARE(test::inkIn(image, image.rect(), red) + test::inkIn(image, image.rect(), blue), 0);
    QVERIFY(test::inkIn(image, image.rect(), Qt::green) > 300);
}

CAMPANEL_TEST(TestForcePlot)

} // namespace campanel::plot::test_force_plot

#include "test_force_plot.moc"
