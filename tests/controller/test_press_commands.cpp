// SPDX-License-Identifier: Apache-2.0
// A press among the states of the controller: download, commands in every stage, the status block.
#include "press_bench.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

namespace test_press_commands {

using namespace campanel::test;
using campanel::controller::MachineOptions;

namespace {

void runUntilStage(PressBench& bench, std::uint16_t stage)
{
    const std::uint64_t endUs = bench.nowUs() + 60'000'000;
    while (bench.core().motion.press.stage != stage && bench.nowUs() < endUs)
        bench.tick();
}

std::uint16_t downloadPress(Rig& rig, const Registers& image)
{
    rig.transfer(1, CTL_TRANSFER_OPERATION_BEGIN, 0,
                 {CTL_PROGRAM_KIND_PRESS, static_cast<std::uint16_t>(image.size()), CTL_MAP_MAJOR});
    for (std::size_t first = 0; first < image.size(); first += CTL_BLOCK_REGISTERS) {
        const std::size_t last = std::min<std::size_t>(image.size(), first + CTL_BLOCK_REGISTERS);
        rig.transfer(1, CTL_TRANSFER_OPERATION_BLOCK, static_cast<std::uint16_t>(first / CTL_BLOCK_REGISTERS),
                     Registers(image.begin() + static_cast<std::ptrdiff_t>(first),
                               image.begin() + static_cast<std::ptrdiff_t>(last)));
    }
    return rig.transfer(1, CTL_TRANSFER_OPERATION_SEAL, 0, {}).at(3);
}

void installPress(Rig& rig, const PressImage& press)
{
    const Registers image = press.registers();
    QCOMPARE(downloadPress(rig, image), CTL_TRANSFER_RESULT_ACCEPTED);
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_WHEN_STOPPED), CTL_REFUSAL_NONE);
}

} // namespace

class TestPressCommands : public QObject {
    Q_OBJECT

private slots:
    void overTheLine();
    void survivesPowerOff();
    void stopNowInEveryStage_data();
    void stopNowInEveryStage();
    void stopAtCycleEndFinishesTheStroke();
    void abandonedByAFault();
    void armedProgramTakesOverAfterTheStroke();
    void homeTakesTheUpperPosition();
    void jogDownEndsAtTheLargestForce();
    void cutterAfterPressAndBack();
};

void TestPressCommands::overTheLine()
{
    Rig rig;
    QVERIFY((rig.status(CTL_REG_IDENTITY_PROGRAM_KINDS) >> CTL_PROGRAM_KIND_PRESS & 1u) != 0);
    installPress(rig, PressImage{});
    QCOMPARE(rig.status(CTL_REG_STATUS_PROGRAM_KIND), std::uint16_t{CTL_PROGRAM_KIND_PRESS});
    QCOMPARE(rig.status(CTL_REG_STATUS_STROKE_RESULT), std::uint16_t{CTL_STROKE_RESULT_NONE});
    QCOMPARE(rig.status(CTL_REG_STATUS_WARNING) >> CTL_WARNING_BIT_NOT_HOMED & 1, 0);
    QCOMPARE(rig.command(CTL_COMMAND_START), std::uint16_t{CTL_REFUSAL_NONE});
    std::vector<std::uint16_t> stages;
    std::uint16_t largest = 0;
    while (rig.status(CTL_REG_STATUS_STATE) == CTL_STATE_RUNNING) {
        const Registers press = rig.read(CTL_REG_STATUS_PRESS_STAGE, 5); // stage, force, ..., result
        if (stages.empty() || stages.back() != press.at(0))
            stages.push_back(press.at(0));
        largest = std::max(largest, press.at(1));
        // A stroke reports its result at its end.
        QCOMPARE(press.at(4) == CTL_STROKE_RESULT_NONE, press.at(0) != CTL_PRESS_STAGE_STANDING);
        rig.run(10'000);
    }
    if (stages.back() == CTL_PRESS_STAGE_STANDING)
        stages.pop_back();
    QCOMPARE(stages, (std::vector<std::uint16_t>{CTL_PRESS_STAGE_APPROACH, CTL_PRESS_STAGE_PROBE,
                                                 CTL_PRESS_STAGE_PRESS, CTL_PRESS_STAGE_HOLD,
                                                 CTL_PRESS_STAGE_RETURN}));
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), std::uint16_t{CTL_STATE_READY});
    QCOMPARE(rig.status(CTL_REG_STATUS_PRESS_STAGE), std::uint16_t{CTL_PRESS_STAGE_STANDING});
    QCOMPARE(rig.status(CTL_REG_STATUS_STROKE_RESULT), std::uint16_t{CTL_STROKE_RESULT_OK});
    QVERIFY(std::abs(static_cast<std::int16_t>(rig.status(CTL_REG_STATUS_STOP_ERROR))) <= 1);
    const int force = rig.status(CTL_REG_STATUS_STOP_FORCE);
    QVERIFY(std::abs(force - 5000) <= 200); // 25 mm, scatter 0.2 mm, at 200 N/mm
    QVERIFY(rig.status(CTL_REG_STATUS_PEAK_FORCE) >= force);
    QVERIFY(std::abs(largest - force) <= 2);
    QCOMPARE(rig.status(CTL_REG_STATUS_PRESS_FORCE), std::uint16_t{0});
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_CYCLE_COUNT), 1u);
    QVERIFY(std::abs(static_cast<std::int32_t>(rig.statusWide(CTL_REG_STATUS_AXIS_POSITION))) <= 1);
}

