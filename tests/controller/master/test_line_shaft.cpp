// SPDX-License-Identifier: Apache-2.0
// The line's shaft that leads a simulated machine. The positions that it must have are the integrals of its
// speed on paper.
#include "line_shaft.h"
#include "simulated_controller.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

namespace test_line_shaft {

using campanel::controller::LineShaft;
using campanel::controller::ShaftOptions;

namespace {

ShaftOptions running()
{
    ShaftOptions options;
    options.counts = 10'000;
    options.speedMmPerS = 250.0;
    return options;
}

void run(LineShaft& shaft, double timeS, double stepS = 0.00025)
{
    for (int i = 0; i < std::lround(timeS / stepS); ++i)
        shaft.advance(stepS);
}

} // namespace

class TestLineShaft : public QObject {
    Q_OBJECT

private slots:
    void countsItsWay();
    void ripplesAsItIsTold();
    void rampsWhenItIsStoppedAndStarted();
    void hasAnEncoderWithFaults();
    void latchesItsCountsAtTheIndexMark();
    void keepsItsCountsWhenAFaultBegins();
    void seesIllegalTransitions();
};

void TestLineShaft::countsItsWay()
{
    LineShaft shaft(running());
    run(shaft, 1.00001, 0.00001);
    QCOMPARE(shaft.counts(), 10'000);
    QVERIFY(shaft.hasEncoder());
    QVERIFY(!LineShaft(ShaftOptions{}).hasEncoder());
}

// The mean of a whole number of waves is the speed; in between the way is off it by v R / (pi f) at most.
void TestLineShaft::ripplesAsItIsTold()
{
    ShaftOptions options = running();
    options.ripple = 0.01;
    options.rippleHz = 11.0;
    LineShaft shaft(options);
    double farthest = 0.0;
    double fastest = 0.0;
    for (int i = 1; i <= 4000; ++i) {
        shaft.advance(0.00025);
        farthest = std::max(farthest, shaft.positionMm() - 250.0 * i * 0.00025);
        fastest = std::max(fastest, shaft.speedMmPerS());
    }
    QVERIFY(std::abs(shaft.positionMm() - 250.0) < 1e-6);
    QVERIFY(std::abs(farthest - 2.5 / (std::numbers::pi * 11.0)) < 1e-4);
    QVERIFY(std::abs(fastest - 252.5) < 0.01);
    LineShaft coarse(options);
    run(coarse, 1.0, 0.002);
    QVERIFY(std::abs(coarse.positionMm() - shaft.positionMm()) < 1e-4);
}

void TestLineShaft::rampsWhenItIsStoppedAndStarted()
{
    LineShaft shaft(running()); // 250 mm/s at 500 mm/s^2: 62.5 mm in 0.5 s
    shaft.setSpeed(0.0);
    run(shaft, 2.0);
    QVERIFY(std::abs(shaft.positionMm() - 62.5) < 1e-6);
    QCOMPARE(shaft.speedMmPerS(), 0.0);
    shaft.setSpeed(-100.0);
    run(shaft, 0.2 + 0.1);
    QVERIFY(std::abs(shaft.positionMm() - (62.5 - 10.0 - 10.0)) < 1e-6);
}

void TestLineShaft::hasAnEncoderWithFaults()
{
    ShaftOptions options = running();
    options.isReversed = true;
    LineShaft reversed(options);
    run(reversed, 1.00125);
    QCOMPARE(reversed.counts(), -10'012);
    options = running();
    options.slip = 0.1;
    LineShaft slipping(options);
    run(slipping, 10.001);
    QCOMPARE(slipping.counts(), 90'009);
    options = running();
    options.lost = 3;
    LineShaft losing(options);
    run(losing, 10.00025);
    QCOMPARE(losing.counts(), 100'002 - 30);
    options = running();
    options.jitterCounts = 0.4;
    LineShaft rough(options);
    LineShaft even(running());
    int differences = 0;
    for (int i = 0; i < 4000; ++i) {
        rough.advance(0.00026);
        even.advance(0.00026);
        QVERIFY(std::abs(rough.counts() - even.counts()) <= 1);
        differences += rough.counts() != even.counts() ? 1 : 0;
    }
    QVERIFY(differences > 400 && differences < 1200); // a fifth
}

void TestLineShaft::latchesItsCountsAtTheIndexMark()
{
    LineShaft shaft(running());
    QCOMPARE(shaft.indexPasses(), 0u);
    run(shaft, 2.5);
    QCOMPARE(shaft.indexPasses(), 2u);
    QCOMPARE(shaft.indexCounts(), 20'000);
    shaft.setLost(7);
    run(shaft, 2.0);
    QCOMPARE(shaft.indexPasses(), 4u);
    QCOMPARE(shaft.indexCounts(), 40'000 - 14);
    QCOMPARE(shaft.counts(), 45'000 - 14);
    shaft.setLost(0);
    shaft.setSpeed(-250.0); // 0.5 s on, 62.5 mm, and as much back
    run(shaft, 1.0 + 0.6);
    QCOMPARE(shaft.indexPasses(), 5u);
    QCOMPARE(shaft.indexCounts(), 40'000 - 14);
}

// Earlier counts stay, later ones change.
void TestLineShaft::keepsItsCountsWhenAFaultBegins()
{
    LineShaft shaft(running());
    run(shaft, 1.20001, 0.00001);
    QCOMPARE(shaft.counts(), 12'000);
    shaft.setReversed(true);
    QCOMPARE(shaft.counts(), 12'000);
    run(shaft, 0.1);
    QCOMPARE(shaft.counts(), 11'000);
    shaft.setReversed(false);
    QCOMPARE(shaft.counts(), 11'000);
    shaft.setSlip(0.5);
    QCOMPARE(shaft.counts(), 11'000);
    run(shaft, 0.1);
    QCOMPARE(shaft.counts(), 11'500);
    shaft.setSlip(0.0);
    QCOMPARE(shaft.counts(), 11'500);
    shaft.jump();
    QCOMPARE(shaft.counts(), 11'500 + 5'000);
    run(shaft, 0.1);
    QCOMPARE(shaft.counts(), 11'500 + 5'000 + 1'000);
}

void TestLineShaft::seesIllegalTransitions()
{
    LineShaft shaft(running());
    run(shaft, 1.00001, 0.00001);
    QCOMPARE(shaft.errors(), 0u);
    shaft.setNoise(0.02);
    run(shaft, 1.0);
    QVERIFY(shaft.errors() > 150 && shaft.errors() < 250);
    QCOMPARE(shaft.counts(), 20'000 - shaft.errors());
    LineShaft coarse(running());
    run(coarse, 1.00001, 0.00001);
    coarse.setNoise(0.02);
    run(coarse, 1.0, 0.002);
    QCOMPARE(coarse.errors(), shaft.errors());
    const std::uint32_t errors = shaft.errors();
    shaft.setNoise(0.0);
    run(shaft, 1.0);
    QCOMPARE(shaft.errors(), errors);
}

CAMPANEL_TEST(TestLineShaft)

} // namespace test_line_shaft

#include "test_line_shaft.moc"
