// SPDX-License-Identifier: Apache-2.0
// The property getters of Machine, from the last status and the active program.
#include "app/machine/command_rules.h"
#include "app/machine/connection_sentences.h"
#include "app/machine/controller_sentences.h"
#include "app/machine/machine.h"
#include "app/machine/settings.h"

namespace campanel::machine {

namespace {

double orUnknown(const std::optional<double>& value)
{
    return value.value_or(unknown);
}

} // namespace

Machine::Connection Machine::connection() const
{
    switch (m_report.state) {
    case link::LinkState::Searching:
        return Connection::Searching;
    case link::LinkState::Connecting:
        return Connection::Connecting;
    case link::LinkState::Connected:
        return Connection::Connected;
    case link::LinkState::Lost:
        return Connection::Lost;
    case link::LinkState::WrongDevice:
        return Connection::WrongDevice;
    case link::LinkState::PortProblem:
        return Connection::PortProblem;
    }
    return Connection::Searching;
}

QString Machine::connectionText() const
{
    return ConnectionSentences::connection(m_report, m_lostAt);
}

QString Machine::stopWaitsText() const
{
    if (!stopWaits())
        return {};
    return isConnected() ? tr("Stop was sent and its answer is awaited.")
                         : tr("Stop waits for the line – it is sent as soon as the line is back.");
}

const ControllerProgram* Machine::runningProgram() const
{
    const bool isOfStatus = m_program && m_status && m_program->generation == m_status->generation &&
                            m_program->crc == m_status->activeCrc;
    return isOfStatus ? m_program.get() : nullptr;
}

double Machine::statusPerSecond() const
{
    return isConnected() ? m_rate.perSecond(m_clock()) : unknown;
}

int Machine::linkQuality() const
{
    return isConnected() ? m_rate.quality(m_clock()) : 0;
}

double Machine::ageMs() const
{
    return m_statusAt ? std::chrono::duration<double, std::milli>(m_clock() - *m_statusAt).count() : unknown;
}

Machine::State Machine::state() const
{
    if (!isConnected() || !m_status || !m_status->state)
        return State::Unknown;
    switch (*m_status->state) {
    case modbus::State::Idle:
        return State::Idle;
    case modbus::State::Ready:
        return State::Ready;
    case modbus::State::Running:
        return State::Running;
    case modbus::State::Stopping:
        return State::Stopping;
    case modbus::State::Jogging:
        return State::Jogging;
    case modbus::State::Homing:
        return State::Homing;
    case modbus::State::Fault:
        return State::Fault;
    }
    return State::Unknown;
}

QString Machine::stateText() const
{
    if (state() != State::Unknown)
        return ControllerSentences::state(*m_status->state);
    if (isConnected() && m_status)
        return tr("Unknown state");
    switch (connection()) {
    case Connection::Searching:
        return tr("Searching");
    case Connection::Connecting:
    case Connection::Connected:
        return tr("Connecting");
    case Connection::Lost:
        return tr("No connection");
    case Connection::WrongDevice:
        return tr("Wrong device");
    case Connection::PortProblem:
        return tr("Port problem");
    }
    return {};
}

QStringList Machine::alarmTexts() const
{
    return m_status && isConnected() ? ControllerSentences::alarms(*m_status) : QStringList();
}

bool Machine::faulted() const
{
    return state() == State::Fault;
}

double Machine::rateBagsPerMin() const
{
    const ControllerProgram* program = runningProgram();
    return program ? program->rateBagsPerMin * m_status->masterSpeedPercent / 100 : unknown;
}

double Machine::masterAngleDeg() const
{
    return m_status ? orUnknown(m_status->masterAngleDeg) : unknown;
}

double Machine::knifeAngleDeg() const
{
    return m_status ? orUnknown(m_status->knifeAngleDeg) : unknown;
}

double Machine::knifeSpeedMmPerS() const
{
    const ControllerProgram* program = runningProgram();
    return program && program->pulsesPerMm > 0 ? m_status->actualFrequencyHz / program->pulsesPerMm : unknown;
}

double Machine::followingErrorPulses() const
{
    return m_status ? m_status->followingErrorPulses : unknown;
}

double Machine::followingErrorMm() const
{
    const ControllerProgram* program = runningProgram();
    return program && program->pulsesPerMm > 0 ? m_status->followingErrorPulses / program->pulsesPerMm
                                               : unknown;
}

double Machine::pulseFrequencyHz() const
{
    return m_status ? m_status->commandedFrequencyHz : unknown;
}

double Machine::cycleCount() const
{
    return m_status ? m_status->cycleCount : unknown;
}

double Machine::positionMm() const
{
    const ControllerProgram* program = runningProgram();
    return program && program->pulsesPerMm > 0 ? m_status->axisPositionPulses / program->pulsesPerMm
                                               : unknown;
}

double Machine::masterSpeedPercent() const
{
    return m_status ? m_status->masterSpeedPercent : unknown;
}

double Machine::forceN() const
{
    return m_status && m_status->press ? m_status->press->forceN : unknown;
}

QString Machine::stageText() const
{
    return m_status && m_status->press && m_status->press->stage
               ? ControllerSentences::pressStage(*m_status->press->stage)
               : QString();
}

int Machine::stage() const
{
    return m_status && m_status->press && m_status->press->stage
               ? static_cast<int>(*m_status->press->stage) - 1
               : -1;
}

QStringList Machine::stageNames() const
{
    using modbus::PressStage;
    QStringList names;
    for (const PressStage stage :
         {PressStage::Approach, PressStage::Probe, PressStage::Press, PressStage::Hold, PressStage::Return})
        names << ControllerSentences::pressStage(stage);
    return names;
}

const profile::PressProgram* Machine::pressProgram() const
{
    return m_program ? std::get_if<profile::PressProgram>(&m_program->recipe.program) : nullptr;
}

double Machine::approachPositionMm() const
{
    const auto* press = pressProgram();
    return press ? press->approachPositionMm : unknown;
}

double Machine::pressPositionMm() const
{
    const auto* press = pressProgram();
    return press ? press->pressPositionMm : unknown;
}

double Machine::minStopForceN() const
{
    const auto* press = pressProgram();
    return press ? press->minStopForceN : unknown;
}

double Machine::maxStopForceN() const
{
    const auto* press = pressProgram();
    return press ? press->maxStopForceN : unknown;
}

int Machine::activeKind() const
{
    return m_program ? static_cast<int>(m_program->recipe.kind()) : 0;
}

double Machine::bagToleranceMm() const
{
    return m_settings.bagToleranceMm();
}

double Machine::bagCount() const
{
    return m_status ? m_status->bagCount : unknown;
}

double Machine::generation() const
{
    return m_status ? m_status->generation : unknown;
}

QString Machine::activeName() const
{
    return m_program ? QString::fromStdString(m_program->header.recipeName) : QString();
}

double Machine::activeVersion() const
{
    return m_program ? m_program->version : unknown;
}

double Machine::activeBagLengthMm() const
{
    return m_program ? m_program->bagLengthMm : unknown;
}

double Machine::activeRateBagsPerMin() const
{
    return m_program ? m_program->rateBagsPerMin : unknown;
}

double Machine::cycleSeconds() const
{
    return m_program ? m_program->cycleSeconds : unknown;
}

double Machine::syncStartDeg() const
{
    return m_program ? m_program->syncStartDeg : unknown;
}

double Machine::syncEndDeg() const
{
    return m_program ? m_program->syncEndDeg : unknown;
}

double Machine::cutAngleDeg() const
{
    return m_program ? m_program->cutDeg : unknown;
}

QVariant Machine::targetCurves() const
{
    return m_program && m_program->curves ? QVariant::fromValue(m_program->curves) : QVariant();
}

QString Machine::blockedReason(modbus::Command command) const
{
    if (!isConnected() || !m_fresh)
        return tr("There is no connection to the controller.");
    if (state() == State::Unknown)
        return tr("The state of the controller is not known.");
    return ControllerSentences::refusal(expectedRefusal(*m_status, command));
}

} // namespace campanel::machine
