// SPDX-License-Identifier: Apache-2.0
// Cams and moves on the bench: with and without homing, the master's ramps and reversals, both stops, one run
// per start, a held speed, faults.
#include "rig.h"
#include "support/cam_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

namespace test_cam_motion {

using namespace campanel::test;

namespace {

constexpr std::uint64_t second = 1'000'000;
constexpr std::uint64_t settleUs =
    2 * CTL_CAM_UPDATE_US + CTL_SLICE_US; // from the master's rest to the axis'

} // namespace

class TestCamMotion : public QObject {
    Q_OBJECT

private slots:
    void pointCamHomesToTheMotorsMark();
    void stopsEndWhereTheyShould_data();
    void stopsEndWhereTheyShould();
    void masterTurnsRound_data();
    void masterTurnsRound();
    void startsBackward();
    void moveRunsOncePerStart();
    void moveStoppedMidwayIsOver();
    void stopAtCycleEndLetsTheMoveFinish();
    void speedIsHeldUntilAStop();
    void changeWhileRunningDoesNotJump();
    void changeOfKind();
    void masterTooFast();
    void callsMayComeAtAnyTime();
};

void TestCamMotion::pointCamHomesToTheMotorsMark()
{
    Rig rig;
    CamImage cam = sineCam(0.0, 2000.0, 200, 8'000'000);
    cam.pulsesPerMotorRev = 4000;
    rig.install(cam.registers());
    QCOMPARE(rig.status(CTL_REG_STATUS_PROGRAM_KIND), CTL_PROGRAM_KIND_POINT_CAM);
    QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & 1u << CTL_WARNING_BIT_NOT_HOMED) != 0);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QCOMPARE(rig.core().motion.state, CTL_STATE_HOMING);
    QVERIFY(rig.runUntilState(CTL_STATE_RUNNING, 5 * second));
    QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & 1u << CTL_WARNING_BIT_NOT_HOMED) == 0);
    // The mark is 300 degrees of the motor behind its position at power-up.
    QCOMPARE(rig.core().motion.origin, std::int64_t{4000 / 6 + 1});
    rig.run(5 * second);
    QVERIFY(std::abs(rig.commanded()) <= 2001);
    QCOMPARE(rig.core().bags.count, 0u);
    QCOMPARE(rig.status(CTL_REG_STATUS_KNIFE_ANGLE), 0);
}

void TestCamMotion::stopsEndWhereTheyShould_data()
{
    QTest::addColumn<unsigned>("shape");
    QTest::addColumn<unsigned>("masterRampMs");
    QTest::addColumn<unsigned>("cycleTicks");
    for (const auto& [name, shape] :
         {std::pair{"trapezoid", CTL_RAMP_SHAPE_TRAPEZOID}, {"S", CTL_RAMP_SHAPE_SCURVE}}) {
        QTest::addRow("%s, ramp shorter than a cycle", name) << unsigned{shape} << 300u << 8'000'000u;
        QTest::addRow("%s, ramp over many cycles", name) << unsigned{shape} << 2000u << 1'600'001u;
        QTest::addRow("%s, full speed at once", name) << unsigned{shape} << 0u << 3'200'000u;
    }
}

// At the boundary: a multiple of the advance. Now: anywhere, and then from there.
void TestCamMotion::stopsEndWhereTheyShould()
{
    QFETCH(unsigned, shape);
    QFETCH(unsigned, masterRampMs);
    QFETCH(unsigned, cycleTicks);
    constexpr std::uint64_t seed = 31;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    CamImage cam = sineCam(4000.0 + 1.0 / 3.0, 500.0, 100, cycleTicks);
    cam.remainder = 1;
    cam.divisor = 3;
    cam.masterRampMs = static_cast<std::uint16_t>(masterRampMs);
    cam.rampShape = static_cast<std::uint16_t>(shape);
    Rig rig;
    rig.install(cam.registers());
    for (int i = 0; i < 12; ++i) {
        rig.start();
        rig.run(random() % (3 * second));
        const bool atBoundary = i % 3 != 0;
        QCOMPARE(rig.command(atBoundary ? CTL_COMMAND_STOP_AT_CYCLE_END : CTL_COMMAND_STOP_NOW),
                 CTL_REFUSAL_NONE);
        const std::uint64_t begunUs = rig.controller().nowUs();
        std::uint32_t speed = rig.core().motion.ramp.speed;
        while (rig.core().motion.state == CTL_STATE_STOPPING) {
            rig.controller().step();
            const ctl_ramp& ramp = rig.core().motion.ramp;
            QVERIFY(speed <= ramp.speed + 4000 || speed < ramp.full / 100);
            speed = ramp.speed;
            QVERIFY(rig.controller().nowUs() - begunUs < 60 * second);
        }
        QCOMPARE(rig.core().motion.state, CTL_STATE_READY);
        if (!atBoundary) {
            const std::uint64_t rampUs = 1000u * (masterRampMs == 0 ? 800u : masterRampMs);
            QVERIFY(rig.controller().nowUs() - begunUs <= rampUs + settleUs);
            continue;
        }
        QVERIFY(ctl_table_between_cycles(&rig.core().motion.table));
        const double exact = rig.core().motion.cycle_count * (4000.0 + 1.0 / 3.0);
        QVERIFY2(std::abs(static_cast<double>(rig.commanded()) - exact) <= 0.5 + 1.0 / 256.0,
                 qPrintable(QStringLiteral("%1, exactly %2").arg(rig.commanded()).arg(exact)));
    }
}

