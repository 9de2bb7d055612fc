// SPDX-License-Identifier: Apache-2.0
// The ratios that suit the machine: the closed forms against check values and a free search over the four
// times, and a million random recipes (nightly; a sample here) that stay feasible and get no slower.
#include "random_cases.h"
#include "recipes.h"

#include "profile/cutter/ratios.h"
#include "profile/model/torque.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_ratios {

using namespace campanel::profile;
using namespace campanel::profile::test;

namespace {

constexpr std::array allModes{RatioMode::Gentle, RatioMode::Cool, RatioMode::Slow, RatioMode::Between};

bool near(double a, double b, double relative)
{
    return std::abs(a - b) <= relative * std::max({std::abs(a), std::abs(b), 1e-12});
}

double highestRate(const RotaryCutterProgram& program, const Machine& machine)
{
    const auto cycle = solveNumbers(program, machine);
    const auto fastest =
        cycle ? fastestRate(RotaryCutter{program, machine, *cycle, {}}) : std::optional<FastestRate>{};
    return fastest ? fastest->rateBagsPerMin : 0;
}

RampTask taskOf(const Recipe& recipe)
{
    const auto& p = recipe.program;
    const Law& law = *findLaw(p.speedLaw);
    RampTask task;
    task.strokeMm = strokeMm(recipe.machine);
    task.filmMm = p.syncRatio * p.bagLengthMm;
    task.cycleTimeS = 60 / p.rateBagsPerMin;
    task.window = 1 / p.k[2] - 1 / p.k[1];
    task.lawTravel = law.at(1, p.speedLawParameters).integral;
    task.lawPeak = law.peaks(p.speedLawParameters).cv;
    task.maxSpeedMmPerS = motionLimits(recipe.machine).maxSpeedMmPerS;
    task.maxAccelerationMmPerS2 = recipe.machine.maxKnifeAccelerationMmPerS2;
    return task;
}

// The four times as one point: both ramps and the beginning of the window, as shares of the cycle.
struct Times {
    double there = 0;
    double back = 0;
    double begin = 0;
};

RotaryCutterProgram withTimes(RotaryCutterProgram program, double window, const Times& times)
{
    program.k = {1 / (times.begin - times.there), 1 / times.begin, 1 / (times.begin + window),
                 1 / (times.begin + window + times.back)};
    return program;
}

enum class Aim { Acceleration, Rms, Speed };

// Returns the figure of a cycle with these times; infinite where they leave the cycle or break a limit.
double figureOf(Aim aim, const Recipe& recipe, double window, const Times& times)
{
    constexpr double none = std::numeric_limits<double>::infinity();
    constexpr double least = minCycleShare * (1 - 1e-9);
    const bool fits = times.there >= least && times.back >= least && times.begin - times.there >= least &&
                      times.begin + window + times.back <= 1 - least;
    if (!fits)
        return none;
    const RotaryCutterProgram program = withTimes(recipe.program, window, times);
    const auto cycle = solveNumbers(program, recipe.machine);
    if (!cycle)
        return none;
    const Peaks peak = peaks(*cycle, program, recipe.machine);
    if (aim == Aim::Acceleration)
        return peak.accelerationMmPerS2;
    if (aim == Aim::Rms)
        return rmsAcceleration(*cycle, program);
    return peak.accelerationMmPerS2 <= recipe.machine.maxKnifeAccelerationMmPerS2 ? peak.speedMmPerS : none;
}

// Searches the four times freely: random steps around the best point, smaller and smaller.
double searched(Aim aim, const Recipe& recipe, double window, RandomRecipes& random)
{
    double best = std::numeric_limits<double>::infinity();
    for (int start = 0; start < 2; ++start) {
        const double free = 1 - window;
        Times at;
        double found = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 500 && std::isinf(found); ++i) {
            const double ramp = random.uniform(0.02, 0.49) * free;
            at = {ramp, ramp, free / 2};
            found = figureOf(aim, recipe, window, at);
        }
        for (double step = 0.2 * free; step > 1e-9; step *= 0.9) {
            for (int i = 0; i < 12; ++i) {
                // Together, apart, and the window alone: the optimum lies on a ridge.
                const double both = random.uniform(-step, step);
                const double apart = i % 3 == 0 ? random.uniform(-step, step) : 0;
                const Times tried{at.there + both + apart, at.back + both - apart,
                                  at.begin + (i % 2 == 0 ? random.uniform(-step, step) : 0)};
                const double figure = figureOf(aim, recipe, window, tried);
                if (figure < found) {
                    found = figure;
                    at = tried;
                }
            }
        }
        best = std::min(best, found);
    }
    return best;
}

} // namespace

