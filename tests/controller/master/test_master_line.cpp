// SPDX-License-Identifier: Apache-2.0
// A packing machine or a cam that follows the encoder of a line: what it refuses, how it engages, stands,
// goes back and disengages.
#include "master_bench.h"

#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

namespace test_master_line {

using namespace campanel::test;
using namespace campanel::test::master;

class TestMasterLine : public QObject {
    Q_OBJECT

private slots:
    void aControllerWithoutTheInputRefuses();
    void aCamThatCannotFollowIsRefused_data();
    void aCamThatCannotFollowIsRefused();
    void aCamFollowsForwardAndBack();
    void aCamMayWaitInstead();
    void aCamDisengagesAtTheEndOfACycle();
    void nothingMovesWithoutAStart();
    void engagesWhileTheLineRuns();
    void standsAndGoesOnWithTheLine();
    void waitsUntilTheLineHasComeBack();
    void disengagesAtTheEndOfACycle();
    void engagesAgainInPhase();
    void stopsWhereTheLineStands();
    void stopNowStopsAtOnce();
    void aRunKeepsItsMaster();
};

void TestMasterLine::aControllerWithoutTheInputRefuses()
{
    Rig rig;
    rig.install(cutter());
    QCOMPARE(rig.status(CTL_REG_MASTER_STATUS_AVAILABLE), 0);
    QCOMPARE(rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER}), 0);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NO_MASTER_INPUT);
    QCOMPARE(rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_CLOCK}), 0);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
}

void TestMasterLine::aCamThatCannotFollowIsRefused_data()
{
    QTest::addColumn<int>("rate");
    QTest::addColumn<int>("atEnd");
    QTest::addColumn<int>("refusal");
    QTest::newRow("forward") << 600 << int{CTL_END_BEHAVIOR_REPEAT} << int{CTL_REFUSAL_NONE};
    QTest::newRow("its master turns in reverse")
        << -600 << int{CTL_END_BEHAVIOR_REPEAT} << int{CTL_REFUSAL_CANNOT_FOLLOW_MASTER};
    QTest::newRow("once") << 600 << int{CTL_END_BEHAVIOR_STOP} << int{CTL_REFUSAL_CANNOT_FOLLOW_MASTER};
}

