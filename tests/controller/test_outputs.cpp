// SPDX-License-Identifier: Apache-2.0
// The test of an output: on at standstill while it is asked for, and what refuses or ends it. A new reason is
// a row.
#include "rig.h"
#include "support/cam_image.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <functional>
#include <map>

namespace test_outputs {

using namespace campanel::test;

namespace {

constexpr std::uint64_t second = 1'000'000;
constexpr std::uint16_t all = (2u << CTL_PERMIT_BIT_LAST) - 1u;
constexpr std::uint16_t tested = CTL_OUTPUT_BIT_SWITCH3;

using Act = std::function<void(Rig&)>;

std::uint16_t tryOutput(Rig& rig, std::uint16_t output = tested, std::uint16_t on = 1)
{
    return rig.command(CTL_COMMAND_TRY_OUTPUT, output, on);
}

std::uint32_t levels(Rig& rig)
{
    return rig.status(CTL_REG_IO_OUTPUTS) | std::uint32_t{rig.status(CTL_REG_IO_MORE_OUTPUTS)} << 16u;
}

bool isOn(Rig& rig, unsigned output = tested)
{
    rig.controller().step();
    return (levels(rig) & 1u << output) != 0;
}

void press(Rig& rig, unsigned input)
{
    rig.controller().machine().setInput(input, true);
    rig.run(1000);
}

void startAndRun(Rig& rig)
{
    rig.start();
    rig.run(second);
}

struct Situation {
    std::uint16_t refusal = CTL_REFUSAL_NONE;
    Act reach = [](Rig&) {};
    std::uint16_t output = tested;
    std::uint16_t on = 1;
};

const std::map<const char*, Situation>& situations()
{
    static const std::map<const char*, Situation> rows{
        {"ready", {}},
        {"running", {CTL_REFUSAL_NOT_STANDSTILL, startAndRun}},
        {"stopping",
         {CTL_REFUSAL_NOT_STANDSTILL,
          [](Rig& rig) {
              startAndRun(rig);
              rig.command(CTL_COMMAND_STOP_AT_CYCLE_END);
          }}},
        {"homing", {CTL_REFUSAL_NOT_STANDSTILL, [](Rig& rig) { rig.command(CTL_COMMAND_HOME); }}},
        {"jogging",
         {CTL_REFUSAL_NOT_STANDSTILL,
          [](Rig& rig) {
              rig.heartbeat(1u << CTL_JOG_BIT_FORWARD, all);
              rig.run(50'000);
          }}},
        {"fault",
         {CTL_REFUSAL_IN_FAULT,
          [](Rig& rig) { ctl_motion_fault(&rig.core().motion, CTL_FAULT_BIT_FOLLOWING_ERROR); }}},
        {"drive alarm", {CTL_REFUSAL_DRIVE_ALARM, [](Rig& rig) { press(rig, CTL_INPUT_BIT_DRIVE_ALARM); }}},
        {"emergency stop",
         {CTL_REFUSAL_EMERGENCY_STOP, [](Rig& rig) { press(rig, CTL_INPUT_BIT_EMERGENCY_STOP); }}},
        {"emergency stop just released",
         {CTL_REFUSAL_EMERGENCY_STOP,
          [](Rig& rig) {
              press(rig, CTL_INPUT_BIT_EMERGENCY_STOP);
              rig.controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, false);
              rig.run(second);
          }}},
        {"somebody cleans",
         {CTL_REFUSAL_NOT_CLEAN, [](Rig& rig) { rig.heartbeat(0, all & ~(1u << CTL_PERMIT_BIT_CLEAN)); }}},
        {"only clean is permitted",
         {CTL_REFUSAL_NONE, [](Rig& rig) { rig.heartbeat(0, 1u << CTL_PERMIT_BIT_CLEAN); }}},
        {"heartbeat lost", {CTL_REFUSAL_HEARTBEAT_LOST, [](Rig& rig) { rig.run(3 * second); }}},
        {"no such output",
         {CTL_REFUSAL_BAD_ARGUMENT, [](Rig&) {}, static_cast<std::uint16_t>(CTL_OUTPUT_BIT_LAST + 1u)}},
        {"neither on nor off", {CTL_REFUSAL_BAD_ARGUMENT, [](Rig&) {}, tested, 2}},
        {"no outputs", {CTL_REFUSAL_BAD_ARGUMENT, [](Rig& rig) { rig.core().board.port.outputs = nullptr; }}},
    };
    return rows;
}

const std::map<const char*, Act>& ends()
{
    static const std::map<const char*, Act> rows{
        {"released", [](Rig& rig) { QCOMPARE(tryOutput(rig, tested, 0), CTL_REFUSAL_NONE); }},
        {"another output",
         [](Rig& rig) { QCOMPARE(tryOutput(rig, CTL_OUTPUT_BIT_SWITCH1), CTL_REFUSAL_NONE); }},
        {"refused",
         [](Rig& rig) { QCOMPARE(tryOutput(rig, CTL_OUTPUT_BIT_LAST + 1u), CTL_REFUSAL_BAD_ARGUMENT); }},
        {"start", [](Rig& rig) { QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NONE); }},
        {"start that is refused",
         [](Rig& rig) {
             rig.setParameter(CTL_REG_PARAMETER_PERMIT_NEEDED, 1);
             QCOMPARE(rig.command(CTL_COMMAND_START), CTL_REFUSAL_NOT_WARM);
         }},
        {"home", [](Rig& rig) { QCOMPARE(rig.command(CTL_COMMAND_HOME), CTL_REFUSAL_NONE); }},
        {"stop", [](Rig& rig) { QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), CTL_REFUSAL_NOT_RUNNING); }},
        {"jog", [](Rig& rig) { rig.heartbeat(1u << CTL_JOG_BIT_FORWARD); }},
        {"emergency stop", [](Rig& rig) { press(rig, CTL_INPUT_BIT_EMERGENCY_STOP); }},
        {"drive alarm", [](Rig& rig) { press(rig, CTL_INPUT_BIT_DRIVE_ALARM); }},
        {"another fault",
         [](Rig& rig) { ctl_motion_fault(&rig.core().motion, CTL_FAULT_BIT_FOLLOWING_ERROR); }},
    };
    return rows;
}

} // namespace

