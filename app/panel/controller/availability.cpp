// SPDX-License-Identifier: Apache-2.0
// One row per action: whether it needs the connection, and the states that block it.
#include "app/panel/controller/availability.h"

#include "app/panel/controller/command_rules.h"
#include "app/panel/controller/controller.h"
#include "app/panel/words/controller_sentences.h"

#include <algorithm>
#include <array>
#include <optional>

namespace campanel::panel {

namespace {

using State = Controller::State;

constexpr unsigned in(State state)
{
    return 1U << static_cast<unsigned>(state);
}

constexpr unsigned moving = in(State::Running) | in(State::Stopping) | in(State::Jogging) | in(State::Homing);
constexpr unsigned all = moving | in(State::Unknown) | in(State::Idle) | in(State::Ready) | in(State::Fault);
constexpr unsigned standstill = in(State::Idle) | in(State::Ready);

constexpr bool connected = true;
constexpr bool anyConnection = false;
constexpr bool endedByEmergencyStop = true;

struct Row {
    Action action;
    bool needsConnection;
    unsigned blockedIn;                       // states
    const char* sentence{};                   // null: that of the state
    std::optional<modbus::Command> command{}; // the controller's own rules, see command_rules.h
    bool isEndedByEmergencyStop = false;
};

constexpr std::array actionRows{
    Row{Action::Start, connected, in(State::Unknown), nullptr, modbus::Command::Start},
    Row{Action::Home, connected, in(State::Unknown), nullptr, modbus::Command::Home},
    Row{Action::JogBag, connected, in(State::Unknown), nullptr, modbus::Command::JogBag},
    Row{Action::SingleCut, connected, in(State::Unknown), nullptr, modbus::Command::SingleCut},
    Row{Action::TakeBag, connected, in(State::Unknown), nullptr, modbus::Command::TakeBag},
    Row{Action::Measure, connected, in(State::Unknown), nullptr, modbus::Command::Measure},
    Row{Action::Jog, connected, all & ~standstill & ~in(State::Jogging), nullptr, {}, endedByEmergencyStop},
    Row{Action::TryOutput, connected, all & ~standstill, nullptr, {}, endedByEmergencyStop},
    Row{Action::Download, connected, 0},
    Row{Action::ChangeMachineData, connected, all & ~standstill,
        QT_TRANSLATE_NOOP(
            "Availability",
            "Program type and machine data can only be changed at standstill. Stop the machine first.")},
    Row{Action::Compare, connected, 0},
    Row{Action::ReverseMaster, connected, 0},
    Row{Action::SetUpMarks, connected, 0},
    Row{Action::MeasureMarks, connected, all & ~in(State::Running),
        QT_TRANSLATE_NOOP("Availability", "Start the machine: this step continues while the machine runs.")},
    Row{Action::Diagnose, anyConnection, moving,
        QT_TRANSLATE_NOOP(
            "Availability",
            "The machine is moving. Stop it first: diagnosis and search interrupt the connection.")},
    Row{Action::RotateScreen, anyConnection, moving,
        QT_TRANSLATE_NOOP("Availability", "The machine is moving. Stop it before changing the screen.")},
    Row{Action::CalibrateTouch, anyConnection, moving,
        QT_TRANSLATE_NOOP("Availability",
                          "The machine is moving. Stop it before calibrating the touchscreen.")},
    Row{Action::UpdateSoftware, anyConnection, moving,
        QT_TRANSLATE_NOOP("Availability",
                          "The machine is moving. Stop it before the update; the panel will restart.")},
    Row{Action::RestoreBackup, anyConnection, moving,
        QT_TRANSLATE_NOOP("Availability",
                          "The machine is moving. Stop it before restoring; the panel will restart.")},
};
static_assert(std::ranges::all_of(actionRows, [](const Row& row) {
    return &row == &actionRows[static_cast<std::size_t>(row.action)];
}));

// These sentences say what blocks an action in a state, unless its row says more; in the order of State.
constexpr std::array sentencesOfStates{
    QT_TRANSLATE_NOOP("Availability", "The controller's state is unknown."),
    "",
    "",
    QT_TRANSLATE_NOOP("Availability", "The machine is running. Stop it first."),
    QT_TRANSLATE_NOOP("Availability", "The machine is stopping. Wait for standstill."),
    QT_TRANSLATE_NOOP("Availability", "The axis is jogging. Wait for standstill."),
    QT_TRANSLATE_NOOP("Availability", "The reference run is active. Wait for standstill."),
    QT_TRANSLATE_NOOP("Availability", "The controller is in fault. Reset the fault first."),
};

// The panel's own reasons against Start hold for these, too.
constexpr bool isStart(Action action)
{
    return action == Action::Start || action == Action::JogBag || action == Action::SingleCut;
}

QString translated(const char* sentence)
{
    return QCoreApplication::translate("Availability", sentence);
}

} // namespace

QString Controller::blockedReason(Action action) const
{
    const Row& row = actionRows[static_cast<std::size_t>(action)];
    if (row.needsConnection && (!isConnected() || !m_fresh))
        return translated(QT_TRANSLATE_NOOP("Availability", "There is no connection to the controller."));
    if ((row.blockedIn & in(state())) != 0)
        return translated(row.sentence ? row.sentence : sentencesOfStates[static_cast<std::size_t>(state())]);
    if (row.isEndedByEmergencyStop && m_status->has(modbus::WarningBit::EmergencyStop))
        return ControllerSentences::refusal(modbus::Refusal::EmergencyStop);
    const QString refusal =
        row.command ? ControllerSentences::refusal(expectedRefusal(*m_status, *row.command)) : QString();
    if (refusal.isEmpty() && isStart(action) && m_program) {
        if (const QString reason = m_masterSetting.refusal(m_program->recipe); !reason.isEmpty())
            return reason;
    }
    const bool isInterlocked = refusal.isEmpty() && isStart(action) && m_startInterlock;
    return isInterlocked ? m_startInterlock() : refusal;
}

} // namespace campanel::panel
