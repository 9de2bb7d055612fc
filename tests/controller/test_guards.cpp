// SPDX-License-Identifier: Apache-2.0
// The automatic stops of the machine: jog without a heartbeat, a lost panel, a drive that does not follow, a
// damaged table.
#include "rig.h"
#include "tests/support/test_program.h"

#include <QTest>

namespace test_guards {

using namespace campanel::test;

namespace {

constexpr std::uint64_t second = 1'000'000;

} // namespace

class TestGuards : public QObject {
    Q_OBJECT

private slots:
    void jogDiesWithTheHeartbeat();
    void jogReversesAndIsRefused();
    void heartbeatLost_data();
    void heartbeatLost();
    void followingErrorStopsThePulses();
    void faultIsResetAtRestOnly();
    void damagedTableIsNoticed();
    void homingWithoutMarkIsAFault();
};

void TestGuards::jogDiesWithTheHeartbeat()
{
    Rig rig;
    for (int i = 0; i < 10; ++i) {
        rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
        rig.run(100'000);
    }
    QCOMPARE(rig.core().motion.state, CTL_STATE_JOGGING);
    QCOMPARE(ctl_motion_commanded_hz(&rig.core().motion), std::int64_t{1000});
    rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
    const std::uint64_t lastUs = rig.core().heartbeat.advanced_us;
    // The same heartbeat again does not count.
    const Registers same = rig.read(CTL_REG_EXCHANGE_TAG, 3);
    rig.write(CTL_REG_EXCHANGE_TAG, same);
    rig.controller().runTo(lastUs + 199'750);
    QCOMPARE(ctl_motion_commanded_hz(&rig.core().motion), std::int64_t{1000});
    rig.controller().runTo(lastUs + 200'250);
    QVERIFY(ctl_motion_commanded_hz(&rig.core().motion) < 1000);
    rig.controller().runTo(lastUs + 250'250);
    QCOMPARE(rig.core().motion.state, CTL_STATE_IDLE);
    const std::int64_t stopped = rig.core().motion.commanded;
    // It does not restart with the heartbeat while the key is still held.
    for (int i = 0; i < 5; ++i) {
        rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
        rig.run(50'000);
    }
    QCOMPARE(rig.core().motion.commanded, stopped);
    rig.heartbeat(0);
    rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
    rig.run(100'000);
    QVERIFY(rig.core().motion.commanded > stopped);
}

void TestGuards::jogReversesAndIsRefused()
{
    Rig rig;
    rig.install(camBank(10000, 1, 8'000'000));
    rig.heartbeat(3); // both keys mean neither
    rig.run(150'000);
    QCOMPARE(rig.core().motion.commanded, std::int64_t{0});
    rig.heartbeat(1u << CTL_JOG_BIT_REVERSE);
    rig.run(150'000);
    QVERIFY(rig.core().motion.commanded < 0);
    QCOMPARE(ctl_motion_commanded_hz(&rig.core().motion), std::int64_t{-1000});
    rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
    rig.run(190'000);
    QCOMPARE(ctl_motion_commanded_hz(&rig.core().motion), std::int64_t{1000});
    rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_ALREADY_RUNNING);
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
    rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, 60'000));
    rig.heartbeat(0);
    rig.start();
    rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
    rig.run(50'000);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
}

void TestGuards::heartbeatLost_data()
{
    QTest::addColumn<unsigned>("action");
    QTest::newRow("run on") << CTL_HEARTBEAT_LOST_ACTION_RUN_ON;
    QTest::newRow("stop") << CTL_HEARTBEAT_LOST_ACTION_STOP_AT_CYCLE_END;
}

void TestGuards::heartbeatLost()
{
    QFETCH(unsigned, action);
    const bool stops = action == CTL_HEARTBEAT_LOST_ACTION_STOP_AT_CYCLE_END;
    const auto bit = 1u << CTL_WARNING_BIT_HEARTBEAT_LOST;
    Rig rig;
    rig.install(camBank(10000, 1, 8'000'000));
    rig.setParameter(CTL_REG_PARAMETER_HEARTBEAT_LOST_ACTION, static_cast<std::uint16_t>(action));
    rig.run(3 * second);
    QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & bit) != 0);
    if (stops)
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_HEARTBEAT_LOST);
    rig.heartbeat();
    QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & bit) == 0);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    for (int i = 0; i < 5; ++i) {
        rig.run(second);
        rig.heartbeat();
    }
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
    rig.run(6 * second);
    QVERIFY((rig.status(CTL_REG_STATUS_WARNING) & bit) != 0);
    QCOMPARE(rig.core().motion.state, stops ? CTL_STATE_READY : CTL_STATE_RUNNING);
    if (stops)
        QVERIFY(ctl_step_between_cycles(&rig.core().motion.table.step));
}

void TestGuards::followingErrorStopsThePulses()
{
    Rig rig;
    rig.install(camBank(10000, 1, 8'000'000));
    rig.start();
    rig.run(2 * second);
    const auto error = static_cast<std::int16_t>(rig.status(CTL_REG_STATUS_FOLLOWING_ERROR));
    QVERIFY2(error > 5 && error < 120, qPrintable(QString::number(error))); // some ms of 10 kHz
    rig.controller().machine().setDriveOn(false);
    QVERIFY(rig.runUntilState(CTL_STATE_FAULT, second));
    QCOMPARE(rig.status(CTL_REG_STATUS_FAULT), 1u << CTL_FAULT_BIT_FOLLOWING_ERROR);
    const std::int64_t stopped = rig.core().motion.commanded;
    rig.run(second);
    QCOMPARE(rig.core().motion.commanded, stopped);
    QCOMPARE(rig.status(CTL_REG_STATUS_MASTER_SPEED), 0);
    QCOMPARE(rig.command(CTL_COMMAND_HOME), CTL_REFUSAL_IN_FAULT);
    // Unfollowed pulses are discarded; the knife must be homed again.
    rig.controller().machine().setDriveOn(true);
    QCOMPARE(rig.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NONE);
    QCOMPARE(rig.status(CTL_REG_STATUS_FAULT), 0);
    QVERIFY(!rig.core().motion.homed);
    rig.start();
    rig.run(2 * second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
}

void TestGuards::faultIsResetAtRestOnly()
{
    Rig rig;
    rig.install(camBank(10000, 1, 8'000'000));
    rig.start();
    rig.run(2 * second);
    rig.write(CTL_REG_PARAMETER_FOLLOWING_ERROR_LIMIT, {0, 10}); // less than the lag
    QCOMPARE(rig.core().motion.state, CTL_STATE_FAULT);
    QCOMPARE(rig.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_FAULT_PERSISTS);
    rig.run(second);
    QCOMPARE(rig.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NONE);
    QCOMPARE(rig.core().motion.state, CTL_STATE_READY);
}

void TestGuards::damagedTableIsNoticed()
{
    Rig rig;
    rig.install(camBank(10000, 1, 8'000'000));
    rig.start();
    ctl_bank& bank = rig.core().banks.bank[rig.core().banks.active];
    bank.registers[80] = static_cast<std::uint16_t>(bank.registers[80] ^ 4u);
    QVERIFY(rig.runUntilState(CTL_STATE_FAULT, second));
    QCOMPARE(rig.status(CTL_REG_STATUS_FAULT), 1u << CTL_FAULT_BIT_ACTIVE_TABLE_DAMAGED);
    rig.run(second);
    QCOMPARE(rig.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_FAULT_PERSISTS);
    rig.install(camBank(10000, 1, 8'000'000)); // a new download corrects it
    QCOMPARE(rig.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NONE);
    rig.start();
}

void TestGuards::homingWithoutMarkIsAFault()
{
    Rig rig;
    rig.install(camBank(10000, 1, 8'000'000));
    rig.write(CTL_REG_PARAMETER_FOLLOWING_ERROR_LIMIT, {15, 0}); // 983040: the lag must not cause a fault
    rig.controller().machine().setDriveOn(false);
    rig.command(CTL_COMMAND_START);
    QVERIFY(rig.runUntilState(CTL_STATE_FAULT, 15 * second));
    QCOMPARE(rig.status(CTL_REG_STATUS_FAULT), 1u << CTL_FAULT_BIT_DRIVE_NOT_FOLLOWING);
    QCOMPARE(rig.core().motion.commanded, std::int64_t{20000});
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_IN_FAULT);
    rig.controller().machine().setDriveOn(true);
    QCOMPARE(rig.command(CTL_COMMAND_RESET_FAULT), CTL_REFUSAL_NONE);
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), CTL_STATE_READY);
    rig.start();
}

CAMPANEL_TEST(TestGuards)

} // namespace test_guards

#include "test_guards.moc"
