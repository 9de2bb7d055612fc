// SPDX-License-Identifier: Apache-2.0
// The gate of every start: a new way to start is a row of ways(), a new reason against one a row of
// reasons().
#include "rig.h"
#include "support/cam_image.h"
#include "support/press_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <functional>
#include <vector>

namespace test_start_gate {

using namespace campanel::test;

namespace {

constexpr std::uint64_t second = 1'000'000;
constexpr std::uint16_t all = (2u << CTL_PERMIT_BIT_LAST) - 1u;

BankImage cutter()
{
    return camBank(10'000, 1, 1'600'000);
}

// Each way ends with the request; its refusal is returned.
struct Way {
    const char* name;
    std::function<void(Rig&)> prepare;
    std::function<std::uint16_t(Rig&)> start;
};

std::uint16_t startByCommand(Rig& rig)
{
    return rig.command(CTL_COMMAND_START);
}

std::uint16_t oneBagByCommand(Rig& rig)
{
    return rig.command(CTL_COMMAND_JOG_BAG);
}

std::uint16_t cutByCommand(Rig& rig)
{
    return rig.command(CTL_COMMAND_SINGLE_CUT);
}

// Longer than the filter time and the check of the bank in pieces.
std::uint16_t press(Rig& rig, unsigned button)
{
    const std::uint16_t presses = rig.status(CTL_REG_SIGNAL_STATUS_PRESSES);
    rig.controller().machine().setInput(button, true);
    rig.run(100'000);
    rig.controller().machine().setInput(button, false);
    const bool isSeen = rig.status(CTL_REG_SIGNAL_STATUS_PRESSES) == presses + 1;
    return isSeen ? rig.status(CTL_REG_SIGNAL_STATUS_REFUSAL) : std::uint16_t{UINT16_MAX};
}

std::uint16_t startByButton(Rig& rig)
{
    return press(rig, CTL_INPUT_BIT_START_BUTTON);
}

std::uint16_t oneBagByButton(Rig& rig)
{
    return press(rig, CTL_INPUT_BIT_BAG_BUTTON);
}

void home(Rig& rig)
{
    rig.install(cutter());
    rig.command(CTL_COMMAND_HOME);
    rig.runUntilState(CTL_STATE_READY);
}

std::vector<Way> ways()
{
    return {
        {"button, homes first", [](Rig& rig) { rig.install(cutter()); }, startByButton},
        {"button, checked in pieces",
         [](Rig& rig) {
             rig.core().board.config.work_registers = 32;
             rig.install(cutter());
         },
         startByButton},
        {"command, homes first", [](Rig& rig) { rig.install(cutter()); }, startByCommand},
        {"command, in phase",
         [](Rig& rig) {
             rig.install(cutter());
             rig.start();
             rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
             rig.runUntilState(CTL_STATE_READY);
         },
         startByCommand},
        {"command, goes on from the middle of a cycle",
         [](Rig& rig) {
             rig.install(cutter());
             rig.start();
             rig.run(2 * second);
             rig.command(CTL_COMMAND_STOP_NOW);
             rig.runUntilState(CTL_STATE_READY);
         },
         startByCommand},
        {"command, checked in pieces",
         [](Rig& rig) {
             rig.core().board.config.work_registers = 32;
             rig.install(cutter());
         },
         startByCommand},
        {"command, any place will do",
         [](Rig& rig) { rig.install(sineCam(0.0, 1000.0, 200, 1'600'000).registers()); }, startByCommand},
        {"command, one bag", home, oneBagByCommand},
        {"command, one bag, checked in pieces",
         [](Rig& rig) {
             rig.core().board.config.work_registers = 32;
             home(rig);
         },
         oneBagByCommand},
        {"button, one bag", home, oneBagByButton},
        {"command, a single cut", home, cutByCommand},
        {"command, a stroke of a press", [](Rig& rig) { rig.install(PressImage().registers()); },
         startByCommand},
    };
}

struct Reason {
    const char* name;
    std::uint16_t refusal;
    std::uint16_t permit = all;
    std::function<void(Rig&)> prevent = [](Rig&) {};
};

std::vector<Reason> reasons()
{
    std::vector<Reason> rows{
        {"emergency stop", CTL_REFUSAL_EMERGENCY_STOP, all,
         [](Rig& rig) { rig.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true); }},
        {"emergency stop just released", CTL_REFUSAL_EMERGENCY_STOP, all,
         [](Rig& rig) {
             rig.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true);
             rig.run(second);
             rig.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, false);
             rig.run(second);
         }},
        {"drive alarm", CTL_REFUSAL_DRIVE_ALARM, all,
         [](Rig& rig) { rig.controller().machine().setInput(CTL_INPUT_BIT_DRIVE_ALARM, true); }},
        {"drive alarm that is gone, not reset", CTL_REFUSAL_DRIVE_ALARM, all,
         [](Rig& rig) {
             rig.controller().machine().setInput(CTL_INPUT_BIT_DRIVE_ALARM, true);
             rig.run(1000);
             rig.controller().machine().setInput(CTL_INPUT_BIT_DRIVE_ALARM, false);
         }},
        {"nothing permitted", CTL_REFUSAL_NOT_WARM, 0},
    };
    for (unsigned bit = CTL_INPUT_BIT_STOP_BUTTON; bit <= CTL_INPUT_BIT_CODER; ++bit) {
        static constexpr const char* names[] = {"Stop button", "door", "next machine", "date coder"};
        const auto refusal =
            static_cast<std::uint16_t>(CTL_REFUSAL_STOP_BUTTON + bit - CTL_INPUT_BIT_STOP_BUTTON);
        rows.push_back({names[bit - CTL_INPUT_BIT_STOP_BUTTON], refusal, all, [bit](Rig& rig) {
                            rig.controller().machine().setInput(bit, true);
                            rig.run(second / 2);
                        }});
    }
    for (unsigned bit = 0; bit <= CTL_PERMIT_BIT_LAST; ++bit) {
        static constexpr const char* names[] = {"not warm", "wrong film", "wrong recipe", "not clean",
                                                "panel disagrees"};
        rows.push_back({names[bit], static_cast<std::uint16_t>(CTL_REFUSAL_NOT_WARM + bit),
                        static_cast<std::uint16_t>(all & ~(1u << bit))});
    }
    return rows;
}

void need(Rig& rig)
{
    rig.setParameter(CTL_REG_PARAMETER_PERMIT_NEEDED, 1);
}

bool moves(Rig& rig, std::uint64_t timeUs = second)
{
    const std::int64_t before = rig.core().motion.commanded;
    rig.run(timeUs);
    const std::uint16_t state = rig.core().motion.state;
    return rig.core().motion.commanded != before || (state != CTL_STATE_READY && state != CTL_STATE_FAULT);
}

} // namespace