class TestRatios : public QObject {
    Q_OBJECT

private slots:
    void squaredSlopes_data();
    void squaredSlopes();
    void gentleBagsPerMinute_data();
    void gentleBagsPerMinute();
    void checkValues();
    void freeSearchIsNeverBetter_data();
    void freeSearchIsNeverBetter();
    void rmsIsThatOfTheCurve();
    void longBagsDwell();
    void motorSpeedLimitsTheRamps();
    void everyPairSuitsItsOwnCycle();
    void windowMovesOnlyForRoom();
    void windowGetsWiderAndNarrower();
    void handSetRatiosStay();
    void offersLongerRamps();
    void offersShorterRampsForALongBag();
    void lawsAreRankedAtTheirOwnBest();
    void frictionAboveThePeakTorque();
    void randomRecipesStayFeasible();
};

void TestRatios::squaredSlopes_data()
{
    QTest::addColumn<int>("law");
    QTest::addColumn<double>("expected");
    const double pi = std::acos(-1.0);
    QTest::newRow("cubic") << static_cast<int>(LawId::Cubic) << 1.2;
    QTest::newRow("quintic") << static_cast<int>(LawId::Quintic) << 10.0 / 7;
    QTest::newRow("harmonic") << static_cast<int>(LawId::Harmonic) << pi * pi / 8;
    QTest::newRow("cycloidal") << static_cast<int>(LawId::Cycloidal) << 1.5;
    QTest::newRow("parabolic") << static_cast<int>(LawId::Parabolic) << 4.0 / 3;
    QTest::newRow("trapezoid") << static_cast<int>(LawId::Trapezoid) << (1 - 4 * 0.25 / 3) / (0.75 * 0.75);
    const double e = std::exp(-3.0);
    QTest::newRow("exponential") << static_cast<int>(LawId::Exponential)
                                 << 3.0 * (1 - e * e) / 2 / ((1 - e) * (1 - e));
}

void TestRatios::squaredSlopes()
{
    QFETCH(int, law);
    QFETCH(double, expected);
    const Law& row = *findLaw(static_cast<LawId>(law));
    const double found = lawSpeedSquare(row, defaultParameters(row));
    QVERIFY2(near(found, expected, 1e-10), qPrintable(QString::number(found, 'g', 15)));
}

void TestRatios::gentleBagsPerMinute_data()
{
    QTest::addColumn<double>("lengthMm");
    QTest::addColumn<double>("byHand");
    QTest::addColumn<double>("gentle");
    QTest::newRow("100 mm") << 100.0 << 205.0 << 263.0;
    QTest::newRow("150 mm") << 150.0 << 227.0 << 291.0;
    QTest::newRow("249 mm") << 249.0 << 302.0 << 387.0;
}

void TestRatios::gentleBagsPerMinute()
{
    QFETCH(double, lengthMm);
    QFETCH(double, byHand);
    QFETCH(double, gentle);
    RotaryCutterProgram program;
    program.bagLengthMm = lengthMm;
    const Machine machine;
    QCOMPARE(std::floor(highestRate(program, machine)), byHand);
    program.ratioMode = RatioMode::Gentle;
    program = withRatios(program, machine);
    QCOMPARE(std::round(highestRate(program, machine)), gentle);
    // The rate that is promised can be entered.
    program.rateBagsPerMin = highestRate(program, machine);
    QVERIFY(isFeasible(withRatios(program, machine), machine));
    program.rateBagsPerMin += 1;
    QVERIFY(!isFeasible(withRatios(program, machine), machine));
}

