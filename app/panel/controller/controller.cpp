// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/controller.h"

#include "app/panel/kit/language_notifier.h"
#include "app/panel/settings/settings.h"
#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/controller_sentences.h"
#include "app/panel/words/register_words.h"

#include <algorithm>
#include <utility>

using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

constexpr auto agePeriod = 100ms;
constexpr auto qualityPeriod = 500ms; // faster changes cannot be read
constexpr auto doubleTouch = 400ms;

} // namespace

Controller::Controller(link::Link& link, Settings& settings, QObject* parent)
    : QObject(parent)
    , m_link(link)
    , m_settings(settings)
    , m_clock(&std::chrono::steady_clock::now)
    , m_wallClock([] { return QDateTime::currentDateTime(); })
    , m_ageTimer(this)
    , m_qualityTimer(this)
{
    m_report.simulated = settings.connection().simulated;
    settings.guardBy(m_access);
    connect(&link, &link::Link::reported, this, &Controller::takeReport);
    connect(&link, &link::Link::statusReceived, this, &Controller::takeStatus);
    connect(&link, &link::Link::programRead, this, &Controller::takeProgram);
    connect(&link, &link::Link::commandEnded, this, &Controller::takeOutcome);
    connect(this, &Controller::connectionChanged, &m_direction, &MasterDirection::noteConnection);
    connect(this, &Controller::programChanged, &m_direction, &MasterDirection::noteProgram);
    connect(this, &Controller::freshChanged, &m_direction, &MasterDirection::changed);
    connect(this, &Controller::connectionChanged, &m_packing, &PackingLine::noteConnection);
    connect(this, &Controller::programChanged, &m_packing, &PackingLine::noteProgram);
    connect(this, &Controller::freshChanged, &m_packing, &PackingLine::changed);
    connect(this, &Controller::connectionChanged, &m_torque, &TorqueWatch::noteConnection);
    connect(this, &Controller::programChanged, &m_torque, &TorqueWatch::noteProgram);
    connect(&m_packing, &PackingLine::bagRecorded, this, &Controller::takeBag);
    connect(&m_packing, &PackingLine::bagsMissed, this, [this] { m_bags.noteGap(); });
    connect(&m_packing, &PackingLine::changed, &m_run, &RunStatements::update);
    connect(&m_packing, &PackingLine::changed, &m_run, &RunStatements::cutsChanged);
    for (const auto change :
         {&Controller::connectionChanged, &Controller::freshChanged, &Controller::stateChanged,
          &Controller::liveChanged, &Controller::bagChanged, &Controller::programChanged})
        connect(this, change, &m_run, &RunStatements::update);
    connect(this, &Controller::commandsChanged, &m_run, &RunStatements::updateStart);
    connect(&settings, &Settings::changed, this, &Controller::bagChanged);
    const auto sendPermit = [this] { m_link.setPermit(permit()); };
    connect(this, &Controller::commandsChanged, this, sendPermit);
    connect(&m_qualityTimer, &QTimer::timeout, this, sendPermit); // it is valid for a short time only
    connect(&m_masterSetting, &MasterSetting::changed, this, &Controller::commandsChanged);
    connect(&m_masterSetting, &MasterSetting::changed, &m_direction, &MasterDirection::changed);
    connect(&m_masterSetting, &MasterSetting::explained, this, &Controller::showMessage);
    connect(&m_direction, &MasterDirection::failed, this, &Controller::showMessage);
    connect(&m_ageTimer, &QTimer::timeout, this, &Controller::updateAge);
    m_ageTimer.start(agePeriod);
    connect(&m_qualityTimer, &QTimer::timeout, this, &Controller::qualityChanged);
    m_qualityTimer.start(qualityPeriod);
    LanguageNotifier::follow(this, [this] { showMessage({}); });
}

void Controller::open()
{
    const auto connectNow = [this] { m_link.connectTo(m_settings.linkSettings()); };
    connect(&m_settings, &Settings::connectionApplied, this, connectNow);
    connectNow();
}

void Controller::setClock(Clock clock)
{
    m_clock = std::move(clock);
    updateAge();
}

void Controller::updateAge()
{
    const bool fresh = m_statusAt && m_clock() - *m_statusAt < freshFor;
    if (fresh != m_fresh) {
        m_fresh = fresh;
        emit freshChanged();
        emit commandsChanged();
    }
    if (!m_fresh && m_statusAt)
        emit ageChanged();
}

void Controller::takeReport(const link::LinkReport& report)
{
    const bool wasConnected = isConnected();
    const bool otherController =
        report.identity && m_report.identity && report.identity->uniqueId != m_report.identity->uniqueId;
    const bool leftController = m_report.identity && !report.identity; // another connection was chosen
    m_report = report;
    if (!isConnected())
        doubtParameters();
    m_hasStopWaited = m_hasStopWaited || (report.pendingStop && !isConnected());
    if (wasConnected && !isConnected())
        noteLoss();
    if (otherController || leftController)
        forgetStatus();
    if (isConnected() != wasConnected)
        m_rate.clear();
    emit connectionChanged();
    emit qualityChanged();
    emit stateChanged();
    emit commandsChanged();
}

