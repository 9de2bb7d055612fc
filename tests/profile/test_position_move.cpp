// SPDX-License-Identifier: Apache-2.0
// Position moves: the servo paper's numbers, refusals, the fastest time, and seeded random moves.
#include "move_checks.h"
#include "random_cases.h"

#include "profile/moves/position_move.h"
#include "tests/support/test_program.h"

namespace test_position_move {

using namespace campanel::profile;
using namespace campanel::profile::test;

namespace {

constexpr unsigned seed = 20150306;

PositionMoveProgram randomMove(RandomValues& random)
{
    PositionMoveProgram p;
    p.distanceMm = random.decades(Field::Distance, 0.01, 500000);
    p.timeS = random.decades(Field::MoveTime, 0.01, 500);
    p.duration = random.pick(2) == 0 ? MoveDuration::Fastest : MoveDuration::GivenTime;
    const Law& law = laws()[random.pick(laws().size())];
    p.law = law.id;
    p.lawParameters = random.parametersOf(law);
    return p;
}

void verifyMotion(const PositionMoveProgram& program, const AxisMotion& solved)
{
    const MotionProfile& motion = solved.motion;
    const MotionPoint start = motion.at(0);
    const MotionPoint end = motion.at(motion.durationS());
    QVERIFY(near(start.positionMm, 0, 1e-12));
    QVERIFY(near(end.positionMm, program.distanceMm, 1e-12));
    QVERIFY(near(start.velocityMmPerS, 0, 1e-9 * solved.peaks.speedMmPerS + 1e-12));
    QVERIFY(near(end.velocityMmPerS, 0, 1e-9 * solved.peaks.speedMmPerS + 1e-12));
    QVERIFY(inRange(Field::MoveTime, motion.durationS()));
    QCOMPARE(snapToGrid(Field::MoveTime, motion.durationS()), motion.durationS());
}

void verifyFastest(const PositionMoveProgram& program, const Machine& machine, const AxisMotion& solved)
{
    QVERIFY(solved.broken.empty());
    PositionMoveProgram faster = program;
    faster.duration = MoveDuration::GivenTime;
    faster.timeS = snapToGrid(Field::MoveTime, solved.motion.durationS() - 0.001);
    if (faster.timeS < solved.motion.durationS())
        QVERIFY(!isClearlyFeasible(faster, machine));
}

} // namespace

class TestPositionMove : public QObject {
    Q_OBJECT

private slots:
    void paperNumbers();
    void coefficientsAreTheLaw();
    void refused_data();
    void refused();
    void wrongLaws();
    void brokenLimitsSuggest();
    void fastest();
    void fastestBeyondTheRange();
    void backwards();
    void randomMoves();
};

void TestPositionMove::paperNumbers()
{
    const PositionMoveProgram program; // 6000 mm in 1 s by the quintic
    const auto solved = solve(program, Machine());
    QVERIFY(solved.has_value());
    QVERIFY(near(solved->peaks.motorRpm, 6750, 1e-12));
    QCOMPARE(std::round(solved->peaks.accelerationMmPerS2), 34641.0);
    QCOMPARE(solved->motion.durationS(), 1.0);
    const auto c = polynomialCoefficients(LawId::Quintic, 6000, 1);
    QVERIFY(c.has_value());
    QCOMPARE((*c)[0], 0.0);
    QCOMPARE((*c)[2], 0.0);
    QVERIFY(std::abs((*c)[3] - 6e-5) < 1e-18);
    QVERIFY(std::abs((*c)[4] + 9e-8) < 1e-21);
    QVERIFY(std::abs((*c)[5] - 3.6e-11) < 1e-24);
    QCOMPARE((*c)[6], 0.0);
}

void TestPositionMove::coefficientsAreTheLaw()
{
    for (const Law& law : laws()) {
        const auto c = polynomialCoefficients(law.id, -250, 0.4);
        const bool isPolynomial =
            law.id == LawId::Cubic || law.id == LawId::Quintic || law.id == LawId::Polynomial4567;
        QCOMPARE(c.has_value(), isPolynomial);
        for (int ms = 0; c && ms <= 400; ms += 25) {
            double position = 0;
            for (std::size_t i = c->size(); i-- > 0;)
                position = position * ms + (*c)[i];
            QVERIFY(near(position, -250 * law.at(ms / 400.0, {}).g, 1e-10));
        }
    }
}

void TestPositionMove::refused_data()
{
    QTest::addColumn<double>("distance");
    QTest::addColumn<double>("time");
    QTest::addColumn<int>("points");
    QTest::addColumn<int>("limit");
    QTest::addColumn<int>("field");
    QTest::addColumn<double>("nearest"); // NaN: no suggestion
    const auto row = [](const char* tag, double distance, double time, int points, Limit limit, Field field,
                        double nearest) {
        QTest::newRow(tag) << distance << time << points << static_cast<int>(limit) << static_cast<int>(field)
                           << nearest;
    };
    const double nan = std::nan("");
    row("no distance", 0, 1, 100, Limit::NoMotion, Field::Distance, nan);
    row("too far", 2e6, 600, 100, Limit::FieldRange, Field::Distance, 640000);
    row("no number", nan, 1, 100, Limit::FieldRange, Field::Distance, 1066.667);
    row("no time", 1000, 0, 100, Limit::FieldRange, Field::MoveTime, 0.938);
    row("too long", 1000, 601, 100, Limit::FieldRange, Field::MoveTime, 600);
    row("time is no number", 1000, nan, 100, Limit::FieldRange, Field::MoveTime, 1);
    row("too few points", 1000, 1, 99, Limit::FieldRange, Field::CamPoints, 100);
    row("too many points", 1000, 1, 2001, Limit::FieldRange, Field::CamPoints, 2000);
}

void TestPositionMove::refused()
{
    QFETCH(double, distance);
    QFETCH(double, time);
    QFETCH(int, points);
    QFETCH(int, limit);
    QFETCH(int, field);
    QFETCH(double, nearest);
    PositionMoveProgram program;
    program.distanceMm = distance;
    program.timeS = time;
    program.camPoints = points;
    const auto solved = solve(program, Machine()); // at most 2000 mm/s by the pulse frequency
    QVERIFY(!solved.has_value());
    QCOMPARE(static_cast<int>(solved.error().limit), limit);
    QCOMPARE(static_cast<int>(solved.error().field), field);
    QCOMPARE(solved.error().nearest.empty(), std::isnan(nearest));
    if (!std::isnan(nearest)) {
        QCOMPARE(static_cast<int>(solved.error().nearest.front().field), field);
        QVERIFY2(near(solved.error().nearest.front().value, nearest, 1e-6), describe(solved.error()).c_str());
    }
    verifySuggestions(program, Machine(), solved.error());
}

void TestPositionMove::wrongLaws()
{
    PositionMoveProgram program;
    for (const LawId law : {LawId::Exponential, LawId::HalfModifiedSine, static_cast<LawId>(77)}) {
        program.law = law;
        program.timeS = -1;
        QCOMPARE(solve(program, Machine()).error().limit, Limit::FieldRange);
        program.timeS = 10;
        QCOMPARE(solve(program, Machine()).error().limit, Limit::LawUnknown);
    }
    program.law = LawId::Trapezoid;
    program.lawParameters = {0.6, 0};
    const auto solved = solve(program, Machine());
    QCOMPARE(solved.error().limit, Limit::LawParameter);
    QCOMPARE(solved.error().allowed, 0.5);
    Machine machine;
    machine.feedMmPerMotorRev = 0;
    program.lawParameters = {0.5, 0};
    QCOMPARE(solve(program, machine).error().field, Field::FeedPerMotorRev);
}

void TestPositionMove::brokenLimitsSuggest()
{
    const PositionMoveProgram program;
    Machine machine = paperMotor();
    machine.maxPulseFrequencyHz = 4000000;
    const auto solved = solve(program, machine);
    QCOMPARE(solved->broken.size(), std::size_t{1});
    const Refusal& refusal = solved->broken.front();
    QCOMPARE(refusal.limit, Limit::MotorSpeed);
    QCOMPARE(refusal.nearest.size(), std::size_t{2});
    QCOMPARE(refusal.nearest[0].field, Field::MoveTime);
    QCOMPARE(refusal.nearest[0].value, 2.25); // 6000 * 1.875 / 5000
    QCOMPARE(refusal.nearest[1].field, Field::Distance);
    QVERIFY(near(refusal.nearest[1].value, 2666.666, 1e-9));
    verifySuggestions(program, machine, refusal);
}

void TestPositionMove::fastest()
{
    PositionMoveProgram program;
    program.duration = MoveDuration::Fastest;
    program.timeS = std::nan(""); // not used
    Machine machine = paperMotor();
    machine.maxPulseFrequencyHz = 4000000;
    const auto limitedBySpeed = solve(program, machine);
    QCOMPARE(limitedBySpeed->motion.durationS(), 2.25);
    QVERIFY(limitedBySpeed->broken.empty());
    machine.maxAccelerationMmPerS2 = 1000;
    const auto limitedByAcceleration = solve(program, machine); // sqrt(6000 * 5.7735 / 1000) = 5.8857
    QCOMPARE(limitedByAcceleration->motion.durationS(), 5.886);
    machine.maxTorqueNm = 0.021; // 0.001 Nm beside friction: 795.77 mm/s^2, 6.5978 s
    const auto limitedByTorque = solve(program, machine);
    QCOMPARE(limitedByTorque->motion.durationS(), 6.598);
    program.distanceMm = 0.001;
    QCOMPARE(solve(program, machine)->motion.durationS(), 0.01); // minimum of the field
}

void TestPositionMove::fastestBeyondTheRange()
{
    PositionMoveProgram program;
    program.duration = MoveDuration::Fastest;
    program.distanceMm = -1000000;
    Machine machine = paperMotor();
    machine.maxMotorRpm = 30; // 50 mm/s: 37 500 s
    const auto solved = solve(program, machine);
    QCOMPARE(solved.error().limit, Limit::FieldRange);
    QCOMPARE(solved.error().field, Field::MoveTime);
    QVERIFY(near(solved.error().actual, 37500, 1e-12));
    QCOMPARE(solved.error().nearest.size(), std::size_t{1});
    QCOMPARE(solved.error().nearest.front().value, -16000.0);
    machine.frictionNm = 2;
    const auto noTorque = solve(program, machine);
    QCOMPARE(noTorque.error().limit, Limit::MotorTorque);
    QVERIFY(noTorque.error().nearest.empty());
}

void TestPositionMove::backwards()
{
    PositionMoveProgram program;
    const auto forwards = solve(program, Machine());
    program.distanceMm = -program.distanceMm;
    const auto backwards = solve(program, Machine());
    QCOMPARE(backwards->peaks.accelerationMmPerS2, forwards->peaks.accelerationMmPerS2);
    QCOMPARE(backwards->motion.at(0.3).positionMm, -forwards->motion.at(0.3).positionMm);
    QCOMPARE(backwards->broken.size(), forwards->broken.size());
    QVERIFY(backwards->broken.front().nearest[1].value < 0);
}

void TestPositionMove::randomMoves()
{
    const int count = campanel::test::randomCases();
    qInfo("seed %u, %d moves", seed, count);
    RandomValues random(seed);
    int refused = 0;
    int broken = 0;
    int suggestions = 0;
    for (int i = 0; i < count && !QTest::currentTestFailed(); ++i) {
        const PositionMoveProgram program = randomMove(random);
        const Machine machine = random.machine();
        const auto solved = solve(program, machine);
        QCOMPARE(isFeasible(program, machine), solved.has_value() && solved->broken.empty());
        if (!solved) {
            ++refused;
            verifySuggestions(program, machine, solved.error());
            continue;
        }
        verifyMotion(program, *solved);
        verifyAgainstSamples(*solved, machine);
        if (program.duration == MoveDuration::Fastest)
            verifyFastest(program, machine, *solved);
        if (!solved->broken.empty()) {
            ++broken;
            suggestions += static_cast<int>(solved->broken.front().nearest.size());
            verifySuggestions(program, machine, solved->broken.front());
        }
    }
    qInfo("%d refused, %d beyond a limit with %d suggestions", refused, broken, suggestions);
    if (!QTest::currentTestFailed())
        QVERIFY(refused > count / 20 && broken > count / 20 && suggestions > broken);
}

CAMPANEL_TEST(TestPositionMove)

} // namespace test_position_move

#include "test_position_move.moc"
