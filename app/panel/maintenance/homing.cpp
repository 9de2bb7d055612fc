// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/homing.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/language_notifier.h"

namespace campanel::panel {

namespace {

using Kind = profile::ProgramKind;

Kind kindOf(const Controller& controller)
{
    return static_cast<Kind>(controller.active().kind);
}

} // namespace

Homing::Homing(Controller& controller, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_pins(controller, this)
{
    connect(&m_pins, &IoPins::changed, this, &Homing::changed);
    for (const auto trigger :
         {&Controller::stateChanged, &Controller::freshChanged, &Controller::connectionChanged})
        connect(&controller, trigger, this, &Homing::note);
    connect(&controller, &Controller::programChanged, this, &Homing::noteProgram);
    connect(&controller, &Controller::commandEnded, this, [this](const link::CommandOutcome& outcome) {
        // A press sets the present position: homing ends with the command.
        if (outcome.command == modbus::Command::Home && outcome.end == link::CommandEnd::Done && !moves())
            end(Result::Done);
    });
    LanguageNotifier::follow(this);
}

bool Homing::moves() const
{
    return kindOf(m_controller) != Kind::Press;
}

bool Homing::isKept() const
{
    return moves() && m_pins.status() && m_pins.status()->isAxisKept;
}

Homing::Place Homing::place() const
{
    const auto& status = m_controller.status();
    if (!m_controller.isConnected() || !m_controller.fresh() || !status)
        return Place::Unknown;
    if (status->has(modbus::WarningBit::NotHomed))
        return Place::NotHomed;
    const bool isMove = kindOf(m_controller) == Kind::PositionMove || kindOf(m_controller) == Kind::SpeedMove;
    return isMove ? Place::NotNeeded : Place::Homed;
}

QString Homing::placeText() const
{
    switch (place()) {
    case Place::Homed:
        return moves() ? tr("Referenced") : tr("Top position known");
    case Place::NotHomed:
        return moves() ? tr("Not referenced") : tr("Top position not known");
    case Place::NotNeeded:
        return tr("No reference run required");
    case Place::Unknown:
        break;
    }
    return tr("Unknown");
}

QString Homing::explanation() const
{
    if (isKept())
        return tr(
            "Keep hands away: the axis turns slowly to 0°, the shorter way. Its encoder keeps the position "
            "without power, so no index mark is searched. Start begins with the reference run when "
            "required.");
    switch (kindOf(m_controller)) {
    case Kind::RotaryCutter:
        return tr("Keep hands away: the knife turns slowly forward to the index mark of its shaft, brakes "
                  "and returns to 0°. Start begins with the reference run when required.");
    case Kind::PointCam:
    case Kind::SegmentCam:
        return tr("The axis turns slowly forward to the index mark of its motor, brakes and returns to "
                  "position 0. Start begins with the reference run when required.");
    case Kind::PositionMove:
    case Kind::SpeedMove:
        return tr(
            "Moves start at the present axis position, so no reference run is required. The reference run "
            "turns slowly to the motor's index mark, which becomes position 0.");
    case Kind::Press:
        return tr("No motion: the present ram position becomes the top position, the reference of all "
                  "depths. Jog the ram there first; a wrong top position makes every stroke wrong.");
    }
    return tr("The reference run depends on the program. Download a recipe first.");
}

QString Homing::keyText() const
{
    return moves() ? tr("Reference run") : tr("Set as top position");
}

QString Homing::blockedReason() const
{
    if (m_controller.state() == Controller::State::Homing && m_controller.fresh())
        return isKept() ? tr("Turning to 0° …") : tr("Searching for the index mark …");
    return m_controller.blockedReason(Action::Home);
}

bool Homing::offered() const
{
    return possible() && (moves() || place() == Place::NotHomed);
}

QString Homing::resultText() const
{
    switch (m_result) {
    case Result::Done:
        return isKept()  ? tr("The last reference run ended at 0°.")
               : moves() ? tr("The last reference run found the index mark.")
                         : tr("The ram position was set as top position.");
    case Result::Stopped:
        return tr("The last reference run was stopped before its end.");
    case Result::Failed:
        return tr("The last reference run failed: no index mark within two revolutions, or the axis did not "
                  "follow. "
                  "See the alarm.");
    case Result::Interrupted:
        return tr("The connection was lost during the reference run: the result is unknown.");
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
    if (m_controller.accessCheck().require(Level::Operator) && possible())
        m_controller.home();
}

void Homing::note()
{
    const Controller::State state = m_controller.state();
    if (state == Controller::State::Homing) {
        m_result = Result::UnderWay;
        m_wasStopping = false;
    } else if (m_result == Result::UnderWay) {
        if (!m_controller.isConnected())
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
