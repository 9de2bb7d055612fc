// SPDX-License-Identifier: Apache-2.0
// The delay behind a master by cuts at two speeds, against the raw normal equations in exact fractions.
#include "app/program/master_delay.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_master_delay {

using campanel::program::MasterDelay;

namespace {

// Pairs lag = 0.1 mm + 2.5 ms x speed, and a wave of `waveMm`.
void cut(MasterDelay& delay, double speed, int cuts, double waveMm = 0)
{
    for (int k = 0; k < cuts; ++k)
        delay.add(speed + 0.01 * k, 0.1 + 0.0025 * (speed + 0.01 * k) + waveMm * std::sin(1.7 * k));
}

} // namespace

class TestMasterDelay : public QObject {
    Q_OBJECT

private slots:
    void measuresNothingAtOneSpeed();
    void findsTheSlope();
    void tellsItsMargin();
    void offersNothingThatIsUncertainOrEqual();
    void staysInTheRange();
};

void TestMasterDelay::measuresNothingAtOneSpeed()
{
    MasterDelay delay;
    QVERIFY(!delay.hasOneSpeed());
    cut(delay, 250, 40);
    QVERIFY(delay.hasOneSpeed());
    QVERIFY(!delay.measured());
    cut(delay, 280, 40); // less than a fifth faster
    QVERIFY(!delay.measured());
    cut(delay, 320, MasterDelay::minCuts - 1);
    QVERIFY(!delay.measured());
    cut(delay, 320, 1);
    QVERIFY(delay.measured());
}

void TestMasterDelay::findsTheSlope()
{
    MasterDelay delay;
    cut(delay, 250, 20);
    cut(delay, 320, 20);
    QVERIFY(std::abs(delay.measured()->ms - 2.5) < 1e-9);
    QVERIFY(std::abs(delay.offered(1.0).value() - 3.5) < 1e-9);
    delay.add(0, 5); // a line that stands has no cut
    QCOMPARE(delay.cuts(), 40);
}

// By Python: the raw sums of the normal equations in fractions.Fraction.
void TestMasterDelay::tellsItsMargin()
{
    MasterDelay delay;
    cut(delay, 250, 20, 0.05);
    cut(delay, 320, 20, 0.05);
    QVERIFY(std::abs(delay.measured()->ms - 2.499942806) < 1e-6);
    QVERIFY(std::abs(delay.measured()->marginMs - 0.162352628) < 1e-6);
}

void TestMasterDelay::offersNothingThatIsUncertainOrEqual()
{
    MasterDelay wild;
    cut(wild, 250, 20, 0.5);
    cut(wild, 320, 20, 0.5);
    QVERIFY(wild.measured()->marginMs > MasterDelay::maxMarginMs);
    QVERIFY(!wild.offered(1.0));
    MasterDelay exact;
    for (int k = 0; k < 20; ++k) {
        exact.add(250, 0.2);
        exact.add(320, 0.2);
    }
    QVERIFY(exact.measured()->marginMs > 0);
    QVERIFY(!exact.offered(1.0));
}

void TestMasterDelay::staysInTheRange()
{
    MasterDelay delay;
    for (int k = 0; k < 20; ++k) {
        delay.add(250, -0.25);
        delay.add(350, -0.35);
    }
    QCOMPARE(delay.offered(0.5).value(), 0.0);
    QVERIFY(!delay.offered(0.0));
}

CAMPANEL_TEST(TestMasterDelay)

} // namespace test_master_delay

#include "test_master_delay.moc"