void TestRatios::checkValues()
{
    Recipe r = checkRecipe(150, 200);
    RampTask task = taskOf(r);
    QVERIFY(near(gentlestRamp(task), 0.4 - minCycleShare, 1e-12));
    QVERIFY(near(coolestRamp(task), 0.8 / 3, 1e-12));
    const auto figures = [&r](RatioMode mode) {
        r.program.ratioMode = mode;
        const RotaryCutterProgram program = withRatios(r.program, r.machine);
        const auto cycle = solveNumbers(program, r.machine);
        return std::pair(peaks(*cycle, program, r.machine), rmsAcceleration(*cycle, program));
    };
    QVERIFY(near(figures(RatioMode::Gentle).first.accelerationMmPerS2, 23645, 1e-4));
    QVERIFY(near(figures(RatioMode::Cool).second, 14186.94, 1e-4));
    const Peaks slow = figures(RatioMode::Slow).first;
    QVERIFY(slow.accelerationMmPerS2 <= r.machine.maxKnifeAccelerationMmPerS2);
    QVERIFY(near(slow.accelerationMmPerS2, r.machine.maxKnifeAccelerationMmPerS2, 1e-3));
    QVERIFY(slow.speedMmPerS < figures(RatioMode::Cool).first.speedMmPerS);
    // A law that is not symmetric: the gentlest ramps do not fill the cycle.
    r.program.speedLaw = LawId::HalfModifiedSine;
    task = taskOf(r);
    QVERIFY(near(gentlestRamp(task), 0.8 / (4 * 0.568310), 1e-6));
    QVERIFY(near(coolestRamp(task), 0.8 / (6 * 0.568310), 1e-6));
}

void TestRatios::freeSearchIsNeverBetter_data()
{
    QTest::addColumn<int>("aim");
    QTest::newRow("acceleration") << static_cast<int>(Aim::Acceleration);
    QTest::newRow("RMS acceleration") << static_cast<int>(Aim::Rms);
    QTest::newRow("speed") << static_cast<int>(Aim::Speed);
}

void TestRatios::freeSearchIsNeverBetter()
{
    QFETCH(int, aim);
    constexpr unsigned seed = 27182818;
    qInfo("seed %u", seed);
    constexpr int machines = 1000;
    const auto wanted = static_cast<Aim>(aim);
    RandomRecipes random(seed);
    double worst = 0;
    for (int tried = 0; tried < machines;) {
        Recipe recipe = random.next();
        recipe.program.pinned = {Field::BagLength, Field::Rate};
        recipe.machine.maxMotorRpm = info(Field::MaxMotorRpm).max;
        recipe.machine.maxPulseFrequencyHz = info(Field::MaxPulseFrequency).max;
        const RampTask task = taskOf(recipe);
        // Bags that the knife can wait for, so that only the aim decides.
        const double gentle = gentlestRamp(task);
        const auto range = possibleRamps(task);
        if (task.window > 0.9 || !range || range->longest < gentle ||
            std::abs(task.filmMm - task.strokeMm) < 1)
            continue;
        if (wanted == Aim::Speed && task.filmMm > task.strokeMm)
            continue; // v_b is the peak, whatever the ramps
        ++tried;
        const double ramp = wanted == Aim::Acceleration ? gentle
                            : wanted == Aim::Rms        ? coolestRamp(task)
                                                        : range->shortest;
        if (wanted == Aim::Speed) // the root itself may exceed the limit by its rounding
            recipe.machine.maxKnifeAccelerationMmPerS2 *= 1 + 1e-9;
        const double closed = figureOf(wanted, recipe, task.window, {ramp, ramp, (1 - task.window) / 2});
        const double found = searched(wanted, recipe, task.window, random);
        QVERIFY2(
            found >= closed * (1 - 1e-6),
            qPrintable(
                QStringLiteral("%1: %2 below %3").arg(tried).arg(found, 0, 'g', 12).arg(closed, 0, 'g', 12)));
        worst = std::max(worst, found / closed - 1);
    }
    qInfo("the search ends at most %g above the closed form", worst);
    QVERIFY(worst < 1e-2); // it is a search
}

void TestRatios::rmsIsThatOfTheCurve()
{
    RandomRecipes random(11);
    for (int i = 0; i < 200;) {
        Recipe recipe = random.next();
        const auto cutter = solve(recipe.program, recipe.machine);
        const Law& law = *findLaw(recipe.program.speedLaw);
        if (!cutter)
            continue;
        ++i;
        // The trapezoidal rule between the joints of the motion; steps inside a law leave its own error.
        double sum = 0;
        for (const Segment& segment : cutter->motion.segments()) {
            constexpr int parts = 4000;
            const double width = (segment.endS() - segment.startS) / parts;
            for (int part = 0; part < parts; ++part) {
                const double a = segment.at(segment.startS + (part + 0.5) * width).accelerationMmPerS2;
                sum += a * a * width;
            }
        }
        const double rms = std::sqrt(sum / cutter->cycle.cycleTimeS);
        QVERIFY2(near(rmsAcceleration(cutter->cycle, recipe.program), rms, 2e-3), law.key.data());
    }
}