void TestCamMotion::masterTurnsRound_data()
{
    QTest::addColumn<unsigned>("shape");
    QTest::addColumn<unsigned>("masterRampMs");
    QTest::newRow("trapezoid") << unsigned{CTL_RAMP_SHAPE_TRAPEZOID} << 400u;
    QTest::newRow("S") << unsigned{CTL_RAMP_SHAPE_SCURVE} << 400u;
    QTest::newRow("full speed at once") << unsigned{CTL_RAMP_SHAPE_TRAPEZOID} << 0u;
}

void TestCamMotion::masterTurnsRound()
{
    QFETCH(unsigned, shape);
    QFETCH(unsigned, masterRampMs);
    CamImage cam = sineCam(10'000.0, 800.0, 100, 4'000'000); // 20 kHz in the mean, 30 kHz at most
    cam.masterRampMs = static_cast<std::uint16_t>(masterRampMs);
    cam.rampShape = static_cast<std::uint16_t>(shape);
    Rig rig;
    rig.install(cam.registers());
    rig.start();
    rig.run(3 * second);
    for (const std::uint16_t direction : {std::uint16_t{1}, std::uint16_t{0}, std::uint16_t{1}}) {
        rig.setParameter(CTL_REG_PARAMETER_MASTER_DIRECTION, direction);
        // 30 kHz are 7.5 pulses per slice; a slice of the ramp hardly changes that.
        const std::int64_t jolt = rig.maxJolt(3 * second);
        QVERIFY2(jolt <= 2, qPrintable(QString::number(jolt)));
        QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
        QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_SPEED), 10000);
        const std::int32_t hz = rig.signedWide(CTL_REG_STATUS_COMMANDED_FREQUENCY);
        QVERIFY(direction == 1 ? hz < -9000 && hz > -31'000 : hz > 9000 && hz < 31'000);
        const unsigned before = rig.status(CTL_REG_STATUS_MASTER_ANGLE);
        const unsigned turned = (rig.status(CTL_REG_STATUS_MASTER_ANGLE) + 36000u - before) % 36000u;
        QVERIFY(direction == 1 ? turned > 18000 : turned < 18000 && turned > 0);
    }
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.commanded() % 10'000, std::int64_t{0});
    QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_ANGLE), 0);
}

void TestCamMotion::startsBackward()
{
    Rig rig;
    rig.install(sineCam(10'000.0, 800.0, 100, 4'000'000).registers());
    rig.setParameter(CTL_REG_PARAMETER_MASTER_DIRECTION, 1);
    rig.start();
    rig.run(5 * second);
    QVERIFY(rig.commanded() < -80'000);
    QVERIFY(rig.core().motion.cycle_count >= 9);
}

void TestCamMotion::moveRunsOncePerStart()
{
    CamImage move = quinticMove(-30'000.0 - 1.0 / 3.0, 100, 8'000'000);
    move.remainder = 2;
    move.divisor = 3;
    Rig rig;
    rig.install(move.registers());
    QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & 1u << CTL_WARNING_BIT_NOT_HOMED) == 0);
    rig.setParameter(CTL_REG_PARAMETER_MASTER_DIRECTION, 1); // applies only to point cams
    for (int run = 1; run <= 6; ++run) {
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
        QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_SPEED), 10000);
        const std::uint64_t begunUs = rig.controller().nowUs();
        QVERIFY(rig.runUntilState(CTL_STATE_READY, 2 * second));
        QVERIFY(rig.controller().nowUs() - begunUs < second + settleUs);
        const double exact = -run * (30'000.0 + 1.0 / 3.0);
        QVERIFY(std::abs(static_cast<double>(rig.core().motion.commanded) - exact) <= 0.5 + 1.0 / 256.0);
        QCOMPARE(rig.core().motion.cycle_count, static_cast<std::uint32_t>(run));
        QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_ANGLE), 0);
        const std::int64_t rest = rig.core().motion.commanded;
        rig.run(second);
        QCOMPARE(rig.core().motion.commanded, rest);
        QCOMPARE(rig.core().motion.state, CTL_STATE_READY);
    }
}

