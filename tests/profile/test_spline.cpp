// SPDX-License-Identifier: Apache-2.0
// Splines against scipy's CubicSpline (spline_golden.txt, made by make_spline_golden.py), and the properties
// of a spline: through its knots, twice continuously differentiable, correct at its ends.
#include "profile/cam/spline.h"
#include "tests/support/places.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTest>
#include <QTextStream>

#include <cmath>
#include <random>

namespace test_spline {

using namespace campanel::profile;

namespace {

struct GoldenPoint {
    double x = 0;
    SplinePoint point;
};

struct GoldenCase {
    QString name;
    SplineEnds ends = SplineEnds::Natural;
    EndSlopes slopes;
    std::vector<double> x;
    std::vector<double> y;
    std::vector<GoldenPoint> points;
};

std::vector<double> numbers(QTextStream& in)
{
    std::vector<double> values;
    for (const QString& field : in.readLine().split(u' '))
        values.push_back(field.toDouble());
    return values;
}

std::vector<GoldenCase> goldenCases()
{
    std::vector<GoldenCase> cases;
    QFile file(campanel::test::sourcePath("tests/profile/spline_golden.txt"));
    if (!file.open(QIODevice::ReadOnly | QIODevice::Text))
        return cases;
    QTextStream in(&file);
    while (!in.atEnd()) {
        const QStringList header = in.readLine().split(u' ');
        GoldenCase golden;
        golden.name = header.at(1);
        golden.ends = header.at(2) == u"natural"
                          ? SplineEnds::Natural
                          : (header.at(2) == u"clamped" ? SplineEnds::Clamped : SplineEnds::Periodic);
        golden.slopes = {header.at(3).toDouble(), header.at(4).toDouble()};
        for (int i = 0; i < header.at(5).toInt(); ++i) {
            const std::vector<double> knot = numbers(in);
            golden.x.push_back(knot.at(0));
            golden.y.push_back(knot.at(1));
        }
        for (int i = 0; i < header.at(6).toInt(); ++i) {
            const std::vector<double> v = numbers(in);
            golden.points.push_back({v.at(0), {v.at(1), v.at(2), v.at(3), v.at(4)}});
        }
        cases.push_back(golden);
    }
    return cases;
}

bool near(double actual, double expected, double tolerance)
{
    return std::abs(actual - expected) <= tolerance * std::max(1.0, std::abs(expected));
}

SplinePoint endOf(const Spline& spline)
{
    const SplinePiece& last = spline.pieces().back();
    return last.at(last.end());
}

} // namespace

class TestSpline : public QObject {
    Q_OBJECT

private slots:
    void agreesWithScipy_data();
    void agreesWithScipy();
    void isTwiceDifferentiable();
    void endsAreAsAsked();
    void minKnots();
    void unitSpacing();
    void continuesOutside();
};

void TestSpline::agreesWithScipy_data()
{
    QTest::addColumn<int>("index");
    const std::vector<GoldenCase> cases = goldenCases();
    QCOMPARE(cases.size(), std::size_t{11});
    for (std::size_t i = 0; i < cases.size(); ++i)
        QTest::newRow(qPrintable(cases[i].name)) << static_cast<int>(i);
}

void TestSpline::agreesWithScipy()
{
    QFETCH(int, index);
    const GoldenCase golden = goldenCases().at(static_cast<std::size_t>(index));
    QVERIFY(golden.points.size() >= 20);
    const Spline spline(golden.x, golden.y, golden.ends, golden.slopes);
    // To 1e-9 of the largest value of each derivative.
    SplinePoint most;
    for (const GoldenPoint& g : golden.points) {
        most.value = std::max(most.value, std::abs(g.point.value));
        most.slope = std::max(most.slope, std::abs(g.point.slope));
        most.curvature = std::max(most.curvature, std::abs(g.point.curvature));
        most.third = std::max(most.third, std::abs(g.point.third));
    }
    for (const GoldenPoint& g : golden.points) {
        const SplinePoint p = spline.at(g.x);
        QVERIFY(std::abs(p.value - g.point.value) <= 1e-9 * most.value);
        QVERIFY(std::abs(p.slope - g.point.slope) <= 1e-9 * most.slope);
        QVERIFY(std::abs(p.curvature - g.point.curvature) <= 1e-9 * most.curvature);
        QVERIFY(std::abs(p.third - g.point.third) <= 1e-9 * most.third);
    }
}

void TestSpline::isTwiceDifferentiable()
{
    constexpr unsigned seed = 271828;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> gap(0.1, 10);
    std::uniform_real_distribution<double> height(-100, 100);
    for (int round = 0; round < 300; ++round) {
        std::vector<double> x{0};
        std::vector<double> y{height(random)};
        for (int i = 0; i < 3 + round; ++i) {
            x.push_back(x.back() + gap(random));
            y.push_back(height(random));
        }
        const auto ends = static_cast<SplineEnds>(round % 3);
        const Spline spline(x, y, ends, {1, -2});
        const auto pieces = spline.pieces();
        QCOMPARE(pieces.size(), x.size() - 1);
        // Curvatures are up to 100 / 0.1^2.
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const SplinePoint end = pieces[i].at(x[i + 1]);
            QCOMPARE(pieces[i].at0.value, y[i]);
            QVERIFY(near(end.value, y[i + 1], 1e-10));
            if (i + 1 == pieces.size())
                break;
            QVERIFY(near(end.slope, pieces[i + 1].at0.slope, 1e-9));
            QVERIFY(near(end.curvature, pieces[i + 1].at0.curvature, 1e-8));
        }
    }
}

