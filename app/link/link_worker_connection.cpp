// SPDX-License-Identifier: Apache-2.0
// The connection of the link worker: opening, loss and recovery.
#include "app/link/link_logging.h"
#include "app/link/link_worker.h"
#include "app/link/simulated_controller.h"

#include <deque>

using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace campanel::link {

namespace {

constexpr auto retryDelay = 250ms;
constexpr auto retryDelayAfterProblem = 1000ms;

LinkState stateAfter(const modbus::LinkError& error, bool wasConnected)
{
    switch (error.kind) {
    case modbus::LinkErrorKind::PortBusy:
    case modbus::LinkErrorKind::PortNotPermitted:
    case modbus::LinkErrorKind::PortNotSerial:
    case modbus::LinkErrorKind::PortSettings:
        return LinkState::PortProblem;
    case modbus::LinkErrorKind::NotCamPanel:
    case modbus::LinkErrorKind::WrongMapMajor:
    case modbus::LinkErrorKind::WrongIdentity:
        return LinkState::WrongDevice;
    case modbus::LinkErrorKind::PortAbsent:
    case modbus::LinkErrorKind::PortGone:
        return wasConnected ? LinkState::Lost : LinkState::Searching;
    default:
        return wasConnected ? LinkState::Lost : LinkState::Connecting;
    }
}

} // namespace

void LinkWorker::connectTo(const ConnectionSettings& settings)
{
    if (m_scan)
        endScan(true);
    m_wasConnected = false;
    disconnect(std::nullopt);
    endHeldStop(CommandEnd::NotSent);
    endDownload();
    cancelComparison();
    m_simulator.reset();
    m_adapter.reset();
    m_settings = settings;
    m_report = {};
    m_report.simulated = settings.simulated;
    if (settings.simulated) {
        startSimulator();
        return;
    }
    m_report.portName = settings.port;
    report(LinkState::Searching);
    stepAfter(0ms);
}

void LinkWorker::startSimulator()
{
    const modbus::LineSettings& line = m_settings.line;
    m_simulator = std::make_unique<SimulatedController>(
        SimulatedController::Options{m_settings.simulatorProgram, m_settings.simulatorStateDir,
                                     QStringList{u"--baud"_s, QString::number(line.baud), u"--parity"_s,
                                                 QString(QChar::fromLatin1(static_cast<char>(line.parity))),
                                                 u"--stop-bits"_s, QString::number(line.stopBits),
                                                 u"--unit"_s, QString::number(m_settings.unit)} +
                                         m_settings.simulatorArguments},
        nullptr);
    connect(m_simulator.get(), &SimulatedController::serving, this, [this](const QString& port) {
        m_report.simulator = SimulatorState::Serving;
        m_report.portName = port;
        stepAfter(0ms);
    });
    connect(m_simulator.get(), &SimulatedController::notFound, this, [this](const QString& searched) {
        m_report.simulator = SimulatorState::NotFound;
        m_report.simulatorDetail = searched;
        report(LinkState::PortProblem);
    });
    connect(m_simulator.get(), &SimulatedController::ended, this, [this](const QString& lastWords) {
        m_report.simulator = SimulatorState::Ended;
        m_report.simulatorDetail = lastWords;
        if (m_report.state == LinkState::Connected)
            lose({modbus::LinkErrorKind::PortGone, m_report.portName.toStdString(), {}, {}, 0});
        else
            report(m_wasConnected ? LinkState::Lost : LinkState::Searching, m_report.error);
    });
    connect(m_simulator.get(), &SimulatedController::faultsAnswered, this, &LinkWorker::faultsSimulated);
    connect(m_simulator.get(), &SimulatedController::rulerRead, this, &LinkWorker::rulerRead);
    m_report.simulator = SimulatorState::Starting;
    report(LinkState::Searching);
    m_simulator->start();
}

void LinkWorker::tryToConnect()
{
    if (m_settings.simulated && m_report.simulator != SimulatorState::Serving)
        return; // its next signal continues
    const bool isReturning = std::exchange(m_isInterruptedByScan, false);
    if (!m_settings.simulated)
        m_report.portName = findPort(m_settings.port, m_adapter);
    if (!m_client) {
        modbus::LinkSettings settings;
        settings.port = m_report.portName.toStdString();
        settings.line = m_settings.line;
        settings.unit = m_settings.unit;
        auto client = std::make_unique<modbus::RtuClient>(std::move(settings), m_record);
        if (const auto opened = client->open(); !opened) {
            report(stateAfter(opened.error(), m_wasConnected), opened.error());
            stepAfter(m_report.state == LinkState::PortProblem ? retryDelayAfterProblem : retryDelay);
            return;
        }
        m_client = std::move(client);
        report(m_wasConnected && !isReturning ? LinkState::Lost : LinkState::Connecting, m_report.error);
    }
    const auto identity = m_client->identify();
    if (!identity) {
        m_client.reset();
        report(stateAfter(identity.error(), m_wasConnected), identity.error());
        stepAfter(m_report.state == LinkState::WrongDevice ? retryDelayAfterProblem : retryDelay);
        return;
    }
    qCInfo(linkLog) << "connected to" << m_report.portName;
    m_wasConnected = true;
    m_adapter = m_settings.simulated ? std::nullopt : identityOf(m_report.portName);
    m_report.hasSerialNumber = m_adapter && !m_adapter->serialNumber.isEmpty();
    m_report.identity = *identity;
    m_lastGoodAt = std::chrono::steady_clock::now();
    m_identifiedAt = m_lastGoodAt;
    m_lastPollAt = {};
    m_permitHeard.reset();
    m_status.reset();
    m_programRead.reset();
    m_headerOf.reset();
    m_header.clear();
    m_list.reset();
    m_isHeaderWanted = false;
    if (m_heldStop && identity->uniqueId != m_controllerId)
        endHeldStop(CommandEnd::NotSent); // meant for another machine
    m_controllerId = identity->uniqueId;
    if (m_download)
        m_download->connectionFound();
    if (m_comparison)
        m_comparison->connectionFound();
    report(LinkState::Connected);
    reportDownload();
    reportComparison();
    stepAfter(0ms);
}

void LinkWorker::lose(const modbus::LinkError& error)
{
    qCWarning(linkLog) << "connection lost:" << QString::fromStdString(modbus::describe(error));
    disconnect(error);
    stepAfter(retryDelay);
}

// Ends all waiting requests except for a Stop; jobs wait.
void LinkWorker::disconnect(std::optional<modbus::LinkError> error)
{
    m_jog.end();
    flushBatch();
    endBegun(error);
    m_client.reset();
    if (m_download)
        m_download->connectionLost();
    if (m_comparison)
        m_comparison->connectionLost();
    std::deque<Request> waiting = m_requests.takeAll();
    std::erase_if(waiting, [this](const Request& request) {
        const auto* command = std::get_if<CommandRequest>(&request);
        const bool isKept = m_wasConnected && command && priorityOf(command->command) == Priority::Stop;
        if (isKept)
            holdStop(*command, std::nullopt);
        return isKept;
    });
    report(m_wasConnected ? LinkState::Lost : LinkState::Searching, std::move(error));
    for (const Request& request : waiting)
        refuse(request);
    for (const ReadRequest& request : m_reads.takeAll())
        emit registersRead({request, ReadEnd::NotSent, {}, {}, m_report.error});
    reportDownload();
    reportComparison();
}

} // namespace campanel::link