void TestCamMotion::moveStoppedMidwayIsOver()
{
    Rig rig;
    rig.install(quinticMove(30'000.0, 100, 16'000'000).registers());
    rig.command(CTL_COMMAND_START);
    rig.run(second);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, 800'000 + settleUs));
    const std::int64_t stopped = rig.core().motion.commanded;
    QVERIFY(stopped > 15'000 && stopped < 29'000);
    QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_ANGLE), 0);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, 3 * second));
    QCOMPARE(rig.core().motion.commanded - stopped, std::int64_t{30'000});
}

void TestCamMotion::stopAtCycleEndLetsTheMoveFinish()
{
    Rig rig;
    rig.install(quinticMove(30'000.0, 100, 16'000'000).registers());
    rig.command(CTL_COMMAND_START);
    rig.run(second);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QCOMPARE(rig.core().motion.state, CTL_STATE_STOPPING);
    QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_SPEED), 10000);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, second));
    QCOMPARE(rig.core().motion.commanded, std::int64_t{30'000});
}

void TestCamMotion::speedIsHeldUntilAStop()
{
    for (const std::uint16_t code :
         {std::uint16_t{CTL_COMMAND_STOP_NOW}, std::uint16_t{CTL_COMMAND_STOP_AT_CYCLE_END}}) {
        Rig rig;
        rig.install(speedMove(20'000.0, 100, 8'000'000).registers());
        rig.setParameter(CTL_REG_PARAMETER_RAMP_TIME, 400);
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        QVERIFY(rig.maxJolt(2 * second) <= 2);
        QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
        QCOMPARE(rig.core().motion.cycle_count, 1u);
        QCOMPARE(rig.signedWide(CTL_REG_STATUS_COMMANDED_FREQUENCY), 20'000);
        QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_ANGLE), 36000);
        const std::int64_t before = rig.core().motion.commanded;
        rig.run(10 * second);
        QVERIFY(std::abs(rig.core().motion.commanded - before - 200'000) <= 1);
        QCOMPARE(rig.command(code), CTL_REFUSAL_NONE);
        const std::int64_t top = rig.core().motion.commanded;
        QVERIFY(rig.maxJolt(400'000 + settleUs) <= 2);
        QCOMPARE(rig.core().motion.state, CTL_STATE_READY);
        // Half of the travel at full speed during the ramp, and two pending updates.
        const std::int64_t braked = rig.core().motion.commanded - top;
        QVERIFY2(std::abs(braked - 4000) <= 90, qPrintable(QString::number(braked)));
        QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_ANGLE), 0);
    }
}

void TestCamMotion::changeWhileRunningDoesNotJump()
{
    CamImage one = sineCam(3000.0, 300.0, 100, 2'400'000);
    CamImage other = sineCam(3000.0, -300.0, 64, 2'400'000); // starts and ends 2500 Hz apart from the first
    Rig rig;
    rig.install(one.registers());
    rig.start();
    rig.run(second);
    for (std::uint16_t change = 0; change < 10; ++change) {
        const Registers image = (change % 2 == 0 ? other : one).registers();
        const auto session = static_cast<std::uint16_t>(change + 2);
        const std::uint32_t generation = rig.core().banks.generation;
        QCOMPARE(rig.download(image, session), CTL_TRANSFER_RESULT_ACCEPTED);
        QCOMPARE(rig.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, session), CTL_REFUSAL_NONE);
        QVERIFY(rig.maxJolt(second) <= 5);
        QCOMPARE(rig.core().banks.generation, generation + 1);
    }
    rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.commanded(), std::int64_t{3000} * rig.core().motion.cycle_count);
    CamImage otherFeed = one;
    otherFeed.feedUm += 1;
    rig.start();
    QCOMPARE(rig.download(otherFeed.registers(), 99), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(otherFeed.registers(), CTL_APPLY_MODE_NEXT_CYCLE, 99),
             CTL_REFUSAL_MACHINE_DATA_DIFFERS);
}

void TestCamMotion::changeOfKind()
{
    Rig rig;
    rig.install(camBank(10000, 1, 8'000'000));
    rig.start();
    rig.run(3 * second);
    rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    const std::uint32_t bags = rig.core().bags.count;
    QVERIFY(bags > 0);
    rig.install(quinticMove(30'000.0, 100, 8'000'000).registers(), 2);
    const std::int64_t before = rig.core().motion.commanded;
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.core().motion.commanded - before, std::int64_t{30'000});
    QCOMPARE(rig.core().bags.count, bags);
    rig.install(camBank(10000, 1, 8'000'000));
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QCOMPARE(rig.core().motion.state, CTL_STATE_HOMING);
    QVERIFY(rig.runUntilState(CTL_STATE_RUNNING));
}

// Each row is within the limit; the cubic between two of them is half as fast again.
void TestCamMotion::masterTooFast()
{
    CamImage cam;
    cam.kind = CTL_PROGRAM_KIND_POSITION_MOVE;
    cam.atEnd = CTL_END_BEHAVIOR_STOP;
    cam.masterRampMs = 0;
    cam.cycleTicks = 1'600'000; // 0.2 s, twice 18 000 pulses
    cam.rows = {{0, 0}, {256 * 18'000, 0}, {256 * 36'000, 0}};
    cam.advance = 36'000;
    Rig rig;
    rig.install(cam.registers());
    rig.write(CTL_REG_PARAMETER_FOLLOWING_ERROR_LIMIT, {15, 0}); // the lag itself must not cause a fault
    for (int i = 0; i < 2; ++i) {
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        QVERIFY(rig.runUntilState(CTL_STATE_FAULT, second));
        QCOMPARE(rig.core().motion.fault, 1u << CTL_FAULT_BIT_MASTER_TOO_FAST);
        const std::int64_t stopped = rig.core().motion.commanded;
        rig.run(second);
        QCOMPARE(rig.core().motion.commanded, stopped);
        QCOMPARE(rig.signedWide(CTL_REG_STATUS_COMMANDED_FREQUENCY), 0);
        QCOMPARE(rig.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NONE);
    }
    rig.install(quinticMove(10'000.0, 100, 8'000'000).registers(), 2);
    const std::int64_t before = rig.core().motion.commanded;
    rig.command(CTL_COMMAND_START);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, 2 * second));
    QCOMPARE(rig.core().motion.commanded - before, std::int64_t{10'000});
}

// The updates keep their period for irregular calls.
void TestCamMotion::callsMayComeAtAnyTime()
{
    constexpr std::uint64_t seed = 32;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    const CamImage move = quinticMove(30'000.0, 100, 8'000'000);
    Rig even;
    Rig uneven;
    even.install(move.registers());
    uneven.install(move.registers());
    for (Rig* rig : {&even, &uneven}) // its machine does not run here
        rig->write(CTL_REG_PARAMETER_FOLLOWING_ERROR_LIMIT, {15, 0});
    even.command(CTL_COMMAND_START);
    uneven.command(CTL_COMMAND_START);
    const std::uint64_t beginUs = even.controller().nowUs();
    QCOMPARE(uneven.controller().nowUs(), beginUs);
    std::uint64_t nowUs = beginUs;
    for (std::uint64_t updateUs = beginUs; updateUs < beginUs + second; updateUs += CTL_CAM_UPDATE_US) {
        ctl_tick(&even.core(), updateUs);
        while (nowUs < updateUs) {
            nowUs = std::min(updateUs, nowUs + 1 + random() % 700);
            ctl_tick(&uneven.core(), nowUs);
        }
        QCOMPARE(uneven.core().motion.table.cam.line_to, even.core().motion.table.cam.line_to);
        QCOMPARE(uneven.core().motion.table.cam.sent, even.core().motion.table.cam.sent);
    }
}

CAMPANEL_TEST(TestCamMotion)

} // namespace test_cam_motion

#include "test_cam_motion.moc"
