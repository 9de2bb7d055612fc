// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/homing.h"

#include "app/panel/controller/controller.h"

namespace campanel::panel {

namespace {

using Kind = profile::ProgramKind;

Kind kindOf(const Controller& machine)
{
    return static_cast<Kind>(machine.active().kind);
}

} // namespace

Homing::Homing(Controller& machine, QObject* parent)
    : QObject(parent)
    , m_machine(machine)
    , m_speed(machine, AxisSpeed::Use::Home, this)
{
    for (const auto told :
         {&Controller::stateChanged, &Controller::freshChanged, &Controller::connectionChanged})
        connect(&machine, told, this, &Homing::note);
    connect(&machine, &Controller::programChanged, this, &Homing::noteProgram);
    connect(&machine, &Controller::commandEnded, this, [this](const link::CommandOutcome& outcome) {
        // A press sets the present position: homing ends with the command.
        if (outcome.command == modbus::Command::Home && outcome.end == link::CommandEnd::Done && !moves())
            end(Result::Done);
    });
}

bool Homing::moves() const
{
    return kindOf(m_machine) != Kind::Press;
}

Homing::Place Homing::place() const
{
    const auto& status = m_machine.status();
    if (!m_machine.isConnected() || !m_machine.fresh() || !status)
        return Place::Unknown;
    if (status->has(modbus::WarningBit::NotHomed))
        return Place::NotHomed;
    const bool isMove = kindOf(m_machine) == Kind::PositionMove || kindOf(m_machine) == Kind::SpeedMove;
    return isMove ? Place::NotNeeded : Place::Homed;
}

QString Homing::placeText() const
{
    switch (place()) {
    case Place::Homed:
        return moves() ? tr("Homed") : tr("Upper position known");
    case Place::NotHomed:
        return moves() ? tr("Not homed") : tr("Upper position not known");
    case Place::NotNeeded:
        return tr("Needs no homing");
    case Place::Unknown:
        break;
    }
    return tr("Not known");
}

QString Homing::explanation() const
{
    switch (kindOf(m_machine)) {
    case Kind::RotaryCutter:
        return tr("The knife turns slowly forward to the index mark of its shaft, brakes and returns to it: "
                  "that is "
                  "0°. Keep hands away from the knife. Start does this by itself when it is needed.");
    case Kind::PointCam:
        return tr(
            "The axis turns slowly forward to the index mark of its motor, brakes and returns to it: that is "
            "position 0. Start does this by itself when it is needed.");
    case Kind::PositionMove:
    case Kind::SpeedMove:
        return tr("Moves begin where the axis stands, so nothing has to be homed. Home turns slowly to the "
                  "index mark "
                  "of the motor and calls it position 0.");
    case Kind::Press:
        return tr("Nothing moves: the place where the ram stands now becomes its upper position, from which "
                  "all depths "
                  "are measured. Jog it there first. A wrong place makes every stroke wrong.");
    }
    return tr("What homing does depends on the program, and the controller has none.");
}

QString Homing::keyText() const
{
    return moves() ? tr("Home") : tr("Set as top position");
}

QString Homing::blockedReason() const
{
    if (m_machine.state() == Controller::State::Homing && m_machine.fresh())
        return tr("Looking for the index mark …");
    return m_machine.blockedReason(modbus::Command::Home);
}

bool Homing::offered() const
{
    return possible() && (moves() || place() == Place::NotHomed);
}

QString Homing::resultText() const
{
    switch (m_result) {
    case Result::Done:
        return moves() ? tr("The last homing has found the index mark.")
                       : tr("The place where the ram stood has become its upper position.");
    case Result::Stopped:
        return tr("The last homing was stopped before it ended.");
    case Result::Failed:
        return tr("The last homing has failed, see the alarm: no index mark came within two revolutions, or "
                  "the axis "
                  "did not follow.");
    case Result::Interrupted:
        return tr("The line was lost while homing: what came of it is not known.");
    case Result::None:
    case Result::UnderWay:
        break;
    }
    return {};
}

bool Homing::failed() const
{
    return m_result == Result::Stopped || m_result == Result::Failed || m_result == Result::Interrupted;
}

void Homing::home()
{
    if (possible())
        m_machine.home();
}

void Homing::note()
{
    const Controller::State state = m_machine.state();
    if (state == Controller::State::Homing) {
        m_result = Result::UnderWay;
        m_wasStopping = false;
    } else if (m_result == Result::UnderWay) {
        if (!m_machine.isConnected())
            end(Result::Interrupted);
        else if (state == Controller::State::Stopping)
            m_wasStopping = true;
        else if (state == Controller::State::Fault)
            end(Result::Failed);
        else if (state != Controller::State::Unknown)
            end(m_wasStopping || place() == Place::NotHomed ? Result::Stopped : Result::Done);
    }
    emit changed();
}

// Clears the result: another program may be for another machine.
void Homing::noteProgram()
{
    if (m_result != Result::UnderWay)
        m_result = Result::None;
    emit changed();
}

void Homing::end(Result result)
{
    m_result = result;
    emit ended(result);
    emit changed();
}

} // namespace campanel::panel
