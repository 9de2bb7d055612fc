// SPDX-License-Identifier: Apache-2.0
// The ink of KnifeDial and BagChart.
#include "samples.h"

#include "app/plot/bag_chart.h"
#include "app/plot/knife_dial.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>

namespace campanel::plot::test_dial_and_bags {

namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const QColor blue(0, 0, 255);
const QColor red(255, 0, 0);
} // namespace

class TestDialAndBags : public QObject {
    Q_OBJECT
private slots:
    void tipPointsTheRightWay_data();
    void tipPointsTheRightWay();
    void unknownAngleHasNoHand();
    void syncArcMayPassTheTop();
    void staleHandIsGrey();
    void bagsAreBetweenTheLines();
    void bagsOutOfToleranceStandOut();
    void chartOfNothing();
};

void TestDialAndBags::tipPointsTheRightWay_data()
{
    QTest::addColumn<double>("angle");
    QTest::addColumn<QPointF>("tip");
    QTest::newRow("top") << 0.0 << QPointF(100, 13);
    QTest::newRow("right") << 90.0 << QPointF(187, 100);
    QTest::newRow("bottom") << 180.0 << QPointF(100, 187);
    QTest::newRow("left, second turn") << 630.0 << QPointF(13, 100);
    QTest::newRow("backwards") << -90.0 << QPointF(13, 100);
}

void TestDialAndBags::tipPointsTheRightWay()
{
    QFETCH(double, angle);
    QFETCH(QPointF, tip);
    KnifeDial dial;
    dial.setSize({200, 200});
    dial.setProperty("tipColor", blue);
    dial.setAngleDeg(angle);
    const QImage image = test::paintItem(dial);
    QVERIFY(test::inkIn(image, test::around(tip.x(), tip.y(), 4), blue) == 81);
    // The whole tip is inside the item.
    const int total = test::inkIn(image, image.rect(), blue);
    QVERIFY2(total > 280 && total < 420, qPrintable(QString::number(total)));
}

void TestDialAndBags::unknownAngleHasNoHand()
{
    KnifeDial dial;
    dial.setSize({200, 200});
    dial.setProperty("tipColor", blue);
    dial.setProperty("handColor", red);
    const QImage image = test::paintItem(dial);
    QCOMPARE(test::inkIn(image, image.rect(), blue), 0);
    QCOMPARE(test::inkIn(image, image.rect(), red), 0);
    QVERIFY(test::inkIn(image, image.rect(), Qt::lightGray) > 3000);
}

void TestDialAndBags::syncArcMayPassTheTop()
{
    KnifeDial dial;
    dial.setSize({200, 200});
    dial.setProperty("syncColor", red);
    dial.setSyncStartDeg(330);
    dial.setSyncEndDeg(30);
    const QImage image = test::paintItem(dial);
    QVERIFY(test::inkIn(image, test::around(100, 13, 2), red) == 25);
    QCOMPARE(test::inkIn(image, QRect(0, 100, 200, 100), red), 0);
}

void TestDialAndBags::staleHandIsGrey()
{
    KnifeDial dial;
    dial.setSize({200, 200});
    dial.setProperty("tipColor", blue);
    dial.setProperty("staleColor", red);
    dial.setAngleDeg(45);
    dial.setProperty("stale", true);
    const QImage image = test::paintItem(dial);
    QCOMPARE(test::inkIn(image, image.rect(), blue), 0);
    QVERIFY(test::inkIn(image, image.rect(), red) > 300);
}

void TestDialAndBags::bagsAreBetweenTheLines()
{
    BagChart chart;
    chart.setSize({300, 100});
    chart.setTolerance(1.0);
    chart.setProperty("pointColor", blue);
    chart.setProperty("toleranceColor", red);
    chart.setProperty("values", QVariant::fromValue(QList<double>{9.0} + QList<double>(57, nan) +
                                                    QList<double>{0.0, nan, 0.5}));
    const QImage image = test::paintItem(chart);
    // Only the newest 60 are drawn; 0.8 of half the height is the tolerance.
    QCOMPARE(test::inkIn(image, QRect(0, 0, 100, 100), blue), 0);
    QVERIFY(test::inkIn(image, test::around(284, 50, 2), blue) > 15);
    QVERIFY(test::inkIn(image, test::around(294, 30, 2), blue) > 15);
    QCOMPARE(test::inkIn(image, QRect(100, 0, 100, 100), blue), 0);
    QVERIFY(test::inkIn(image, QRect(0, 8, 300, 4), red) > 150);
    QVERIFY(test::inkIn(image, QRect(0, 88, 300, 4), red) > 150);
}

void TestDialAndBags::bagsOutOfToleranceStandOut()
{
    BagChart chart;
    chart.setSize({300, 100});
    chart.setTolerance(1.0);
    chart.setProperty("violationColor", red);
    chart.setProperty("toleranceColor", QColor(Qt::green));
    chart.setProperty("values", QVariant::fromValue(QList<double>{0.0, -3.0, 0.1}));
    const QImage image = test::paintItem(chart);
    QVERIFY(test::inkIn(image, QRect(0, 50, 300, 50), red) > 20);
    QCOMPARE(test::inkIn(image, QRect(0, 0, 300, 50), red), 0);
}

void TestDialAndBags::chartOfNothing()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
    BagChart chart;
    chart.setSize({300, 100});
    chart.setProperty("gridColor", red);
    const QImage image = test::paintItem(chart);
    QVERIFY(test::inkIn(image, QRect(0, 49, 300, 3), red) >= 300);
}

CAMPANEL_TEST(TestDialAndBags)

} // namespace campanel::plot::test_dial_and_bags

#include "test_dial_and_bags.moc"