class TestStartGate : public QObject {
    Q_OBJECT

private slots:
    void noWayAroundTheGate();
    void asShippedNoPermitIsNeeded();
    void permitHoldsWithItsHeartbeat();
    void permitLostWhileRunningEndsNothing();
    void homingAndJoggingNeedCleanAlone();
    void emergencyStopEndsEveryMotion_data();
    void emergencyStopEndsEveryMotion();
    void keyHeldThroughTheEmergencyStopMovesNothing();
    void olderMinorHasNoPermit();
};

void TestStartGate::noWayAroundTheGate()
{
    int starts = 0;
    int tried = 0;
    for (const Way& way : ways()) {
        for (const Reason& reason : reasons()) {
            Rig rig;
            way.prepare(rig);
            need(rig);
            reason.prevent(rig);
            rig.run(1000);
            rig.heartbeat(0, reason.permit);
            const std::uint16_t refusal = way.start(rig);
            QVERIFY2(
                refusal == reason.refusal,
                qPrintable(QStringLiteral("%1: %2, refusal %3").arg(way.name, reason.name).arg(refusal)));
            starts += moves(rig) ? 1 : 0;
            ++tried;
        }
        Rig rig;
        way.prepare(rig);
        need(rig);
        rig.heartbeat(0, all);
        QCOMPARE(way.start(rig), CTL_REFUSAL_NONE);
        QVERIFY2(moves(rig), way.name);
    }
    QCOMPARE(starts, 0);
    QCOMPARE(tried, 168);
}

