// SPDX-License-Identifier: Apache-2.0
// Speed moves: the servo paper's numbers, slowing down, over a distance, the fastest time, and seeded random
// moves.
#include "move_checks.h"
#include "random_cases.h"

#include "profile/moves/speed_move.h"
#include "tests/support/test_program.h"

namespace test_speed_move {

using namespace campanel::profile;
using namespace campanel::profile::test;

namespace {

constexpr unsigned seed = 54009000;

SpeedMoveProgram randomMove(RandomValues& random)
{
    SpeedMoveProgram p;
    p.startSpeedMmPerS = random.pick(3) == 0 ? 0 : random.decades(Field::StartSpeed, 1, 10000);
    p.endSpeedMmPerS = random.pick(3) == 0 ? 0 : random.decades(Field::EndSpeed, 1, 10000);
    p.timeS = random.decades(Field::MoveTime, 0.01, 500);
    p.distanceMm = random.decades(Field::Distance, 0.01, 500000);
    p.duration = static_cast<MoveDuration>(random.pick(3));
    const Law& law = laws()[random.pick(laws().size())];
    p.law = law.id;
    p.lawParameters = random.parametersOf(law);
    return p;
}

void verifyMotion(const SpeedMoveProgram& program, const AxisMotion& solved)
{
    const MotionProfile& motion = solved.motion;
    const MotionPoint start = motion.at(0);
    const MotionPoint end = motion.at(motion.durationS());
    QVERIFY(near(start.velocityMmPerS, program.startSpeedMmPerS, 1e-12));
    QVERIFY(near(end.velocityMmPerS, program.endSpeedMmPerS, 1e-12));
    QVERIFY(near(start.positionMm, 0, 1e-12));
    const double room = 1e-9 * std::max(std::abs(end.positionMm), solved.peaks.speedMmPerS);
    QVERIFY(std::abs(end.positionMm - meanSpeedMmPerS(program) * motion.durationS()) <= room + 1e-12);
    if (program.duration == MoveDuration::OverDistance)
        QVERIFY(std::abs(end.positionMm - program.distanceMm) <= room + 1e-12);
    else
        QCOMPARE(snapToGrid(Field::MoveTime, motion.durationS()), motion.durationS());
    QVERIFY(inRange(Field::MoveTime, motion.durationS()));
}

void verifyFastest(const SpeedMoveProgram& program, const Machine& machine, const AxisMotion& solved)
{
    if (!solved.broken.empty()) // a speed itself is too fast
        return;
    SpeedMoveProgram faster = program;
    faster.duration = MoveDuration::GivenTime;
    faster.timeS = snapToGrid(Field::MoveTime, solved.motion.durationS() - 0.001);
    if (faster.timeS < solved.motion.durationS())
        QVERIFY(!isClearlyFeasible(faster, machine));
}

// 2000 mm/s are allowed by the pulse frequency.
SpeedMoveProgram gentleMove()
{
    SpeedMoveProgram program;
    program.endSpeedMmPerS = 1000;
    return program;
}

} // namespace

class TestSpeedMove : public QObject {
    Q_OBJECT

private slots:
    void paperNumbers();
    void slowingDownIsSpeedingUpBackwards_data();
    void slowingDownIsSpeedingUpBackwards();
    void overDistance_data();
    void overDistance();
    void refused();
    void derivedTimeOutOfRange();
    void brokenLimitsSuggest();
    void fastest();
    void randomMoves();
};

void TestSpeedMove::paperNumbers()
{
    const SpeedMoveProgram program; // 0 to 5400 r/min (9000 mm/s) in 1 s by half a modified sine
    const auto solved = solve(program, Machine());
    QVERIFY(solved.has_value());
    constexpr double mmPerRev = 100;
    const double revolutions = solved->motion.at(1).positionMm / mmPerRev;
    QVERIFY(std::abs(revolutions - 51.1479) < 5e-5);
    QVERIFY(std::abs(solved->peaks.accelerationMmPerS2 / mmPerRev - 141.37) < 5e-3);
    QCOMPARE(solved->peaks.motorRpm, 5400.0);
    QVERIFY(near(solved->peaks.accelerationTimeS, 0.25, 1e-12));
    QVERIFY(near(solved->motion.at(0).accelerationMmPerS2, 0, 1e-9));
    QVERIFY(near(solved->motion.at(1).accelerationMmPerS2, 0, 1e-9));
}

void TestSpeedMove::slowingDownIsSpeedingUpBackwards_data()
{
    QTest::addColumn<int>("law");
    for (const Law& law : laws())
        QTest::newRow(std::string(law.key).c_str()) << static_cast<int>(law.id);
}

void TestSpeedMove::slowingDownIsSpeedingUpBackwards()
{
    QFETCH(int, law);
    SpeedMoveProgram up;
    up.startSpeedMmPerS = 200;
    up.law = static_cast<LawId>(law);
    up.lawParameters = defaultParameters(*findLaw(up.law));
    SpeedMoveProgram down = up;
    std::swap(down.startSpeedMmPerS, down.endSpeedMmPerS);
    SpeedMoveProgram backwards = down; // the same in the other direction
    backwards.startSpeedMmPerS *= -1;
    backwards.endSpeedMmPerS *= -1;
    const auto rising = solve(up, Machine());
    const auto falling = solve(down, Machine());
    const auto mirrored = solve(backwards, Machine());
    const double whole = rising->motion.at(1).positionMm;
    for (int i = 0; i <= 100; ++i) {
        const MotionPoint there = rising->motion.at(1 - i / 100.0);
        const MotionPoint back = falling->motion.at(i / 100.0);
        QVERIFY(near(back.velocityMmPerS, there.velocityMmPerS, 1e-12));
        QVERIFY(near(back.accelerationMmPerS2, -there.accelerationMmPerS2, 1e-9));
        QVERIFY(near(back.jerkMmPerS3, there.jerkMmPerS3, 1e-9));
        QVERIFY(near(back.positionMm, whole - there.positionMm, 1e-9));
        QVERIFY(near(mirrored->motion.at(i / 100.0).positionMm, -back.positionMm, 1e-9));
    }
    QVERIFY(near(meanSpeedMmPerS(down), meanSpeedMmPerS(up), 1e-12));
    QVERIFY(near(falling->peaks.accelerationMmPerS2, rising->peaks.accelerationMmPerS2, 1e-12));
    const bool isSmooth = up.law != LawId::Exponential;
    QCOMPARE(std::abs(falling->motion.at(0).accelerationMmPerS2) < 1e-6, isSmooth);
    QCOMPARE(std::abs(falling->motion.at(1).accelerationMmPerS2) < 1e-6, isSmooth);
    QCOMPARE(std::isfinite(falling->peaks.jerkMmPerS3), isSmooth);
}

void TestSpeedMove::overDistance_data()
{
    QTest::addColumn<double>("start");
    QTest::addColumn<double>("end");
    QTest::addColumn<double>("distance");
    QTest::addColumn<double>("time");
    const double g1 = 0.568309886; // half modified sine
    QTest::newRow("from rest") << 0.0 << 1000.0 << 500.0 << 0.5 / g1;
    QTest::newRow("to rest") << 1000.0 << 0.0 << 500.0 << 0.5 / g1;
    QTest::newRow("faster") << 400.0 << 1000.0 << 500.0 << 500 / (400 + 600 * g1);
    QTest::newRow("slower") << 1000.0 << 400.0 << 500.0 << 500 / (400 + 600 * g1);
    QTest::newRow("backwards") << 0.0 << -1000.0 << -500.0 << 0.5 / g1;
    QTest::newRow("there and back") << -400.0 << 1000.0 << 500.0 << 500 / (-400 + 1400 * g1);
}

void TestSpeedMove::overDistance()
{
    QFETCH(double, start);
    QFETCH(double, end);
    QFETCH(double, distance);
    QFETCH(double, time);
    SpeedMoveProgram program;
    program.startSpeedMmPerS = start;
    program.endSpeedMmPerS = end;
    program.distanceMm = distance;
    program.duration = MoveDuration::OverDistance;
    program.timeS = -1; // not used
    const auto solved = solve(program, Machine());
    QVERIFY(solved.has_value());
    QVERIFY(near(solved->motion.durationS(), time, 1e-8));
    verifyMotion(program, *solved);
    program.distanceMm = -distance;
    const auto wrongSign = solve(program, Machine());
    QCOMPARE(wrongSign.error().limit, Limit::DistanceSign);
    QVERIFY(!wrongSign.error().nearest.empty());
    QCOMPARE(wrongSign.error().nearest.front().field, Field::Distance);
    verifySuggestions(program, Machine(), wrongSign.error());
}

void TestSpeedMove::refused()
{
    SpeedMoveProgram program = gentleMove();
    program.startSpeedMmPerS = 1000;
    QCOMPARE(solve(program, Machine()).error().limit, Limit::NoMotion);
    program = gentleMove();
    program.law = static_cast<LawId>(0);
    QCOMPARE(solve(program, Machine()).error().limit, Limit::LawUnknown);
    program = gentleMove();
    program.law = LawId::Exponential;
    program.lawParameters = {0, 0};
    QCOMPARE(solve(program, Machine()).error().limit, Limit::LawParameter);
    program = gentleMove();
    program.endSpeedMmPerS = 200000;
    const auto tooFast = solve(program, Machine());
    QCOMPARE(tooFast.error().field, Field::EndSpeed);
    QCOMPARE(tooFast.error().nearest.front().value, 2000.0);
    program.endSpeedMmPerS = std::nan("");
    verifySuggestions(program, Machine(), solve(program, Machine()).error());
    program = gentleMove();
    program.startSpeedMmPerS = -1000;
    program.law = LawId::Quintic; // forward and back to the same place, for any time
    program.duration = MoveDuration::OverDistance;
    QCOMPARE(solve(program, Machine()).error().limit, Limit::NoMotion);
    Machine machine;
    machine.inertiaKgCm2 = -1;
    const auto wrongMachine = solve(gentleMove(), machine);
    QCOMPARE(wrongMachine.error().field, Field::Inertia);
    QCOMPARE(wrongMachine.error().nearest.front().value, 0.0);
}

void TestSpeedMove::derivedTimeOutOfRange()
{
    SpeedMoveProgram program = gentleMove();
    program.law = LawId::Quintic;
    program.duration = MoveDuration::OverDistance;
    program.distanceMm = 4; // 0.008 s; 0.01 s would break the acceleration as well
    const auto tooShort = solve(program, Machine());
    QCOMPARE(tooShort.error().limit, Limit::DistanceTooShort);
    QVERIFY(near(tooShort.error().allowed, 5, 1e-12));
    QCOMPARE(tooShort.error().nearest.front().field, Field::Distance);
    QCOMPARE(tooShort.error().nearest.front().value, 18.75); // 1000 * 1.875 / 50 000 s
    verifySuggestions(program, Machine(), tooShort.error());
    program.distanceMm = 0;
    QCOMPARE(solve(program, Machine()).error().limit, Limit::DistanceTooShort);
    program.distanceMm = 400000; // 800 s
    const auto tooLong = solve(program, Machine());
    QCOMPARE(tooLong.error().limit, Limit::FieldRange);
    QCOMPARE(tooLong.error().field, Field::MoveTime);
    QVERIFY(near(tooLong.error().actual, 800, 1e-12));
    QCOMPARE(tooLong.error().nearest.front().value, 300000.0);
    verifySuggestions(program, Machine(), tooLong.error());
}

void TestSpeedMove::brokenLimitsSuggest()
{
    SpeedMoveProgram program = gentleMove();
    program.law = LawId::Quintic;
    program.timeS = 0.03; // 62 500 mm/s^2
    const auto solved = solve(program, Machine());
    QCOMPARE(solved->broken.size(), std::size_t{1});
    const Refusal& refusal = solved->broken.front();
    QCOMPARE(refusal.limit, Limit::AxisAcceleration);
    QVERIFY(near(refusal.actual, 62500, 1e-12));
    QCOMPARE(refusal.nearest.size(), std::size_t{3});
    QCOMPARE(refusal.nearest[0].field, Field::MoveTime);
    QCOMPARE(refusal.nearest[0].value, 0.038);
    QCOMPARE(refusal.nearest[1].field, Field::EndSpeed);
    QCOMPARE(refusal.nearest[1].value, 800.0);
    QCOMPARE(refusal.nearest[2].field, Field::StartSpeed);
    QCOMPARE(refusal.nearest[2].value, 200.0);
    program.endSpeedMmPerS = 9000; // beyond the pulse frequency, at any time
    program.timeS = 10;
    const auto tooFast = solve(program, Machine());
    QCOMPARE(tooFast->broken.front().nearest.size(), std::size_t{1});
    QCOMPARE(tooFast->broken.front().nearest.front().value, 2000.0);
}

void TestSpeedMove::fastest()
{
    SpeedMoveProgram program = gentleMove();
    program.duration = MoveDuration::Fastest;
    Machine machine = paperMotor();
    QCOMPARE(solve(program, machine)->motion.durationS(), 0.032); // 1000 * pi / 2 / 50 000 = 0.0314
    machine.maxAccelerationMmPerS2 = 2;
    const auto tooSlow = solve(program, machine); // 785 s
    QCOMPARE(tooSlow.error().field, Field::MoveTime);
    QCOMPARE(tooSlow.error().nearest.front().field, Field::EndSpeed);
    QCOMPARE(tooSlow.error().nearest.front().value, 763.9); // 2 * 600 / (pi / 2)
    machine.frictionNm = 5;
    QCOMPARE(solve(program, machine).error().limit, Limit::MotorTorque);
    program.endSpeedMmPerS = 9000;
    QCOMPARE(solve(program, Machine())->broken.size(), std::size_t{2}); // motor speed and pulse frequency
}

void TestSpeedMove::randomMoves()
{
    const int count = campanel::test::randomCases();
    qInfo("seed %u, %d moves", seed, count);
    RandomValues random(seed);
    int refused = 0;
    int broken = 0;
    int sound = 0;
    int suggestions = 0;
    for (int i = 0; i < count && !QTest::currentTestFailed(); ++i) {
        const SpeedMoveProgram program = randomMove(random);
        const Machine machine = random.machine();
        const auto solved = solve(program, machine);
        QCOMPARE(isFeasible(program, machine), solved.has_value() && solved->broken.empty());
        if (!solved) {
            ++refused;
            suggestions += static_cast<int>(solved.error().nearest.size());
            verifySuggestions(program, machine, solved.error());
            continue;
        }
        verifyMotion(program, *solved);
        verifyAgainstSamples(*solved, machine);
        if (program.duration == MoveDuration::Fastest)
            verifyFastest(program, machine, *solved);
        if (solved->broken.empty()) {
            ++sound;
            continue;
        }
        ++broken;
        suggestions += static_cast<int>(solved->broken.front().nearest.size());
        verifySuggestions(program, machine, solved->broken.front());
    }
    qInfo("%d refused, %d beyond a limit, %d sound, %d suggestions", refused, broken, sound, suggestions);
    if (!QTest::currentTestFailed())
        QVERIFY(refused > count / 20 && broken > count / 20 && sound > count / 20 && suggestions > count / 5);
}

CAMPANEL_TEST(TestSpeedMove)

} // namespace test_speed_move

#include "test_speed_move.moc"
