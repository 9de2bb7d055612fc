// SPDX-License-Identifier: Apache-2.0
// The property getters of Machine, from the last status and the active program.
#include "app/panel/controller/command_rules.h"
#include "app/panel/controller/controller.h"
#include "app/panel/settings/settings.h"
#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/controller_sentences.h"
#include "profile/cutter/jaw.h"

#include <cmath>
#include <numbers>

namespace campanel::panel {

namespace {

double orUnknown(const std::optional<double>& value)
{
    return value.value_or(unknown);
}

// Returns the time of the jaws on the film at this rate; the controller does not know their angle.
double sealTimeMs(const ControllerProgram& program, double rateBagsPerMin, double contactAngleDeg)
{
    if (!program.recipe.isCutter() || !(contactAngleDeg > 0) || !(rateBagsPerMin > 0))
        return unknown;
    profile::Machine machine = program.recipe.machine;
    machine.contactAngleDeg = contactAngleDeg;
    profile::CycleNumbers cycle;
    cycle.filmSpeedMmPerS = program.recipe.cutter().syncRatio * program.bagLengthMm * rateBagsPerMin / 60;
    return profile::sealTimeMs(cycle, machine);
}

// Returns the angle of the knife shaft at a position of its circumference, 0 to 360.
double turnedDeg(const ControllerProgram& program, double positionMm)
{
    constexpr double fullTurn = 360;
    const double deg = positionMm / program.recipe.machine.knifeRadiusMm * 180 / std::numbers::pi;
    return deg - fullTurn * std::floor(deg / fullTurn);
}

} // namespace

Controller::Connection Controller::connection() const
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

QString Controller::connectionText() const
{
    return ConnectionSentences::connection(m_report, m_lostAt);
}

QString Controller::stopWaitsText() const
{
    if (!stopWaits())
        return {};
    return isConnected()
               ? tr("Stop was sent. Waiting for the response.")
               : tr("Stop is not sent yet. The panel sends Stop as soon as the connection is restored.");
}

const ControllerProgram* Controller::runningProgram() const
{
    const bool isOfStatus = m_program && m_status && m_program->generation == m_status->generation &&
                            m_program->crc == m_status->activeCrc;
    return isOfStatus ? m_program.get() : nullptr;
}

double Controller::statusPerSecond() const
{
    return isConnected() ? m_rate.perSecond(m_clock()) : unknown;
}

int Controller::linkQuality() const
{
    return isConnected() ? m_rate.quality(m_clock()) : 0;
}

double Controller::ageMs() const
{
    return m_statusAt ? std::chrono::duration<double, std::milli>(m_clock() - *m_statusAt).count() : unknown;
}

bool Controller::isMoving() const
{
    const State now = state();
    return now == State::Running || now == State::Stopping || now == State::Jogging || now == State::Homing;
}

Controller::State Controller::state() const
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

QString Controller::stateText() const
{
    if (state() != State::Unknown)
        return ControllerSentences::text(*m_status->state);
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

QStringList Controller::alarmTexts() const
{
    return m_status && isConnected() ? ControllerSentences::alarms(*m_status) : QStringList();
}

bool Controller::faulted() const
{
    return state() == State::Fault;
}

QStringList Controller::stageNames() const
{
    QStringList names = ControllerSentences::texts("PressStage");
    names.removeFirst(); // at standstill
    return names;
}

double Controller::generation() const
{
    return m_status ? m_status->generation : unknown;
}

LiveValues Controller::live() const
{
    LiveValues values;
    if (!m_status)
        return values;
    values.masterAngleDeg = orUnknown(m_status->masterAngleDeg);
    values.knifeAngleDeg = orUnknown(m_status->knifeAngleDeg);
    values.followingErrorPulses = m_status->followingErrorPulses;
    values.pulseFrequencyHz = m_status->commandedFrequencyHz;
    values.cycleCount = m_status->cycleCount - m_cyclesBefore;
    values.masterSpeedPercent = m_status->masterSpeedPercent;
    if (m_status->press) {
        values.forceN = m_status->press->forceN;
        if (m_status->press->stage)
            values.stage = static_cast<int>(*m_status->press->stage) - 1;
    }
    const ControllerProgram* program = runningProgram();
    if (!program)
        return values;
    values.rateBagsPerMin = program->rateBagsPerMin * m_status->masterSpeedPercent / 100;
    values.sealTimeMs = sealTimeMs(*program, values.rateBagsPerMin, m_contactAngleDeg);
    if (program->pulsesPerMm > 0) {
        values.knifeSpeedMmPerS = m_status->actualFrequencyHz / program->pulsesPerMm;
        values.followingErrorMm = m_status->followingErrorPulses / program->pulsesPerMm;
        values.positionMm = static_cast<double>(*m_axisPosition.actualPulses()) / program->pulsesPerMm;
    }
    const bool isKnife = program->recipe.isCutter();
    values.positionUnit = isKnife ? QStringLiteral("°") : QStringLiteral("mm");
    values.position = !isKnife                              ? values.positionMm
                      : std::isfinite(values.knifeAngleDeg) ? values.knifeAngleDeg
                                                            : turnedDeg(*program, values.positionMm);
    return values;
}

BagValues Controller::bags() const
{
    const double toleranceMm = m_settings.bagToleranceMm();
    return {m_status ? m_status->bagCount : unknown,
            m_bags.lengthMm(),
            m_bags.deviationMm(),
            m_bags.lengths(),
            m_bags.meanMm(),
            m_bags.meanDeviationMm(),
            m_bags.scatterMm(),
            m_bags.series(),
            static_cast<int>(m_bags.deviationsMm().size()),
            m_bags.countWithin(toleranceMm),
            m_bags.scrap(),
            m_bags.isLastScrap(),
            toleranceMm};
}

bool Controller::startIsHeld() const
{
    return m_settings.startIsHeld();
}

RunFacts::Program Controller::programState() const
{
    using enum RunFacts::Program;
    if (m_program)
        return Present;
    if (!m_status || m_status->activeCrc)
        return Reading;
    const bool hadOne = m_report.identity && m_settings.hadProgram(m_report.identity->uniqueId);
    return hadOne ? Lost : Absent;
}

ActiveProgramValues Controller::active() const
{
    ActiveProgramValues values;
    if (!m_program)
        return values;
    values.isPresent = true;
    values.kind = static_cast<int>(m_program->recipe.kind());
    values.followsMaster = profile::camMaster(m_program->recipe.program) != nullptr;
    values.name = QString::fromStdString(m_program->name);
    values.version = m_program->version;
    values.bagLengthMm = m_program->bagLengthMm;
    values.rateBagsPerMin = m_program->rateBagsPerMin;
    values.cycleSeconds = m_program->cycleSeconds;
    values.syncStartDeg = m_program->syncStartDeg;
    values.syncEndDeg = m_program->syncEndDeg;
    values.cutAngleDeg = m_program->cutDeg;
    if (m_program->curves)
        values.curves = QVariant::fromValue(m_program->curves);
    if (const auto* press = std::get_if<profile::PressProgram>(&m_program->recipe.program)) {
        values.approachPositionMm = press->approachPositionMm;
        values.pressPositionMm = press->pressPositionMm;
        values.minStopForceN = press->minStopForceN;
        values.maxStopForceN = press->maxStopForceN;
    }
    return values;
}

// Nothing judges heat and cleaning yet.
std::uint16_t Controller::permit() const
{
    using modbus::PermitBit;
    const auto bit = [](PermitBit which, bool isSet) {
        return isSet ? 1U << static_cast<unsigned>(which) : 0U;
    };
    return static_cast<std::uint16_t>(
        bit(PermitBit::Warm, true) | bit(PermitBit::Film, !m_startInterlock || m_startInterlock().isEmpty()) |
        bit(PermitBit::Recipe, m_status && m_status->activeCrc) | bit(PermitBit::Clean, true) |
        bit(PermitBit::PanelAgrees, canStart()));
}

} // namespace campanel::panel
