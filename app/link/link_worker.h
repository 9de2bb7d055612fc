// SPDX-License-Identifier: Apache-2.0
// The one owner of the port. Lives in the link thread; everything else talks to it by queued signals. Does
// one exchange per turn of its event loop, so that an urgent request waits for one exchange at most.
#pragma once

#include "app/link/download_job.h"
#include "app/link/link_values.h"
#include "app/link/port_finder.h"
#include "app/link/request_queue.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

namespace campanel::link {

class SimulatedController;

class LinkWorker : public QObject {
    Q_OBJECT

public:
    LinkWorker();
    ~LinkWorker() override;

public slots:
    void connectTo(const campanel::link::ConnectionSettings& settings);
    void request(const campanel::link::CommandRequest& request);
    void requestParameter(const campanel::link::ParameterRequest& request);
    void download(const std::vector<std::uint16_t>& bank);
    void cancelDownload();

signals:
    void reported(const campanel::link::LinkReport& report);
    void statusReceived(const campanel::link::StatusBatch& batch);
    void programRead(const campanel::link::ActiveProgram& program);
    void commandEnded(const campanel::link::CommandOutcome& outcome);
    void parameterEnded(const campanel::link::ParameterOutcome& outcome);
    void downloadReported(const campanel::link::DownloadReport& report);

private:
    using ProgramId = std::pair<std::uint32_t, std::uint32_t>; // generation and CRC-32

    void startSimulator();
    void step();
    void tryToConnect();
    void exchange();
    void enqueue(Request request);
    void carryOut(const Request& request);
    void sendCommand(const CommandRequest& request);
    void sendParameter(const ParameterRequest& request);
    void advanceDownload();
    void pollStatus();
    void noteStatus(const modbus::StatusBlock& status);
    void noteProgram(const ProgramId& program);
    void readHeader();
    void setClock();
    void lose(const modbus::LinkError& error);
    void refuse(const Request& request);
    void endDownload();
    void reportDownload();
    void report(LinkState state, std::optional<modbus::LinkError> error = std::nullopt);
    void flushBatch();
    void stepAfter(std::chrono::milliseconds delay);

    ConnectionSettings m_settings;
    LinkReport m_report;
    QTimer m_stepTimer;
    std::unique_ptr<SimulatedController> m_simulator;
    std::unique_ptr<modbus::RtuClient> m_client; // exists while the port is open
    std::optional<AdapterIdentity> m_adapter;    // of the port that was opened last
    RequestQueue m_requests;
    std::unique_ptr<DownloadJob> m_download;
    std::uint16_t m_session = 0;
    std::uint16_t m_heartbeat = 0;
    bool m_wasConnected = false; // since connectTo()

    std::optional<modbus::StatusBlock> m_status; // the last one of this connection
    SteadyTime m_lastGoodAt;
    SteadyTime m_lastPollAt;
    StatusBatch m_batch;
    SteadyTime m_lastFlushAt;
    std::optional<ProgramId> m_programRead; // told last; empty: none was, in this connection
    bool m_isHeaderWanted = false;
    std::optional<ProgramId> m_headerOf; // the program that was active before m_header was read
    std::vector<std::uint16_t> m_header;
    std::optional<modbus::BankReader> m_knots; // of a point cam
};

} // namespace campanel::link