class TestOutputs : public QObject {
    Q_OBJECT

private slots:
    void onWhileItIsAskedFor();
    void eachOutputAlone();
    void withoutAProgram();
    void refusedButAtStandstill_data();
    void refusedButAtStandstill();
    void whateverElseHappensEndsIt_data();
    void whateverElseHappensEndsIt();
    void enabledDriveDoesNotMove();
};

void TestOutputs::onWhileItIsAskedFor()
{
    Rig rig;
    rig.install(camBank(10'000, 1, 1'600'000));
    QVERIFY(!isOn(rig));
    for (int i = 0; i < 20; ++i) {
        QCOMPARE(tryOutput(rig), CTL_REFUSAL_NONE);
        rig.run(400'000);
        QVERIFY(isOn(rig));
    }
    QCOMPARE(tryOutput(rig), CTL_REFUSAL_NONE);
    rig.run(490'000);
    QVERIFY(isOn(rig));
    rig.run(20'000);
    QVERIFY(!isOn(rig));
    rig.run(2 * second);
    QVERIFY(!isOn(rig));
}

void TestOutputs::eachOutputAlone()
{
    Rig rig;
    rig.install(camBank(10'000, 1, 1'600'000));
    rig.setParameter(CTL_REG_PARAMETER_DRIVE_ENABLE, CTL_DRIVE_ENABLE_OFF);
    rig.controller().machine().setInput(CTL_INPUT_BIT_STOP_BUTTON, true); // not ready to start
    rig.run(100'000);
    for (std::uint16_t output = 0; output <= CTL_OUTPUT_BIT_LAST; ++output) {
        QCOMPARE(tryOutput(rig, output), CTL_REFUSAL_NONE);
        rig.run(1000);
        QCOMPARE(levels(rig), 1u << output);
    }
    QCOMPARE(tryOutput(rig, 0, 0), CTL_REFUSAL_NONE);
    rig.run(1000);
    QCOMPARE(levels(rig), 0u);
}

void TestOutputs::withoutAProgram()
{
    Rig rig;
    QCOMPARE(rig.core().motion.state, CTL_STATE_IDLE);
    QCOMPARE(tryOutput(rig), CTL_REFUSAL_NONE);
    QVERIFY(isOn(rig));
}

void TestOutputs::refusedButAtStandstill_data()
{
    QTest::addColumn<QString>("name");
    for (const auto& [name, situation] : situations())
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestOutputs::refusedButAtStandstill()
{
    QFETCH(QString, name);
    const auto row = std::ranges::find_if(
        situations(), [&name](const auto& each) { return name == QLatin1String(each.first); });
    const Situation& situation = row->second;
    Rig rig;
    rig.install(camBank(10'000, 1, 1'600'000));
    rig.heartbeat(0, all);
    situation.reach(rig);
    rig.setParameter(CTL_REG_PARAMETER_PERMIT_NEEDED, 1);
    QCOMPARE(tryOutput(rig, situation.output, situation.on), situation.refusal);
    QCOMPARE(isOn(rig), situation.refusal == CTL_REFUSAL_NONE);
    rig.run(100'000);
    QCOMPARE(isOn(rig), situation.refusal == CTL_REFUSAL_NONE);
}

void TestOutputs::whateverElseHappensEndsIt_data()
{
    QTest::addColumn<QString>("name");
    for (const auto& [name, act] : ends())
        QTest::newRow(name) << QString::fromLatin1(name);
}

// A test that has ended stays so: nothing comes on again when the reason is gone.
void TestOutputs::whateverElseHappensEndsIt()
{
    QFETCH(QString, name);
    const auto row =
        std::ranges::find_if(ends(), [&name](const auto& each) { return name == QLatin1String(each.first); });
    Rig rig;
    rig.install(camBank(10'000, 1, 1'600'000));
    rig.heartbeat();
    QCOMPARE(tryOutput(rig), CTL_REFUSAL_NONE);
    QVERIFY(isOn(rig));
    row->second(rig);
    rig.run(1000);
    QVERIFY(!isOn(rig));
    rig.run(300'000);
    QVERIFY(!isOn(rig));
}

// The core gives no pulses at standstill.
void TestOutputs::enabledDriveDoesNotMove()
{
    Rig rig;
    rig.install(camBank(10'000, 1, 1'600'000));
    rig.setParameter(CTL_REG_PARAMETER_DRIVE_ENABLE, CTL_DRIVE_ENABLE_OFF);
    rig.run(second);
    const std::int64_t commanded = rig.core().motion.commanded;
    const std::int64_t actual = rig.core().motion.actual;
    for (int i = 0; i < 10; ++i) {
        QCOMPARE(tryOutput(rig, CTL_OUTPUT_BIT_DRIVE_ENABLE), CTL_REFUSAL_NONE);
        rig.run(200'000);
        QVERIFY(isOn(rig, CTL_OUTPUT_BIT_DRIVE_ENABLE));
    }
    QCOMPARE(rig.core().motion.commanded, commanded);
    QCOMPARE(rig.core().motion.actual, actual);
    rig.run(second);
    QVERIFY(!isOn(rig, CTL_OUTPUT_BIT_DRIVE_ENABLE));
}

CAMPANEL_TEST(TestOutputs)

} // namespace test_outputs

#include "test_outputs.moc"
