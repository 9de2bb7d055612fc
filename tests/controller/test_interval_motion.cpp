// SPDX-License-Identifier: Apache-2.0
// Moves of intervals on the bench, by commands: one run per start, a held speed, both stops, flash, refusals.
// Positions are compared with uniformly accelerated motion in floating point.
#include "bank/ctl_check.h"
#include "rig.h"
#include "support/cam_image.h"
#include "support/interval_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>

namespace test_interval_motion {

using namespace campanel::test;

namespace {

constexpr std::uint64_t second = 1'000'000;

void addDirections()
{
    QTest::addColumn<bool>("backwards");
    QTest::newRow("forward") << false;
    QTest::newRow("backward") << true;
}

} // namespace

class TestIntervalMotion : public QObject {
    Q_OBJECT

private slots:
    void moveRunsOncePerStart_data() { addDirections(); }
    void moveRunsOncePerStart();
    void moveStoppedMidwayIsOver_data() { addDirections(); }
    void moveStoppedMidwayIsOver();
    void stopAtCycleEndLetsTheMoveFinish();
    void speedIsHeldUntilAStop_data();
    void speedIsHeldUntilAStop();
    void stoppedBeforeTheSpeedIsReached();
    void changeOfLayout();
    void survivesPowerLoss();
    void damagedWhileRunning();
    void refusals_data();
    void refusals();
};

// 2/3 pulse per run are owed, towards plus infinity in either direction.
void TestIntervalMotion::moveRunsOncePerStart()
{
    QFETCH(bool, backwards);
    IntervalImage move = trapezoidMove(backwards);
    move.remainder = 2;
    move.divisor = 3;
    Rig rig;
    rig.install(move.registers());
    QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & 1u << CTL_WARNING_BIT_NOT_HOMED) == 0);
    rig.setParameter(CTL_REG_PARAMETER_MASTER_DIRECTION, 1); // applies only to point cams
    const std::int64_t begin = rig.core().motion.commanded;
    const double sign = backwards ? -1 : 1;
    for (std::int64_t run = 1; run <= 6; ++run) {
        const std::int64_t runBegin = rig.core().motion.commanded;
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
        QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_SPEED), 10000);
        double worst = 0;
        double endS = 0;
        while (rig.core().motion.state == CTL_STATE_RUNNING) {
            rig.controller().step();
            // The table's own ticks: the time between the command and its first slice is not included.
            const std::uint32_t ticks = rig.core().motion.table.interval.cycle_ticks;
            endS = ticks / 8e6;
            const auto moved = static_cast<double>(rig.core().motion.commanded - runBegin);
            worst = std::max(worst, std::abs(sign * moved - pulsesAfter(move.rows, endS)));
            QVERIFY(endS < 1);
        }
        QVERIFY2(worst <= 2, qPrintable(QString::number(worst)));
        QVERIFY2(std::abs(endS - move.timeS()) < 0.02, qPrintable(QString::number(endS - move.timeS())));
        QVERIFY(rig.runUntilState(CTL_STATE_READY, second / 1000));
        QCOMPARE(rig.core().motion.commanded - begin, run * move.advance() + run * 2 / 3);
        QCOMPARE(rig.core().motion.cycle_count, static_cast<std::uint32_t>(run));
        QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_ANGLE), 0);
        QCOMPARE(rig.signedWide(CTL_REG_STATUS_COMMANDED_FREQUENCY), 0);
        const std::int64_t rest = rig.core().motion.commanded;
        rig.run(second);
        QCOMPARE(rig.core().motion.commanded, rest);
        QCOMPARE(rig.core().motion.state, CTL_STATE_READY);
    }
}

