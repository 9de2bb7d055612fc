// SPDX-License-Identifier: Apache-2.0
// The regime map agrees with the check of each recipe on it, and its lines lie where the behavior changes.
#include "profile/cutter/limits.h"
#include "profile/cutter/paper_lengths.h"
#include "profile/cutter/ramps.h"
#include "profile/cutter/regime_map.h"
#include "random_cases.h"
#include "recipes.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace test_regime_map {

using namespace campanel::profile;
using namespace campanel::profile::test;

namespace {

constexpr unsigned seed = 20261125;

Recipe withJaws()
{
    Recipe recipe = checkRecipe();
    recipe.machine.contactAngleDeg = 20;
    recipe.program.minSealTimeMs = 30;
    return recipe;
}

Limit limitAt(const Recipe& recipe, double lengthMm)
{
    return regimePoint(recipe.program, recipe.machine, lengthMm).limit;
}

// Returns the rate of the best ramps beside a window, found by a search. The ramps there and back are
// ramp (1 + skew) and ramp (1 - skew).
double searchedRate(Recipe recipe, double lengthMm, double skew)
{
    RotaryCutterProgram& program = recipe.program;
    const double window = 1 / program.k[2] - 1 / program.k[1];
    const double free = 1 - window;
    program.ratioMode = RatioMode::ByHand;
    const auto rateWith = [&](double ramp) {
        const double begin = free / 2 + ramp * skew;
        program.k = {1 / (begin - ramp * (1 + skew)), 1 / begin, 1 / (begin + window),
                     1 / (begin + window + ramp * (1 - skew))};
        return regimePoint(program, recipe.machine, lengthMm).rateBagsPerMin;
    };
    double best = 0;
    double place = free / 4;
    constexpr int parts = 40;
    for (double width = free / 4 - minCycleShare; width > 1e-6; width /= parts / 4.0) {
        const double middle = place;
        for (int i = -parts; i <= parts; ++i) {
            const double ramp =
                std::clamp(middle + i * width / parts, minCycleShare, free / 2 - minCycleShare);
            const double rate = rateWith(ramp);
            if (rate > best)
                place = ramp;
            best = std::max(best, rate);
        }
    }
    return best;
}

// Returns the rate of the best skew. Friction allows the ramp that slows the knife down to be shorter.
double searchedRate(const Recipe& recipe, double lengthMm)
{
    const Machine& m = recipe.machine;
    const double speeding = m.maxTorqueNm - m.frictionNm;
    const double slowing = m.maxTorqueNm + m.frictionNm;
    if (m.inertiaKgCm2 == 0 || m.maxTorqueNm == 0 || speeding <= 0)
        return searchedRate(recipe, lengthMm, 0);
    constexpr int steps = 8; // of a golden section
    const double sign = recipe.program.syncRatio * lengthMm > strokeMm(m) ? 1 : -1;
    double low = 0;
    double high = (slowing - speeding) / (slowing + speeding);
    double best = std::max(searchedRate(recipe, lengthMm, 0), searchedRate(recipe, lengthMm, sign * high));
    for (int i = 0; i < steps; ++i) {
        const double width = (high - low) * (std::numbers::phi - 1);
        const double first = searchedRate(recipe, lengthMm, sign * (high - width));
        const double second = searchedRate(recipe, lengthMm, sign * (low + width));
        best = std::max({best, first, second});
        (first > second ? high : low) = first > second ? low + width : high - width;
    }
    return best;
}

bool isFeasibleAt(Recipe recipe, double lengthMm, double rate)
{
    recipe.program.pinned = {Field::BagLength, Field::Rate};
    recipe.program.bagLengthMm = lengthMm;
    recipe.program.rateBagsPerMin = rate;
    return isFeasible(recipe.program, recipe.machine);
}

} // namespace

class TestRegimeMap : public QObject {
    Q_OBJECT

private slots:
    void regimesOfTheCheckRecipe();
    void paperLengthsOnTheDefaultMachine();
    void linesAreTheEnds();
    void refusesWhatHasNoMap();
    void agreesWithTheCheck();
    void noBagIsPossibleBeyondTheStroke();
    void fastestRampsAreThoseOfASearch();
};