void TestMasterLine::aCamThatCannotFollowIsRefused()
{
    QFETCH(int, rate);
    QFETCH(int, atEnd);
    QFETCH(int, refusal);
    Rig rig(onLine(100.0));
    CamImage image = cam();
    image.masterRate = static_cast<std::int16_t>(rate);
    image.atEnd = static_cast<std::uint16_t>(atEnd);
    rig.install(image.registers());
    rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
    rig.run(500'000);
    QCOMPARE(int{rig.command(CTL_COMMAND_START)}, refusal);
}

// The slave is where the curve is, also behind a way back, to a pulse.
void TestMasterLine::aCamFollowsForwardAndBack()
{
    Rig rig(onLine(camMmPerS));
    rig.install(cam().registers());
    rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
    rig.run(500'000);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(runUntilEngaged(rig));
    auto& shaft = rig.controller().machine().shaft();
    std::int64_t before = rig.core().motion.commanded;
    for (const double speed : {camMmPerS, -0.7 * camMmPerS, -0.9 * camMmPerS, 0.3 * camMmPerS}) {
        shaft.setSpeed(speed);
        rig.run(5'123'000);
        QVERIFY(speed > 0.0 ? rig.core().motion.commanded > before : rig.core().motion.commanded < before);
        before = rig.core().motion.commanded;
        shaft.setSpeed(0.0);
        rig.run(2'000'000);
        const ctl_master& master = rig.core().master;
        QVERIFY(ctl_tracker_stands(&master.tracker));
        QCOMPARE(master.line, master.gear.ticks + master.clutch.offset);
        QCOMPARE(master.gear.ticks % 800, 0); // 2000 counts a cycle of 1 600 000 ticks
        const double cycles = static_cast<double>(master.line) / cycleTicks;
        const double slave = camNet * cycles + camSwing * std::sin(2.0 * std::numbers::pi * cycles);
        QVERIFY(std::abs(static_cast<double>(rig.commanded()) - slave) < 1.0);
    }
}

void TestMasterLine::aCamMayWaitInstead()
{
    Rig rig(onLine(camMmPerS));
    rig.install(cam().registers());
    rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
    rig.write(CTL_REG_MASTER_BACKWARD, {0});
    rig.run(500'000);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(runUntilEngaged(rig));
    rig.controller().machine().shaft().setSpeed(0.0);
    rig.run(2'000'000);
    const std::int64_t stands = rig.core().motion.commanded;
    rig.controller().machine().shaft().setSpeed(-camMmPerS);
    rig.run(2'000'000);
    QCOMPARE(rig.core().motion.commanded, stands);
}

void TestMasterLine::aCamDisengagesAtTheEndOfACycle()
{
    Rig rig(onLine(camMmPerS));
    rig.install(cam().registers());
    rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_ENCODER});
    rig.run(500'000);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(runUntilEngaged(rig));
    rig.run(1'234'000);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    const std::int64_t cycles = rig.core().motion.cycle_count;
    QCOMPARE(rig.commanded(), static_cast<std::int64_t>(camNet) * cycles);
}

// Neither at power-up with a running line nor behind a fault.
void TestMasterLine::nothingMovesWithoutAStart()
{
    MemoryFlash flash;
    {
        Rig rig(onLine(fullMmPerS), &flash);
        followEncoder(rig);
        QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, crc32(cutter().registers())), CTL_REFUSAL_NONE);
    }
    Rig rig(onLine(fullMmPerS), &flash);
    QCOMPARE(rig.status(CTL_REG_MASTER_SOURCE), CTL_MASTER_SOURCE_ENCODER);
    rig.run(5'000'000);
    QVERIFY(rig.core().master.tracker.count > 200'000);
    QCOMPARE(rig.core().motion.commanded, 0);
    QCOMPARE(rig.core().packer.film_sent, 0);
}

void TestMasterLine::engagesWhileTheLineRuns()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QCOMPARE(state(rig), CTL_MASTER_STATE_ENGAGING);
    QVERIFY(rig.statusWide(CTL_REG_MASTER_STATUS_TO_ENGAGED) >
            60'000); // um; the ramp needs the time it needs
    // The film gains no more speed in a slice than the ramp of the clock would, times one and a half.
    const double perSlice = static_cast<double>(rig.core().packer.bag) / 800.0;
    const double most = 1.5 * perSlice / 3200.0;
    double last = 0.0;
    std::int64_t before = rig.core().packer.film_at;
    while (state(rig) == CTL_MASTER_STATE_ENGAGING) {
        const std::int64_t start = before;
        for (int i = 0; i < 40; ++i)
            rig.controller().step();
        before = rig.core().packer.film_at;
        const double speed = static_cast<double>(before - start) / 40.0;
        QVERIFY2(speed - last < 40.0 * most * 1.1 + 0.05 * perSlice,
                 qPrintable(QString::number(speed - last)));
        last = speed;
    }
    QCOMPARE(state(rig), CTL_MASTER_STATE_ENGAGED);
    rig.run(1'000'000);
    QVERIFY(std::abs(rig.status(CTL_REG_STATUS_MASTER_SPEED) - 10'000) < 100);
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_RUNNING);
}

void TestMasterLine::standsAndGoesOnWithTheLine()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    rig.controller().machine().shaft().setSpeed(0.0);
    rig.run(4'000'000);
    const std::int64_t stands = rig.core().motion.commanded;
    rig.run(4'000'000);
    QCOMPARE(rig.core().motion.commanded, stands);
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_RUNNING);
    QCOMPARE(state(rig), CTL_MASTER_STATE_ENGAGED);
    rig.controller().machine().shaft().setSpeed(fullMmPerS);
    rig.run(4'000'000);
    QVERIFY(rig.core().motion.commanded > stands + 5 * knifePulses);
}

