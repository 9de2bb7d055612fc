// SPDX-License-Identifier: Apache-2.0
// The cutter cam against the check values of the paper's corrected formulas, its curves and its refusals.
#include "recipes.h"

#include "profile/cutter/explain.h"
#include "profile/cutter/limits.h"
#include "profile/cutter/paper_table.h"
#include "profile/cutter/sampling.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_rotary_cutter {

using namespace campanel::profile;
using namespace campanel::profile::test;

namespace {

bool near(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance;
}

} // namespace

class TestRotaryCutter : public QObject {
    Q_OBJECT

private slots:
    void checkValues_data();
    void checkValues();
    void shortCheckOfTheWeight();
    void everyPairGivesTheSameCycle_data();
    void everyPairGivesTheSameCycle();
    void asymmetricLawClosesTheStroke();
    void paperFormulaOfTheCubic();
    void curvesHoldTheJoints();
    void figuresOfTheDrawing();
    void paperTableError_data();
    void paperTableError();
    void refusals_data();
    void refusals();
    void refusalOfALawParameter();
};

void TestRotaryCutter::checkValues_data()
{
    QTest::addColumn<double>("bagLengthMm");
    QTest::addColumn<double>("baseSpeedMmPerS");
    QTest::newRow("L=100") << 100.0 << 526.1402;
    QTest::newRow("L=250") << 250.0 << 445.3710;
    QTest::newRow("L=460") << 460.0 << 332.2940;
}

void TestRotaryCutter::checkValues()
{
    QFETCH(double, bagLengthMm);
    QFETCH(double, baseSpeedMmPerS);
    const Recipe r = checkRecipe(bagLengthMm);
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(cutter.has_value());
    QVERIFY(near(cutter->cycle.weightS, 0.35, 1e-12));
    QVERIFY(near(cutter->cycle.baseSpeedMmPerS, baseSpeedMmPerS, 6e-5));
    QVERIFY(near(cutter->cycle.filmSpeedMmPerS, bagLengthMm, 1e-12));
    QVERIFY(near(cutter->cycle.speedRatio, bagLengthMm / baseSpeedMmPerS, 1e-6));
    QVERIFY(near(cutter->motion.at(1).positionMm, 120 * std::acos(-1.0), 1e-9));
}

// T = 0.6, k = 6, 3, 1.5, 1.2, v_a = 200, h = 300, cubic -> W = 0.3, v_b = 800, k0 = 4.
void TestRotaryCutter::shortCheckOfTheWeight()
{
    Recipe r = checkRecipe();
    r.program.pinned = {Field::BaseSpeed, Field::Rate};
    r.program.baseSpeedMmPerS = 200;
    r.program.rateBagsPerMin = 100;
    r.program.k = {6, 3, 1.5, 1.2};
    r.machine.knifeRadiusMm = 300 / (2 * std::acos(-1.0));
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(cutter.has_value());
    QVERIFY(near(cutter->cycle.weightS, 0.3, 1e-12));
    QVERIFY(near(cutter->cycle.filmSpeedMmPerS, 800, 1e-9));
    QVERIFY(near(cutter->cycle.speedRatio, 4, 1e-12));
    QVERIFY(near(cutter->cycle.bagLengthMm, 480, 1e-9));
}

void TestRotaryCutter::everyPairGivesTheSameCycle_data()
{
    QTest::addColumn<int>("pair");
    for (int i = 0; i < static_cast<int>(allPairs.size()); ++i) {
        const auto& pair = allPairs[static_cast<std::size_t>(i)];
        QTest::newRow(
            (std::string(info(pair[0]).symbol) + " and " + std::string(info(pair[1]).symbol)).c_str())
            << i;
    }
}

void TestRotaryCutter::everyPairGivesTheSameCycle()
{
    QFETCH(int, pair);
    for (const double sync : {1.0, 1.05}) {
        Recipe r = checkRecipe(180, 73);
        r.program.syncRatio = sync;
        r.program.speedLaw = LawId::HalfModifiedSine;
        const CycleNumbers known = solve(r.program, r.machine)->cycle;
        RotaryCutterProgram p = r.program;
        p.pinned = allPairs[static_cast<std::size_t>(pair)];
        p.bagLengthMm = p.rateBagsPerMin = p.baseSpeedMmPerS = p.filmSpeedMmPerS = std::nan("");
        const auto give = [&](Field field, double x) {
            if (isPinned(p, field))
                setValue(p, field, x);
        };
        give(Field::BagLength, known.bagLengthMm);
        give(Field::Rate, known.rateBagsPerMin);
        give(Field::BaseSpeed, known.baseSpeedMmPerS);
        give(Field::FilmSpeed, known.filmSpeedMmPerS);
        const auto again = solve(p, r.machine);
        QVERIFY(again.has_value());
        QVERIFY(near(again->cycle.bagLengthMm, 180, 1e-9));
        QVERIFY(near(again->cycle.rateBagsPerMin, 73, 1e-9));
        QVERIFY(near(again->cycle.baseSpeedMmPerS, known.baseSpeedMmPerS, 1e-9));
        QVERIFY(near(again->cycle.filmSpeedMmPerS, sync * 180 * 73 / 60, 1e-9));
    }
}