void TestPressCommands::survivesPowerOff()
{
    MemoryFlash flash;
    const Registers image = PressImage{}.registers();
    {
        Rig rig({}, &flash);
        installPress(rig, PressImage{});
        QCOMPARE(rig.command(CTL_COMMAND_SAVE_TO_FLASH, 0, 0, crc32(image)), std::uint16_t{CTL_REFUSAL_NONE});
    }
    Rig rig({}, &flash);
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), std::uint16_t{CTL_STATE_READY});
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC), crc32(image));
    QCOMPARE(rig.command(CTL_COMMAND_START), std::uint16_t{CTL_REFUSAL_NONE});
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.status(CTL_REG_STATUS_STROKE_RESULT), std::uint16_t{CTL_STROKE_RESULT_OK});
}

void TestPressCommands::stopNowInEveryStage_data()
{
    QTest::addColumn<int>("stage");
    QTest::addColumn<int>("result");
    QTest::newRow("approach") << int{CTL_PRESS_STAGE_APPROACH} << int{CTL_STROKE_RESULT_STOPPED};
    QTest::newRow("probe") << int{CTL_PRESS_STAGE_PROBE} << int{CTL_STROKE_RESULT_STOPPED};
    QTest::newRow("press") << int{CTL_PRESS_STAGE_PRESS} << int{CTL_STROKE_RESULT_STOPPED};
    QTest::newRow("hold") << int{CTL_PRESS_STAGE_HOLD} << int{CTL_STROKE_RESULT_STOPPED};
    QTest::newRow("return") << int{CTL_PRESS_STAGE_RETURN} << int{CTL_STROKE_RESULT_OK}; // was pressed
}

