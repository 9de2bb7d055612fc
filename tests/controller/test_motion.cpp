// SPDX-License-Identifier: Apache-2.0
// States and motion: homing, start, both stops, change during a run, the cut bags.
#include "rig.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

namespace test_motion {

using namespace campanel::test;

namespace {

constexpr std::uint64_t second = 1'000'000;

// Returns the pulses of this many whole cycles of K / N pulses.
std::int64_t pulsesOf(const BankImage& bank, std::uint64_t cycles)
{
    return static_cast<std::int64_t>(cycles * bank.pulsesPerMotorRev / bank.knives);
}

bool atBoundary(Rig& rig)
{
    return ctl_step_between_cycles(&rig.core().motion.table.step);
}

} // namespace

class TestMotion : public QObject {
    Q_OBJECT

private slots:
    void startHomesFirst();
    void homingFindsTheMark();
    void stopWhileHoming();
    void rampReachesTheTablesSpeed();
    void stopAtCycleEndEndsOnTheBoundary_data();
    void stopAtCycleEndEndsOnTheBoundary();
    void stopNowKeepsThePhase();
    void stopNowAfterStopAtCycleEnd();
    void changeWhileRunningDoesNotJump();
    void changeAtStandstillMidCycleHomesAgain();
    void armedChangeSurvivesStop();
    void armedChangeWaitsForTheEndOfTheStop();
    void otherMachineDataNeedHoming();
    void refusals();
    void bagsAreMeasured();
    void knivesCutEachStroke();
};

void TestMotion::startHomesFirst()
{
    Rig rig;
    rig.install(camBank(10000, 1, 8'000'000));
    QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & 1u << CTL_WARNING_BIT_NOT_HOMED) != 0);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_HOMING);
    QVERIFY(rig.runUntilState(CTL_STATE_RUNNING, 5 * second));
    QCOMPARE(rig.commanded(), std::int64_t{0});
    QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & 1u << CTL_WARNING_BIT_NOT_HOMED) == 0);
}

void TestMotion::homingFindsTheMark()
{
    for (const double start : {0.0, 1.0, 90.0, 300.0, 359.9}) {
        campanel::controller::MachineOptions options;
        options.startAngleDegrees = start;
        Rig rig(options);
        rig.install(camBank(10000, 1, 8'000'000));
        QCOMPARE(rig.command(CTL_COMMAND_HOME), CTL_REFUSAL_NONE);
        QVERIFY(rig.runUntilState(CTL_STATE_READY, 10 * second));
        rig.run(second / 10);
        // The knife is at its mark in the machine, not only in the controller.
        const double physical = std::fmod(
            start / 360.0 * 10000 + static_cast<double>(rig.controller().machine().encoder()), 10000.0);
        QVERIFY2(std::min(physical, 10000.0 - physical) <= 1.0, qPrintable(QString::number(physical)));
        const unsigned angle = rig.status(CTL_REG_STATUS_KNIFE_ANGLE);
        QVERIFY(angle <= 4 || angle >= 35996); // one pulse is 0.036 degrees
        QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_ANGLE), 0);
    }
}

void TestMotion::stopWhileHoming()
{
    for (const std::uint16_t code :
         {std::uint16_t{CTL_COMMAND_STOP_NOW}, std::uint16_t{CTL_COMMAND_STOP_AT_CYCLE_END}}) {
        Rig rig;
        rig.install(camBank(10000, 1, 8'000'000));
        rig.command(CTL_COMMAND_START);
        rig.run(second / 5);
        QCOMPARE(rig.command(code), CTL_REFUSAL_NONE);
        QVERIFY(rig.runUntilState(CTL_STATE_READY, second));
        rig.run(second);
        QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_READY);
        QVERIFY(!rig.core().motion.homed);
    }
}