void TestIntervalMotion::moveStoppedMidwayIsOver()
{
    QFETCH(bool, backwards);
    const IntervalImage move = trapezoidMove(backwards);
    Rig rig;
    rig.install(move.registers());
    rig.setParameter(CTL_REG_PARAMETER_RAMP_TIME, 200);
    rig.command(CTL_COMMAND_START);
    rig.run(second * 3 / 10);
    QCOMPARE(rig.signedWide(CTL_REG_STATUS_COMMANDED_FREQUENCY), backwards ? -20'000 : 20'000);
    const unsigned angle = rig.status(CTL_REG_STATUS_MASTER_ANGLE);
    QVERIFY2(angle > 11'000 && angle < 12'500, qPrintable(QString::number(angle)));
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
    const std::int64_t top = rig.core().motion.commanded;
    QVERIFY(rig.maxJolt(second / 10) <= 2);
    // Half-way through the ramp the generator runs at half its speed.
    const std::int32_t hz = rig.signedWide(CTL_REG_STATUS_COMMANDED_FREQUENCY);
    QVERIFY(std::abs(std::abs(hz) - 9700) < 500 && (hz < 0) == backwards);
    QVERIFY(rig.maxJolt(second / 10) <= 2);
    QCOMPARE(rig.core().motion.state, CTL_STATE_READY);
    const std::int64_t stopped = rig.core().motion.commanded;
    QVERIFY2(std::abs(std::abs(stopped - top) - 2000) <= 60, qPrintable(QString::number(stopped - top)));
    QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_ANGLE), 0);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, second));
    QCOMPARE(rig.core().motion.commanded - stopped, move.advance());
}

void TestIntervalMotion::stopAtCycleEndLetsTheMoveFinish()
{
    const IntervalImage move = trapezoidMove();
    Rig rig;
    rig.install(move.registers());
    const std::int64_t begin = rig.core().motion.commanded;
    rig.command(CTL_COMMAND_START);
    rig.run(second / 2);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QCOMPARE(rig.core().motion.state, CTL_STATE_STOPPING);
    QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_SPEED), 10000);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, second / 2));
    QCOMPARE(rig.core().motion.commanded - begin, move.advance());
}

void TestIntervalMotion::speedIsHeldUntilAStop_data()
{
    QTest::addColumn<bool>("backwards");
    QTest::addColumn<std::uint16_t>("code");
    for (const bool backwards : {false, true}) {
        const char* way = backwards ? "backward" : "forward";
        QTest::addRow("%s, stop now", way) << backwards << std::uint16_t{CTL_COMMAND_STOP_NOW};
        QTest::addRow("%s, stop at cycle end", way)
            << backwards << std::uint16_t{CTL_COMMAND_STOP_AT_CYCLE_END};
    }
}