// With a law of G(1) = 0.568 the ramps must mirror in time: the travel of both is equal and the stroke
// closes.
void TestRotaryCutter::asymmetricLawClosesTheStroke()
{
    for (const LawId law : {LawId::HalfModifiedSine, LawId::Exponential}) {
        Recipe r = checkRecipe(150);
        r.program.speedLaw = law;
        r.program.speedLawParameters = defaultParameters(*findLaw(law));
        const auto cutter = solve(r.program, r.machine);
        QVERIFY(cutter.has_value());
        const CycleNumbers& c = cutter->cycle;
        const MotionProfile& motion = cutter->motion;
        QVERIFY(near(motion.at(c.cycleTimeS).positionMm, c.strokeMm, 1e-9));
        for (int i = 0; i <= 100;
             ++i) { // ramps are of equal length here, so the cycle is its own mirror image
            const double t = c.taS + i / 100.0 * (c.tbS - c.taS);
            QVERIFY(near(motion.at(t).velocityMmPerS, motion.at(c.taS + c.tdS - t).velocityMmPerS, 1e-9));
        }
        double travelled = 0; // trapezoid rule, independent of G
        constexpr int steps = 200000;
        for (int i = 0; i < steps; ++i)
            travelled += motion.at((i + 0.5) * c.cycleTimeS / steps).velocityMmPerS * c.cycleTimeS / steps;
        QVERIFY(near(travelled, c.strokeMm, 1e-5));
    }
}

// Checks Eq. (5) of the paper, literally.
void TestRotaryCutter::paperFormulaOfTheCubic()
{
    const Recipe r = checkRecipe(100);
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(cutter.has_value());
    const CycleNumbers& c = cutter->cycle;
    const double va = c.baseSpeedMmPerS;
    const double change = c.filmSpeedMmPerS - va;
    const double cube = std::pow(c.taS - c.tbS, 3);
    for (int i = 0; i <= 50; ++i) {
        const double t = c.taS + i / 50.0 * (c.tbS - c.taS);
        const double paper = 2 * change / cube * t * t * t - 3 * change * (c.taS + c.tbS) / cube * t * t +
                             6 * change * c.taS * c.tbS / cube * t +
                             change * (std::pow(c.taS, 3) - 3 * c.taS * c.taS * c.tbS) / cube + va;
        QVERIFY(near(cutter->motion.at(t).velocityMmPerS, paper, 1e-9));
    }
}

void TestRotaryCutter::curvesHoldTheJoints()
{
    const Recipe r = checkRecipe(250);
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(cutter.has_value());
    const Curves curves = sampleCurves(*cutter, 1000);
    QCOMPARE(curves.timeS.size(), curves.jerkMmPerS3.size());
    QCOMPARE(curves.timeS.size(), curves.frequencyHz.size());
    QCOMPARE(curves.timeS.front(), 0.0);
    QCOMPARE(curves.timeS.back(), cutter->cycle.cycleTimeS);
    QVERIFY(curves.timeS.size() >= 1004 && curves.timeS.size() <= 1008);
    for (const double joint : {cutter->cycle.taS, cutter->cycle.tbS, cutter->cycle.tcS, cutter->cycle.tdS})
        QVERIFY(std::count_if(curves.timeS.begin(), curves.timeS.end(),
                              [&](double t) { return near(t, joint, 1e-12); }) == 2);
    QVERIFY(std::is_sorted(curves.timeS.begin(), curves.timeS.end()));
    for (std::size_t i = 1; i < curves.timeS.size(); ++i) {
        const double dt = curves.timeS[i] - curves.timeS[i - 1];
        const double mean = (curves.velocityMmPerS[i] + curves.velocityMmPerS[i - 1]) / 2;
        QVERIFY(near(curves.positionMm[i] - curves.positionMm[i - 1], mean * dt, 1e-5));
    }
    QVERIFY(near(curves.frequencyHz.front(), 11813.83, 0.01));
}

// Checks the figures of the Motion page's drawing.
void TestRotaryCutter::figuresOfTheDrawing()
{
    const Recipe r = checkRecipe(250);
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(cutter.has_value());
    const Peaks peak = peaks(*cutter);
    QVERIFY(near(peak.motorRpm, 71, 0.5));
    QVERIFY(near(peak.accelerationMmPerS2, 1950, 5));
    QVERIFY(near(peak.pulseFrequencyHz, 11800, 50));
    QCOMPARE(cutter->angleDegAt(0.25), 90.0);
}

