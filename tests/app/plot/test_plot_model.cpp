// SPDX-License-Identifier: Apache-2.0
// The model of the plots before painting: decimation, scales, quantities.
#include "samples.h"

#include "app/plot/decimation.h"
#include "app/plot/picture/axis_scale.h"
#include "app/plot/picture/label_draw.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace campanel::plot::test_plot_model {

class TestPlotModel : public QObject {
    Q_OBJECT
private slots:
    void shortCurvesStayAsTheyAre();
    void decimationKeepsExtremaAndEnds();
    void decimationLeavesOutWhatIsNotFinite();
    void decimationKeepsSteps();
    void scaleIsRound_data();
    void scaleIsRound();
    void zeroKeepsItsTick();
    void scaleAlwaysShowsTheDataWithThreeOrFourTicks();
    void scaleStaysWhileDataMovesALittle();
    void scaleFollowsDataThatShrinksALot();
    void decimals_data();
    void decimals();
    void numbersAreLocal();
    void unknownValuesAreNoCurves();
    void valuesAreInterpolatedInTheUnitOnScreen();
};

void TestPlotModel::shortCurvesStayAsTheyAre()
{
    const std::vector<double> x{0, 1, 2};
    const std::vector<double> y{5, -1, 7};
    QCOMPARE(decimate(x, y, 10, 2.0), QPolygonF({{0, 10}, {1, -2}, {2, 14}}));
}

void TestPlotModel::decimationKeepsExtremaAndEnds()
{
    const unsigned seed = std::random_device{}();
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> length(5, 20000);
    std::uniform_int_distribution<int> limit(4, 1000);
    std::normal_distribution<double> noise(0, 100);
    for (int round = 0; round < 200; ++round) {
        const int count = length(random);
        const int maximum = limit(random);
        std::vector<double> x;
        std::vector<double> y;
        for (int i = 0; i < count; ++i) {
            x.push_back(i * 1e-3);
            y.push_back(noise(random));
        }
        const QPolygonF reduced = decimate(x, y, maximum);
        QVERIFY(reduced.size() <= maximum);
        QCOMPARE(reduced.first(), QPointF(x.front(), y.front()));
        QCOMPARE(reduced.last(), QPointF(x.back(), y.back()));
        const auto byY = [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); };
        const auto [lowest, highest] = std::minmax_element(reduced.cbegin(), reduced.cend(), byY);
        QCOMPARE(lowest->y(), *std::ranges::min_element(y));
        QCOMPARE(highest->y(), *std::ranges::max_element(y));
        QVERIFY(std::ranges::is_sorted(reduced, {}, &QPointF::x));
    }
}

void TestPlotModel::decimationLeavesOutWhatIsNotFinite()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const std::vector<double> x{0, 1, 2, nan, 4};
    const std::vector<double> y{1, nan, inf, 3, 4};
    QCOMPARE(decimate(x, y, 4), QPolygonF({{0, 1}, {4, 4}}));
    QVERIFY(decimate({}, {}, 4).isEmpty());
}

void TestPlotModel::decimationKeepsSteps()
{
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i <= 4000; ++i) {
        x.push_back(i);
        y.push_back(i < 2000 ? 0 : 1);
    }
    const QPolygonF reduced = decimate(x, y, 100);
    // Nothing between the levels, and the step moves by at most one section.
    for (const QPointF& point : reduced) {
        QVERIFY(point.y() == 0 || point.y() == 1);
        QCOMPARE(point.y(), point.x() < 2000 ? 0.0 : 1.0);
    }
}

