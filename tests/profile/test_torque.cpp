// SPDX-License-Identifier: Apache-2.0
// Torque: integrals of the laws, peak and RMS against sampled curves, limits, what is unknown.
#include "move_checks.h"
#include "random_cams.h"
#include "recipes.h"

#include "profile/cutter/limits.h"
#include "profile/cutter/sampling.h"
#include "profile/moves/position_move.h"
#include "profile/moves/speed_move.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

namespace test_torque {

using namespace campanel::profile;
using namespace campanel::profile::test;

namespace {

constexpr unsigned seed = 20261124;

// Returns the RMS torque by the midpoint rule.
double sampledRmsNm(const MotionProfile& motion, const TorqueLoad& load)
{
    constexpr int steps = 4000;
    double sum = 0;
    for (const Segment& segment : motion.segments()) {
        const double step = segment.durationS / steps;
        for (int i = 0; i < steps; ++i) {
            const MotionPoint p = segment.at(segment.startS + (i + 0.5) * step);
            sum += step * std::pow(load.at(p.velocityMmPerS, p.accelerationMmPerS2), 2);
        }
    }
    return std::sqrt(sum / motion.durationS());
}

const Refusal* find(const std::vector<Refusal>& broken, Limit limit)
{
    const auto found = std::ranges::find(broken, limit, &Refusal::limit);
    return found == broken.end() ? nullptr : &*found;
}

// Returns the check recipe with 10 kg cm^2 and 0.1 Nm at the motor.
Recipe motorRecipe(double bagLengthMm = 250, double rateBagsPerMin = 60)
{
    Recipe recipe = checkRecipe(bagLengthMm, rateBagsPerMin);
    recipe.machine.inertiaKgCm2 = 10;
    recipe.machine.frictionNm = 0.1;
    return recipe;
}

} // namespace

class TestTorque : public QObject {
    Q_OBJECT

private slots:
    void squaresOfTheLaws();
    void squaresAgreeWithSums_data();
    void squaresAgreeWithSums();
    void squaresOfTheExponentialLaw();
    void cutter();
    void gearAndSign();
    void unknownIsNoLimit();
    void peakIsThatOfTheCurve();
    void frictionHelpsToSlowDown();
    void rmsAgreesWithSamples();
    void shortestProductIsTheWorst();
    void positionMoveKeepsItsRatedTorque();
    void speedMoveKeepsItsRatedTorque();
    void frictionAboveTheRatedTorque();
    void brakingWithFrictionAboveTheTorque();
    void curve();
};

void TestTorque::squaresOfTheLaws()
{
    const auto speed = [](LawId id) { return lawSpeedSquare(*findLaw(id), {}); };
    const auto acceleration = [](LawId id) { return lawAccelerationSquare(*findLaw(id), {}); };
    const double pi = std::numbers::pi;
    QVERIFY(near(speed(LawId::Cubic), 1.2, 1e-12));
    QVERIFY(near(speed(LawId::Harmonic), pi * pi / 8, 1e-9));
    QVERIFY(near(speed(LawId::Quintic), 10.0 / 7, 1e-12));
    QVERIFY(near(speed(LawId::Cycloidal), 1.5, 1e-9));
    QVERIFY(near(speed(LawId::Parabolic), 4.0 / 3, 1e-12));
    QVERIFY(near(acceleration(LawId::Cubic), 12, 1e-12));
    QVERIFY(near(acceleration(LawId::Quintic), 120.0 / 7, 1e-12));
    QVERIFY(near(acceleration(LawId::Cycloidal), 2 * pi * pi, 1e-8));
    QVERIFY(near(acceleration(LawId::Harmonic), std::pow(pi, 4) / 8, 1e-9));
    QVERIFY(near(acceleration(LawId::Parabolic), 16, 1e-12));
}

void TestTorque::squaresAgreeWithSums_data()
{
    QTest::addColumn<int>("row");
    for (std::size_t i = 0; i < laws().size(); ++i)
        QTest::newRow(std::string(laws()[i].key).c_str()) << static_cast<int>(i);
}

void TestTorque::squaresAgreeWithSums()
{
    QFETCH(int, row);
    const Law& law = laws()[static_cast<std::size_t>(row)];
    RandomValues random(seed);
    for (int i = 0; i < 5; ++i) {
        const LawParameters parameters = i == 0 ? defaultParameters(law) : random.parametersOf(law);
        constexpr int steps = 200'000;
        double speed = 0;
        double acceleration = 0;
        for (int k = 0; k < steps; ++k) {
            const LawPoint p = law.at((k + 0.5) / steps, parameters);
            speed += p.g1 * p.g1 / steps;
            acceleration += p.g2 * p.g2 / steps;
        }
        QVERIFY(near(lawSpeedSquare(law, parameters), speed, 1e-4));
        if (law.isDisplacementLaw)
            QVERIFY2(near(lawAccelerationSquare(law, parameters), acceleration, 1e-3),
                     qPrintable(QString::number(acceleration)));
    }
}

// k / 2 (1 + e^-k) / (1 - e^-k) in closed form.
void TestTorque::squaresOfTheExponentialLaw()
{
    for (const double k : {0.1, 1.0, 3.0, 14.0, 20.0}) {
        const double exact = k / 2 * (1 + std::exp(-k)) / (1 - std::exp(-k));
        QVERIFY2(near(lawSpeedSquare(*findLaw(LawId::Exponential), {k, 0}) / exact, 1, 1e-12),
                 qPrintable(QString::number(k)));
    }
}

// 250 mm at 60 bags/min: peak 1953.71 mm/s^2, RMS 195.371 sqrt(1.2 * 2 / 0.15) = 781.48 mm/s^2.
void TestTorque::cutter()
{
    const Recipe r = motorRecipe();
    const Peaks peak = peaks(*solve(r.program, r.machine));
    QVERIFY(near(peak.torqueNm, 10e-4 * 1953.7095 / 60 + 0.1, 1e-6));
    QVERIFY(near(peak.rmsTorqueNm, std::hypot(10e-4 * 781.4838 / 60, 0.1), 1e-6));
    // The same numbers as in the design of the ratios: 150 mm at 200 bags/min and no friction.
    Recipe gentle = motorRecipe(150, 200);
    gentle.machine.frictionNm = 0;
    const auto solved = solve(gentle.program, gentle.machine);
    QVERIFY(near(peaks(*solved).rmsTorqueNm * 60 / 10e-4,
                 std::sqrt(squareAcceleration(solved->cycle, gentle.program)), 1e-12));
}

// A gear of 7:3 turns the motor faster; friction opposes the motion, also of a braking axis.
void TestTorque::gearAndSign()
{
    Machine machine;
    machine.inertiaKgCm2 = 2;
    machine.frictionNm = 0.3;
    machine.gearNumerator = 7;
    machine.gearDenominator = 3;
    const TorqueLoad knife = knifeLoad(machine);
    QVERIFY(near(knife.nmPerMmPerS2, 2e-4 * 7 / 3 / 60, 1e-12));
    QVERIFY(near(knife.at(100, 6000), 2e-4 * 7 / 3 * 100 + 0.3, 1e-12));
    QVERIFY(near(knife.at(100, -6000), -2e-4 * 7 / 3 * 100 + 0.3, 1e-12));
    QVERIFY(near(knife.at(-100, -6000), -2e-4 * 7 / 3 * 100 - 0.3, 1e-12));
    QCOMPARE(knife.at(0, 0), 0.0);
    AccelerationExtremes extremes;
    extremes.add(-6000, 1); // slows down
    QVERIFY(near(knife.peak(extremes).nm, 0.3 - 2e-4 * 7 / 3 * 100, 1e-12));
    extremes.add(-600000, 2);
    QVERIFY(near(knife.peak(extremes).nm, 2e-4 * 7 / 3 * 10000 - 0.3, 1e-12));
    QCOMPARE(knife.peak(extremes).timeS, 2.0);
    extremes.add(600000, 3);
    QVERIFY(near(knife.peak(extremes).nm, 2e-4 * 7 / 3 * 10000 + 0.3, 1e-12));
    machine.feedMmPerMotorRev = 50;
    QVERIFY(near(axisLoad(machine).nmPerMmPerS2, 2e-4 * 2 * std::numbers::pi / 50, 1e-12));
}

void TestTorque::unknownIsNoLimit()
{
    Recipe r = checkRecipe();
    const auto numbersOf = [&r] { return peaks(*solve(r.program, r.machine)); };
    QVERIFY(std::isnan(numbersOf().torqueNm) && std::isnan(numbersOf().rmsTorqueNm));
    r.machine.maxTorqueNm = 0.001; // limits without an inertia
    r.machine.ratedTorqueNm = 0.001;
    r.machine.frictionNm = 1;
    QVERIFY(isFeasible(r.program, r.machine));
    QCOMPARE(fastestRate(*solve(r.program, r.machine))->limitedBy, Limit::KnifeAcceleration);
    r.machine.inertiaKgCm2 = 10; // an inertia without limits
    r.machine.maxTorqueNm = r.machine.ratedTorqueNm = 0;
    QVERIFY(isFeasible(r.program, r.machine));
    QVERIFY(numbersOf().torqueNm > 1);
    r.machine.maxTorqueNm = 0.9; // friction alone exceeds it
    const std::vector<Refusal> broken = checkLimits(*solve(r.program, r.machine));
    QCOMPARE(broken.size(), std::size_t{1});
    QCOMPARE(broken.front().limit, Limit::MotorTorque);
    QVERIFY(broken.front().nearest.empty());
    QVERIFY(!fastestRate(*solve(r.program, r.machine)));
}

// The largest magnitude of the sampled k a + M_f sign(v), of cutters, cams and moves, and its place.
void TestTorque::peakIsThatOfTheCurve()
{
    qInfo("seed %u", seed);
    RandomRecipes recipes(seed);
    RandomCams cams(seed);
    RandomValues values(seed);
    int helped = 0; // by friction
    const auto verify = [&helped](const MotionProfile& motion, const TorqueLoad& load, const Peaks& peaks) {
        double largest = 0;
        double acceleration = 0;
        for (const Segment& segment : motion.segments()) {
            constexpr int steps = 4000;
            for (int i = 0; i < steps; ++i) {
                const MotionPoint p = segment.at(segment.startS + (i + 0.5) / steps * segment.durationS);
                largest = std::max(largest, std::abs(load.at(p.velocityMmPerS, p.accelerationMmPerS2)));
                acceleration = std::max(acceleration, std::abs(p.accelerationMmPerS2));
            }
        }
        QVERIFY2(largest <= peaks.torqueNm * (1 + 1e-9) && near(largest / peaks.torqueNm, 1, 5e-3),
                 qPrintable(QStringLiteral("%1 stated, %2 Nm").arg(peaks.torqueNm).arg(largest)));
        helped += load.nmPerMmPerS2 * acceleration + load.frictionNm > 1.02 * largest ? 1 : 0;
    };
    for (int i = 0; i < 300 && !QTest::currentTestFailed(); ++i) {
        Recipe r = recipes.next();
        r.machine.inertiaKgCm2 = 5;
        r.machine.frictionNm = values.uniform(0, 2);
        if (const auto cutter = solve(r.program, r.machine))
            verify(cutter->motion, knifeLoad(r.machine), peaks(*cutter));
        CamRecipe c = cams.next();
        c.machine.frictionNm = values.uniform(0, 2);
        if (const auto cam = solve(c.program, c.machine); cam && std::isfinite(cam->peaks.jerkMmPerS3))
            verify(cam->motion, axisLoad(c.machine), cam->peaks);
        const auto& lawRows = laws();
        SpeedMoveProgram move;
        const Law& law = lawRows[values.pick(lawRows.size())];
        if (!law.isSpeedLaw)
            continue;
        move.law = law.id;
        move.lawParameters = values.parametersOf(law);
        move.startSpeedMmPerS = std::round(values.uniform(-3000, 3000));
        move.endSpeedMmPerS = std::round(values.uniform(-3000, 3000));
        move.timeS = values.uniform(0.1, 3);
        Machine m = values.machine();
        m.inertiaKgCm2 = 3;
        m.frictionNm = values.uniform(0, 0.5);
        if (const auto solved = solve(move, m))
            verify(solved->motion, axisLoad(m), solved->peaks);
    }
    QVERIFY2(helped > 100, qPrintable(QString::number(helped)));
}

// A long ramp speeds the knife up, a short one slows it down. The torque of the latter is smaller than k a +
// M_f.
void TestTorque::frictionHelpsToSlowDown()
{
    Recipe r = checkRecipe(500, 120);
    r.program.k = {6, 2.5, 1.6667, 1.5};
    r.machine.inertiaKgCm2 = 20;
    r.machine.frictionNm = 1;
    r.machine.maxTorqueNm = 1.3;
    const auto cutter = solve(r.program, r.machine);
    const Peaks peak = peaks(*cutter);
    QVERIFY(near(peak.torqueNm, 1.1622, 1e-4));
    QVERIFY(near(peak.torqueTimeS, (cutter->cycle.taS + cutter->cycle.tbS) / 2, 1e-9));
    QVERIFY(near(peak.accelerationTimeS, (cutter->cycle.tcS + cutter->cycle.tdS) / 2, 1e-9));
    QVERIFY(checkLimits(*cutter).empty());
    // At the highest rate one of the ramps meets the torque exactly.
    const auto fastest = fastestRate(*cutter);
    QVERIFY(fastest && fastest->limitedBy == Limit::MotorTorque);
    r.program.rateBagsPerMin = fastest->rateBagsPerMin;
    QVERIFY(near(peaks(*solve(r.program, r.machine)).torqueNm, 1.3, 2e-3));
    r.program.rateBagsPerMin += 0.1;
    const std::vector<Refusal> broken = checkLimits(*solve(r.program, r.machine));
    QCOMPARE(broken.size(), std::size_t{1});
    QCOMPARE(broken.front().limit, Limit::MotorTorque);
    QCOMPARE(broken.front().brokenDuring.size(), std::size_t{1});
    const MotionPoint place = solve(r.program, r.machine)->motion.at(*broken.front().timeS);
    QVERIFY(near(knifeLoad(r.machine).at(place.velocityMmPerS, place.accelerationMmPerS2),
                 broken.front().actual, 1e-9));
    // From 9000 mm/s to rest the motor does nothing but what friction does not.
    SpeedMoveProgram move;
    move.startSpeedMmPerS = 9000;
    move.endSpeedMmPerS = 0;
    Machine machine = paperMotor();
    machine.frictionNm = 0.5;
    QCOMPARE(solve(move, machine)->peaks.torqueNm, 0.5);
}

void TestTorque::rmsAgreesWithSamples()
{
    qInfo("seed %u", seed);
    RandomRecipes recipes(seed);
    RandomCams cams(seed);
    RandomValues values(seed);
    int compared = 0;
    for (int i = 0; i < 300; ++i) {
        Recipe r = recipes.next();
        r.machine.inertiaKgCm2 = 5;
        if (const auto cutter = solve(r.program, r.machine)) {
            QVERIFY(near(peaks(*cutter).rmsTorqueNm / sampledRmsNm(cutter->motion, knifeLoad(r.machine)), 1,
                         1e-4));
            ++compared;
        }
        const CamRecipe c = cams.next();
        if (const auto cam = solve(c.program, c.machine); cam && std::isfinite(cam->peaks.jerkMmPerS3)) {
            const double sampled = sampledRmsNm(cam->motion, axisLoad(c.machine));
            QVERIFY2(near(cam->peaks.rmsTorqueNm / sampled, 1, 1e-3), qPrintable(QString::number(sampled)));
            ++compared;
        }
        SpeedMoveProgram move;
        move.startSpeedMmPerS = values.uniform(-3000, 3000);
        move.endSpeedMmPerS = values.uniform(-3000, 3000);
        move.timeS = values.uniform(0.1, 3);
        Machine m = values.machine();
        m.inertiaKgCm2 = 3;
        if (const auto solved = solve(move, m)) {
            QVERIFY(near(solved->peaks.rmsTorqueNm / sampledRmsNm(solved->motion, axisLoad(m)), 1, 1e-3));
            ++compared;
        }
    }
    QVERIFY2(compared > 400, qPrintable(QString::number(compared)));
}

// At one rate, the shortest of the paper's 15 lengths needs the highest RMS torque.
void TestTorque::shortestProductIsTheWorst()
{
    double peakBefore = std::numeric_limits<double>::infinity();
    double rmsBefore = peakBefore;
    for (const double length : {100.0, 120.0, 150.0, 180.0, 200.0, 249.0, 300.0, 350.0, 376.0}) {
        const Recipe r = motorRecipe(length, 60);
        const Peaks peak = peaks(*solve(r.program, r.machine));
        QVERIFY(peak.torqueNm < peakBefore && peak.rmsTorqueNm < rmsBefore);
        peakBefore = peak.torqueNm;
        rmsBefore = peak.rmsTorqueNm;
    }
}

void TestTorque::positionMoveKeepsItsRatedTorque()
{
    PositionMoveProgram program;
    program.duration = MoveDuration::Fastest;
    Machine machine = paperMotor();
    machine.maxMotorRpm = 20000;
    machine.maxPulseFrequencyHz = 4'000'000;
    machine.maxAccelerationMmPerS2 = 10'000'000;
    machine.ratedTorqueNm = 0.1;
    // 6000 sqrt(120 / 7) k = sqrt(0.1^2 - 0.02^2) T^2, k = 0.2e-4 2 pi / 100.
    const double k = 0.2e-4 * 2 * std::numbers::pi / 100;
    const double expected = std::sqrt(6000 * std::sqrt(120.0 / 7) * k / std::sqrt(0.01 - 0.0004));
    const auto fastest = solve(program, machine);
    QVERIFY(fastest && fastest->broken.empty());
    QVERIFY(near(fastest->motion.durationS(), expected, 1.5e-3));
    program.duration = MoveDuration::GivenTime;
    program.timeS = 0.9 * expected;
    const auto broken = solve(program, machine);
    const Refusal* refusal = find(broken->broken, Limit::RmsTorque);
    QVERIFY(refusal != nullptr);
    QCOMPARE(refusal->field, Field::RatedTorque);
    QCOMPARE(refusal->allowed, 0.1);
    QCOMPARE(refusal->nearest.size(), std::size_t{2});
    verifySuggestions(program, machine, *refusal);
}

void TestTorque::speedMoveKeepsItsRatedTorque()
{
    RandomValues random(seed);
    int refused = 0;
    for (int i = 0; i < 300; ++i) {
        SpeedMoveProgram program;
        program.startSpeedMmPerS = random.pick(2) == 0 ? 0 : std::round(random.uniform(-2000, 2000));
        program.endSpeedMmPerS = std::round(random.uniform(-2000, 2000));
        program.duration = static_cast<MoveDuration>(random.pick(3));
        program.distanceMm = std::round(random.uniform(-400, 400));
        program.timeS = snapToGrid(Field::MoveTime, random.uniform(0.02, 1));
        Machine machine = paperMotor();
        machine.maxTorqueNm = 0;
        machine.inertiaKgCm2 = 5;
        machine.ratedTorqueNm = snapToGrid(Field::RatedTorque, random.uniform(0.03, 0.3));
        const auto solved = solve(program, machine);
        if (!solved)
            continue;
        const double sampled = sampledRmsNm(solved->motion, axisLoad(machine));
        if (program.duration == MoveDuration::Fastest)
            QVERIFY(solved->broken.empty() && sampled <= machine.ratedTorqueNm * (1 + 1e-4));
        if (const Refusal* refusal = find(solved->broken, Limit::RmsTorque)) {
            QVERIFY(sampled > machine.ratedTorqueNm * (1 - 1e-4));
            QVERIFY(!refusal->nearest.empty());
            verifySuggestions(program, machine, *refusal);
            ++refused;
        }
    }
    QVERIFY2(refused > 20, qPrintable(QString::number(refused)));
}

void TestTorque::frictionAboveTheRatedTorque()
{
    Machine machine = paperMotor();
    machine.ratedTorqueNm = 0.01;
    PositionMoveProgram move;
    move.duration = MoveDuration::Fastest;
    const auto refused = solve(move, machine);
    QVERIFY(!refused);
    QCOMPARE(refused.error().limit, Limit::RmsTorque);
    QCOMPARE(refused.error().actual, 0.02);
    QCOMPARE(refused.error().allowed, 0.01);
}

// The motor has less torque than friction takes, but friction alone slows the axis down.
void TestTorque::brakingWithFrictionAboveTheTorque()
{
    SpeedMoveProgram program;
    program.startSpeedMmPerS = 3000;
    program.endSpeedMmPerS = 1000;
    program.duration = MoveDuration::Fastest;
    Machine machine;
    machine.inertiaKgCm2 = 1.5;
    machine.frictionNm = 0.1;
    machine.ratedTorqueNm = 0.085;
    machine.pulsesPerMotorRev = 1000;
    const auto fastest = solve(program, machine);
    QVERIFY(fastest && fastest->broken.empty());
    const double fastestS = fastest->motion.durationS();
    program.duration = MoveDuration::GivenTime;
    const auto isFeasibleIn = [&](double timeS) {
        program.timeS = timeS;
        return isFeasible(program, machine);
    };
    QVERIFY(isFeasibleIn(0.3) && !isFeasibleIn(fastestS - 0.001));
    for (const double timeS : {fastestS - 0.01, 20.0}) { // too short, and so long that friction is too much
        program.timeS = timeS;
        const auto refused = solve(program, machine);
        const Refusal* refusal = find(refused->broken, Limit::RmsTorque);
        QVERIFY(refusal != nullptr);
        QCOMPARE(refusal->nearest.front().field, Field::MoveTime);
        verifySuggestions(program, machine, *refusal);
    }
    program.duration = MoveDuration::Fastest;
    program.endSpeedMmPerS = 5000; // to speed up, no time is long enough
    QCOMPARE(solve(program, machine).error().limit, Limit::RmsTorque);
    machine.maxTorqueNm = 0.09;
    QCOMPARE(solve(program, machine).error().limit, Limit::MotorTorque);
}

void TestTorque::curve()
{
    Recipe r = checkRecipe();
    QVERIFY(sampleCurves(*solve(r.program, r.machine), 100).torqueNm.empty());
    r = motorRecipe();
    const auto cutter = solve(r.program, r.machine);
    const Curves curves = sampleCurves(*cutter, 1001);
    QCOMPARE(curves.torqueNm.size(), curves.timeS.size());
    const auto [low, high] = std::ranges::minmax(curves.torqueNm);
    QVERIFY(near(high, peaks(*cutter).torqueNm, 1e-4));
    QVERIFY(near(low, 0.1 - 10e-4 * 1953.7095 / 60, 1e-3));
    QCOMPARE(curves.torqueNm.front(), 0.1);
}

CAMPANEL_TEST(TestTorque)

} // namespace test_torque

#include "test_torque.moc"