void TestRatios::longBagsDwell()
{
    // L_crit = (2 h - A) / c, A = c L sigma: L (1 + sigma) = 2 h.
    Recipe r = checkRecipe(640, 60);
    r.program.ratioMode = RatioMode::Gentle;
    const double critical = 2 * strokeMm(r.machine) / 1.2;
    r.program.bagLengthMm = snapToGrid(Field::BagLength, critical - 2);
    QVERIFY(solveNumbers(withRatios(r.program, r.machine), r.machine)->baseSpeedMmPerS > 0.5);
    r.program.bagLengthMm = snapToGrid(Field::BagLength, critical + 20);
    const RotaryCutterProgram program = withRatios(r.program, r.machine);
    const auto cycle = solveNumbers(program, r.machine);
    QVERIFY(cycle.has_value());
    QVERIFY(isFeasible(program, r.machine));
    QVERIFY(cycle->baseSpeedMmPerS < 0.5); // the knife waits
    QVERIFY(1 / program.k[1] - 1 / program.k[0] < 0.395);
}

void TestRatios::motorSpeedLimitsTheRamps()
{
    Recipe r = checkRecipe(100, 200);
    r.program.ratioMode = RatioMode::Gentle;
    const auto speedOf = [&r] {
        const RotaryCutterProgram program = withRatios(r.program, r.machine);
        return peaks(*solveNumbers(program, r.machine), program, r.machine).motorRpm;
    };
    const double free = speedOf();
    r.machine.maxMotorRpm = std::floor(free) - 40;
    QVERIFY(isFeasible(withRatios(r.program, r.machine), r.machine));
    QVERIFY(near(speedOf(), r.machine.maxMotorRpm, 1e-3));
    // All modes reach the same rate: the ratios follow it.
    const double highest = highestRate(withRatios(r.program, r.machine), r.machine);
    QVERIFY(highest > 200);
    for (const RatioMode mode : allModes) {
        r.program.ratioMode = mode;
        QCOMPARE(highestRate(withRatios(r.program, r.machine), r.machine), highest);
    }
    r.program.rateBagsPerMin = highest;
    for (const RatioMode mode : allModes) {
        r.program.ratioMode = mode;
        QVERIFY(isFeasible(withRatios(r.program, r.machine), r.machine));
    }
}

void TestRatios::everyPairSuitsItsOwnCycle()
{
    RandomRecipes random(5);
    int tried = 0;
    int others = 0;
    while (tried < 2000) {
        Recipe recipe = random.next();
        recipe.program.ratioMode = allModes[random.pick(allModes.size())];
        recipe.program.rampPositionPercent = snapToGrid(Field::RampPosition, random.uniform(0, 100));
        const RotaryCutterProgram program = withRatios(recipe.program, recipe.machine);
        if (!isFeasible(program, recipe.machine))
            continue;
        ++tried;
        const auto cycle = solveNumbers(program, recipe.machine);
        RotaryCutterProgram same = program;
        same.pinned = {Field::BagLength, Field::Rate};
        same.bagLengthMm = cycle->bagLengthMm;
        same.rateBagsPerMin = cycle->rateBagsPerMin;
        same = withRatios(same, recipe.machine);
        bool isSame = true;
        for (std::size_t i = 0; i < same.k.size(); ++i)
            isSame = isSame && std::abs(1 / same.k[i] - 1 / program.k[i]) < 4e-4;
        // With a pinned base speed the ramps that suit may make a bag that is none: other ones do.
        QVERIFY2(isSame || isPinned(program, Field::BaseSpeed), QByteArray::number(tried));
        others += isSame ? 0 : 1;
    }
    qInfo("%d of %d have other ramps", others, tried);
    QVERIFY(others < tried / 20);
}