void TestSpline::endsAreAsAsked()
{
    const std::vector<double> x{0, 60, 150, 200, 290, 360};
    const std::vector<double> y{0, 80, 140, 230, 300, 377};
    const Spline natural(x, y, SplineEnds::Natural);
    QVERIFY(std::abs(natural.pieces().front().at0.curvature) < 1e-15);
    QVERIFY(std::abs(endOf(natural).curvature) < 1e-14);
    const Spline clamped(x, y, SplineEnds::Clamped, {0.5, -3});
    QVERIFY(near(clamped.pieces().front().at0.slope, 0.5, 1e-15));
    QVERIFY(near(endOf(clamped).slope, -3, 1e-13));
    const Spline periodic(x, y, SplineEnds::Periodic);
    QVERIFY(near(periodic.pieces().front().at0.slope, endOf(periodic).slope, 1e-13));
    QVERIFY(std::abs(periodic.pieces().front().at0.curvature - endOf(periodic).curvature) < 1e-14);
    // A straight line is its own periodic spline, with a net advance.
    const Spline line(std::vector<double>{0, 1, 3, 4}, std::vector<double>{5, 7, 11, 13},
                      SplineEnds::Periodic);
    QVERIFY(near(line.at(2.2).value, 9.4, 1e-14));
    QVERIFY(near(line.at(0).slope, 2, 1e-14));
}

void TestSpline::minKnots()
{
    const std::vector<double> x{1, 3};
    const std::vector<double> y{4, 10};
    QVERIFY(near(Spline(x, y, SplineEnds::Natural).at(2).value, 7, 1e-14));
    QVERIFY(near(Spline(x, y, SplineEnds::Periodic).at(2).slope, 3, 1e-14));
    // Rest to rest: the cubic 2-3 with its mean speed times 1.5.
    QVERIFY(near(Spline(x, y, SplineEnds::Clamped).at(2).slope, 4.5, 1e-14));
    // y = x^3 is its own clamped spline.
    const Spline cube(std::vector<double>{-1, 0, 2}, std::vector<double>{-1, 0, 8}, SplineEnds::Clamped,
                      {3, 12});
    QVERIFY(near(cube.at(1).value, 1, 1e-13));
    QVERIFY(near(cube.at(-0.5).third, 6, 1e-13));
}

void TestSpline::unitSpacing()
{
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i < 50; ++i) {
        x.push_back(i);
        y.push_back(std::sin(i * i));
    }
    for (const SplineEnds ends : {SplineEnds::Natural, SplineEnds::Clamped, SplineEnds::Periodic}) {
        const std::vector<double> given = splineSlopes(x, y, ends, {1, -2});
        const std::vector<double> unit = unitSplineSlopes(y, ends, {1, -2});
        QCOMPARE(unit.size(), y.size());
        for (std::size_t i = 0; i < y.size(); ++i)
            QVERIFY(std::abs(unit[i] - given[i]) < 1e-13);
    }
}

void TestSpline::continuesOutside()
{
    const Spline cube(std::vector<double>{-1, 0, 2}, std::vector<double>{-1, 0, 8}, SplineEnds::Clamped,
                      {3, 12});
    QVERIFY(near(cube.at(-2).value, -8, 1e-12));
    QVERIFY(near(cube.at(3).value, 27, 1e-12));
}

CAMPANEL_TEST(TestSpline)

} // namespace test_spline

#include "test_spline.moc"
