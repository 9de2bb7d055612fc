// SPDX-License-Identifier: Apache-2.0
// The inputs that act on a run: what each ends and how, and that nothing starts by a level. What they refuse
// is in test_start_gate.
#include "link/ctl_command.h"
#include "rig.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <vector>

namespace test_actions {

using namespace campanel::test;

namespace {

constexpr std::uint64_t second = 1'000'000;

BankImage cutter()
{
    return camBank(10'000, 1, 1'600'000);
}

void setInput(Rig& rig, unsigned input, bool isOn)
{
    rig.controller().machine().setInput(input, isOn);
    rig.run(200'000);
}

bool rests(Rig& rig, std::uint64_t timeUs = 3 * second)
{
    const std::int64_t before = rig.core().motion.commanded;
    rig.run(timeUs);
    return rig.core().motion.commanded == before;
}

// Runs into the middle of a cycle.
void startAndRun(Rig& rig)
{
    rig.install(cutter());
    rig.start();
    rig.run(2 * second + 300'000);
}

} // namespace

class TestActions : public QObject {
    Q_OBJECT

private slots:
    void buttonStartsByItsEdgeAlone()
    {
        Rig rig;
        setInput(rig, CTL_INPUT_BIT_START_BUTTON, true); // also before there is a program
        QCOMPARE(rig.status(CTL_REG_SIGNAL_STATUS_REFUSAL), CTL_REFUSAL_NO_ACTIVE_PROGRAM);
        rig.install(cutter());
        QVERIFY(rests(rig));
        setInput(rig, CTL_INPUT_BIT_START_BUTTON, false);
        setInput(rig, CTL_INPUT_BIT_START_BUTTON, true);
        QCOMPARE(rig.status(CTL_REG_SIGNAL_STATUS_REFUSAL), CTL_REFUSAL_NONE);
        QVERIFY(rig.runUntilState(CTL_STATE_RUNNING));
        // It is still held when the run has ended.
        QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NONE);
        QVERIFY(rig.runUntilState(CTL_STATE_READY));
        QVERIFY(rests(rig));
        QCOMPARE(rig.status(CTL_REG_SIGNAL_STATUS_PRESSES), 2);
    }

    void bounceIsOnePress()
    {
        Rig rig;
        rig.install(cutter());
        for (int i = 0; i < 20; ++i) {
            rig.controller().machine().setInput(CTL_INPUT_BIT_START_BUTTON, i % 2 == 0);
            rig.run(5'000);
        }
        QCOMPARE(rig.status(CTL_REG_SIGNAL_STATUS_PRESSES), 0);
        setInput(rig, CTL_INPUT_BIT_START_BUTTON, true);
        QCOMPARE(rig.status(CTL_REG_SIGNAL_STATUS_PRESSES), 1);
    }

    // As the machine comes up with a jammed button, or a wire of a closed contact that is broken.
    void levelAtPowerUpStartsNothing()
    {
        MemoryFlash flash;
        {
            Rig rig({}, &flash);
            rig.install(cutter());
            rig.setParameter(CTL_REG_SIGNAL_START_BUTTON_CONTACT, CTL_CONTACT_NORMALLY_CLOSED);
            QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC)),
                     CTL_REFUSAL_NONE);
        }
        Rig rig({}, &flash);
        QVERIFY(rig.core().banks.has_active);
        rig.run(second);
        QVERIFY(rig.status(CTL_REG_IO_INPUTS) & 1u << CTL_INPUT_BIT_START_BUTTON);
        QCOMPARE(rig.status(CTL_REG_SIGNAL_STATUS_PRESSES), 0);
        QVERIFY(rests(rig));
    }

    void panelsCommandKeepsItsResult()
    {
        Rig rig;
        rig.core().board.config.work_registers = 32;
        rig.install(cutter());
        QCOMPARE(rig.command(CTL_COMMAND_TEACH_MARKS), CTL_REFUSAL_BAD_ARGUMENT);
        const Registers before = rig.read(CTL_REG_RESULT_COUNTER, 4);
        setInput(rig, CTL_INPUT_BIT_START_BUTTON, true);
        QVERIFY(rig.runUntilState(CTL_STATE_RUNNING));
        QCOMPARE(rig.read(CTL_REG_RESULT_COUNTER, 4), before);
    }

