// SPDX-License-Identifier: Apache-2.0
// Limits: which one is exceeded, where, and that the suggested value is feasible and the nearest.
#include "recipes.h"

#include "profile/cutter/limits.h"
#include "profile/cutter/ratios.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_limits {

using namespace campanel::profile;
using namespace campanel::profile::test;

namespace {

bool near(double a, double b, double tolerance)
{
    return std::abs(a - b) <= tolerance;
}

// Searches the field's grid outwards from the present value until a value is feasible.
std::optional<double> nearestByWalking(Recipe recipe, Field field)
{
    const double present = value(recipe.program, field);
    const double step = info(field).resolution();
    const double farthest = info(field).max - info(field).min;
    for (int i = 0; i * step <= farthest; ++i) {
        for (const int side : {-1, 1}) {
            const double x = snapToGrid(field, present + side * i * step);
            setValue(recipe.program, field, x);
            if (isFeasible(recipe.program, recipe.machine))
                return x;
        }
    }
    return std::nullopt;
}

} // namespace

class TestLimits : public QObject {
    Q_OBJECT

private slots:
    void brokenLimit_data();
    void brokenLimit();
    void brokenSpansOfAnAsymmetricLaw();
    void meetingALimitExactlyIsAllowed();
    void severalLimitsAtOnce();
    void peaksAgreeWithTheCurves_data();
    void peaksAgreeWithTheCurves();
    void nearestIsTheNearest();
    void nearestWithRatiosThatFollow();
    void nearestOfAValueFarBeyondTheRange();
    void fastestRateIsTheFastest_data();
    void fastestRateIsTheFastest();
};

void TestLimits::brokenLimit_data()
{
    QTest::addColumn<int>("field");
    QTest::addColumn<double>("allowed");
    QTest::addColumn<int>("limit");
    QTest::addColumn<double>("actual");
    QTest::addColumn<double>("timeS");   // of the peak
    QTest::addColumn<double>("brokenS"); // in total
    const auto row = [](const char* tag, Field field, double allowed, Limit limit, double actual,
                        double timeS, double brokenS) {
        QTest::newRow(tag) << static_cast<int>(field) << allowed << static_cast<int>(limit) << actual << timeS
                           << brokenS;
    };
    // L = 250 at 60 bags/min: v_a = 445.371 on [0, 0.25] and [0.75, 1]. On a cubic ramp the speed falls to
    // the mean (347.6855) in the middle, and |a| = peak 4x(1-x) is above 3/4 of the peak for x in (1/4, 3/4).
    row("motor speed down to the middle of the ramps", Field::MaxMotorRpm, 347.68547531 / 376.99111843 * 60,
        Limit::MotorSpeed, 70.883, 0, 0.65);
    row("pulse frequency down to the middle of the ramps", Field::MaxPulseFrequency,
        347.68547531 / 376.99111843 * 10000, Limit::PulseFrequency, 11813.83, 0, 0.65);
    row("acceleration above three quarters of its peak", Field::MaxKnifeAcceleration, 1953.70951 * 0.75,
        Limit::KnifeAcceleration, 1953.7095, 0.325, 0.15);
    row("machine slower than the rate", Field::MaxRate, 50, Limit::MachineRate, 60, -1, 0);
}

void TestLimits::brokenLimit()
{
    QFETCH(int, field);
    QFETCH(double, allowed);
    QFETCH(int, limit);
    QFETCH(double, actual);
    QFETCH(double, timeS);
    QFETCH(double, brokenS);
    Recipe r = checkRecipe();
    r.machine.timerClockHz = 60000000; // so that the timer hardly rounds the allowed frequency
    setValue(r.machine, static_cast<Field>(field), allowed);
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(cutter.has_value());
    const std::vector<Refusal> broken = checkLimits(*cutter);
    QCOMPARE(broken.size(), std::size_t{1});
    QCOMPARE(static_cast<int>(broken[0].limit), limit);
    QVERIFY(near(broken[0].actual, actual, 1e-4 * actual));
    QVERIFY(near(broken[0].allowed, allowed, 2e-4 * allowed));
    QCOMPARE(broken[0].timeS.has_value(), timeS >= 0);
    if (broken[0].timeS) {
        QVERIFY(near(*broken[0].timeS, timeS, 1e-9));
        QVERIFY(near(*broken[0].angleDeg, 360 * timeS, 1e-6));
    }
    double total = 0;
    for (const TimeSpan& span : broken[0].brokenDuring)
        total += span.toS - span.fromS;
    QVERIFY2(near(total, brokenS, 1e-4), std::to_string(total).c_str());
    QCOMPARE(broken[0].brokenDuring.size(), brokenS > 0 ? std::size_t{2} : std::size_t{0}); // there and back
    QVERIFY(!broken[0].nearest.empty());
    for (const Suggestion& s : broken[0].nearest) {
        Recipe mended = r;
        setValue(mended.program, s.field, s.value);
        QVERIFY(isFeasible(mended.program, mended.machine));
    }
}