void TestRatios::windowMovesOnlyForRoom()
{
    Recipe r = checkRecipe(150, 100);
    r.program.ratioMode = RatioMode::Cool;
    r.program.k = {5, 3, 2, 1.5}; // 0.333 to 0.5
    RotaryCutterProgram cool = withRatios(r.program, r.machine);
    QCOMPARE(cool.k[1], 3.0);
    QCOMPARE(cool.k[2], 2.0);
    r.program.ratioMode = RatioMode::Gentle;
    const RotaryCutterProgram gentle = withRatios(r.program, r.machine);
    const double window = 1 / gentle.k[2] - 1 / gentle.k[1];
    QVERIFY(window >= 1.0 / 6);
    QVERIFY(window < 1.0 / 6 + 2e-5);
    QVERIFY(std::abs(1 / gentle.k[2] + 1 / gentle.k[1] - 1) < 1e-4);
    const RotaryCutterProgram again = withRatios(gentle, r.machine);
    QCOMPARE(again.k, gentle.k);
    for (std::size_t i = 0; i < gentle.k.size(); ++i)
        QCOMPARE(gentle.k[i], snapToGrid(Field::K1, gentle.k[i]));
}

void TestRatios::windowGetsWiderAndNarrower()
{
    Recipe r = checkRecipe(150, 100);
    const auto share = [](const RotaryCutterProgram& p) { return 1 / p.k[2] - 1 / p.k[1]; };
    const RotaryCutterProgram wide = withWindow(r.program, r.machine, 0.24);
    QVERIFY(near(share(wide), 0.24, 1e-3));
    QVERIFY(share(wide) >= 0.24);
    QVERIFY(near(1 / wide.k[1] - 1 / wide.k[0], 0.15, 1e-3)); // by hand the ramps keep their length
    r.program.ratioMode = RatioMode::Gentle;
    const RotaryCutterProgram narrow = withWindow(withRatios(r.program, r.machine), r.machine, 0.16);
    QVERIFY(near(share(narrow), 0.16, 1e-3));
    QVERIFY(near(1 / narrow.k[1] - 1 / narrow.k[0], 0.419, 1e-3)); // the ramps follow
    // No window leaves no room for ramps.
    QVERIFY(isFeasible(withWindow(r.program, r.machine, 0.99), r.machine) ||
            share(withWindow(r.program, r.machine, 0.99)) < 0.998);
}

void TestRatios::handSetRatiosStay()
{
    Recipe r = checkRecipe(150, 100);
    QCOMPARE(withRatios(r.program, r.machine).k, r.program.k);
    r.program.ratioMode = RatioMode::Gentle;
    r.program.k[2] = 2.6; // no window
    QCOMPARE(withRatios(r.program, r.machine).k, r.program.k);
}

void TestRatios::offersLongerRamps()
{
    Recipe r = checkRecipe(150, 250);
    auto broken = checkLimits(*solve(r.program, r.machine));
    QVERIFY(!broken.empty() && broken.front().ramps);
    QVERIFY(broken.front().ramps->isLonger);
    QCOMPARE(broken.front().ramps->rateBagsPerMin, 250.0); // within the limits at the rate itself
    r.program.rateBagsPerMin = 300;
    broken = checkLimits(*solve(r.program, r.machine));
    QCOMPARE(std::round(broken.front().ramps->rateBagsPerMin), 291.0);
    // Already gentle, and limited by something else: there is nothing to offer.
    r.program.ratioMode = RatioMode::Gentle;
    r.program = withRatios(r.program, r.machine);
    broken = checkLimits(*solve(r.program, r.machine));
    QVERIFY(!broken.empty() && !broken.front().ramps);
    r = checkRecipe(250, 100);
    r.machine.maxRateBagsPerMin = 80;
    QVERIFY(!checkLimits(*solve(r.program, r.machine)).front().ramps);
}

void TestRatios::offersShorterRampsForALongBag()
{
    Recipe r = checkRecipe(1100, 30); // h / w = 1077 mm with these ratios
    const auto refused = solve(r.program, r.machine);
    QVERIFY(!refused.has_value());
    QCOMPARE(refused.error().limit, Limit::StrokeCannotClose);
    QVERIFY(refused.error().ramps);
    QVERIFY(!refused.error().ramps->isLonger);
    QCOMPARE(refused.error().ramps->rateBagsPerMin, 30.0);
}