void TestMasterLine::waitsUntilTheLineHasComeBack()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    auto& shaft = rig.controller().machine().shaft();
    shaft.setSpeed(0.0);
    rig.run(4'000'000);
    const std::int64_t stands = rig.core().motion.commanded;
    const std::int64_t film = rig.core().packer.film_sent;
    const std::int64_t counts = rig.core().master.tracker.count;
    shaft.setSpeed(-40.0);
    rig.run(2'000'000);
    QCOMPARE(rig.core().motion.commanded, stands);
    QCOMPARE(rig.core().packer.film_sent, film);
    const double backMm = static_cast<double>(counts - rig.core().master.tracker.count) / 40.0;
    QVERIFY(backMm > 50.0);
    // It still has to come back so far, to the count.
    QVERIFY(std::abs(rig.read(CTL_REG_MASTER_STATUS_HELD, 1).at(0) - 32'767) < 1); // saturates
    shaft.setSpeed(40.0);
    while (rig.core().master.tracker.count < counts - 40) {
        rig.controller().step();
        QCOMPARE(rig.core().motion.commanded, stands);
    }
    rig.run(500'000);
    QVERIFY(rig.core().motion.commanded > stands);
    // Line and counts are where they would be without the way back.
    shaft.setSpeed(0.0);
    rig.run(2'000'000);
    const ctl_master& master = rig.core().master;
    QVERIFY(std::abs(master.line - master.wanted) < 200); // an overshoot of the tracker's, below a count
}

void TestMasterLine::disengagesAtTheEndOfACycle()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    rig.run(3 * cycleUs + 41'000);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    std::int64_t last = rig.core().motion.commanded;
    while (rig.core().motion.state == CTL_STATE_STOPPING) {
        rig.controller().step();
        QVERIFY(rig.core().motion.commanded >= last);
        last = rig.core().motion.commanded;
    }
    QCOMPARE(rig.core().motion.state, CTL_STATE_READY);
    QVERIFY(ctl_table_between_cycles(&rig.core().motion.table));
    QCOMPARE(rig.core().packer.master, 0u);
    QCOMPARE(rig.commanded() % knifePulses, 0);
    QCOMPARE(state(rig), CTL_MASTER_STATE_OFF);
    rig.run(2'000'000);
    QCOMPARE(rig.core().motion.commanded, last); // the line runs on
}

// Start and stop at any moment: a bag begins where bags began before, seen from the line's shaft.
void TestMasterLine::engagesAgainInPhase()
{
    Rig rig(onLine(fullMmPerS * 0.8));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    const std::int64_t offset = rig.core().master.clutch.offset;
    for (int i = 0; i < 20; ++i) {
        rig.run(100'000 + 37'000 * static_cast<std::uint64_t>(i));
        QCOMPARE(rig.command(i % 3 == 0 ? CTL_COMMAND_STOP_NOW : CTL_COMMAND_STOP_AT_CYCLE_END),
                 CTL_REFUSAL_NONE);
        QVERIFY(rig.runUntilState(CTL_STATE_READY));
        rig.run(113'000 * static_cast<std::uint64_t>(i));
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        QVERIFY(runUntilEngaged(rig));
        const std::int64_t moved = rig.core().master.clutch.offset - offset;
        QCOMPARE(moved % static_cast<std::int64_t>(cycleTicks), 0);
        QCOMPARE(rig.core().master.line % static_cast<std::int64_t>(cycleTicks),
                 static_cast<std::int64_t>(rig.core().packer.master));
    }
}

// The end of the cycle may never come.
void TestMasterLine::stopsWhereTheLineStands()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    rig.controller().machine().shaft().setSpeed(0.0);
    rig.run(4'000'000);
    const std::int64_t stands = rig.core().motion.commanded;
    QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, 1'000'000));
    QCOMPARE(rig.core().motion.commanded, stands);
}

void TestMasterLine::stopNowStopsAtOnce()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    rig.run(1'000'000);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, 1'000'000)); // a ramp of 800 ms
}

void TestMasterLine::aRunKeepsItsMaster()
{
    Rig rig(onLine(fullMmPerS));
    followEncoder(rig);
    rig.start();
    QVERIFY(runUntilEngaged(rig));
    QCOMPARE(rig.write(CTL_REG_MASTER_SOURCE, {CTL_MASTER_SOURCE_CLOCK}), 0);
    QCOMPARE(rig.write(CTL_REG_MASTER_REVERSED, {1}), 0);
    rig.run(2'000'000);
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_RUNNING);
    QCOMPARE(state(rig), CTL_MASTER_STATE_ENGAGED);
    rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.run(1000);
    QVERIFY(!rig.core().master.reads);
}

CAMPANEL_TEST(TestMasterLine)

} // namespace test_master_line

#include "test_master_line.moc"
