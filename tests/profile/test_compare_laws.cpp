// SPDX-License-Identifier: Apache-2.0
// One move with many laws: peaks side by side, and their curves.
#include "move_checks.h"

#include "profile/laws/laws.h"
#include "profile/moves/compare_laws.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace test_compare_laws {

using namespace campanel::profile;

namespace {

const LawComparison& of(const std::vector<LawComparison>& compared, LawId law)
{
    return *std::find_if(compared.begin(), compared.end(),
                         [law](const LawComparison& c) { return c.choice.law == law; });
}

} // namespace

class TestCompareLaws : public QObject {
    Q_OBJECT

private slots:
    void positionMove();
    void speedMove();
    void ownParameters();
    void trapezoidAndQuintic();
    void unsuitableLaw();
    void curvesForTheOverlay();
};

void TestCompareLaws::positionMove()
{
    const PositionMoveProgram program;
    const auto compared = compareLaws(program, test::paperMotor(), suitableLaws(program));
    QCOMPARE(compared.size(), std::size_t{10});
    for (const LawComparison& c : compared) {
        const Law& law = *findLaw(c.choice.law);
        const LawPeaks peaks = law.peaks(c.choice.parameters);
        QVERIFY(c.result.has_value());
        QCOMPARE(c.result->motion.durationS(), 1.0);
        QCOMPARE(c.result->peaks.speedMmPerS, 6000 * peaks.cv);
        QCOMPARE(c.result->peaks.motorRpm, 3600 * peaks.cv);
        QCOMPARE(c.result->peaks.accelerationMmPerS2, 6000 * peaks.ca);
        QCOMPARE(c.result->peaks.torqueNm, axisLoad(test::paperMotor()).at(1, 6000 * peaks.ca));
        const bool isFinite = std::abs(law.at(0, c.choice.parameters).g2) < 1e-9 && std::isfinite(peaks.cj);
        QCOMPARE(std::isfinite(c.result->peaks.jerkMmPerS3), isFinite);
        if (isFinite)
            QCOMPARE(c.result->peaks.jerkMmPerS3, 6000 * peaks.cj);
    }
}

void TestCompareLaws::speedMove()
{
    SpeedMoveProgram program;
    program.duration = MoveDuration::Fastest;
    program.endSpeedMmPerS = 1500;
    const auto compared = compareLaws(program, Machine(), suitableLaws(program));
    QCOMPARE(compared.size(), laws().size());
    for (const LawComparison& c : compared) {
        const LawPeaks peaks = findLaw(c.choice.law)->peaks(c.choice.parameters);
        const double shortest = 1500 * peaks.cv / 50000;
        const double time = c.result->motion.durationS();
        QVERIFY(time >= shortest * (1 - 1e-9) && time < shortest + 0.001);
        QVERIFY(c.result->broken.empty());
    }
}

void TestCompareLaws::ownParameters()
{
    SpeedMoveProgram program;
    program.law = LawId::Exponential;
    program.lawParameters = {5, 0};
    const auto choices = suitableLaws(program);
    const auto find = [&choices](LawId law) {
        return *std::find_if(choices.begin(), choices.end(),
                             [law](const LawChoice& c) { return c.law == law; });
    };
    QCOMPARE(find(LawId::Exponential).parameters[0], 5.0);
    QCOMPARE(find(LawId::Trapezoid).parameters[0], 0.25);
}

// The quintic needs less peak acceleration than a trapezoid only when the ramps are shorter than 22.29 %.
void TestCompareLaws::trapezoidAndQuintic()
{
    const PositionMoveProgram program;
    const std::vector<LawChoice> choices{
        {LawId::Quintic, {}}, {LawId::Trapezoid, {0.2228, 0}}, {LawId::Trapezoid, {0.2230, 0}}};
    const auto compared = compareLaws(program, Machine(), choices);
    const double quintic = compared[0].result->peaks.accelerationMmPerS2;
    QVERIFY(compared[1].result->peaks.accelerationMmPerS2 > quintic);
    QVERIFY(compared[2].result->peaks.accelerationMmPerS2 < quintic);
}

void TestCompareLaws::unsuitableLaw()
{
    const std::vector<LawChoice> choices{{LawId::Quintic, {}}, {LawId::HalfModifiedSine, {}}};
    const auto compared = compareLaws(PositionMoveProgram(), Machine(), choices);
    QVERIFY(of(compared, LawId::Quintic).result.has_value());
    QCOMPARE(of(compared, LawId::HalfModifiedSine).result.error().limit, Limit::LawUnknown);
}

void TestCompareLaws::curvesForTheOverlay()
{
    const PositionMoveProgram program;
    for (const LawComparison& c : compareLaws(program, Machine(), suitableLaws(program))) {
        const Curves curves = sampleAxisCurves(*c.result, Machine(), 401);
        QCOMPARE(curves.timeS.size(), std::size_t{401});
        QCOMPARE(curves.positionMm.back(), 6000.0);
        const double largest = *std::max_element(curves.velocityMmPerS.begin(), curves.velocityMmPerS.end());
        QCOMPARE(largest, c.result->peaks.speedMmPerS);
        QCOMPARE(*std::max_element(curves.frequencyHz.begin(), curves.frequencyHz.end()),
                 c.result->peaks.pulseFrequencyHz);
    }
}

CAMPANEL_TEST(TestCompareLaws)

} // namespace test_compare_laws

#include "test_compare_laws.moc"