void TestLimits::brokenSpansOfAnAsymmetricLaw()
{
    Recipe r = checkRecipe();
    r.program.speedLaw = LawId::HalfModifiedSine;
    const double peak = peaks(*solve(r.program, r.machine)).accelerationMmPerS2;
    r.machine.maxKnifeAccelerationMmPerS2 = 0.9 * peak;
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(cutter.has_value());
    const std::vector<Refusal> broken = checkLimits(*cutter);
    QCOMPARE(broken.size(), std::size_t{1});
    QCOMPARE(broken[0].brokenDuring.size(), std::size_t{2});
    const TimeSpan there = broken[0].brokenDuring[0];
    const TimeSpan back = broken[0].brokenDuring[1];
    QVERIFY(near(there.fromS + back.toS, 1, 1e-9)); // the cycle is its own mirror image about T/2
    QVERIFY(near(there.toS + back.fromS, 1, 1e-9));
    for (const double edge : {there.fromS, there.toS, back.fromS, back.toS})
        QVERIFY(near(std::abs(cutter->motion.at(edge).accelerationMmPerS2), 0.9 * peak, 1e-6 * peak));
}

void TestLimits::meetingALimitExactlyIsAllowed()
{
    Recipe r = checkRecipe();
    const Peaks peak = peaks(*solve(r.program, r.machine));
    r.machine.maxKnifeAccelerationMmPerS2 = peak.accelerationMmPerS2;
    r.machine.maxMotorRpm = peak.motorRpm;
    r.machine.maxRateBagsPerMin = 60;
    QVERIFY(checkLimits(*solve(r.program, r.machine)).empty());
    r.machine.maxKnifeAccelerationMmPerS2 *= 1 - 1e-6;
    QCOMPARE(checkLimits(*solve(r.program, r.machine)).size(), std::size_t{1});
}

void TestLimits::severalLimitsAtOnce()
{
    Recipe r = checkRecipe(100, 300);
    r.machine.maxMotorRpm = 400;
    r.machine.maxRateBagsPerMin = 200;
    const std::vector<Refusal> broken = checkLimits(*solve(r.program, r.machine));
    QCOMPARE(broken.size(), std::size_t{3});
    for (const Refusal& refusal : broken) {
        QCOMPARE(refusal.nearest.size(), broken[0].nearest.size());
        QVERIFY(refusal.actual > refusal.allowed);
    }
}

void TestLimits::peaksAgreeWithTheCurves_data()
{
    QTest::addColumn<int>("row");
    for (std::size_t i = 0; i < laws().size(); ++i)
        QTest::newRow(std::string(laws()[i].key).c_str()) << static_cast<int>(i);
}