void TestMotion::rampReachesTheTablesSpeed()
{
    Rig rig;
    const BankImage bank = camBank(10000, 1, 8'000'000);
    rig.install(bank);
    rig.start();
    rig.run(400'000);
    QVERIFY(std::abs(static_cast<int>(rig.status(CTL_REG_STATUS_MASTER_SPEED)) - 5000) <= 25);
    rig.run(450'000);
    QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_SPEED), 10000);
    // The encoder speed follows the commanded one: compare the means of a cycle.
    std::int64_t commanded = 0;
    std::int64_t actual = 0;
    for (int i = 0; i < 4000; ++i) {
        rig.controller().step();
        commanded += ctl_motion_commanded_hz(&rig.core().motion);
        actual += rig.core().motion.actual_hz;
    }
    QVERIFY(std::abs(commanded / 4000 - 10000) <= 50);
    QVERIFY(std::abs(actual / 4000 - 10000) <= 50);
}

void TestMotion::stopAtCycleEndEndsOnTheBoundary_data()
{
    QTest::addColumn<unsigned>("knives");
    QTest::addColumn<unsigned>("cycleTicks");
    QTest::addColumn<unsigned>("rampMs");
    QTest::newRow("ramp shorter than a cycle") << 1u << 8'000'000u << 300u;
    QTest::newRow("ramp over many cycles") << 3u << 1'600'001u << 2000u;
    QTest::newRow("slow cycle") << 1u << 48'000'000u << 800u;
}

void TestMotion::stopAtCycleEndEndsOnTheBoundary()
{
    QFETCH(unsigned, knives);
    QFETCH(unsigned, cycleTicks);
    QFETCH(unsigned, rampMs);
    constexpr std::uint64_t seed = 12;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    const BankImage bank = camBank(10007, static_cast<std::uint16_t>(knives), cycleTicks);
    Rig rig;
    rig.install(bank);
    rig.setParameter(CTL_REG_PARAMETER_RAMP_TIME, static_cast<std::uint16_t>(rampMs));
    std::uint32_t cyclesBefore = 0;
    for (int i = 0; i < 15; ++i) {
        rig.start();
        rig.run(random() % (3 * second));
        QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
        std::int64_t last = rig.core().motion.commanded;
        const std::uint64_t begunUs = rig.controller().nowUs();
        while (rig.core().motion.state == CTL_STATE_STOPPING) {
            const ctl_ramp& ramp = rig.core().motion.ramp;
            const std::uint32_t speed = ramp.speed;
            rig.controller().step();
            QVERIFY(rig.core().motion.commanded >= last);
            // 2000 ticks of ramp per step; except for the last slow part, never much more.
            QVERIFY(speed <= ramp.speed + 4000 || speed < ramp.full / 100);
            last = rig.core().motion.commanded;
            QVERIFY(rig.controller().nowUs() - begunUs < 60 * second);
        }
        QCOMPARE(rig.core().motion.state, CTL_STATE_READY);
        QVERIFY(atBoundary(rig));
        QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_ANGLE), 0);
        QVERIFY(rig.core().motion.cycle_count > cyclesBefore);
        cyclesBefore = rig.core().motion.cycle_count;
        QCOMPARE(rig.commanded(), pulsesOf(bank, cyclesBefore));
    }
}

void TestMotion::stopNowKeepsThePhase()
{
    constexpr std::uint64_t seed = 13;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    const BankImage bank = camBank(10007, 3, 8'000'000);
    Rig rig;
    rig.install(bank);
    for (int i = 0; i < 10; ++i) {
        rig.start();
        rig.run(random() % (3 * second));
        QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
        QVERIFY(rig.runUntilState(CTL_STATE_READY, 810'000));
        const std::int64_t stopped = rig.commanded();
        const unsigned angle = rig.status(CTL_REG_STATUS_MASTER_ANGLE);
        rig.run(second);
        QCOMPARE(rig.commanded(), stopped);
        QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_ANGLE), angle);
    }
    rig.start();
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.commanded(), pulsesOf(bank, rig.core().motion.cycle_count));
}

void TestMotion::stopNowAfterStopAtCycleEnd()
{
    Rig rig;
    rig.install(camBank(10000, 1, 48'000'000));
    rig.start();
    rig.run(second);
    rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    rig.run(second / 2);
    QCOMPARE(rig.core().motion.state, CTL_STATE_STOPPING);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, 810'000));
    QVERIFY(!atBoundary(rig));
}