void Controller::noteLoss()
{
    m_lostAt = m_wallClock();
    m_beforeLoss = m_status;
    if (!m_returnMessage.isEmpty() && m_commandMessage == m_returnMessage)
        showMessage({}); // outdated
}

// Reports the changes during the interruption.
void Controller::noteReturn(const modbus::StatusBlock& status)
{
    const std::optional<modbus::StatusBlock> before = std::exchange(m_beforeLoss, std::nullopt);
    if (!before || m_hasStopWaited)
        return;
    m_returnMessage.clear();
    if (status.uptimeS < before->uptimeS)
        m_returnMessage = tr("Connection restored. The controller has restarted meanwhile.");
    else if (status.generation != before->generation)
        m_returnMessage = tr("Connection restored. The controller has a different program now.");
    else if (before->state && status.state && before->state != status.state)
        m_returnMessage =
            tr("Connection restored. Before: %1. Now: %2.", "states of the machine")
                .arg(ControllerSentences::text(*before->state), ControllerSentences::text(*status.state));
    if (!m_returnMessage.isEmpty())
        showMessage(m_returnMessage);
}

void Controller::forgetStatus()
{
    m_beforeLoss.reset();
    m_status.reset();
    m_axisPosition.reset();
    m_statusAt.reset();
    m_program.reset();
    m_trace.clear();
    m_strokes.clear();
    m_bags = {};
    updateAge();
    emit ageChanged();
    emit liveChanged();
    emit bagChanged();
    emit programChanged();
    emit savedChanged();
}

void Controller::takeStatus(const link::StatusBatch& batch)
{
    m_rate.note(batch, m_clock());
    if (batch.samples.isEmpty())
        return;
    noteReturn(batch.samples.first().status);
    const std::optional<modbus::StatusBlock> before = m_status;
    bool bagsChanged = false;
    for (const link::StatusSample& sample : batch.samples) {
        trace(sample.status);
        const modbus::StatusBlock& status = sample.status;
        m_strokes.note(status, m_program ? m_program->pulsesPerMm : 0);
        bagsChanged |= !m_status || m_status->bagCount != status.bagCount;
        if (m_status && status.uptimeS < m_status->uptimeS) { // the controller was restarted
            doubtParameters();
            restartBags();
            m_cyclesBefore = 0;
        }
        m_status = status;
        m_axisPosition.note(status);
        bagsChanged |= m_packing.recordsBags()
                           ? m_bags.noteLength(status.bagLengthMm)
                           : m_bags.note(status.bagCount, status.bagLengthMm, status.bagDeviationMm);
        m_statusAt = sample.receivedAt;
    }
    updateAge();
    m_direction.noteStatus(batch);
    m_torque.noteStatus();
    emit liveChanged();
    if (bagsChanged)
        emit bagChanged();
    if (!before || before->state != m_status->state || before->faultBits != m_status->faultBits ||
        before->warningBits != m_status->warningBits) {
        emit stateChanged();
        emit commandsChanged();
    }
    if (!before || before->activeCrc != m_status->activeCrc || before->savedCrc != m_status->savedCrc)
        emit savedChanged();
    if (!before)
        emit ageChanged();
}

void Controller::takeBag(const modbus::BagRecord& bag)
{
    m_bags.note(bag, active().bagLengthMm);
    emit bagChanged();
}

void Controller::trace(const modbus::StatusBlock& status)
{
    const bool turns = status.state == modbus::State::Running || status.state == modbus::State::Stopping;
    // Only samples of the known program: its pulses and cycle define the scale.
    if (!turns || !status.masterAngleDeg || !m_program || m_program->generation != status.generation ||
        m_program->pulsesPerMm <= 0)
        return;
    m_trace.add(
        {status.cycleCount, *status.masterAngleDeg / 360, status.actualFrequencyHz / m_program->pulsesPerMm},
        m_program->cycleSeconds);
}

void Controller::takeProgram(const link::ActiveProgram& program)
{
    if (!m_report.identity)
        return;
    const auto before = std::exchange(m_program, readProgram(program, *m_report.identity));
    if (m_program)
        m_settings.noteProgramIn(m_report.identity->uniqueId);
    m_trace.clear();
    // After a gap of the line the program is read again, and its bags go on.
    if (!before || !m_program || before->generation != m_program->generation || before->crc != m_program->crc)
        restartBags();
    if (before && m_program && before->generation != m_program->generation && m_status)
        m_cyclesBefore = m_status->cycleCount;
    emit programChanged();
    emit liveChanged();
    emit bagChanged();
    emit commandsChanged();
}

void Controller::restartBags()
{
    m_strokes.clear();
    m_bags.restart(isMoving() || !m_packing.recordsBags());
    m_packing.forgetLastBag();
}