void TestRatios::lawsAreRankedAtTheirOwnBest()
{
    const Recipe r = checkRecipe(150, 200);
    const std::vector<RankedLaw> ranked = rankLaws(r.program, r.machine);
    const auto speedLaws = std::ranges::count_if(laws(), &Law::isSpeedLaw);
    QCOMPARE(static_cast<std::ptrdiff_t>(ranked.size()), speedLaws);
    double before = 0;
    for (const RankedLaw& each : ranked) {
        QVERIFY(each.cycle);
        QVERIFY(each.peaks.accelerationMmPerS2 >= before);
        before = each.peaks.accelerationMmPerS2;
        Recipe own = r;
        own.program.speedLaw = each.program.speedLaw;
        own.program.speedLawParameters = each.program.speedLawParameters;
        const RampTask task = taskOf(own);
        const double ramp = gentlestRamp(task);
        const double best =
            task.lawPeak * (task.strokeMm - task.filmMm) / (ramp * (0.8 - 2 * task.lawTravel * ramp) * 0.09);
        QVERIFY2(near(each.peaks.accelerationMmPerS2, best, 1e-3), findLaw(own.program.speedLaw)->key.data());
    }
}

// No ratios help where friction alone takes the torque; some are found all the same.
void TestRatios::frictionAboveThePeakTorque()
{
    for (const RatioMode mode : allModes) {
        for (const double frictionNm : {0.999, 1.0, 1.2}) {
            for (const double ratedNm : {0.0, 1.5}) {
                for (const double lengthMm : {100.0, 377.0, 600.0}) {
                    Recipe r = checkRecipe(lengthMm, 60);
                    r.program.ratioMode = mode;
                    r.machine.inertiaKgCm2 = 10;
                    r.machine.frictionNm = frictionNm;
                    r.machine.maxTorqueNm = 1;
                    r.machine.ratedTorqueNm = ratedNm;
                    r.program = withRatios(r.program, r.machine);
                    const auto cutter = solve(r.program, r.machine);
                    QVERIFY(cutter && (frictionNm < 1 || !checkLimits(*cutter).empty()));
                    QCOMPARE(fastestRate(*cutter).has_value(), frictionNm < 1);
                }
            }
        }
    }
}

void TestRatios::randomRecipesStayFeasible()
{
    constexpr unsigned seed = 16180339;
    const int recipes = campanel::test::randomCases();
    qInfo("seed %u, %d recipes", seed, recipes);
    RandomRecipes random(seed);
    int feasible = 0;
    int mended = 0;
    int faster = 0;
    for (int i = 0; i < recipes; ++i) {
        Recipe recipe = random.next();
        RotaryCutterProgram followed = recipe.program;
        followed.ratioMode = allModes[random.pick(allModes.size())];
        followed.rampPositionPercent = snapToGrid(Field::RampPosition, random.uniform(0, 100));
        followed = withRatios(followed, recipe.machine);
        const QByteArray tag = QByteArray::number(i);
        const bool wasFeasible = isFeasible(recipe.program, recipe.machine);
        const bool isNow = isFeasible(followed, recipe.machine);
        QVERIFY2(isNow || !wasFeasible, tag);
        feasible += wasFeasible ? 1 : 0;
        mended += isNow && !wasFeasible ? 1 : 0;
        // The same bags, as fast as they can be.
        const auto cycle = solveNumbers(recipe.program, recipe.machine);
        if (!cycle || !inRange(Field::BagLength, cycle->bagLengthMm))
            continue;
        recipe.program.pinned = {Field::BagLength, Field::Rate};
        recipe.program.bagLengthMm = cycle->bagLengthMm;
        recipe.program.rateBagsPerMin = cycle->rateBagsPerMin;
        const double byHand = highestRate(recipe.program, recipe.machine);
        recipe.program.ratioMode = followed.ratioMode;
        const double following = highestRate(recipe.program, recipe.machine);
        QVERIFY2(following >= byHand,
                 qPrintable(QStringLiteral("%1: %2, by hand %3").arg(i).arg(following).arg(byHand)));
        faster += following > byHand ? 1 : 0;
    }
    qInfo("%d feasible, %d more with these ratios, %d faster", feasible, mended, faster);
    QVERIFY(feasible > recipes / 20 && mended > recipes / 50 && faster > recipes / 5);
}

CAMPANEL_TEST(TestRatios)

} // namespace test_ratios

#include "test_ratios.moc"