void TestIntervalMotion::speedIsHeldUntilAStop()
{
    QFETCH(bool, backwards);
    QFETCH(std::uint16_t, code);
    const IntervalImage move = rampAndHold(backwards);
    const std::int64_t sign = backwards ? -1 : 1;
    Rig rig;
    rig.install(move.registers());
    rig.setParameter(CTL_REG_PARAMETER_RAMP_TIME, 400);
    for (std::uint32_t run = 1; run <= 2; ++run) {
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        QVERIFY(rig.maxJolt(second) <= 1);
        QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
        QCOMPARE(rig.core().motion.cycle_count, run);
        QVERIFY(ctl_table_holding(&rig.core().motion.table));
        QCOMPARE(rig.signedWide(CTL_REG_STATUS_COMMANDED_FREQUENCY),
                 static_cast<std::int32_t>(sign) * 20'000);
        QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_ANGLE), 36000);
        const std::int64_t before = rig.core().motion.commanded;
        rig.run(10 * second);
        const std::int64_t held = sign * (rig.core().motion.commanded - before);
        QVERIFY2(std::abs(held - 200'000) <= 1, qPrintable(QString::number(held)));
        QCOMPARE(rig.core().motion.cycle_count, run);
        const std::uint64_t begunUs = rig.controller().nowUs();
        const std::int64_t top = rig.core().motion.commanded;
        QCOMPARE(rig.command(code), CTL_REFUSAL_NONE);
        QCOMPARE(rig.core().motion.state, CTL_STATE_STOPPING);
        QVERIFY(rig.maxJolt(390'000) <= 1);
        QVERIFY(rig.runUntilState(CTL_STATE_READY, second / 10));
        QVERIFY(rig.controller().nowUs() - begunUs <= 405'000);
        // Half of the travel at the held speed during the ramp, and the time of the command.
        const std::int64_t braked = sign * (rig.core().motion.commanded - top);
        QVERIFY2(std::abs(braked - 4000) <= 60, qPrintable(QString::number(braked)));
        QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_ANGLE), 0);
    }
}

void TestIntervalMotion::stoppedBeforeTheSpeedIsReached()
{
    Rig rig;
    rig.install(rampAndHold().registers());
    rig.setParameter(CTL_REG_PARAMETER_RAMP_TIME, 400);
    rig.command(CTL_COMMAND_START);
    rig.run(second / 4);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.maxJolt(405'000) <= 1);
    QCOMPARE(rig.core().motion.state, CTL_STATE_READY);
    QCOMPARE(rig.core().motion.cycle_count, 0u);
}

// Cam points and intervals of one machine: an armed change of the layout waits for the standstill.
void TestIntervalMotion::changeOfLayout()
{
    const CamImage cam = quinticMove(30'000.0, 100, 8'000'000);
    const IntervalImage intervals = trapezoidMove();
    Rig rig;
    rig.install(cam.registers());
    std::int64_t expected = rig.core().motion.commanded;
    for (std::uint16_t change = 0; change < 4; ++change) {
        const bool toIntervals = change % 2 == 0;
        const Registers image = toIntervals ? intervals.registers() : cam.registers();
        const auto session = static_cast<std::uint16_t>(change + 2);
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        QCOMPARE(rig.download(image, session), CTL_TRANSFER_RESULT_ACCEPTED);
        QCOMPARE(rig.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, session), CTL_REFUSAL_NONE);
        QVERIFY(rig.runUntilState(CTL_STATE_READY, 2 * second));
        expected += toIntervals ? 30'000 : intervals.advance();
        QCOMPARE(rig.core().motion.commanded, expected);
        QCOMPARE(rig.core().motion.table.layout,
                 toIntervals ? CTL_TABLE_LAYOUT_INTERVALS : CTL_TABLE_LAYOUT_CAM_POINTS);
    }
}

void TestIntervalMotion::survivesPowerLoss()
{
    MemoryFlash flash;
    const IntervalImage move = trapezoidMove(true);
    const Registers image = move.registers();
    {
        Rig rig({}, &flash);
        rig.install(image);
        QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, crc32(image)), CTL_REFUSAL_NONE);
    }
    Rig rig({}, &flash);
    QCOMPARE(rig.core().motion.state, CTL_STATE_READY);
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC), crc32(image));
    const std::int64_t begin = rig.core().motion.commanded;
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, 2 * second));
    QCOMPARE(rig.core().motion.commanded - begin, move.advance());
}

// A damaged number of rows leads neither the engine nor the check outside the bank.
void TestIntervalMotion::damagedWhileRunning()
{
    Rig rig;
    rig.install(rampAndHold().registers());
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    rig.run(second);
    const std::int64_t before = rig.core().motion.commanded;
    rig.core().banks.bank[rig.core().banks.active].registers[CTL_OFFSET_BANK_ROW_COUNT] = 0xFFFF;
    rig.controller().step();
    QCOMPARE(rig.core().motion.commanded - before, std::int64_t{5});
    QCOMPARE(rig.core().motion.state, CTL_STATE_FAULT);
    QCOMPARE(rig.core().motion.fault, 1u << CTL_FAULT_BIT_ACTIVE_TABLE_DAMAGED);
    QCOMPARE(rig.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_FAULT_PERSISTS);
    rig.run(second);
    QCOMPARE(rig.core().motion.commanded - before, std::int64_t{5});
}