void Controller::start()
{
    if (!m_access.require(Level::Operator))
        return;
    const QString reason = startBlockedReason();
    if (!reason.isEmpty()) {
        showMessage(reason);
        return;
    }
    startBy(modbus::Command::Start);
}

void Controller::startBy(modbus::Command command, const modbus::CommandArguments& arguments)
{
    m_link.setPermit(permit());
    send(command, arguments);
}

void Controller::stop()
{
    const bool isAgain = state() == State::Stopping || stopWaits();
    // A finger that bounces has touched once: it must not make the stop at cycle end an immediate one.
    if (isAgain && m_stopPressedAt && now() - *m_stopPressedAt < doubleTouch)
        return;
    m_stopPressedAt = now();
    send(isAgain ? modbus::Command::StopNow : modbus::Command::StopAtCycleEnd);
}

void Controller::withdrawStop()
{
    if (m_access.require(Level::Operator))
        m_link.withdrawStop();
}

void Controller::home()
{
    if (m_access.require(Level::Operator))
        send(modbus::Command::Home);
}

void Controller::resetFault()
{
    if (m_access.require(Level::Operator))
        send(modbus::Command::ResetFault);
}

void Controller::setContactAngle(double deg)
{
    if (m_contactAngleDeg == deg)
        return;
    m_contactAngleDeg = deg;
    emit liveChanged();
}

void Controller::send(modbus::Command command, const modbus::CommandArguments& arguments)
{
    showMessage({});
    m_hasStopWaited = false;
    m_lastRequestId = m_link.nextId();
    const link::CommandRequest request{m_lastRequestId, command, arguments};
    emit commandSending(request);
    m_link.request(request);
}

void Controller::doubtParameters()
{
    for (const auto& [name, parameter] : m_parameters)
        m_report.identity ? parameter->doubt() : parameter->clear();
}

Parameter& Controller::parameter(std::string_view name)
{
    const modbus::RegisterInfo* info = modbus::findRegister(name);
    Q_ASSERT(info);
    Parameter*& parameter = m_parameters[info->name]; // outlives `name`
    if (!parameter)
        parameter = new Parameter(*this, *info);
    return *parameter;
}

ParameterField* Controller::parameterField(const QString& name)
{
    const auto row = std::ranges::find(parameterTable, name.toStdString(), &ParameterRow::name);
    if (row == parameterTable.end())
        return nullptr;
    ParameterField*& field = m_parameterFields[row->name];
    if (!field)
        field = new ParameterField(*this, *row);
    return field;
}

bool Controller::writeParameter(const modbus::RegisterInfo& info, double value, const Parameter::Reply& reply)
{
    if (!m_access.require(Level::Technician))
        return false;
    showMessage({});
    emit parameterWriting(RegisterWords::name(info), value);
    m_link.exchange({0, std::string(info.name), value},
                    {this, [this, reply](const link::ParameterOutcome& outcome) {
                         emit parameterWritten(outcome);
                         if (reply.context)
                             reply.receive(outcome);
                     }});
    return true;
}

void Controller::takeOutcome(const link::CommandOutcome& outcome)
{
    // Stop at standstill has no effect.
    const bool isNeedlessStop =
        outcome.reason == modbus::Refusal::NotRunning &&
        (outcome.command == modbus::Command::StopNow || outcome.command == modbus::Command::StopAtCycleEnd);
    // The link's own requests have no id; only the last press counts.
    if (outcome.id != 0)
        emit commandEnded(outcome);
    if (outcome.id != m_lastRequestId)
        return;
    if (std::exchange(m_hasStopWaited, false)) {
        m_beforeLoss.reset(); // the result of the Stop is the change
        showMessage(stopOutcomeText(outcome));
    } else if (!isNeedlessStop)
        showMessage(ConnectionSentences::command(outcome));
}

// Returns the result of a Stop that has waited for the line.
QString Controller::stopOutcomeText(const link::CommandOutcome& outcome) const
{
    switch (outcome.end) {
    case link::CommandEnd::Done:
        return tr("Connection restored: Stop was sent, and the controller accepted the command.");
    case link::CommandEnd::Withdrawn:
        return tr("Stop was withdrawn and will not be sent.");
    case link::CommandEnd::NotSent:
        return tr("Stop was not sent: a different machine is connected now.");
    case link::CommandEnd::Refused:
        if (outcome.reason == modbus::Refusal::NotRunning)
            return tr("Connection restored: Stop was sent, but the machine was no longer running.");
        break;
    case link::CommandEnd::NotReceived:
    case link::CommandEnd::OutcomeUnknown:
        break;
    }
    return ConnectionSentences::command(outcome);
}

void Controller::dismissMessage()
{
    showMessage({});
}

void Controller::showMessage(const QString& text)
{
    if (m_commandMessage == text)
        return;
    m_commandMessage = text;
    emit commandMessageChanged();
}

} // namespace campanel::panel