void TestRotaryCutter::paperTableError_data()
{
    QTest::addColumn<double>("bagLengthMm");
    QTest::addColumn<double>("pulses");
    QTest::addColumn<double>("mm");
    QTest::newRow("L=100: 85 pulses, 3.2 mm") << 100.0 << 85.0 << 3.2;
    QTest::newRow("L=250: 39 pulses, 1.5 mm") << 250.0 << 39.0 << 1.5;
}

void TestRotaryCutter::paperTableError()
{
    QFETCH(double, bagLengthMm);
    QFETCH(double, pulses);
    QFETCH(double, mm);
    const Recipe r = checkRecipe(bagLengthMm);
    const PaperTable table = paperTable(*solve(r.program, r.machine), 20);
    QVERIFY(near(std::abs(table.errorPulses), pulses, 0.5));
    QVERIFY(near(std::abs(table.errorMm), mm, 0.05));
}

void TestRotaryCutter::refusals_data()
{
    QTest::addColumn<int>("field");
    QTest::addColumn<double>("value");
    QTest::addColumn<int>("limit");
    QTest::addColumn<int>("nearestField");
    QTest::addColumn<double>("nearestValue");
    const auto row = [](const char* tag, Field field, double x, Limit limit, int nearestField,
                        double nearest) {
        QTest::newRow(tag) << static_cast<int>(field) << x << static_cast<int>(limit) << nearestField
                           << nearest;
    };
    const double nan = std::nan("");
    const auto id = [](Field field) { return static_cast<int>(field); };
    row("bag longer than the stroke allows", Field::BagLength, 1100, Limit::StrokeCannotClose,
        id(Field::BagLength), 1077.1);
    row("bag length not a number", Field::BagLength, nan, Limit::FieldRange, id(Field::BagLength), 250);
    row("bag length zero", Field::BagLength, 0, Limit::FieldRange, id(Field::BagLength), 10);
    row("rate infinite", Field::Rate, std::numeric_limits<double>::infinity(), Limit::FieldRange,
        id(Field::Rate), 60);
    row("rate beyond its field", Field::Rate, 9999, Limit::FieldRange, id(Field::Rate), 303.5);
    row("k2 above k1", Field::K2, 5, Limit::RatioOrder, id(Field::K2), 3.8973);
    row("k4 at one", Field::K4, 1, Limit::FieldRange, id(Field::K4), 1.0001);
    row("sync ratio negative", Field::SyncRatio, -1, Limit::FieldRange, id(Field::SyncRatio), 0.5);
    row("no slices", Field::SlicesPerRamp, 0, Limit::FieldRange, id(Field::SlicesPerRamp), 1);
    row("no knives", Field::Knives, 0, Limit::FieldRange, id(Field::Knives), 1);
    row("timer clock zero", Field::TimerClock, 0, Limit::FieldRange, id(Field::TimerClock), 100000);
}

void TestRotaryCutter::refusals()
{
    QFETCH(int, field);
    QFETCH(double, value);
    QFETCH(int, limit);
    QFETCH(int, nearestField);
    QFETCH(double, nearestValue);
    Recipe r = checkRecipe(250);
    setValue(r.program, static_cast<Field>(field), value);
    setValue(r.machine, static_cast<Field>(field), value);
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(!cutter.has_value());
    const Refusal& refusal = cutter.error();
    QCOMPARE(static_cast<int>(refusal.limit), limit);
    QVERIFY(!refusal.nearest.empty());
    const auto found = std::find_if(refusal.nearest.begin(), refusal.nearest.end(), [&](const Suggestion& s) {
        return static_cast<int>(s.field) == nearestField;
    });
    QVERIFY2(found != refusal.nearest.end(), describe(refusal).c_str());
    QVERIFY2(near(found->value, nearestValue, 1e-9), describe(refusal).c_str());
    setValue(r.program, found->field, found->value);
    setValue(r.machine, found->field, found->value);
    QVERIFY(isFeasible(r.program, r.machine));
}

void TestRotaryCutter::refusalOfALawParameter()
{
    Recipe r = checkRecipe(250);
    r.program.speedLaw = LawId::SCurve;
    r.program.speedLawParameters = {0.25, 0.6};
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(!cutter.has_value());
    QCOMPARE(static_cast<int>(cutter.error().limit), static_cast<int>(Limit::LawParameter));
    QCOMPARE(cutter.error().lawParameter, std::string_view("jerk_share"));
    QCOMPARE(cutter.error().allowed, 0.5);

    r.program.speedLaw = static_cast<LawId>(99);
    QCOMPARE(static_cast<int>(solve(r.program, r.machine).error().limit),
             static_cast<int>(Limit::LawUnknown));
    r.program.pinned = {Field::Rate, Field::Rate};
    QCOMPARE(static_cast<int>(solve(r.program, r.machine).error().limit),
             static_cast<int>(Limit::PinnedPair));
}

CAMPANEL_TEST(TestRotaryCutter)

} // namespace test_rotary_cutter

#include "test_rotary_cutter.moc"
