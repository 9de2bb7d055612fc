// SPDX-License-Identifier: Apache-2.0
// The sealing jaws: the window that must hold them, the seal time, and what is offered when they do not fit.
#include "profile/cutter/explain.h"
#include "profile/cutter/jaw.h"
#include "profile/cutter/limits.h"
#include "random_cases.h"
#include "recipes.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <optional>

namespace test_jaw {

using namespace campanel::profile;
using namespace campanel::profile::test;
using campanel::test::randomCases;

namespace {

constexpr unsigned seed = 20261124;

Recipe withJaws(double lengthMm, double rate, double angleDeg = 20)
{
    Recipe recipe = checkRecipe(lengthMm, rate);
    recipe.machine.contactAngleDeg = angleDeg;
    return recipe;
}

double sealMs(const Recipe& recipe)
{
    return sealTimeMs(*solveNumbers(recipe.program, recipe.machine), recipe.machine);
}

bool near(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance;
}

std::vector<Refusal> broken(const Recipe& recipe)
{
    return checkLimits(*solve(recipe.program, recipe.machine));
}

Recipe mended(Recipe recipe, const Suggestion& suggestion)
{
    setValue(recipe.program, suggestion.field, suggestion.value);
    setValue(recipe.machine, suggestion.field, suggestion.value);
    if (suggestion.ratios)
        recipe.program.k = *suggestion.ratios;
    return recipe;
}

} // namespace

class TestJaw : public QObject {
    Q_OBJECT

private slots:
    void checkValues();
    void thinKnifeIsNotChecked();
    void narrowWindowIsRefusedAndWidened();
    void widerWindowMovesTheOtherEnds();
    void widerWindowMayNeedALowerRate();
    void sealTimeLimitsTheRate();
    void offersWhatWorks_data();
    void offersWhatWorks();
    void explained();
    void randomJaws();
};

// The design's figures: A = 20.944 mm at 20 degrees and R = 60 mm, sigma = 0.2 with the default ratios.
void TestJaw::checkValues()
{
    const Recipe recipe = withJaws(100, 60);
    QVERIFY(near(jawArcMm(recipe.machine), 20.943951, 1e-6));
    const CutterLengths lengths = cutterLengths(recipe.program, recipe.machine);
    QVERIFY(near(lengths.jawMm, 104.719755, 1e-6));
    QVERIFY(near(lengths.jawWithMarginMm, 115.191731, 1e-6));
    QVERIFY(near(lengths.equalSpeedMm, 376.991118, 1e-6));
    QVERIFY(near(lengths.dwellMm, 733.038286, 1e-6)); // 2 h - A
    QVERIFY(near(lengths.strokeMm, 1077.117481, 1e-6));
    QVERIFY(near(sealMs(withJaws(100, 60)), 209.43951, 1e-5));
    QVERIFY(near(sealMs(withJaws(250, 60)), 83.775804, 1e-6));
    QVERIFY(near(sealMs(withJaws(250, 300)), 16.755161, 1e-6));

    Recipe fast = withJaws(250, 300);
    fast.program.syncRatio = 1.25; // the knife is faster than the film
    QVERIFY(near(sealMs(fast), 16.755161 / 1.25, 1e-6));
    QVERIFY(near(cutterLengths(fast.program, fast.machine).jawMm, 104.719755 / 1.25, 1e-6));
}

void TestJaw::thinKnifeIsNotChecked()
{
    Recipe recipe = withJaws(20, 20, 0);
    QVERIFY(isFeasible(recipe.program, recipe.machine));
    QCOMPARE(requiredWindowDeg(recipe.machine), 0.0);
    recipe.machine.contactAngleDeg = 2;
    QVERIFY(!isFeasible(recipe.program, recipe.machine));
}

void TestJaw::narrowWindowIsRefusedAndWidened()
{
    const Recipe recipe = withJaws(100, 60);
    const std::vector<Refusal> refusals = broken(recipe);
    QCOMPARE(refusals.size(), std::size_t{1});
    const Refusal& refusal = refusals.front();
    QCOMPARE(refusal.limit, Limit::JawWindow);
    QCOMPARE(limitId(refusal.limit), std::string_view("jaw_window"));
    QVERIFY(near(refusal.actual, 19.098593, 1e-6)); // c L sigma / R
    QCOMPARE(refusal.allowed, 22.0);
    QVERIFY(near(*refusal.timeS, 0.4, 1e-9));
    QVERIFY(near(*refusal.angleDeg, 144, 1e-9));
    QCOMPARE(refusal.brokenDuring.size(), std::size_t{1});
    QVERIFY(near(refusal.brokenDuring[0].toS, 0.6, 1e-9));
    QVERIFY(!fastestRate(*solve(recipe.program, recipe.machine)));

    QCOMPARE(refusal.nearest.size(), std::size_t{2});
    const auto& ratios = refusal.nearest[0].ratios;
    QVERIFY(ratios.has_value());
    QCOMPARE((*ratios)[0], recipe.program.k[0]); // the ramps still have room
    QCOMPARE((*ratios)[3], recipe.program.k[3]);
    // sigma = A' / (c L) = 0.2303835, to the grid of the ratios; the middle stays.
    QVERIFY(near(1 / (*ratios)[2] - 1 / (*ratios)[1], 0.2303835, 6e-5));
    QVERIFY(near(1 / (*ratios)[2] + 1 / (*ratios)[1], 1.0, 6e-5));
    QVERIFY(broken(mended(recipe, refusal.nearest[0])).empty());
    QCOMPARE(refusal.nearest[1].field, Field::BagLength);
    QCOMPARE(refusal.nearest[1].value, 115.2);
    QVERIFY(isFeasible(withJaws(115.2, 60).program, recipe.machine));
    QVERIFY(!isFeasible(withJaws(115.1, 60).program, recipe.machine));
}

void TestJaw::widerWindowMovesTheOtherEnds()
{
    const Recipe recipe = withJaws(30, 60); // sigma = 0.768
    const std::vector<Refusal> refusals = broken(recipe);
    QCOMPARE(refusals.front().limit, Limit::JawWindow);
    const Suggestion& offered = refusals.front().nearest.front();
    QVERIFY(offered.ratios.has_value());
    QVERIFY((*offered.ratios)[0] > recipe.program.k[0]);
    QVERIFY((*offered.ratios)[3] < recipe.program.k[3]);
    QVERIFY(broken(mended(recipe, offered)).empty());
    // A bag shorter than the jaws has no window that holds them: only the length helps.
    const std::vector<Refusal> tooShort = broken(withJaws(20, 60));
    QCOMPARE(tooShort.front().nearest.size(), std::size_t{1});
    QCOMPARE(tooShort.front().nearest.front().field, Field::BagLength);
}

void TestJaw::widerWindowMayNeedALowerRate()
{
    const Recipe recipe = withJaws(60, 200); // the longest ramps beside that window reach 189
    const Suggestion offered = broken(recipe).front().nearest.front();
    QVERIFY(offered.ratios.has_value());
    QCOMPARE(offered.field, Field::Rate);
    QVERIFY(offered.value > 185 && offered.value < 190);
    Recipe slower = mended(recipe, offered);
    QVERIFY(broken(slower).empty());
    slower.program.rateBagsPerMin += 0.1;
    QVERIFY(!broken(slower).empty());
}

void TestJaw::sealTimeLimitsTheRate()
{
    Recipe recipe = withJaws(250, 300);
    recipe.program.minSealTimeMs = 50;
    const std::vector<Refusal> refusals = broken(recipe);
    QCOMPARE(refusals.size(), std::size_t{1});
    QCOMPARE(refusals.front().limit, Limit::SealTime);
    QVERIFY(near(refusals.front().actual, 16.755161, 1e-6));
    QCOMPARE(refusals.front().allowed, 50.0);
    QVERIFY(near(*refusals.front().angleDeg, 144, 1e-9));
    QCOMPARE(refusals.front().nearest.front().field, Field::Rate);
    QCOMPARE(refusals.front().nearest.front().value, 100.5); // 60 R theta_c / (L t_min) = 100.53
    for (const auto& pair : allPairs) {
        Recipe same = recipe;
        const CycleNumbers c = solve(checkRecipe(250, 80).program, recipe.machine)->cycle;
        same.program.pinned = pair;
        setValue(same.program, Field::BagLength, c.bagLengthMm);
        setValue(same.program, Field::Rate, c.rateBagsPerMin);
        setValue(same.program, Field::BaseSpeed, c.baseSpeedMmPerS);
        setValue(same.program, Field::FilmSpeed, c.filmSpeedMmPerS);
        const auto fastest = fastestRate(*solve(same.program, same.machine));
        QVERIFY(fastest.has_value());
        QCOMPARE(fastest->rateBagsPerMin, 100.5);
        QCOMPARE(fastest->limitedBy, Limit::SealTime);
    }
}

void TestJaw::offersWhatWorks_data()
{
    QTest::addColumn<double>("angleDeg");
    QTest::addColumn<int>("knives");
    QTest::addColumn<double>("lengthMm");
    QTest::addColumn<double>("minSealTimeMs");
    QTest::addColumn<int>("limit");
    QTest::addColumn<int>("field");
    QTest::addColumn<double>("value");
    const auto row = [](const char* tag, double angle, int knives, double length, double seal, Limit limit,
                        Field field, double value) {
        QTest::newRow(tag) << angle << knives << length << seal << static_cast<int>(limit)
                           << static_cast<int>(field) << value;
    };
    // The arc of the jaws and its margin exceeds the stroke: no window of any bag holds them.
    row("jaws that never fit", 150, 4, 150, 0, Limit::JawWindow, Field::ContactAngle, 26.6);
    row("seal time that no rate keeps", 20, 1, 250, 10000, Limit::SealTime, Field::MinSealTime, 83);
    row("seal time without jaws", 0, 1, 250, 100, Limit::SealTime, Field::MinSealTime, 0);
}

void TestJaw::offersWhatWorks()
{
    QFETCH(double, angleDeg);
    QFETCH(int, knives);
    QFETCH(double, lengthMm);
    QFETCH(double, minSealTimeMs);
    QFETCH(int, limit);
    QFETCH(int, field);
    QFETCH(double, value);
    Recipe recipe = withJaws(lengthMm, 60, angleDeg);
    recipe.machine.knives = knives;
    recipe.program.minSealTimeMs = minSealTimeMs;
    const std::vector<Refusal> refusals = broken(recipe);
    QCOMPARE(static_cast<int>(refusals.front().limit), limit);
    QVERIFY(refusals.front().timeS.has_value());
    QCOMPARE(refusals.front().nearest.size(), std::size_t{1});
    const Suggestion& offered = refusals.front().nearest.front();
    QCOMPARE(static_cast<int>(offered.field), field);
    QCOMPARE(offered.value, value);
    QVERIFY(broken(mended(recipe, offered)).empty());
}

void TestJaw::explained()
{
    const Recipe recipe = withJaws(250, 60);
    const auto cutter = solve(recipe.program, recipe.machine);
    const Explanation seal = explain(*cutter, CutterQuantity::SealTime);
    QCOMPARE(seal.formula, std::string("1000 A / v_b, A = 2 pi R theta_c / 360"));
    QCOMPARE(seal.numbers, std::string("1000 * 2 pi * 60 * 20 / 360 / 250"));
    QVERIFY(near(seal.result, 1000 * 2 * std::numbers::pi * 60 * 20 / 360 / 250, 1e-9));
    const Explanation window = explain(*cutter, CutterQuantity::SyncWindow);
    QCOMPARE(window.numbers, std::string("360 * 250 * (0.6 - 0.4) / (2 pi * 60)"));
    QVERIFY(near(window.result, 47.746483, 1e-6));
}

// The check agrees with the motion itself: the knife turns by at least the window while it moves at
// film speed, and every offered value makes the recipe feasible.
void TestJaw::randomJaws()
{
    const int count = randomCases(20000);
    qInfo("seed %u, %d recipes", seed, count);
    RandomRecipes random(seed);
    int narrow = 0;
    int widened = 0;
    int kept = 0;
    for (int i = 0; i < count && !QTest::currentTestFailed(); ++i) {
        Recipe recipe = random.next();
        recipe.machine.contactAngleDeg = snapToGrid(Field::ContactAngle, random.uniform(0.5, 60));
        recipe.program.minSealTimeMs = snapToGrid(Field::MinSealTime, random.uniform(0, 80));
        const auto cutter = solve(recipe.program, recipe.machine);
        if (!cutter)
            continue;
        const CycleNumbers& c = cutter->cycle;
        const double turnedMm = cutter->motion.at(c.tcS).positionMm - cutter->motion.at(c.tbS).positionMm;
        const double turnedDeg = turnedMm / recipe.machine.knifeRadiusMm * 180 / std::numbers::pi;
        QVERIFY(near(turnedDeg, windowDeg(c, recipe.machine), 1e-6));
        const bool holds = turnedDeg >= recipe.machine.contactAngleDeg + jawMarginDeg;
        const std::vector<Refusal> refusals = checkLimits(*cutter);
        QCOMPARE(refusals.empty(), isFeasible(recipe.program, recipe.machine));
        const bool isNarrow = !refusals.empty() && refusals.front().limit == Limit::JawWindow;
        QVERIFY(isNarrow != holds || near(turnedDeg, recipe.machine.contactAngleDeg + jawMarginDeg, 1e-6));
        narrow += isNarrow ? 1 : 0;
        kept += refusals.empty() ? 1 : 0;
        for (const Refusal& refusal : refusals) {
            for (const Suggestion& suggestion : refusal.nearest) {
                widened += suggestion.ratios ? 1 : 0;
                const Recipe after = mended(recipe, suggestion);
                QVERIFY2(isFeasible(after.program, after.machine), describe(refusal).c_str());
            }
        }
    }
    qInfo("%d narrow, %d widened, %d within the limits", narrow, widened, kept);
    QVERIFY(narrow > count / 20 && widened > count / 50 && kept > count / 50);
}

CAMPANEL_TEST(TestJaw)

} // namespace test_jaw

#include "test_jaw.moc"