// Stops in place; the next Start goes up first and then performs a whole stroke.
void TestPressCommands::stopNowInEveryStage()
{
    QFETCH(int, stage);
    QFETCH(int, result);
    PressBench bench(PressImage{}, MachineOptions{});
    QCOMPARE(ctl_start(&bench.core().motion, &bench.core().io), std::uint16_t{CTL_REFUSAL_NONE});
    runUntilStage(bench, static_cast<std::uint16_t>(stage));
    for (int i = 0; i < 400; ++i) // about 60 ms into the stage
        bench.tick();
    const double stoppedMm = bench.machine().ram().positionMm();
    const double speedMmPerS =
        std::abs(static_cast<double>(ctl_motion_commanded_hz(&bench.core().motion))) / 100;
    QCOMPARE(ctl_motion_stop_now(&bench.core().motion), std::uint16_t{CTL_REFUSAL_NONE});
    bench.runToStandstill();
    QCOMPARE(bench.core().motion.state, std::uint16_t{CTL_STATE_READY});
    QCOMPARE(int{bench.last().result}, result);
    QCOMPARE(bench.core().motion.cycle_count, 1u);
    // A ramp of 20 ms at most, and the servo's lag of 4 ms.
    const double ranOutMm = std::abs(bench.machine().ram().positionMm() - stoppedMm);
    QVERIFY2(ranOutMm <= speedMmPerS * (0.010 + 0.004) + 0.03, qPrintable(QString::number(ranOutMm)));
    QVERIFY(bench.stroke());
    QCOMPARE(int{bench.last().result}, int{CTL_STROKE_RESULT_OK});
    QCOMPARE(bench.backwards, 0);
    QVERIFY(std::abs(bench.last().error) <= 1);
}

void TestPressCommands::stopAtCycleEndFinishesTheStroke()
{
    PressBench bench(PressImage{}, MachineOptions{});
    QCOMPARE(ctl_start(&bench.core().motion, &bench.core().io), std::uint16_t{CTL_REFUSAL_NONE});
    QCOMPARE(ctl_start(&bench.core().motion, &bench.core().io), std::uint16_t{CTL_REFUSAL_ALREADY_RUNNING});
    runUntilStage(bench, CTL_PRESS_STAGE_PROBE);
    QCOMPARE(ctl_motion_stop_at_cycle_end(&bench.core().motion), std::uint16_t{CTL_REFUSAL_NONE});
    QCOMPARE(bench.core().motion.state, std::uint16_t{CTL_STATE_STOPPING});
    bench.runToStandstill();
    QCOMPARE(int{bench.last().result}, int{CTL_STROKE_RESULT_OK});
    QCOMPARE(bench.core().motion.state, std::uint16_t{CTL_STATE_READY});
    QVERIFY(std::abs(bench.machine().ram().positionMm()) <= 0.015);
}

// The drive does not follow: no more pulses, and the stroke counts as stopped.
void TestPressCommands::abandonedByAFault()
{
    PressBench bench(PressImage{}, MachineOptions{});
    QCOMPARE(ctl_start(&bench.core().motion, &bench.core().io), std::uint16_t{CTL_REFUSAL_NONE});
    runUntilStage(bench, CTL_PRESS_STAGE_APPROACH);
    bench.machine().setDriveOn(false);
    bench.runToStandstill();
    QCOMPARE(bench.core().motion.state, std::uint16_t{CTL_STATE_FAULT});
    QCOMPARE(int{bench.core().motion.fault}, 1 << CTL_FAULT_BIT_FOLLOWING_ERROR);
    QCOMPARE(int{bench.last().result}, int{CTL_STROKE_RESULT_STOPPED});
    QCOMPARE(bench.core().motion.cycle_count, 1u);
    const std::int64_t commanded = bench.core().motion.commanded;
    for (int i = 0; i < 1000; ++i)
        bench.tick();
    QCOMPARE(bench.core().motion.commanded, commanded);
    bench.machine().setDriveOn(true);
    QCOMPARE(ctl_motion_reset_fault(&bench.core().motion), std::uint16_t{CTL_REFUSAL_NONE});
    QVERIFY(bench.stroke());
    QCOMPARE(int{bench.last().result}, int{CTL_STROKE_RESULT_OK});
}