void TestPlotModel::scaleIsRound_data()
{
    QTest::addColumn<double>("minimum");
    QTest::addColumn<double>("maximum");
    QTest::addColumn<double>("lower");
    QTest::addColumn<double>("upper");
    QTest::newRow("velocity of the drawings") << 250.0 << 445.0 << 200.0 << 500.0;
    QTest::newRow("acceleration") << -1.95 << 1.95 << -2.0 << 2.0;
    QTest::newRow("ends on round numbers") << 200.0 << 500.0 << 200.0 << 500.0;
    QTest::newRow("rounding noise beyond the end") << 200.0 << 500.0 + 1e-9 << 200.0 << 500.0;
    QTest::newRow("flat") << 400.0 << 400.0 << 200.0 << 600.0;
    QTest::newRow("zero") << 0.0 << 0.0 << -0.01 << 0.01;
}

void TestPlotModel::scaleIsRound()
{
    QFETCH(double, minimum);
    QFETCH(double, maximum);
    AxisScale scale;
    QVERIFY(scale.fit(minimum, maximum, 0.01));
    QTEST(scale.lower(), "lower");
    QTEST(scale.upper(), "upper");
}

void TestPlotModel::zeroKeepsItsTick()
{
    for (const auto& [minimum, maximum] :
         {std::pair{-15.0, 55.0}, {-55.0, 15.0}, {-40.0, 40.0}, {-1.0, 2.9}}) {
        AxisScale scale;
        scale.fit(minimum, maximum, 0.01);
        QVERIFY2(scale.division().ticks(QwtScaleDiv::MajorTick).contains(0.0),
                 qPrintable(QStringLiteral("%1..%2").arg(minimum).arg(maximum)));
    }
}

void TestPlotModel::scaleAlwaysShowsTheDataWithThreeOrFourTicks()
{
    const unsigned seed = std::random_device{}();
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> exponent(-2, 6);
    std::uniform_real_distribution<double> unit(-1, 1);
    AxisScale scale;
    for (int round = 0; round < 20000; ++round) {
        const double size = std::pow(10, exponent(random));
        const double a = size * unit(random);
        const double b = size * unit(random);
        const double minimum = std::min(a, b);
        const double maximum = std::max(a, b);
        scale.fit(minimum, maximum, 1e-3);
        const double slack = 1e-5 * (scale.upper() - scale.lower());
        QVERIFY2(scale.lower() <= minimum + slack && scale.upper() >= maximum - slack,
                 qPrintable(QStringLiteral("%1..%2").arg(minimum).arg(maximum)));
        const auto ticks = scale.division().ticks(QwtScaleDiv::MajorTick).size();
        QVERIFY2(ticks == 3 || ticks == 4,
                 qPrintable(QStringLiteral("%1..%2: %3").arg(minimum).arg(maximum).arg(ticks)));
    }
}

void TestPlotModel::scaleStaysWhileDataMovesALittle()
{
    AxisScale scale;
    QVERIFY(scale.fit(250, 445, 0.01));
    for (double top = 445; top <= 500; top += 1) {
        QVERIFY(!scale.fit(250, top, 0.01));
    }
    QVERIFY(scale.fit(250, 520, 0.01));
    const double upper = scale.upper();
    QVERIFY(upper >= 520);
    // Back over the limit: the scale does not alternate.
    for (int i = 0; i < 10; ++i) {
        QVERIFY(!scale.fit(250, i % 2 ? 499 : 501, 0.01));
    }
    QCOMPARE(scale.upper(), upper);
}

void TestPlotModel::scaleFollowsDataThatShrinksALot()
{
    AxisScale scale;
    QVERIFY(scale.fit(0, 1000, 0.01));
    QVERIFY(scale.fit(0, 300, 0.01));
    QVERIFY(scale.upper() < 500);
    // After reset() the previous scale has no influence.
    QVERIFY(scale.fit(0, 400, 0.01) || scale.upper() >= 400);
    scale.reset();
    QVERIFY(scale.fit(0, 300, 0.01));
    QCOMPARE(scale.upper(), 300.0);
}

void TestPlotModel::decimals_data()
{
    QTest::addColumn<double>("step");
    QTest::addColumn<int>("digits");
    QTest::newRow("200") << 200.0 << 0;
    QTest::newRow("1") << 1.0 << 0;
    QTest::newRow("0.5") << 0.5 << 1;
    QTest::newRow("0.1") << 0.1 << 1;
    QTest::newRow("0.02") << 0.02 << 2;
    QTest::newRow("none") << 0.0 << 0;
}

