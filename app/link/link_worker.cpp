// SPDX-License-Identifier: Apache-2.0
#include "app/link/link_worker.h"

#include "app/link/link_logging.h"
#include "app/link/parameter_exchange.h"
#include "app/link/simulated_controller.h"

#include <QDateTime>
#include <QRandomGenerator>

#include <algorithm>
#include <utility>

using namespace std::chrono_literals;

namespace campanel::link {

namespace {

using std::chrono::steady_clock;

// The minimum poll period on a faster line: the screen cannot display more samples.
constexpr auto shortestPollPeriod = 8ms;
// A batch paints what moves on a page, 25 times a second.
constexpr auto shortestBatchPeriod = 40ms;
// The time at standstill after which the polls slow down.
constexpr auto timeUntilRest = 1000ms;
constexpr auto pollPeriodAtRest = 100ms;
// The interval in which another controller on the same cable is detected.
constexpr auto identityPeriod = 3000ms;
// The poll period during a transfer: short enough for fresh data and the heartbeat.
constexpr auto pollPeriodInTransfer = 400ms;
// The time without a valid status after which the connection counts as lost.
constexpr auto silenceUntilLost = 1000ms;

CommandEnd endAfter(const modbus::LinkError& error)
{
    if (modbus::portIsLost(error))
        return CommandEnd::NotSent;
    return error.kind == modbus::LinkErrorKind::OutcomeUnknown ? CommandEnd::OutcomeUnknown
                                                               : CommandEnd::NotReceived;
}

// Returns true when the controller would refuse the command again.
bool isFinal(const modbus::LinkError& error)
{
    return error.kind == modbus::LinkErrorKind::Exception && !modbus::isBusy(error);
}

bool isStanding(std::optional<modbus::State> state)
{
    return state == modbus::State::Idle || state == modbus::State::Ready || state == modbus::State::Fault;
}

// Returns true when two statuses differ in nothing but the motion.
bool differOnlyInMotion(const modbus::StatusBlock& one, const modbus::StatusBlock& other)
{
    return one.state == other.state && one.faultBits == other.faultBits &&
           one.warningBits == other.warningBits && one.generation == other.generation &&
           one.stagedState == other.stagedState && one.activeCrc == other.activeCrc &&
           one.savedCrc == other.savedCrc;
}

} // namespace

LinkWorker::LinkWorker()
    : m_stepTimer(this)
    , m_record(std::make_shared<modbus::LinkRecord>())
    , m_watch(m_record, this)
    , m_session(static_cast<std::uint16_t>(QRandomGenerator::global()->bounded(1, 0x10000)))
{
    m_stepTimer.setSingleShot(true);
    m_stepTimer.setTimerType(Qt::PreciseTimer);
    connect(&m_stepTimer, &QTimer::timeout, this, &LinkWorker::step);
    connect(&m_watch, &LinkWatch::figuresReported, this, &LinkWorker::figuresReported);
    connect(&m_watch, &LinkWatch::framesRecorded, this, &LinkWorker::framesRecorded);
}

LinkWorker::~LinkWorker() = default;

void LinkWorker::request(const CommandRequest& request)
{
    if (priorityOf(request.command) == Priority::Stop)
        m_jog.end();
    const bool isKept = m_wasConnected && m_report.state != LinkState::Connected;
    if (!isKept || priorityOf(request.command) != Priority::Stop) {
        enqueue(request);
        return;
    }
    holdStop(request, std::nullopt);
    report(m_report.state, m_report.error);
}

void LinkWorker::requestParameter(const ParameterRequest& request)
{
    enqueue(request);
}

void LinkWorker::enqueue(Request request)
{
    if (m_report.state != LinkState::Connected) {
        refuse(request);
        return;
    }
    m_requests.push(std::move(request));
    m_restlessAt = steady_clock::now();
    stepAfter(0ms);
}

void LinkWorker::download(const std::vector<std::uint16_t>& bank)
{
    DownloadReport refused;
    refused.stage = DownloadStage::Failed;
    refused.isConnectionMissing = m_report.state != LinkState::Connected;
    refused.isBusy = m_download != nullptr;
    if (refused.isConnectionMissing || refused.isBusy) {
        emit downloadReported(refused);
        return;
    }
    if (++m_session == 0)
        ++m_session;
    m_download = std::make_unique<DownloadJob>(bank, *m_report.identity, m_session);
    reportDownload();
    stepAfter(0ms);
}

void LinkWorker::cancelDownload()
{
    if (!m_download)
        return;
    m_download->cancel(m_report.state == LinkState::Connected);
    reportDownload();
}

void LinkWorker::step()
{
    if (m_scan)
        advanceScan();
    else if (m_report.state == LinkState::Connected)
        exchange();
    else
        tryToConnect();
}

void LinkWorker::exchange()
{
    const auto sinceLastPoll = steady_clock::now() - m_lastPollAt;
    const bool mayPollWait = sinceLastPoll < pollPeriodInTransfer;
    const bool isReadNext = !m_reads.isEmpty() && !m_wasRead;
    const bool isPollNext = isPollUrgent() && !m_requests.isStopNext();
    m_wasRead = false;
    if (m_heldStop && !std::exchange(m_heldStop->isPollNext, false))
        sendHeldStop();
    else if (isPollNext)
        pollStatus();
    else if (isResultDue() && !m_requests.isStopNext())
        askForResult();
    else if (const auto request = takeRequest())
        carryOut(*request);
    else if (m_isHeaderWanted)
        readHeader();
    else if (isReadNext)
        advanceRead();
    else if (m_download && m_download->hasWork() && mayPollWait && !m_begun)
        advanceDownload();
    else if (m_comparison && m_comparison->hasWork() && mayPollWait)
        advanceComparison();
    else if (mayPollWait && m_jog.directionAt(m_lastPollAt) == JogDirection::None &&
             steady_clock::now() - m_identifiedAt >= identityPeriod)
        checkIdentity();
    else if (sinceLastPoll >= pollPeriod())
        pollStatus();
    if (m_report.state != LinkState::Connected)
        return;
    const bool hasWork = m_heldStop || isPollUrgent() || isResultDue() ||
                         (!m_requests.isEmpty() && (!m_begun || m_requests.isStopNext())) ||
                         !m_reads.isEmpty() || (m_download && m_download->hasWork() && !m_begun) ||
                         (m_comparison && m_comparison->hasWork());
    const auto pollDue = m_lastPollAt + pollPeriod() - steady_clock::now();
    stepAfter(hasWork ? 0ms : std::max(0ms, std::chrono::ceil<std::chrono::milliseconds>(pollDue)));
}

std::uint16_t LinkWorker::permitAt(SteadyTime now) const
{
    return now < m_permit.until ? m_permit.bits : std::uint16_t{0};
}

// Returns true when the controller must get jog keys or permit before anything but a Stop.
bool LinkWorker::isPollUrgent() const
{
    const SteadyTime now = steady_clock::now();
    return m_jog.isPollDue(now, m_lastPollAt) ||
           (m_permitHeard != permitAt(now) && m_report.identity->hasRegister("exchange.permit"));
}

// Detects another controller or firmware, which makes all earlier data invalid; reconnecting identifies it.
void LinkWorker::checkIdentity()
{
    m_identifiedAt = steady_clock::now();
    const auto registers = m_client->readProven(modbus::identityAddress, modbus::identityRegisters);
    if (!registers)
        return;
    modbus::Identity found = modbus::decodeIdentity(*registers);
    found.tableLayouts = m_report.identity->tableLayouts; // not among these registers
    if (found == *m_report.identity)
        return;
    qCWarning(linkLog) << "another controller answers";
    disconnect(std::nullopt);
    stepAfter(0ms);
}

// Returns the present period. A command or a jog key is sent at once and ends the rest.
std::chrono::milliseconds LinkWorker::pollPeriod() const
{
    const bool isResting = steady_clock::now() - m_restlessAt > timeUntilRest && !m_download && !m_heldStop;
    return isResting ? pollPeriodAtRest : shortestPollPeriod;
}

void LinkWorker::carryOut(const Request& request)
{
    if (const auto* command = std::get_if<CommandRequest>(&request))
        sendCommand(*command);
    else
        sendParameter(std::get<ParameterRequest>(request));
}

// Returns the next request. Only a Stop overtakes a command that the controller works on: the controller
// keeps the result of its last command alone.
std::optional<Request> LinkWorker::takeRequest()
{
    return m_begun && !m_requests.isStopNext() ? std::nullopt : m_requests.take();
}

void LinkWorker::sendCommand(const CommandRequest& request)
{
    endBegun(std::nullopt);
    const auto result = m_client->begin(request.command, request.arguments);
    if (!result && priorityOf(request.command) == Priority::Stop && !isFinal(result.error())) {
        keepStop(request, result.error());
        return;
    }
    if (result && result->status == modbus::CommandStatus::Busy) {
        const SteadyTime now = steady_clock::now();
        m_begun = BegunCommand{request, result->counter, now, now};
        return;
    }
    if (result) {
        endCommand(request, *result);
        return;
    }
    emit commandEnded(
        {request.id, request.command, endAfter(result.error()), modbus::Refusal::None, result.error()});
    if (modbus::portIsLost(result.error()))
        lose(result.error());
}

void LinkWorker::endCommand(const CommandRequest& request, const modbus::CommandResult& result)
{
    emit commandEnded({request.id, request.command, result.done() ? CommandEnd::Done : CommandEnd::Refused,
                       result.reason, std::nullopt});
}

// Asks once after each status whether the controller has finished its work.
void LinkWorker::askForResult()
{
    m_begun->askedAt = steady_clock::now();
    const bool isLate = m_begun->askedAt - m_begun->begunAt > modbus::RtuClient::flashAllowance;
    const auto found = m_client->readResult(m_begun->counter);
    if (!found && modbus::portIsLost(found.error())) {
        lose(found.error());
    } else if (found && *found && (*found)->status != modbus::CommandStatus::Busy) {
        const CommandRequest request = m_begun->request;
        m_begun.reset();
        endCommand(request, **found);
    } else if (isLate || (found && !*found)) {
        endBegun(found ? std::nullopt : std::optional(found.error()));
    }
}

// The result of the command is not known: another command took its place, or the line was lost.
void LinkWorker::endBegun(std::optional<modbus::LinkError> error)
{
    if (!m_begun)
        return;
    const CommandRequest request = m_begun->request;
    m_begun.reset();
    emit commandEnded(
        {request.id, request.command, CommandEnd::OutcomeUnknown, modbus::Refusal::None, std::move(error)});
}

void LinkWorker::sendParameter(const ParameterRequest& request)
{
    ParameterOutcome outcome{request.id, request.name, ParameterEnd::Done, std::nullopt, std::nullopt};
    const auto kept = exchangeParameter(*m_client, request);
    if (kept) {
        outcome.value = *kept;
    } else {
        outcome.end = parameterEndAfter(kept.error());
        outcome.error = kept.error();
    }
    emit parameterEnded(outcome);
    if (!kept && modbus::portIsLost(kept.error()))
        lose(kept.error());
}

void LinkWorker::advanceDownload()
{
    m_download->advance(*m_client);
    const bool isPortLost = m_download->isPortLost();
    reportDownload();
    if (isPortLost)
        lose({modbus::LinkErrorKind::PortGone, m_report.portName.toStdString(), {}, {}, 0});
}

void LinkWorker::pollStatus()
{
    m_lastPollAt = steady_clock::now();
    const std::uint16_t permit = permitAt(m_lastPollAt);
    const auto status = m_client->exchangeStatus(++m_heartbeat, m_jog.bits(m_lastPollAt), permit);
    if (status) {
        m_jog.noteAnswer();
        m_permitHeard = permit;
        noteStatus(*status);
        return;
    }
    ++m_batch.failedExchanges;
    flushBatch();
    if (modbus::portIsLost(status.error()) || steady_clock::now() - m_lastGoodAt > silenceUntilLost)
        lose(status.error());
}

void LinkWorker::noteStatus(const modbus::StatusBlock& status)
{
    const bool isFirst = !m_status;
    m_lastGoodAt = steady_clock::now();
    const bool isChange = isFirst || !differOnlyInMotion(status, *m_status);
    if (isChange || !isStanding(status.state) || status.axisPositionPulses != m_status->axisPositionPulses)
        m_restlessAt = m_lastGoodAt;
    m_status = status;
    m_batch.samples << StatusSample{m_lastGoodAt, status, m_lastGoodAt - m_lastPollAt};
    // A change is told at once, before what follows from it.
    if (isChange || m_lastGoodAt - m_lastFlushAt >= shortestBatchPeriod)
        flushBatch();
    if (m_download) {
        const DownloadStage before = m_download->report().stage;
        m_download->noteStatus(status);
        if (m_download->report().stage != before)
            reportDownload();
    }
    if (isFirst && status.has(modbus::WarningBit::ClockNotSet))
        setClock();
    if (m_comparison) {
        m_comparison->noteStatus(status);
        reportComparison();
    }
    noteProgram({status.generation, status.activeCrc.value_or(0)});
}

void LinkWorker::noteProgram(const ProgramId& program)
{
    if (m_programRead == program)
        return;
    const bool isEmpty = !m_status->activeCrc;
    // A header certainly belongs to a program when the statuses before and after it have that program.
    if (!isEmpty && (m_header.empty() || m_headerOf != program)) {
        m_headerOf = program;
        m_header.clear();
        m_list.reset();
        m_isHeaderWanted = true;
        return;
    }
    if (!isEmpty && m_isHeaderWanted)
        return;
    m_programRead = program;
    ActiveProgram read{program.first, program.second, {}, {}};
    if (!isEmpty) {
        read.header = m_header;
        read.list = m_list ? m_list->registers() : std::vector<std::uint16_t>{};
    }
    emit programRead(read);
}

// Performs one exchange per call. After a failure the next status repeats it.
void LinkWorker::readHeader()
{
    if (m_header.empty()) {
        m_header = m_client->readProven(modbus::activeBankBase, modbus::bankHeaderRegisters)
                       .value_or(std::vector<std::uint16_t>{});
        const modbus::ListSpan list = m_header.empty() ? modbus::ListSpan{} : modbus::listSpan(m_header);
        m_isHeaderWanted = list.count > 0;
        if (m_isHeaderWanted)
            m_list.emplace(static_cast<std::uint16_t>(modbus::activeBankBase + list.offset), list.count);
        return;
    }
    const auto isComplete = m_list->advance(*m_client);
    m_isHeaderWanted = isComplete && !*isComplete;
    if (!isComplete)
        m_header.clear();
}

void LinkWorker::setClock()
{
    m_requests.push(CommandRequest{0,
                                   modbus::Command::SetClock,
                                   {0, 0, static_cast<std::uint32_t>(QDateTime::currentSecsSinceEpoch())}});
}

void LinkWorker::refuse(const Request& request)
{
    if (const auto* command = std::get_if<CommandRequest>(&request)) {
        emit commandEnded(
            {command->id, command->command, CommandEnd::NotSent, modbus::Refusal::None, m_report.error});
        return;
    }
    const auto& parameter = std::get<ParameterRequest>(request);
    emit parameterEnded({parameter.id, parameter.name, ParameterEnd::NotSent, std::nullopt, m_report.error});
}

void LinkWorker::endDownload()
{
    if (!m_download)
        return;
    DownloadReport canceled = m_download->report();
    canceled.stage = DownloadStage::Canceled;
    m_download.reset();
    emit downloadReported(canceled);
}

void LinkWorker::reportDownload()
{
    if (!m_download)
        return;
    const DownloadReport report = m_download->report();
    if (m_download->ended())
        m_download.reset();
    emit downloadReported(report);
}

void LinkWorker::report(LinkState state, std::optional<modbus::LinkError> error)
{
    m_report.state = state;
    m_report.error = std::move(error);
    m_report.isScanning = m_scan != nullptr;
    m_report.pendingStop = m_heldStop ? std::optional(m_heldStop->request.command) : std::nullopt;
    emit reported(m_report);
}

void LinkWorker::flushBatch()
{
    if (m_batch.samples.isEmpty() && m_batch.failedExchanges == 0)
        return;
    emit statusReceived(m_batch);
    m_batch = {};
    m_lastFlushAt = steady_clock::now();
}

void LinkWorker::stepAfter(std::chrono::milliseconds delay)
{
    m_stepTimer.start(delay);
}

} // namespace campanel::link
