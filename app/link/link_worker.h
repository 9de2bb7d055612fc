// SPDX-License-Identifier: Apache-2.0
// The only owner of the port. Lives in the link thread; other objects use it through queued signals. Performs
// one exchange per turn of its event loop, so that an urgent request waits for one exchange at most.
#pragma once

#include "app/link/comparison_job.h"
#include "app/link/download_job.h"
#include "app/link/held_jog.h"
#include "app/link/link_events.h"
#include "app/link/link_watch.h"
#include "app/link/port_finder.h"
#include "app/link/register_reads.h"
#include "app/link/request_queue.h"

#include <QTimer>

#include <memory>
#include <optional>

namespace campanel::link {

class SimulatedController;

class LinkWorker : public LinkEvents {
    Q_OBJECT

public:
    LinkWorker();
    ~LinkWorker() override;

    void connectTo(const campanel::link::ConnectionSettings& settings);
    void request(const campanel::link::CommandRequest& request);
    void requestParameter(const campanel::link::ParameterRequest& request);
    void download(const std::vector<std::uint16_t>& bank);
    void cancelDownload();
    void withdrawStop();
    void setJog(const campanel::link::JogRequest& request);
    void setPermit(const campanel::link::PermitRequest& request);
    void readRegisters(const campanel::link::ReadRequest& request);
    void compareProgram(const std::vector<std::uint16_t>& bank);
    void cancelComparison();
    void startScan(campanel::modbus::ScanPlan::Depth depth);
    void cancelScan();
    void simulateFaults(const QStringList& rules);
    void measureSimulatedBag();
    void watchFigures(bool isWatched) { m_watch.watchFigures(isWatched); }
    void resetFigures() { m_watch.resetFigures(); }
    void watchFrames(bool isWatched) { m_watch.watchFrames(isWatched); }

private:
    using ProgramId = std::pair<std::uint32_t, std::uint32_t>; // generation and CRC-32
    // A Stop that waits for the line, or for the result of its exchange.
    struct HeldStop {
        CommandRequest request;
        std::optional<std::uint16_t> counter; // counter of the sent command
        bool isPollNext = false;              // the last attempt failed
    };

    // A command that the controller carries out in pieces; statuses go on meanwhile.
    struct BegunCommand {
        CommandRequest request;
        std::uint16_t counter = 0;
        SteadyTime begunAt;
        SteadyTime askedAt;
    };

    void startSimulator();
    void step();
    void tryToConnect();
    void exchange();
    void enqueue(Request request);
    [[nodiscard]] std::optional<Request> takeRequest();
    void carryOut(const Request& request);
    void sendCommand(const CommandRequest& request);
    void holdStop(const CommandRequest& request, std::optional<std::uint16_t> counter);
    void keepStop(const CommandRequest& request, const modbus::LinkError& error);
    void endHeldStop(CommandEnd end);
    void sendHeldStop();
    [[nodiscard]] std::uint16_t permitAt(SteadyTime now) const;
    [[nodiscard]] bool isPollUrgent() const;
    [[nodiscard]] bool isResultDue() const { return m_begun && m_lastPollAt > m_begun->askedAt; }
    void askForResult();
    void endBegun(std::optional<modbus::LinkError> error);
    void endCommand(const CommandRequest& request, const modbus::CommandResult& result);
    void advanceRead();
    void sendParameter(const ParameterRequest& request);
    void advanceDownload();
    void advanceComparison();
    void advanceScan();
    void endScan(bool isCanceled);
    void reportScan(bool isRunning, bool isCanceled);
    void reportComparison();
    void pollStatus();
    void noteStatus(const modbus::StatusBlock& status);
    void noteProgram(const ProgramId& program);
    void readHeader();
    void setClock();
    void lose(const modbus::LinkError& error);
    void disconnect(std::optional<modbus::LinkError> error);
    void refuse(const Request& request);
    void endDownload();
    void reportDownload();
    void report(LinkState state, std::optional<modbus::LinkError> error = std::nullopt);
    void flushBatch();
    [[nodiscard]] std::chrono::milliseconds pollPeriod() const;
    void checkIdentity();
    void stepAfter(std::chrono::milliseconds delay);

    ConnectionSettings m_settings;
    LinkReport m_report;
    QTimer m_stepTimer;
    std::shared_ptr<modbus::LinkRecord> m_record; // shared by all connections
    LinkWatch m_watch;
    std::unique_ptr<SimulatedController> m_simulator;
    std::unique_ptr<modbus::RtuClient> m_client; // exists while the port is open
    std::optional<AdapterIdentity> m_adapter;    // adapter of the port opened last
    RequestQueue m_requests;
    std::optional<HeldStop> m_heldStop;
    std::optional<BegunCommand> m_begun;
    HeldJog m_jog;
    PermitRequest m_permit;
    std::optional<std::uint16_t> m_permitHeard; // confirmed by the controller of this connection
    std::uint64_t m_controllerId = 0;           // controller of the held Stop
    RegisterReads m_reads;
    bool m_wasRead = false; // the last exchange was one of m_reads
    std::unique_ptr<DownloadJob> m_download;
    std::unique_ptr<ComparisonJob> m_comparison;
    std::unique_ptr<modbus::LineScan> m_scan;
    modbus::ScanPlan::Depth m_scanDepth = modbus::ScanPlan::Depth::Diagnosis;
    // Was connected when the scan began: lost only when the first attempt afterwards fails.
    bool m_isInterruptedByScan = false;
    std::uint16_t m_session = 0;
    std::uint16_t m_heartbeat = 0;
    bool m_wasConnected = false; // since connectTo()

    std::optional<modbus::StatusBlock> m_status; // last status of this connection
    SteadyTime m_lastGoodAt;
    SteadyTime m_lastPollAt;
    SteadyTime m_identifiedAt;
    SteadyTime m_restlessAt; // last time of a movement, a change or a request
    StatusBatch m_batch;
    SteadyTime m_lastFlushAt;
    std::optional<ProgramId> m_programRead; // last one reported; empty: none in this connection
    bool m_isHeaderWanted = false;
    std::optional<ProgramId> m_headerOf; // the active program before m_header was read
    std::vector<std::uint16_t> m_header;
    std::optional<modbus::BankReader> m_list; // only for a point cam
};

} // namespace campanel::link