    // Stop comes while the bank is being checked for the press: it wins.
    void stopOvertakesThePress()
    {
        Rig rig;
        rig.install(cutter());
        rig.core().board.config.work_registers = 1;
        rig.controller().machine().setInput(CTL_INPUT_BIT_START_BUTTON, true);
        rig.run(21'000);
        QVERIFY(rig.core().work.checks);
        ctl_core& core = rig.core();
        ++core.written.command[0]; // the counter
        core.written.command[CTL_REG_COMMAND_CODE - CTL_REG_COMMAND_COUNTER] = CTL_COMMAND_STOP_NOW;
        ctl_command(&core, true);
        QVERIFY(rests(rig));
    }

    // A door that opens and closes again while the bank is being checked.
    void doorEndsThePress()
    {
        Rig rig;
        rig.install(cutter());
        rig.setParameter(CTL_REG_SIGNAL_DOOR_FILTER, 0);
        rig.core().board.config.work_registers = 1;
        rig.controller().machine().setInput(CTL_INPUT_BIT_START_BUTTON, true);
        rig.run(21'000);
        QVERIFY(rig.core().work.checks);
        for (const bool isOpen : {true, false}) {
            rig.controller().machine().setInput(CTL_INPUT_BIT_DOOR, isOpen);
            rig.run(1'000);
        }
        QVERIFY(rig.core().work.checks);
        QVERIFY(rests(rig));
    }

    // A press that waits for the end of a save is none any more once something ends motion.
    void nothingStartsBehindAStop_data()
    {
        QTest::addColumn<int>("input"); // -1: the command Stop
        QTest::newRow("command") << -1;
        QTest::newRow("Stop button") << int{CTL_INPUT_BIT_STOP_BUTTON};
        QTest::newRow("door") << int{CTL_INPUT_BIT_DOOR};
        QTest::newRow("emergency stop") << int{CTL_INPUT_BIT_EMERGENCY_STOP};
    }

    void nothingStartsBehindAStop()
    {
        QFETCH(int, input);
        Rig rig;
        rig.install(cutter());
        ctl_core& core = rig.core();
        core.work.waits = true;
        setInput(rig, CTL_INPUT_BIT_START_BUTTON, true);
        QCOMPARE(rig.status(CTL_REG_SIGNAL_STATUS_PRESSES), 1);
        if (input < 0) {
            ++core.written.command[0]; // the counter
            core.written.command[CTL_REG_COMMAND_CODE - CTL_REG_COMMAND_COUNTER] = CTL_COMMAND_STOP_NOW;
            ctl_command(&core, true);
        } else {
            setInput(rig, static_cast<unsigned>(input), true);
            setInput(rig, static_cast<unsigned>(input), false);
            rig.run(3 * second);
        }
        core.work.waits = false;
        QVERIFY(rests(rig));
    }

    void inputEndsARun_data()
    {
        QTest::addColumn<unsigned>("input");
        QTest::addColumn<bool>("atOnce");
        QTest::newRow("Stop button") << unsigned{CTL_INPUT_BIT_STOP_BUTTON} << false;
        QTest::newRow("door") << unsigned{CTL_INPUT_BIT_DOOR} << true;
        QTest::newRow("next machine") << unsigned{CTL_INPUT_BIT_NEXT_MACHINE} << false;
        QTest::newRow("date coder") << unsigned{CTL_INPUT_BIT_CODER} << false;
    }

    // At the end of the cycle or at once; nothing goes on when the cause is gone.
    void inputEndsARun()
    {
        QFETCH(unsigned, input);
        QFETCH(bool, atOnce);
        Rig rig;
        startAndRun(rig);
        setInput(rig, input, true);
        QCOMPARE(rig.core().motion.state, CTL_STATE_STOPPING);
        QCOMPARE(rig.core().motion.stop == CTL_STOP_NOW, atOnce);
        QVERIFY(rig.runUntilState(CTL_STATE_READY));
        QCOMPARE(rig.commanded() % 10'000 == 0, !atOnce);
        setInput(rig, input, false);
        QVERIFY(rests(rig));
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    }

    void inputEndsTheReferenceRunOfAStart()
    {
        for (const unsigned input : {unsigned{CTL_INPUT_BIT_STOP_BUTTON}, unsigned{CTL_INPUT_BIT_DOOR}}) {
            Rig rig;
            rig.install(cutter());
            QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
            rig.run(100'000);
            QCOMPARE(rig.core().motion.state, CTL_STATE_HOMING);
            setInput(rig, input, true);
            QVERIFY(rig.runUntilState(CTL_STATE_READY));
            setInput(rig, input, false);
            QVERIFY(rests(rig));
        }
    }

    void filmIsThreadedWithTheDoorOpen()
    {
        Rig rig;
        rig.install(cutter());
        setInput(rig, CTL_INPUT_BIT_DOOR, true);
        rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
        rig.run(100'000);
        QCOMPARE(rig.core().motion.state, CTL_STATE_JOGGING);
        QCOMPARE(rig.status(CTL_REG_STATUS_WARNING) & 1u << CTL_WARNING_BIT_DOOR_OPEN,
                 1 << CTL_WARNING_BIT_DOOR_OPEN);
    }
};

CAMPANEL_TEST(TestActions)

} // namespace test_actions

#include "test_actions.moc"