void TestMotion::changeWhileRunningDoesNotJump()
{
    const BankImage slow = camBank(10007, 3, 4'000'000);
    const BankImage fast = camBank(10007, 3, 2'400'000, 80);
    Rig rig;
    rig.install(slow);
    rig.start();
    rig.run(second);
    std::uint32_t generation = 1;
    for (std::uint16_t change = 0; change < 20; ++change) {
        const Registers image = (change % 2 == 0 ? fast : slow).registers();
        const auto session = static_cast<std::uint16_t>(change + 2);
        QCOMPARE(rig.download(image, session), CTL_TRANSFER_RESULT_ACCEPTED);
        QCOMPARE(rig.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, session), CTL_REFUSAL_NONE);
        int steps = 0;
        while (rig.core().banks.generation == generation) {
            const std::int64_t position = rig.commanded();
            rig.controller().step();
            const std::int64_t moved = rig.commanded() - position;
            QVERIFY(moved >= 0 && moved <= 50); // 200 kHz for 250 us
            QVERIFY(++steps < 20'000);          // 5 s
        }
        generation += 1;
        QCOMPARE(rig.core().banks.generation, generation);
        QCOMPARE(rig.core().banks.active_crc, crc32(image));
        // It changed at a boundary: the rest of the step belongs to the new table's first row.
        const ctl_step& step = rig.core().motion.table.step;
        QVERIFY(step.cycle_ticks <= 2000);
        QCOMPARE(rig.commanded(), pulsesOf(slow, rig.core().motion.cycle_count) + ctl_step_row_pulses(&step));
        QCOMPARE(rig.status(CTL_REG_STATUS_STAGED_STATE), CTL_STAGED_STATE_EMPTY);
    }
    rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.commanded(), pulsesOf(slow, rig.core().motion.cycle_count));
}

void TestMotion::changeAtStandstillMidCycleHomesAgain()
{
    campanel::controller::MachineOptions options;
    options.products.missing = 1.0; // no product for the knife to wait for
    Rig rig(options);
    rig.install(camBank(10000, 1, 8'000'000));
    rig.start();
    rig.run(1'300'000);
    rig.command(CTL_COMMAND_STOP_NOW);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QVERIFY(!atBoundary(rig));
    rig.install(camBank(10000, 1, 4'000'000));
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QCOMPARE(rig.core().motion.state, CTL_STATE_HOMING);
    QVERIFY(rig.runUntilState(CTL_STATE_RUNNING));
    QCOMPARE(rig.commanded(), std::int64_t{0});
    // At a boundary the phase is kept and homing is not necessary.
    rig.run(second);
    rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.install(camBank(10000, 1, 8'000'000));
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
}

void TestMotion::armedChangeSurvivesStop()
{
    const Registers image = camBank(10000, 1, 4'000'000).registers();
    Rig rig;
    rig.install(camBank(10000, 1, 24'000'000));
    rig.start();
    rig.run(2 * second);
    rig.download(image, 2);
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, 2), CTL_REFUSAL_NONE);
    rig.command(CTL_COMMAND_STOP_NOW);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.status(CTL_REG_STATUS_STAGED_STATE), CTL_STAGED_STATE_ARMED);
    rig.start();
    rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    QCOMPARE(rig.core().banks.generation, 1u);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.core().banks.generation, 2u); // the boundary was reached at standstill
    QCOMPARE(rig.core().banks.active_crc, crc32(image));
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
}

// The table stays during a slow-down over several cycles; the change comes with the last boundary.
void TestMotion::armedChangeWaitsForTheEndOfTheStop()
{
    const Registers image = camBank(10000, 1, 1'200'000).registers();
    Rig rig;
    rig.install(camBank(10000, 1, 1'600'000));
    rig.setParameter(CTL_REG_PARAMETER_RAMP_TIME, 2000);
    rig.start();
    rig.run(3 * second);
    QCOMPARE(rig.download(image, 2), CTL_TRANSFER_RESULT_ACCEPTED);
    rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_NEXT_CYCLE, 2), CTL_REFUSAL_NONE);
    const std::uint32_t cycles = rig.core().motion.cycle_count;
    while (rig.core().motion.state == CTL_STATE_STOPPING) {
        QCOMPARE(rig.core().banks.generation, 1u);
        rig.controller().step();
    }
    QVERIFY(rig.core().motion.cycle_count - cycles >= 4);
    QCOMPARE(rig.core().motion.state, CTL_STATE_READY);
    QCOMPARE(rig.core().banks.generation, 2u);
}