void TestPlotModel::decimals()
{
    QFETCH(double, step);
    QTEST(decimalsOfStep(step), "digits");
}

void TestPlotModel::numbersAreLocal()
{
    QCOMPARE(localNumber(QLocale(QStringLiteral("en_US")), -1.5, 1), QStringLiteral("\u22121.5"));
    QCOMPARE(localNumber(QLocale(QStringLiteral("de_DE")), -1.5, 1), QStringLiteral("\u22121,5"));
    QCOMPARE(localNumber(QLocale(QStringLiteral("zh_CN")), 0.25, 2), QStringLiteral("0.25"));
}

void TestPlotModel::unknownValuesAreNoCurves()
{
    QVERIFY(!curveSetFrom(QVariant()));
    QVERIFY(!curveSetFrom(QVariant(QStringLiteral("velocity"))));
    QVERIFY(!curveSetFrom(QVariant::fromValue(CurveSet())));
    auto uneven = test::makeCurves([](double) { return 1.0; });
    uneven->jerkMmPerS3.pop_back();
    QVERIFY(!curveSetFrom(QVariant::fromValue<CurveSet>(uneven)));
    QVERIFY(curveSetFrom(test::curveVariant([](double) { return 1.0; })));
    QVERIFY(!quantityByName(QStringLiteral("power")));
    QCOMPARE(quantityByName(QStringLiteral("torque")), Quantity::Torque);
    // A torque may be unknown, but not in parts.
    auto known = test::makeCurves([](double) { return 1.0; });
    const CurveSet unknown = curveSetFrom(QVariant::fromValue<CurveSet>(known));
    QVERIFY(std::isnan(valueAt(unknown, Quantity::Torque, known->timeS.front())));
    known->torqueNm.assign(known->timeS.size(), 0.25);
    QCOMPARE(
        valueAt(curveSetFrom(QVariant::fromValue<CurveSet>(known)), Quantity::Torque, known->timeS.front()),
        0.25);
    known->torqueNm.pop_back();
    QVERIFY(!curveSetFrom(QVariant::fromValue<CurveSet>(known)));
    QCOMPARE(quantityByName(QStringLiteral("frequency")), Quantity::Frequency);
}

void TestPlotModel::valuesAreInterpolatedInTheUnitOnScreen()
{
    auto curves = std::make_shared<profile::Curves>();
    curves->timeS = {0, 1, 1, 2};
    curves->positionMm = {0, 10, 10, 30};
    curves->velocityMmPerS = {10, 10, 20, 20};
    curves->accelerationMmPerS2 = {0, 2000, 4000, 4000};
    curves->jerkMmPerS3 = {0, 0, 0, 0};
    curves->frequencyHz = {0, 1000, 1000, 500};
    const CurveSet set = curves;
    QCOMPARE(valueAt(set, Quantity::Position, 1.5), 20.0);
    QCOMPARE(valueAt(set, Quantity::Acceleration, 0.5), 1.0);
    QCOMPARE(valueAt(set, Quantity::Velocity, 1.0), 20.0);
    QCOMPARE(valueAt(set, Quantity::Frequency, 2.0), 0.5);
    QVERIFY(std::isnan(valueAt(set, Quantity::Velocity, 2.1)));
    QVERIFY(std::isnan(valueAt(set, Quantity::Velocity, -0.1)));
    QVERIFY(std::isnan(valueAt(nullptr, Quantity::Velocity, 0.5)));
    QVERIFY(std::isnan(valueAt(set, Quantity::Velocity, std::numeric_limits<double>::quiet_NaN())));
}

CAMPANEL_TEST(TestPlotModel)

} // namespace campanel::plot::test_plot_model

#include "test_plot_model.moc"