void TestRegimeMap::regimesOfTheCheckRecipe()
{
    const Recipe recipe = withJaws();
    const auto map = regimeMap(recipe.program, recipe.machine, {50, 1200}, 200);
    QVERIFY(map.has_value());
    QCOMPARE(map->points.size(), std::size_t{204}); // both ends of the feasible lengths from both sides
    QVERIFY(std::ranges::is_sorted(map->points, {}, &RegimePoint::bagLengthMm));
    QCOMPARE(limitAt(recipe, 100), Limit::JawWindow);
    QCOMPARE(limitAt(recipe, 120), Limit::KnifeAcceleration);
    QCOMPARE(limitAt(recipe, 350), Limit::SealTime); // 60 R theta_c / (L t_min) = 119.7
    QCOMPARE(regimePoint(recipe.program, recipe.machine, 350).rateBagsPerMin, 119.6);
    QCOMPARE(limitAt(recipe, 1100), Limit::StrokeCannotClose);
    QCOMPARE(regimePoint(recipe.program, recipe.machine, 1100).rateBagsPerMin, 0.0);
    QCOMPARE(map->limits, (std::vector{Limit::KnifeAcceleration, Limit::SealTime}));
    QVERIFY(map->maxRateBagsPerMin > 200);
}

// The fastest rates of the paper's machine with the default ratios, as known without a map.
void TestRegimeMap::paperLengthsOnTheDefaultMachine()
{
    const Recipe recipe = checkRecipe();
    QCOMPARE(std::floor(regimePoint(recipe.program, recipe.machine, 100).rateBagsPerMin), 205.0);
    QCOMPARE(std::floor(regimePoint(recipe.program, recipe.machine, 150).rateBagsPerMin), 227.0);
    QCOMPARE(std::floor(regimePoint(recipe.program, recipe.machine, 249).rateBagsPerMin), 302.0);
    QCOMPARE(paperLengths.size(), std::size_t{15});
    for (const PaperLength& each : paperLengths)
        QVERIFY(regimePoint(recipe.program, recipe.machine, each.bagLengthMm).rateBagsPerMin > 100);
}

void TestRegimeMap::linesAreTheEnds()
{
    const Recipe recipe = withJaws();
    const CutterLengths lengths = cutterLengths(recipe.program, recipe.machine);
    QVERIFY(!isFeasibleAt(recipe, lengths.jawWithMarginMm - 0.01, 60));
    QVERIFY(isFeasibleAt(recipe, lengths.jawWithMarginMm + 0.01, 60));
    QVERIFY(isFeasibleAt(recipe, lengths.strokeMm - 0.01, 10));
    QVERIFY(!isFeasibleAt(recipe, lengths.strokeMm + 0.01, 10));
    // L_crit: ramps as long as possible and a window that the jaws just fill rest the knife.
    Recipe longest = recipe;
    const double window = jawArcMm(recipe.machine) / lengths.dwellMm;
    longest.program.k = {1000, 2 / (1 - window), 2 / (1 + window), 1.001};
    longest.program.bagLengthMm = lengths.dwellMm;
    longest.program.rateBagsPerMin = 10;
    longest.program.minSealTimeMs = 0;
    const auto cycle = solveNumbers(longest.program, longest.machine);
    QVERIFY(cycle.has_value());
    QVERIFY(cycle->baseSpeedMmPerS < 0.01 * cycle->filmSpeedMmPerS);
    longest.program.bagLengthMm = 1.01 * lengths.dwellMm;
    QCOMPARE(solveNumbers(longest.program, longest.machine).error().limit, Limit::StrokeCannotClose);
    const LengthRange range = regimeRange(recipe.program, recipe.machine);
    QVERIFY(range.fromMm < 100 && range.toMm > lengths.dwellMm);
}

void TestRegimeMap::refusesWhatHasNoMap()
{
    Recipe recipe = checkRecipe();
    recipe.program.k = {4, 2, 2.5, 1.3};
    const auto map = regimeMap(recipe.program, recipe.machine, {50, 500}, 20);
    QVERIFY(!map.has_value());
    QCOMPARE(map.error().limit, Limit::RatioOrder);
    // The inputs of the cycle do not matter, only ratios, law and machine.
    recipe = checkRecipe(5000, 9000);
    QVERIFY(regimeMap(recipe.program, recipe.machine, {50, 500}, 20).has_value());
}