void TestIntervalMotion::refusals_data()
{
    QTest::addColumn<Registers>("image");
    QTest::addColumn<unsigned>("length");
    QTest::addColumn<unsigned>("result");
    QTest::addColumn<unsigned>("detail");
    const auto header = [](const char* tag, unsigned offset, unsigned value, unsigned detail) {
        Registers image = trapezoidMove().registers();
        image.at(offset) = static_cast<std::uint16_t>(value);
        QTest::newRow(tag) << image << static_cast<unsigned>(image.size())
                           << unsigned{CTL_TRANSFER_RESULT_BAD_HEADER} << detail;
    };
    const auto rows = [](const char* tag, std::size_t count, unsigned result, unsigned detail) {
        IntervalImage move;
        move.rows.assign(count, {2, 1000, 1000});
        const Registers image = move.registers();
        QTest::newRow(tag) << image << static_cast<unsigned>(image.size()) << result << detail;
    };
    rows("as many rows as there is room for", CTL_INTERVAL_CAPACITY, CTL_TRANSFER_RESULT_ACCEPTED, 0);
    rows("a row too many", CTL_INTERVAL_CAPACITY + 1, CTL_TRANSFER_RESULT_BAD_HEADER,
         CTL_OFFSET_BANK_ROW_COUNT);
    rows("no row", 0, CTL_TRANSFER_RESULT_BAD_HEADER, CTL_OFFSET_BANK_ROW_COUNT);
    header("unknown layout", CTL_OFFSET_BANK_LAYOUT, 9, CTL_OFFSET_BANK_LAYOUT);
    header("cutter", CTL_OFFSET_BANK_KIND, CTL_PROGRAM_KIND_ROTARY_CUTTER, CTL_OFFSET_BANK_KIND);
    header("point cam", CTL_OFFSET_BANK_KIND, CTL_PROGRAM_KIND_POINT_CAM, CTL_OFFSET_BANK_KIND);
    header("press", CTL_OFFSET_BANK_KIND, CTL_PROGRAM_KIND_PRESS, CTL_OFFSET_BANK_KIND);
    header("repeats", CTL_OFFSET_BANK_END_BEHAVIOR, CTL_END_BEHAVIOR_REPEAT, CTL_OFFSET_BANK_END_BEHAVIOR);
    header("unknown end", CTL_OFFSET_BANK_END_BEHAVIOR, 3, CTL_OFFSET_BANK_END_BEHAVIOR);
    header("fraction bits", CTL_OFFSET_INTERVAL_FRACTION_BITS, 9, CTL_OFFSET_INTERVAL_FRACTION_BITS);
    header("no pulses per revolution", CTL_OFFSET_POSITION_MOVE_PULSES_PER_MOTOR_REV + 1, 0,
           CTL_OFFSET_POSITION_MOVE_PULSES_PER_MOTOR_REV);
    const Registers image = trapezoidMove().registers();
    const auto length = static_cast<unsigned>(image.size());
    QTest::newRow("cut off") << image << length - 8 << unsigned{CTL_TRANSFER_RESULT_BAD_HEADER}
                             << unsigned{CTL_OFFSET_BANK_ROW_COUNT};
    Registers fast = image;
    fast.at(CTL_OFFSET_BANK_ROWS + CTL_INTERVAL_REGISTERS + 4) += 0x300; // 195 kHz more
    QTest::newRow("too fast") << fast << length << unsigned{CTL_TRANSFER_RESULT_BAD_ROW} << 1u;
    Registers sum = image;
    sum.at(CTL_OFFSET_BANK_ADVANCE + 1) += 1;
    QTest::newRow("sum") << sum << length << unsigned{CTL_TRANSFER_RESULT_BAD_SUM}
                         << unsigned{CTL_OFFSET_BANK_ADVANCE};
}

void TestIntervalMotion::refusals()
{
    QFETCH(Registers, image);
    QFETCH(unsigned, length);
    QFETCH(unsigned, result);
    QFETCH(unsigned, detail);
    const auto bank = std::make_unique<ctl_bank>();
    QVERIFY(image.size() <= CTL_BANK_REGISTERS);
    std::ranges::copy(image, bank->registers);
    const ctl_config config = benchConfig();
    const ctl_verdict verdict = ctl_bank_check(bank.get(), &config, length);
    QCOMPARE(unsigned{verdict.result}, result);
    QCOMPARE(unsigned{verdict.detail}, detail);
}

CAMPANEL_TEST(TestIntervalMotion)

} // namespace test_interval_motion

#include "test_interval_motion.moc"