void TestStartGate::asShippedNoPermitIsNeeded()
{
    Rig rig;
    QCOMPARE(rig.read(CTL_REG_PARAMETER_PERMIT_NEEDED, 1), Registers{0});
    rig.install(cutter());
    rig.heartbeat(); // of a panel that does not know the register
    rig.start();
    Rig silent; // nor is a heartbeat needed
    silent.install(cutter());
    silent.run(10 * second);
    silent.start();
}

void TestStartGate::permitHoldsWithItsHeartbeat()
{
    Rig rig;
    rig.install(cutter());
    need(rig);
    const auto lose = [&rig](const std::function<void()>& change, std::uint16_t refusal) {
        rig.heartbeat(0, all);
        QCOMPARE(rig.read(CTL_REG_EXCHANGE_PERMIT, 1), Registers{all});
        change();
        QCOMPARE(rig.command(CTL_COMMAND_START), refusal);
        QVERIFY(!moves(rig));
    };
    lose([&rig] { rig.heartbeat(); }, CTL_REFUSAL_NOT_WARM);
    QCOMPARE(rig.read(CTL_REG_EXCHANGE_PERMIT, 1), Registers{0});
    lose([&rig] { rig.write(CTL_REG_EXCHANGE_JOG, {0}); }, CTL_REFUSAL_NOT_WARM);
    lose([&rig] { rig.write(CTL_REG_EXCHANGE_JOG, {0, all}); }, CTL_REFUSAL_NOT_WARM);
    lose([&rig] { rig.write(CTL_REG_EXCHANGE_PERMIT, {all}); }, CTL_REFUSAL_NOT_WARM);
    lose([&rig] { rig.run(2 * second); }, CTL_REFUSAL_HEARTBEAT_LOST); // parameter.heartbeat_timeout
    rig.heartbeat(0, all | 0x8000u);                                   // a bit of a newer panel
    rig.start();
}

void TestStartGate::permitLostWhileRunningEndsNothing()
{
    Rig rig;
    rig.install(cutter());
    need(rig);
    rig.heartbeat(0, all);
    rig.start();
    for (int i = 0; i < 10; ++i) {
        rig.heartbeat(0, 0);
        rig.run(second);
    }
    rig.run(5 * second);
    QCOMPARE(rig.core().motion.state, CTL_STATE_RUNNING);
}