void TestPressCommands::armedProgramTakesOverAfterTheStroke()
{
    Rig rig;
    installPress(rig, PressImage{});
    QCOMPARE(rig.command(CTL_COMMAND_START), std::uint16_t{CTL_REFUSAL_NONE});
    PressImage next;
    next.rows[CTL_PRESS_PRESS].end = 9800;
    const Registers image = next.registers();
    QCOMPARE(downloadPress(rig, image), std::uint16_t{CTL_TRANSFER_RESULT_ACCEPTED});
    QCOMPARE(rig.apply(image, CTL_APPLY_MODE_NEXT_CYCLE), std::uint16_t{CTL_REFUSAL_NONE});
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_ACTIVE_CRC), crc32(image));
    QVERIFY(std::abs(int{rig.status(CTL_REG_STATUS_STOP_FORCE)} - 5000) <=
            200); // the first one's depth still
    QCOMPARE(rig.command(CTL_COMMAND_START), std::uint16_t{CTL_REFUSAL_NONE});
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.status(CTL_REG_STATUS_STROKE_RESULT), std::uint16_t{CTL_STROKE_RESULT_OK});
    QVERIFY(std::abs(int{rig.status(CTL_REG_STATUS_STOP_FORCE)} - 4600) <= 200);
}

void TestPressCommands::homeTakesTheUpperPosition()
{
    Rig rig;
    installPress(rig, PressImage{});
    const std::uint32_t before = rig.statusWide(CTL_REG_STATUS_AXIS_POSITION);
    QCOMPARE(before, 0u);
    for (int i = 0; i < 20; ++i) {
        rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
        rig.run(50'000);
    }
    rig.heartbeat();
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.run(200'000);
    const auto lower = static_cast<std::int32_t>(rig.statusWide(CTL_REG_STATUS_AXIS_POSITION));
    QVERIFY(lower > 500);
    QCOMPARE(rig.command(CTL_COMMAND_HOME), std::uint16_t{CTL_REFUSAL_NONE});
    QCOMPARE(rig.statusWide(CTL_REG_STATUS_AXIS_POSITION), 0u);
    QCOMPARE(rig.status(CTL_REG_STATUS_STATE), std::uint16_t{CTL_STATE_READY});
}

void TestPressCommands::jogDownEndsAtTheLargestForce()
{
    MachineOptions options;
    options.press.workPieceMm = 5.0;
    options.press.workPieceScatterMm = 0.0;
    Rig rig(options);
    installPress(rig, PressImage{});
    rig.setParameter(CTL_REG_PARAMETER_JOG_FREQUENCY + 1, 10'000); // 100 mm/s; 8000 N are 40 mm deep
    for (int i = 0; i < 40; ++i) {
        rig.heartbeat(1u << CTL_JOG_BIT_FORWARD);
        rig.run(50'000);
    }
    QVERIFY(rig.status(CTL_REG_STATUS_PRESS_FORCE) >= 8000);
    const double overrunMm = rig.controller().machine().ram().positionMm() - 45.0;
    QVERIFY2(overrunMm <= 3.0, qPrintable(QString::number(overrunMm))); // a ramp of 50 ms and the lag
    rig.heartbeat();
    rig.heartbeat(1u << CTL_JOG_BIT_REVERSE);
    rig.run(100'000);
    QVERIFY(rig.controller().machine().ram().positionMm() < 45.0);
}

void TestPressCommands::cutterAfterPressAndBack()
{
    Rig rig;
    rig.install(camBank(10000, 1, 1'600'000));
    rig.start();
    QCOMPARE(rig.command(CTL_COMMAND_STOP_NOW), std::uint16_t{CTL_REFUSAL_NONE});
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    rig.run(500'000);
    installPress(rig, PressImage{});
    QCOMPARE(rig.command(CTL_COMMAND_START), std::uint16_t{CTL_REFUSAL_NONE});
    QVERIFY(rig.runUntilState(CTL_STATE_READY));
    QCOMPARE(rig.status(CTL_REG_STATUS_STROKE_RESULT), std::uint16_t{CTL_STROKE_RESULT_OK});
    rig.install(camBank(10000, 1, 1'600'000));
    rig.start();
    QCOMPARE(rig.status(CTL_REG_STATUS_FAULT), std::uint16_t{0});
}

CAMPANEL_TEST(TestPressCommands)

} // namespace test_press_commands

#include "test_press_commands.moc"