void TestLimits::peaksAgreeWithTheCurves()
{
    QFETCH(int, row);
    const Law& law = laws()[static_cast<std::size_t>(row)];
    Recipe r = checkRecipe(120, 90);
    r.program.k = {5, 2.5, 1.6, 1.3}; // ramps of different length
    r.program.speedLaw = law.id;
    r.program.speedLawParameters = defaultParameters(law);
    const auto cutter = solve(r.program, r.machine);
    QVERIFY(cutter.has_value());
    const Peaks peak = peaks(*cutter);
    double acceleration = 0;
    double jerk = 0;
    double speed = 0;
    for (const Segment& segment : cutter->motion.segments()) {
        constexpr int steps = 20000;
        for (int i = 0; i <= steps; ++i) {
            const MotionPoint p = segment.at(segment.startS + segment.durationS * i / steps);
            acceleration = std::max(acceleration, std::abs(p.accelerationMmPerS2));
            jerk = std::max(jerk, std::abs(p.jerkMmPerS3));
            speed = std::max(speed, p.velocityMmPerS);
        }
    }
    QVERIFY(near(acceleration, peak.accelerationMmPerS2, 1e-6 * acceleration));
    QVERIFY(near(speed, peak.speedMmPerS, 1e-9 * speed));
    const LawParameters& p = r.program.speedLawParameters;
    if (law.at(0, p).g1 > 1e-9 || law.at(1, p).g1 > 1e-9) // its acceleration jumps
        QVERIFY(std::isinf(peak.jerkMmPerS3));
    else
        QVERIFY(near(jerk, peak.jerkMmPerS3, 1e-6 * jerk));
    const double justInside =
        peak.accelerationTimeS - 1e-9; // the end of an exponential ramp belongs to the ramp
    QVERIFY(
        near(std::abs(cutter->motion.at(justInside).accelerationMmPerS2), acceleration, 1e-4 * acceleration));
}

void TestLimits::nearestIsTheNearest()
{
    constexpr unsigned seed = 20140704;
    qInfo("seed %u", seed);
    RandomRecipes random(seed);
    int compared = 0;
    int impossible = 0;
    while (compared < 30) {
        const Recipe r = random.next();
        if (isFeasible(r.program, r.machine))
            continue;
        const auto cutter = solve(r.program, r.machine);
        const std::vector<Refusal> broken = cutter ? checkLimits(*cutter) : std::vector{cutter.error()};
        for (const Field field : r.program.pinned) {
            const std::optional<double> walked = nearestByWalking(r, field);
            const auto& nearest = broken.front().nearest;
            const auto offered = std::find_if(nearest.begin(), nearest.end(),
                                              [field](const Suggestion& s) { return s.field == field; });
            QCOMPARE(offered != nearest.end(), walked.has_value());
            if (walked) {
                const double present = value(r.program, field);
                QVERIFY2(near(std::abs(offered->value - present), std::abs(*walked - present), 1e-9),
                         describe(broken.front()).c_str());
            } else {
                ++impossible;
            }
        }
        ++compared;
    }
    QVERIFY(impossible > 0 && impossible < 2 * compared); // both outcomes occurred
}

// Each value is tried with its own ratios. The offered one works, and no nearer one does.
void TestLimits::nearestWithRatiosThatFollow()
{
    constexpr unsigned seed = 20261127;
    constexpr double roundingMm = 0.5; // of the ratios on their grid, at the limit
    qInfo("seed %u", seed);
    RandomRecipes random(seed);
    const auto isFeasibleAt = [](RotaryCutterProgram program, const Machine& machine, double lengthMm) {
        program.bagLengthMm = lengthMm;
        return isFeasible(withRatios(program, machine), machine);
    };
    int offers = 0;
    int none = 0;
    while (offers < 60) {
        Recipe r = checkRecipe(snapToGrid(Field::BagLength, random.uniform(10, 2000)),
                               snapToGrid(Field::Rate, random.uniform(20, 400)));
        r.program.ratioMode = std::array{RatioMode::Gentle, RatioMode::Cool, RatioMode::Slow}[random.pick(3)];
        r.machine.maxKnifeAccelerationMmPerS2 = std::round(random.uniform(20000, 200000));
        r.machine.contactAngleDeg = random.pick(2) == 0 ? 0 : 20;
        if (random.pick(2) == 0) {
            r.machine.inertiaKgCm2 = 10;
            r.machine.frictionNm = 0.1;
            r.machine.maxTorqueNm = random.uniform(0.2, 2);
        }
        r.program = withRatios(r.program, r.machine);
        if (isFeasible(r.program, r.machine))
            continue;
        const auto cutter = solve(r.program, r.machine);
        const Refusal refusal = cutter ? checkLimits(*cutter).front() : cutter.error();
        const auto offered = std::ranges::find_if(refusal.nearest, [](const Suggestion& each) {
            return each.field == Field::BagLength && !each.ratios;
        });
        const bool isOffered = offered != refusal.nearest.end();
        const double present = r.program.bagLengthMm;
        const double distance = isOffered ? std::abs(offered->value - present) - roundingMm : 2000;
        QVERIFY2(!isOffered || isFeasibleAt(r.program, r.machine, offered->value), describe(refusal).c_str());
        for (int i = 0; i < 500; ++i) {
            const double nearer = snapToGrid(Field::BagLength, present + random.uniform(-distance, distance));
            QVERIFY2(distance <= 0 || !isFeasibleAt(r.program, r.machine, nearer),
                     qPrintable(QStringLiteral("%1 mm: %2").arg(nearer).arg(describe(refusal).c_str())));
        }
        ++(isOffered ? offers : none);
    }
    qInfo("%d offers, %d without", offers, none);
}