void TestStartGate::homingAndJoggingNeedCleanAlone()
{
    constexpr unsigned clean = 1u << CTL_PERMIT_BIT_CLEAN;
    constexpr unsigned forward = 1u << CTL_JOG_BIT_FORWARD;
    Rig rig;
    rig.install(cutter());
    need(rig);
    rig.heartbeat(0, all & ~clean);
    QCOMPARE(rig.command(CTL_COMMAND_HOME), CTL_REFUSAL_NOT_CLEAN);
    rig.heartbeat(forward, all & ~clean);
    QVERIFY(!moves(rig, 100'000));
    rig.heartbeat(forward, clean); // the key is still held
    QVERIFY(!moves(rig, 100'000));
    rig.heartbeat(0, clean);
    rig.heartbeat(forward, clean);
    QVERIFY(moves(rig, 100'000));
    rig.heartbeat(0, clean);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, second));
    rig.heartbeat(0, clean);
    QCOMPARE(rig.command(CTL_COMMAND_HOME), CTL_REFUSAL_NONE);
    QCOMPARE(rig.core().motion.state, CTL_STATE_HOMING);
}

void TestStartGate::emergencyStopEndsEveryMotion_data()
{
    QTest::addColumn<int>("state");
    QTest::newRow("running") << static_cast<int>(CTL_STATE_RUNNING);
    QTest::newRow("stopping") << static_cast<int>(CTL_STATE_STOPPING);
    QTest::newRow("homing") << static_cast<int>(CTL_STATE_HOMING);
    QTest::newRow("jogging") << static_cast<int>(CTL_STATE_JOGGING);
}

// Nothing goes on when it is released: neither by itself nor within two seconds by Start or Home.
void TestStartGate::emergencyStopEndsEveryMotion()
{
    QFETCH(int, state);
    Rig rig;
    rig.install(cutter());
    if (state == CTL_STATE_JOGGING) {
        rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
    } else {
        QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
        if (state != CTL_STATE_HOMING) {
            QVERIFY(rig.runUntilState(CTL_STATE_RUNNING));
            rig.run(2 * second);
        }
        if (state == CTL_STATE_STOPPING)
            QCOMPARE(rig.command(CTL_COMMAND_STOP_AT_CYCLE_END), CTL_REFUSAL_NONE);
    }
    rig.run(50'000);
    QCOMPARE(static_cast<int>(rig.core().motion.state), state);
    rig.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true);
    QVERIFY(rig.runUntilState(CTL_STATE_READY, second));
    QCOMPARE(rig.command(CTL_COMMAND_HOME), CTL_REFUSAL_EMERGENCY_STOP);
    rig.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, false);
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_EMERGENCY_STOP);
    QVERIFY(!moves(rig, 3 * second));
    QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE);
    QVERIFY(moves(rig));
}

void TestStartGate::keyHeldThroughTheEmergencyStopMovesNothing()
{
    Rig rig;
    rig.install(cutter());
    const auto hold = [&rig](int times) {
        const std::int64_t before = rig.core().motion.commanded;
        for (int i = 0; i < times; ++i) {
            rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
            rig.run(50'000);
        }
        return rig.core().motion.commanded != before;
    };
    rig.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true);
    QVERIFY(!hold(10));
    rig.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, false);
    QVERIFY(!hold(100));
    rig.heartbeat();
    QVERIFY(hold(10));
}

// As `campanel-controller --map-minor 4` answers.
void TestStartGate::olderMinorHasNoPermit()
{
    Rig rig;
    rig.core().board.config.map_minor = 4;
    QCOMPARE(rig.read(CTL_REG_IDENTITY_MAP_MINOR, 1), Registers{4});
    QCOMPARE(rig.read(CTL_REG_EXCHANGE_TAG, 3).size(), std::size_t{3});
    QVERIFY(rig.read(CTL_REG_EXCHANGE_TAG, 4).empty());
    QVERIFY(rig.read(CTL_REG_PARAMETER_DRIVE_ENABLE, 2).empty());
    QCOMPARE(rig.write(CTL_REG_EXCHANGE_TAG, {1, 1, 0, all}), 2);
    QCOMPARE(rig.write(CTL_REG_PARAMETER_PERMIT_NEEDED, {1}), 2);
    QVERIFY(rig.readWrite(CTL_REG_STATUS_TAG, 1, CTL_REG_EXCHANGE_TAG, {2, 2, 0, all}).empty());
    QVERIFY(rig.readWrite(CTL_REG_EXCHANGE_PERMIT, 1, CTL_REG_EXCHANGE_TAG, {2, 2, 0}).empty());
    QCOMPARE(rig.status(CTL_REG_STATUS_TAG), 0); // nothing was written
    // The read-back window says so by a count of 0.
    QCOMPARE(rig.readWrite(CTL_REG_READBACK_RESULT_TAG, 3, CTL_REG_READBACK_TAG,
                           {7, CTL_REG_PARAMETER_PERMIT_NEEDED, 1}),
             (Registers{7, CTL_REG_PARAMETER_PERMIT_NEEDED, 0}));
    rig.install(cutter());
    rig.heartbeat();
    rig.start();
    rig.core().board.config.map_minor = CTL_MAP_MINOR;
    QCOMPARE(rig.read(CTL_REG_EXCHANGE_TAG, 4).size(), std::size_t{4});
}

CAMPANEL_TEST(TestStartGate)

} // namespace test_start_gate

#include "test_start_gate.moc"