void TestMotion::otherMachineDataNeedHoming()
{
    Rig rig;
    rig.install(camBank(10000, 1, 8'000'000));
    rig.command(CTL_COMMAND_HOME);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QVERIFY(rig.core().motion.homed);
    rig.install(camBank(10007, 3, 8'000'000));
    QVERIFY(!rig.core().motion.homed);
    rig.start();
    rig.run(5 * second);
    QVERIFY(rig.core().motion.homed);
}

void TestMotion::refusals()
{
    Rig rig;
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NO_ACTIVE_PROGRAM);
    QCOMPARE(rig.command(CTL_COMMAND_HOME), CTL_REFUSAL_NO_ACTIVE_PROGRAM);
    QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH), CTL_REFUSAL_NO_ACTIVE_PROGRAM);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NOT_RUNNING);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NOT_RUNNING);
    QCOMPARE(rig.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NO_FAULT);
    rig.install(camBank(10000, 1, 8'000'000));
    rig.start();
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_ALREADY_RUNNING);
    QCOMPARE(rig.command(CTL_COMMAND_HOME), CTL_REFUSAL_NOT_STANDSTILL);
    QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, 1), CTL_REFUSAL_WRONG_CHECKSUM);
}

void TestMotion::bagsAreMeasured()
{
    campanel::controller::MachineOptions options;
    options.film.slipMm = 0.0;
    Rig exact(options);
    exact.install(camBank(10000, 1, 8'000'000));
    exact.start();
    exact.run(10 * second);
    const std::uint32_t bags = exact.statusWide(CTL_REG_STATUS_BAG_COUNT);
    QVERIFY(bags >= 8 && bags <= 10);
    // The table's steps and the servo leave some hundredths of a millimeter.
    QVERIFY(std::abs(static_cast<int>(exact.statusWide(CTL_REG_STATUS_BAG_LENGTH)) - 250'000) <= 30);
    QCOMPARE(static_cast<std::int16_t>(exact.status(CTL_REG_STATUS_BAG_DEVIATION)),
             static_cast<int>(exact.statusWide(CTL_REG_STATUS_BAG_LENGTH)) - 250'000);

    Rig slipping;
    slipping.install(camBank(10000, 1, 1'600'000));
    slipping.start();
    slipping.run(2 * second);
    double sum = 0.0;
    int count = 0;
    std::uint32_t last = slipping.core().bags.count;
    while (count < 500) {
        slipping.controller().step();
        if (slipping.core().bags.count == last)
            continue;
        last = slipping.core().bags.count;
        const double deviationMm = (slipping.core().bags.length_um - 250'000.0) / 1000.0;
        sum += deviationMm * deviationMm;
        ++count;
    }
    const double rms = std::sqrt(sum / count);
    QVERIFY2(rms > 0.015 && rms < 0.08, qPrintable(QString::number(rms)));
}

void TestMotion::knivesCutEachStroke()
{
    Rig rig;
    rig.install(camBank(10007, 3, 1'600'000));
    rig.start();
    rig.run(2 * second);
    const std::uint32_t bags = rig.core().bags.count;
    const std::uint32_t cycles = rig.core().motion.cycle_count;
    const std::int64_t position = rig.core().motion.actual;
    rig.run(60 * second);
    QCOMPARE(rig.core().bags.count - bags, 300u);
    QCOMPARE(rig.core().motion.cycle_count - cycles, 300u);
    const std::int64_t turned = rig.core().motion.actual - position; // 100 revolutions
    QVERIFY(std::abs(turned - 1'000'700) <= 2);
}

CAMPANEL_TEST(TestMotion)

} // namespace test_motion

#include "test_motion.moc"