// All distances from such a value are equal by rounding.
void TestLimits::nearestOfAValueFarBeyondTheRange()
{
    Recipe r = checkRecipe();
    double nearest = 0;
    for (const double length : {2000.1, 1e9, 1e18, 1e308}) {
        r.program.bagLengthMm = length;
        const auto refused = solve(r.program, r.machine);
        QVERIFY(!refused && !refused.error().nearest.empty());
        const double offered = refused.error().nearest.front().value;
        QCOMPARE(offered, nearest > 0 ? nearest : offered);
        nearest = offered;
    }
    QCOMPARE(nearest, 1077.1); // h / w
    r.program.bagLengthMm = -1e308;
    QCOMPARE(solve(r.program, r.machine).error().nearest.front().value, 10.0);
}

void TestLimits::fastestRateIsTheFastest_data()
{
    QTest::addColumn<int>("field");
    QTest::addColumn<double>("limitValue");
    QTest::addColumn<double>("rate");
    QTest::addColumn<int>("limit");
    const auto row = [](const char* tag, Field field, double value, double rate, Limit limit) {
        QTest::newRow(tag) << static_cast<int>(field) << value << rate << static_cast<int>(limit);
    };
    row("acceleration", Field::MaxKnifeAcceleration, 11100, 143.0, Limit::KnifeAcceleration);
    row("motor speed", Field::MaxMotorRpm, 150, 126.9, Limit::MotorSpeed);
    row("pulse frequency", Field::MaxPulseFrequency, 40000, 203.1, Limit::PulseFrequency);
    row("machine", Field::MaxRate, 100, 100, Limit::MachineRate);
    // 10 kg cm^2 and 0.1 Nm at R = 60: 0.0325618 and 0.0130247 Nm at 60 bags/min beside friction.
    row("peak torque", Field::MaxTorque, 0.3, 148.7, Limit::MotorTorque);
    row("RMS torque", Field::RatedTorque, 0.2, 218.7, Limit::RmsTorque);
    row("natural frequency", Field::NaturalFrequency, 2.5, 150, Limit::NaturalFrequency);
}

void TestLimits::fastestRateIsTheFastest()
{
    QFETCH(int, field);
    QFETCH(double, limitValue);
    QFETCH(double, rate);
    QFETCH(int, limit);
    Recipe r = checkRecipe();
    r.machine.inertiaKgCm2 = 10;
    r.machine.frictionNm = 0.1;
    setValue(r.machine, static_cast<Field>(field), limitValue);
    for (const auto& pair : allPairs) { // for any pinned pair, at any speed
        Recipe same = r;
        const CycleNumbers c = solve(checkRecipe(250, 170).program, r.machine)->cycle;
        same.program.pinned = pair;
        setValue(same.program, Field::BagLength, c.bagLengthMm);
        setValue(same.program, Field::Rate, c.rateBagsPerMin);
        setValue(same.program, Field::BaseSpeed, c.baseSpeedMmPerS);
        setValue(same.program, Field::FilmSpeed, c.filmSpeedMmPerS);
        const auto fastest = fastestRate(*solve(same.program, same.machine));
        QVERIFY(fastest.has_value());
        QVERIFY(near(fastest->rateBagsPerMin, rate, 1e-9));
        QCOMPARE(static_cast<int>(fastest->limitedBy), limit);
    }
    r.program.rateBagsPerMin = rate;
    QVERIFY(isFeasible(r.program, r.machine));
    r.program.rateBagsPerMin = rate + 0.1;
    QVERIFY(!isFeasible(r.program, r.machine));
}

CAMPANEL_TEST(TestLimits)

} // namespace test_limits

#include "test_limits.moc"
