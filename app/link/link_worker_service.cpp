// SPDX-License-Identifier: Apache-2.0
// Other tasks of the link worker than status, commands and downloads: a Stop that waits for the line, reads,
// comparisons and scans.
#include "app/link/link_worker.h"
#include "app/link/simulated_controller.h"

#include <algorithm>

using namespace std::chrono_literals;

namespace campanel::link {

void LinkWorker::holdStop(const CommandRequest& request, std::optional<std::uint16_t> counter)
{
    const auto withdrawn = [this](const CommandRequest& replaced) {
        emit commandEnded(
            {replaced.id, replaced.command, CommandEnd::Withdrawn, modbus::Refusal::None, std::nullopt});
    };
    // The more urgent Stop stays; of two equal ones the later.
    if (m_heldStop && m_heldStop->request.command == modbus::Command::StopNow &&
        request.command != modbus::Command::StopNow) {
        withdrawn(request);
        return;
    }
    if (m_heldStop)
        withdrawn(m_heldStop->request);
    m_heldStop = HeldStop{request, counter, false};
}

// Keeps a Stop whose exchange failed. In doubt, the controller is asked for its result first. Otherwise it is
// sent again, after another exchange that detects a lost line.
void LinkWorker::keepStop(const CommandRequest& request, const modbus::LinkError& error)
{
    const bool isInDoubt = error.kind == modbus::LinkErrorKind::OutcomeUnknown;
    holdStop(request, isInDoubt ? std::optional(static_cast<std::uint16_t>(error.code)) : std::nullopt);
    m_heldStop->isPollNext = !isInDoubt;
    if (modbus::portIsLost(error))
        lose(error);
    else
        report(m_report.state, m_report.error);
}

void LinkWorker::endHeldStop(CommandEnd end)
{
    if (!m_heldStop)
        return;
    const CommandRequest request = m_heldStop->request;
    m_heldStop.reset();
    emit commandEnded({request.id, request.command, end, modbus::Refusal::None,
                       end == CommandEnd::NotSent ? m_report.error : std::nullopt});
}

void LinkWorker::withdrawStop()
{
    if (!m_heldStop)
        return;
    // A Stop that was sent cannot be withdrawn; its result is no longer requested.
    endHeldStop(m_heldStop->counter ? CommandEnd::OutcomeUnknown : CommandEnd::Withdrawn);
    report(m_report.state, m_report.error);
}

void LinkWorker::setJog(const JogRequest& request)
{
    m_jog.hold(request);
    if (m_report.state == LinkState::Connected &&
        m_jog.isPollDue(std::chrono::steady_clock::now(), m_lastPollAt))
        stepAfter(0ms);
}

void LinkWorker::setPermit(const PermitRequest& request)
{
    m_permit = request;
    if (m_report.state == LinkState::Connected && isPollUrgent())
        stepAfter(0ms);
}

// Sends the held Stop; at most one exchange, while connected. It is never sent again on mere suspicion. While
// its reception is unknown, its result is requested, with polls in between that detect a lost line.
void LinkWorker::sendHeldStop()
{
    HeldStop& held = *m_heldStop;
    std::optional<modbus::CommandResult> found;
    if (held.counter) {
        const auto result = m_client->readResult(*held.counter);
        if (!result && modbus::portIsLost(result.error())) {
            lose(result.error());
            return;
        }
        if (!result || (*result && (*result)->status == modbus::CommandStatus::Busy)) {
            held.isPollNext = true;
            return;
        }
        if (*result && (*result)->code == held.request.command)
            found = *result;
    }
    const CommandRequest request = held.request;
    m_heldStop.reset();
    if (found)
        endCommand(request, *found);
    else
        m_requests.push(request);
    report(m_report.state, m_report.error);
}

void LinkWorker::readRegisters(const ReadRequest& request)
{
    if (m_report.state != LinkState::Connected || !m_reads.push(request)) {
        emit registersRead({request, ReadEnd::NotSent, {}, {}, m_report.error});
        return;
    }
    stepAfter(0ms);
}

void LinkWorker::advanceRead()
{
    m_wasRead = true;
    const auto outcome = m_reads.advance(*m_client);
    if (!outcome)
        return;
    emit registersRead(*outcome);
    if (outcome->error && modbus::portIsLost(*outcome->error))
        lose(*outcome->error);
}

void LinkWorker::compareProgram(const std::vector<std::uint16_t>& bank)
{
    ComparisonReport refused;
    refused.stage = ComparisonStage::Failed;
    refused.isConnectionMissing = m_report.state != LinkState::Connected;
    refused.isBusy = m_comparison != nullptr;
    if (refused.isConnectionMissing || refused.isBusy) {
        emit comparisonReported(refused);
        return;
    }
    m_comparison = std::make_unique<ComparisonJob>(bank);
    if (m_status)
        m_comparison->noteStatus(*m_status);
    reportComparison();
    stepAfter(0ms);
}

void LinkWorker::cancelComparison()
{
    if (!m_comparison)
        return;
    m_comparison->cancel();
    reportComparison();
}

void LinkWorker::advanceComparison()
{
    m_comparison->advance(*m_client);
    const bool isPortLost = m_comparison->isPortLost();
    reportComparison();
    if (isPortLost)
        lose({modbus::LinkErrorKind::PortGone, m_report.portName.toStdString(), {}, {}, 0});
}

void LinkWorker::reportComparison()
{
    if (!m_comparison)
        return;
    const ComparisonReport report = m_comparison->report();
    if (m_comparison->ended())
        m_comparison.reset();
    emit comparisonReported(report);
}

void LinkWorker::startScan(modbus::ScanPlan::Depth depth)
{
    if (m_scan)
        endScan(true);
    modbus::ScanPlan plan;
    plan.depth = depth;
    plan.line = m_settings.line;
    plan.unit = m_settings.unit;
    // A search for a controller must not find the simulated one.
    if (!m_settings.simulated || depth == modbus::ScanPlan::Depth::Diagnosis)
        plan.port = m_report.portName.toStdString();
    for (const PortDescription& port : availablePorts())
        plan.otherPorts.push_back(port.path.toStdString());
    m_scanDepth = depth;
    m_isInterruptedByScan |= m_report.state == LinkState::Connected; // or by the scan that it replaces
    m_scan = std::make_unique<modbus::LineScan>(std::move(plan));
    disconnect(m_report.error);
    reportScan(true, false);
    stepAfter(0ms);
}

void LinkWorker::cancelScan()
{
    if (m_scan)
        endScan(true);
}

void LinkWorker::advanceScan()
{
    m_scan->advance();
    if (m_scan->ended()) {
        endScan(false);
        return;
    }
    reportScan(true, false);
    stepAfter(0ms);
}

void LinkWorker::endScan(bool isCanceled)
{
    reportScan(false, isCanceled);
    m_scan.reset();
    report(m_isInterruptedByScan ? LinkState::Connecting : m_report.state, m_report.error);
    stepAfter(0ms);
}

void LinkWorker::simulateFaults(const QStringList& rules)
{
    if (!m_simulator)
        emit faultsSimulated({FaultsEnd::NotSimulated, {}});
    else if (!m_simulator->setFaults(rules))
        emit faultsSimulated({FaultsEnd::NotServing, {}});
}

void LinkWorker::measureSimulatedBag()
{
    if (!m_simulator)
        emit rulerRead({RulerEnd::NotSimulated});
    else if (!m_simulator->measureSimulatedBag())
        emit rulerRead({RulerEnd::NotServing});
}

void LinkWorker::reportScan(bool isRunning, bool isCanceled)
{
    ScanReport report;
    report.depth = m_scanDepth;
    report.isRunning = isRunning;
    report.isCanceled = isCanceled;
    report.progress = m_scan->progress();
    report.findings = QList<modbus::LineFinding>(m_scan->findings().begin(), m_scan->findings().end());
    if (const modbus::LineFinding* controller = m_scan->controller()) {
        ConnectionSettings found = m_settings;
        found.simulated = m_settings.simulated && controller->port == m_report.portName.toStdString();
        found.port = QString::fromStdString(controller->port);
        found.line = controller->line;
        found.unit = controller->unit;
        report.found = found;
    }
    emit scanReported(report);
}

} // namespace campanel::link
