// SPDX-License-Identifier: Apache-2.0
// The map of a calibration: its fit, composition and text. The numbers were computed with rational numbers in
// Python, by elimination in the full normal equations.
#include "app/panel/display/touch_matrix.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <random>

namespace test_touch_matrix {

using namespace Qt::StringLiterals;
using namespace campanel::panel;

namespace {

const QList<QPointF> crosses{{0.1, 0.1}, {0.8, 0.1}, {0.8, 0.9}, {0.1, 0.9}};

QList<TouchPair> pairsOf(const QList<QPointF>& touched)
{
    QList<TouchPair> pairs;
    for (qsizetype i = 0; i < touched.size(); ++i)
        pairs << TouchPair{touched[i], crosses[i]};
    return pairs;
}

bool areClose(const TouchMatrix& one, const TouchMatrix& other, double tolerance)
{
    for (std::size_t i = 0; i < one.size(); ++i) {
        if (std::abs(one[i] - other[i]) > tolerance)
            return false;
    }
    return true;
}

} // namespace

class TestTouchMatrix : public QObject {
    Q_OBJECT

private slots:
    void leastSquares_data()
    {
        QTest::addColumn<QList<QPointF>>("touched");
        QTest::addColumn<QString>("expected");
        QTest::newRow("offset")
            << QList<QPointF>{{0.13, 0.08}, {0.81, 0.085}, {0.812, 0.902}, {0.128, 0.9}}
            << u"1.026384111 0.000004628 -0.032402808 -0.005009606 0.977394351 0.021720843"_s;
        QTest::newRow("inverted")
            << QList<QPointF>{{0.9, 0.91}, {0.21, 0.9}, {0.2, 0.105}, {0.905, 0.1}}
            << u"-1.003478380 0.003037872 1.004145825 0.003456775 -0.996807823 1.000227751"_s;
        QTest::newRow("turned") << QList<QPointF>{{0.9, 0.1}, {0.9, 0.8}, {0.1, 0.8}, {0.1, 0.1}}
                                << u"0 1 0 -1 0 1"_s;
    }
    void leastSquares()
    {
        QFETCH(QList<QPointF>, touched);
        QFETCH(QString, expected);
        const auto fit = fitTouches(pairsOf(touched));
        QVERIFY(fit);
        QVERIFY2(areClose(*fit, *matrixIn(expected), 1e-9), qPrintable(matrixText(*fit)));
    }

    void anExactMapIsFound()
    {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> small(-0.2, 0.2);
        for (int i = 0; i < 1000; ++i) {
            TouchMatrix wanted = plainTouch;
            for (double& number : wanted)
                number += small(random);
            // Touches whose map gives the crosses, by Cramer's rule.
            const double area = wanted[0] * wanted[4] - wanted[1] * wanted[3];
            QList<QPointF> touched;
            for (const QPointF& cross : crosses) {
                const double x = cross.x() - wanted[2];
                const double y = cross.y() - wanted[5];
                touched << QPointF((x * wanted[4] - y * wanted[1]) / area,
                                   (y * wanted[0] - x * wanted[3]) / area);
            }
            const auto fit = fitTouches(pairsOf(touched));
            QVERIFY(fit);
            QVERIFY2(areClose(*fit, wanted, 1e-12), qPrintable(u"case %1 of seed 7"_s.arg(i)));
        }
    }

    void badTouchesAreRefused_data()
    {
        QTest::addColumn<QList<QPointF>>("touched");
        QTest::addColumn<TouchFault>("fault");
        QTest::newRow("one missed by 8 %")
            << QList<QPointF>{{0.1, 0.1}, {0.8, 0.1}, {0.72, 0.9}, {0.1, 0.9}} << TouchFault::Missed;
        QTest::newRow("two exchanged")
            << QList<QPointF>{{0.1, 0.1}, {0.8, 0.9}, {0.8, 0.1}, {0.1, 0.9}} << TouchFault::Missed;
        QTest::newRow("all at one place")
            << QList<QPointF>{{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}} << TouchFault::Implausible;
        QTest::newRow("all on a line")
            << QList<QPointF>{{0.1, 0.5}, {0.8, 0.5}, {0.8, 0.5}, {0.1, 0.5}} << TouchFault::Implausible;
        QTest::newRow("a third of the screen")
            << QList<QPointF>{{0.4, 0.4}, {0.63, 0.4}, {0.63, 0.67}, {0.4, 0.67}} << TouchFault::Implausible;
    }
    void badTouchesAreRefused()
    {
        QFETCH(QList<QPointF>, touched);
        QFETCH(TouchFault, fault);
        const auto fit = fitTouches(pairsOf(touched));
        QVERIFY(!fit);
        QCOMPARE(fit.error(), fault);
    }

    void theSecondMapComesAfterTheFirst()
    {
        const TouchMatrix second{1.1, 0.02, -0.05, 0.01, 0.95, 0.03};
        const TouchMatrix turned{0, -1, 1, 1, 0, 0};
        QVERIFY(areClose(composed(second, turned), {0.02, -1.1, 1.05, 0.95, -0.01, 0.04}, 1e-15));
        const QPointF place(0.3, 0.7);
        const QPointF distance =
            mapped(composed(second, turned), place) - mapped(second, mapped(turned, place));
        QVERIFY(std::hypot(distance.x(), distance.y()) < 1e-15);
    }

    void textAndBack()
    {
        const TouchMatrix matrix{1.5, -0.25, 0.125, 0, 1, -0.0625};
        QCOMPARE(matrixText(matrix), u"1.500000 -0.250000 0.125000 0.000000 1.000000 -0.062500"_s);
        QCOMPARE(matrixIn(matrixText(matrix)), std::optional(matrix));
        QCOMPARE(matrixIn(u"0 1 0 -1 0 1"_s), (std::optional(TouchMatrix{0, 1, 0, -1, 0, 1})));
        for (const QString& bad : {u""_s, u"none"_s, u"1 0 0 0 1"_s, u"1 0 0 0 1 nan"_s, u"1 0 0 0 1 0 0"_s})
            QVERIFY2(!matrixIn(bad), qPrintable(bad));
        QVERIFY(isUsable(matrix));
        QVERIFY(!isUsable({1, 0, 4, 0, 1, 0}));
        QVERIFY(!isUsable({0.3, 0, 0, 0, 0.3, 0}));
    }
};

CAMPANEL_TEST(TestTouchMatrix)

} // namespace test_touch_matrix

#include "test_touch_matrix.moc"
