// SPDX-License-Identifier: Apache-2.0
// Ten thousand seeded random recipes: each is solved within limits or refused with a correct suggestion.
#include "random_cases.h"
#include "recipes.h"
#include "table_replay.h"

#include "profile/cutter/limits.h"
#include "profile/cutter/sampling.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_random_recipes {

using namespace campanel::profile;
using namespace campanel::profile::test;

namespace {

constexpr unsigned seed = 31415926;
const int recipeCount = campanel::test::randomCases();

bool near(double a, double b, double relative)
{
    return std::abs(a - b) <= relative * std::max({std::abs(a), std::abs(b), 1.0});
}

void verifySuggestions(const Recipe& recipe, const Refusal& refusal)
{
    for (const Suggestion& s : refusal.nearest) {
        Recipe mended = recipe;
        setValue(mended.program, s.field, s.value);
        setValue(mended.machine, s.field, s.value);
        QVERIFY2(isFeasible(mended.program, mended.machine), describe(refusal).c_str());
        if (refusal.limit == Limit::RowCapacity || refusal.limit == Limit::TooFewPulses)
            QVERIFY2(buildStepTable(*solve(mended.program, mended.machine)).has_value(),
                     describe(refusal).c_str());
    }
}

void verifyMotion(const RotaryCutter& cutter)
{
    const auto segments = cutter.motion.segments();
    for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
        const MotionPoint before = segments[i].at(segments[i].endS());
        const MotionPoint after = segments[i + 1].at(segments[i + 1].startS);
        QVERIFY(near(before.positionMm, after.positionMm, 1e-12));
        QVERIFY(near(before.velocityMmPerS, after.velocityMmPerS, 1e-9));
    }
    QVERIFY(near(cutter.motion.durationS(), cutter.cycle.cycleTimeS, 1e-12));
    QVERIFY(near(cutter.motion.at(cutter.cycle.cycleTimeS).positionMm, cutter.cycle.strokeMm, 1e-9));
    const double sealed = cutter.program.syncRatio * cutter.cycle.bagLengthMm / cutter.cycle.cycleTimeS;
    QVERIFY(near(cutter.cycle.filmSpeedMmPerS, sealed, 1e-9));
}

void verifyLimits(const RotaryCutter& cutter)
{
    const Machine& m = cutter.machine;
    const Curves curves = sampleCurves(cutter, 200);
    for (std::size_t i = 0; i < curves.timeS.size(); ++i) {
        QVERIFY(curves.velocityMmPerS[i] >= -1e-9);
        QVERIFY(std::abs(curves.accelerationMmPerS2[i]) <= m.maxKnifeAccelerationMmPerS2 * (1 + 1e-6));
        QVERIFY(curves.frequencyHz[i] <= m.maxPulseFrequencyHz * (1 + 1e-6));
        QVERIFY(curves.velocityMmPerS[i] * motorRpmPerMmPerS(m) <= m.maxMotorRpm * (1 + 1e-6));
        QVERIFY(i == 0 || curves.positionMm[i] >= curves.positionMm[i - 1] - 1e-9);
    }
}

void verifyTable(const RotaryCutter& cutter, const StepTable& table)
{
    const PulsesPerCycle pulses = pulsesPerCycle(cutter.machine);
    QCOMPARE(sumOfPulses(table), pulses.whole);
    QCOMPARE(sumOfTicks(table), std::int64_t{table.cycleTicks});
    QCOMPARE(std::int64_t{table.cycleTicks},
             std::int64_t{std::llround(cutter.cycle.cycleTimeS * cutter.machine.timerClockHz)});
    QVERIFY(table.rows.size() <= static_cast<std::size_t>(cutter.machine.rowCapacity));
    for (const StepRow& row : table.rows)
        QVERIFY(isWithinTimer(row, cutter.machine));
    if (pulses.remainder > 0)
        QVERIFY(isWithinTimer(table.rows.at(table.carryRow), cutter.machine, 1));
    // Half a tick at the highest frequency, and the carried fraction.
    QVERIFY(table.errors.boundaryPulses <= 1.5);
    QVERIFY(table.errors.rmsPulses <= table.errors.insidePulses + 1e-9);
}

void verifyOtherPair(const RotaryCutter& cutter, const std::array<Field, 2>& pair)
{
    const CycleNumbers& c = cutter.cycle;
    // A resting knife does not determine rate or length, so v_a = 0 and L do not determine the cycle.
    if (c.baseSpeedMmPerS < 1 && pair == allPairs[3])
        return;
    RotaryCutterProgram p = cutter.program;
    p.pinned = pair;
    setValue(p, Field::BagLength, c.bagLengthMm);
    setValue(p, Field::Rate, c.rateBagsPerMin);
    setValue(p, Field::BaseSpeed, c.baseSpeedMmPerS);
    setValue(p, Field::FilmSpeed, c.filmSpeedMmPerS);
    const auto again = solve(p, cutter.machine);
    QVERIFY2(again.has_value(), again ? "" : describe(again.error()).c_str());
    QVERIFY(near(again->cycle.bagLengthMm, c.bagLengthMm, 1e-6));
    QVERIFY(near(again->cycle.rateBagsPerMin, c.rateBagsPerMin, 1e-6));
    QVERIFY(near(again->cycle.baseSpeedMmPerS, c.baseSpeedMmPerS, 1e-6));
    QVERIFY(near(again->cycle.filmSpeedMmPerS, c.filmSpeedMmPerS, 1e-6));
}

} // namespace

class TestRandomRecipes : public QObject {
    Q_OBJECT

private slots:
    void solvedWithinLimitsOrRefused();
};

void TestRandomRecipes::solvedWithinLimitsOrRefused()
{
    qInfo("seed %u, %d recipes", seed, recipeCount);
    RandomRecipes random(seed);
    int refused = 0;
    int broken = 0;
    int tables = 0;
    for (int i = 0; i < recipeCount && !QTest::currentTestFailed(); ++i) {
        const Recipe recipe = random.next();
        const auto cutter = solve(recipe.program, recipe.machine);
        if (!cutter) {
            ++refused;
            verifySuggestions(recipe, cutter.error());
            continue;
        }
        verifyMotion(*cutter);
        verifyOtherPair(*cutter, allPairs[random.pick(allPairs.size())]);
        const std::vector<Refusal> limits = checkLimits(*cutter);
        QCOMPARE(limits.empty(), isFeasible(recipe.program, recipe.machine));
        if (!limits.empty()) {
            ++broken;
            for (const Refusal& refusal : limits)
                verifySuggestions(recipe, refusal);
            continue;
        }
        verifyLimits(*cutter);
        const auto table = buildStepTable(*cutter);
        if (table) {
            ++tables;
            verifyTable(*cutter, *table);
        } else {
            verifySuggestions(recipe, table.error());
        }
    }
    qInfo("%d refused, %d beyond a limit, %d tables", refused, broken, tables);
    if (QTest::currentTestFailed())
        return;
    // Every kind of outcome occurred.
    QVERIFY(refused > recipeCount / 20 && broken > recipeCount / 20 && tables > recipeCount / 20);
}

CAMPANEL_TEST(TestRandomRecipes)

} // namespace test_random_recipes

#include "test_random_recipes.moc"
