// SPDX-License-Identifier: Apache-2.0
// The refusals expected by the panel are those of the controller's core, in every state.
#include "app/panel/controller/command_rules.h"
#include "app/program/program_image.h"
#include "app/program/recipe.h"
#include "controller/rig.h"
#include "modbus/line/wire_time.h"
#include "modbus/map/blocks.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
#include <memory>
#include <vector>

namespace test_command_rules {

using namespace campanel;
using modbus::Command;
using modbus::Refusal;
using modbus::State;
using panel::expectedRefusal;
using test::Rig;

namespace {

enum class Situation {
    Idle,
    JoggingWithoutProgram,
    FaultWithoutProgram,
    Ready,
    Jogging,
    Homing,
    Homed,
    Running,
    Stopping,
    Fault,
    EmergencyStop,
    DriveAlarm
};

void jog(Rig& rig)
{
    constexpr std::uint64_t slice = 10'000;
    for (int i = 0; i < 10; ++i) {
        rig.heartbeat(1U << CTL_JOG_BIT_FORWARD);
        rig.run(slice);
    }
}

std::unique_ptr<Rig> rigIn(Situation situation, profile::ProgramKind kind)
{
    auto rig = std::make_unique<Rig>();
    if (situation > Situation::FaultWithoutProgram) {
        const auto image = program::buildProgram(program::defaultRecipe(kind));
        rig->install(image->registers);
    }
    switch (situation) {
    case Situation::Idle:
    case Situation::Ready:
        break;
    case Situation::JoggingWithoutProgram:
    case Situation::Jogging:
        jog(*rig);
        break;
    case Situation::FaultWithoutProgram:
    case Situation::Fault:
        ctl_motion_fault(&rig->core().motion, CTL_FAULT_BIT_FOLLOWING_ERROR);
        break;
    case Situation::Homing:
        rig->command(CTL_COMMAND_HOME);
        break;
    case Situation::Homed:
        rig->command(CTL_COMMAND_HOME);
        rig->runUntilState(CTL_STATE_READY);
        break;
    case Situation::EmergencyStop:
        rig->controller().machine().setInput(CTL_INPUT_BIT_EMERGENCY_STOP, true);
        rig->run(1000);
        break;
    case Situation::DriveAlarm:
        rig->controller().machine().setInput(CTL_INPUT_BIT_DRIVE_ALARM, true);
        rig->run(1000);
        rig->controller().machine().setInput(CTL_INPUT_BIT_DRIVE_ALARM, false);
        rig->run(1000);
        break;
    case Situation::Running:
    case Situation::Stopping:
        rig->start();
        if (situation == Situation::Stopping)
            rig->command(CTL_COMMAND_STOP_AT_CYCLE_END);
        break;
    }
    return rig;
}

modbus::StatusBlock statusOf(Rig& rig)
{
    return modbus::decodeStatus(rig.read(modbus::statusAddress, modbus::statusRegisters));
}

} // namespace

class TestCommandRules : public QObject {
    Q_OBJECT

private slots:
    void theCoreRefusesWhatIsExpected_data()
    {
        QTest::addColumn<int>("situation");
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("state");
        const auto row = [](const char* tag, Situation situation, State state,
                            profile::ProgramKind kind = profile::ProgramKind::RotaryCutter) {
            QTest::newRow(tag) << static_cast<int>(situation) << static_cast<int>(kind)
                               << static_cast<int>(state);
        };
        row("no program", Situation::Idle, State::Idle);
        row("jogging without a program", Situation::JoggingWithoutProgram, State::Jogging);
        row("fault without a program", Situation::FaultWithoutProgram, State::Fault);
        row("ready", Situation::Ready, State::Ready);
        row("ready and homed", Situation::Homed, State::Ready);
        row("ready with a press", Situation::Ready, State::Ready, profile::ProgramKind::Press);
        row("ready with a move", Situation::Ready, State::Ready, profile::ProgramKind::PositionMove);
        row("jogging", Situation::Jogging, State::Jogging);
        row("homing", Situation::Homing, State::Homing);
        row("running", Situation::Running, State::Running);
        row("stopping", Situation::Stopping, State::Stopping);
        row("fault", Situation::Fault, State::Fault);
        row("emergency stop", Situation::EmergencyStop, State::Ready);
        row("drive alarm", Situation::DriveAlarm, State::Fault);
    }

    void theCoreRefusesWhatIsExpected()
    {
        QFETCH(int, situation);
        QFETCH(int, kind);
        QFETCH(int, state);
        std::vector commands{Command::Start, Command::Home, Command::ResetFault, Command::Measure};
        if (kind == static_cast<int>(profile::ProgramKind::RotaryCutter))
            commands.insert(commands.end(), {Command::JogBag, Command::SingleCut, Command::TakeBag});
        for (const Command command : commands) {
            const auto rig =
                rigIn(static_cast<Situation>(situation), static_cast<profile::ProgramKind>(kind));
            rig->setParameter(CTL_REG_PARAMETER_SWITCH1_MODE, CTL_SWITCH_MODE_REJECTED_BAGS);
            const modbus::StatusBlock status = statusOf(*rig);
            QCOMPARE(status.state, std::optional(static_cast<State>(state)));
            if (command == Command::Measure)
                rig->heartbeat();
            const std::uint16_t refused = rig->command(static_cast<std::uint16_t>(command));
            QCOMPARE(static_cast<int>(expectedRefusal(status, command)), static_cast<int>(refused));
        }
    }
};

CAMPANEL_TEST(TestCommandRules)

} // namespace test_command_rules

#include "test_command_rules.moc"