void TestRegimeMap::agreesWithTheCheck()
{
    const int count = campanel::test::randomCases(2000);
    qInfo("seed %u, %d recipes", seed, count);
    RandomRecipes random(seed);
    int feasible = 0;
    int none = 0;
    for (int i = 0; i < count && !QTest::currentTestFailed(); ++i) {
        Recipe recipe = random.next();
        recipe.machine.contactAngleDeg = random.pick(2) == 0 ? 0 : random.uniform(1, 40);
        recipe.program.minSealTimeMs =
            recipe.machine.contactAngleDeg > 0 ? std::round(random.uniform(0, 60)) : 0;
        const double length = random.uniform(20, 900);
        const RegimePoint point = regimePoint(recipe.program, recipe.machine, length);
        if (point.rateBagsPerMin > 0) {
            ++feasible;
            QVERIFY(isFeasibleAt(recipe, length, point.rateBagsPerMin));
            QVERIFY(!isFeasibleAt(recipe, length, point.rateBagsPerMin + 0.2));
            // Every slower rate works as well: the region has no holes.
            const double slower = random.uniform(std::min(2.0, point.rateBagsPerMin), point.rateBagsPerMin);
            QVERIFY(isFeasibleAt(recipe, length, slower));
        } else {
            ++none;
            for (const double rate : {1.0, 7.0, 60.0, 200.0})
                QVERIFY(!isFeasibleAt(recipe, length, rate));
        }
    }
    qInfo("%d with a rate, %d without", feasible, none);
    QVERIFY(feasible > count / 10 && none > count / 10);
}

// The map by hand ends vertically: the point just beyond the stroke has no rate.
void TestRegimeMap::noBagIsPossibleBeyondTheStroke()
{
    RandomRecipes random(seed);
    int ends = 0;
    while (ends < 100) {
        const Recipe recipe = random.next();
        const auto map = regimeMap(recipe.program, recipe.machine, {20, 2000}, 20);
        if (!map || !(map->lengths.strokeMm < 2000))
            continue;
        ++ends;
        for (const RegimePoint& point : map->points) {
            if (point.bagLengthMm <= map->lengths.strokeMm)
                continue;
            QCOMPARE(point.rateBagsPerMin, 0.0);
            QVERIFY(point.limit == Limit::StrokeCannotClose);
        }
    }
}

void TestRegimeMap::fastestRampsAreThoseOfASearch()
{
    const int count = std::min(campanel::test::randomCases(300), 10000);
    qInfo("seed %u, %d machines", seed, count);
    RandomRecipes random(seed);
    std::map<Limit, int> limits;
    double worst = 0;
    for (int tried = 0; tried < count && !QTest::currentTestFailed();) {
        Recipe recipe = random.next();
        recipe.program.ratioMode = RatioMode::Gentle;
        recipe.machine.maxMotorRpm = std::round(random.uniform(50, 3000));
        recipe.machine.maxKnifeAccelerationMmPerS2 = std::round(random.uniform(20000, 200000));
        const LengthRange range{20, 20 + random.uniform(80, 800)};
        const auto map = regimeMap(recipe.program, recipe.machine, range, 5);
        if (!map || 1 / recipe.program.k[2] - 1 / recipe.program.k[1] > 0.9)
            continue;
        ++tried;
        for (const RegimePoint& point : map->points) {
            const bool isEveryFifth = &point == &map->points[static_cast<std::size_t>(tried) % 5];
            const double searched = isEveryFifth ? searchedRate(recipe, point.bagLengthMm)
                                                 : searchedRate(recipe, point.bagLengthMm, 0);
            // k1 and k4 on their grids cost less than a thousandth.
            const double tolerance = 0.2 + searched * 1e-3;
            QVERIFY2(point.rateBagsPerMin >= searched - tolerance &&
                         (!isEveryFifth || point.rateBagsPerMin <= searched + tolerance),
                     qPrintable(QStringLiteral("%1: %2 mm %3, searched %4")
                                    .arg(tried)
                                    .arg(point.bagLengthMm)
                                    .arg(point.rateBagsPerMin)
                                    .arg(searched)));
            if (isEveryFifth)
                worst = std::max(worst, std::abs(point.rateBagsPerMin - searched));
            limits[point.limit] += 1;
        }
    }
    qInfo("at most %.1f bags/min from the search, by %zu limits", worst, limits.size());
    for (const Limit each :
         {Limit::KnifeAcceleration, Limit::MotorSpeed, Limit::RmsTorque, Limit::MotorTorque})
        QVERIFY(limits[each] > count / 50);
}

CAMPANEL_TEST(TestRegimeMap)

} // namespace test_regime_map

#include "test_regime_map.moc"
