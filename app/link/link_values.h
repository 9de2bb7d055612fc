// SPDX-License-Identifier: Apache-2.0
// What travels between the GUI thread and the link thread: plain values, copied by queued signals.
#pragma once

#include "modbus/bank_header.h"
#include "modbus/blocks.h"
#include "modbus/download.h"
#include "modbus/link_error.h"
#include "modbus/rtu_client.h"
#include "modbus/wire_time.h"

#include <QList>
#include <QString>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace campanel::link {

using SteadyTime = std::chrono::steady_clock::time_point;

// How to reach the controller.
struct ConnectionSettings {
    bool simulated = true;
    QString port; // device path; not used when simulated
    modbus::LineSettings line;
    int unit = 1;
    QString simulatorProgram;  // empty: searched for beside this program, see SimulatedController
    QString simulatorStateDir; // where the simulated controller keeps its flash
};

enum class LinkState {
    Searching,   // the port is not there (yet)
    Connecting,  // opened; asking who is at the other end
    Connected,   // status comes in
    Lost,        // was connected; the port is looked for again
    WrongDevice, // someone else answers
    PortProblem, // the port is there and cannot be used
};

enum class SimulatorState { NotUsed, Starting, Serving, NotFound, Ended };

struct LinkReport {
    LinkState state = LinkState::Searching;
    QString portName; // the path in use, empty while there is none
    bool simulated = true;
    SimulatorState simulator = SimulatorState::NotUsed;
    QString simulatorDetail;                // what it wrote before it ended, or where it was looked for
    std::optional<modbus::LinkError> error; // why it is not connected
    std::optional<modbus::Identity> identity;
};

struct StatusSample {
    SteadyTime receivedAt;
    modbus::StatusBlock status;
};

// Samples since the last batch, oldest first; at most some 60 batches a second.
struct StatusBatch {
    QList<StatusSample> samples;
    int failedExchanges = 0; // since the last batch
};

// The header of the bank that the controller is executing, and the knots of a point cam. Without a program:
// an empty header.
struct ActiveProgram {
    std::uint32_t generation = 0;
    std::uint32_t crc = 0;
    std::vector<std::uint16_t> header;
    std::vector<std::uint16_t> knots{}; // registers, modbus::knotRegisters each

    [[nodiscard]] bool isEmpty() const { return header.empty(); }
};

struct CommandRequest {
    quint32 id = 0; // chosen by who asks; comes back with the outcome
    modbus::Command command = modbus::Command::None;
    modbus::CommandArguments arguments;
};

enum class CommandEnd {
    Done,
    Refused,       // by the controller: see reason
    NotSent,       // there was no connection; nothing went out
    NotReceived,   // the controller did not get it
    OutcomeUnknown // it may have been carried out
};

struct CommandOutcome {
    quint32 id = 0;
    modbus::Command command = modbus::Command::None;
    CommandEnd end = CommandEnd::Done;
    modbus::Refusal reason = modbus::Refusal::None;
    std::optional<modbus::LinkError> error;
};

// One register of the table by its name, to be read, or to be written and read back.
struct ParameterRequest {
    quint32 id = 0;              // chosen by who asks; comes back with the outcome
    std::string name;            // any numeric register to read; one of the group "parameter" to write
    std::optional<double> value; // physical, to be written; empty: only read
};

enum class ParameterEnd {
    Done,
    NotSent,       // there was no connection; nothing went out
    Refused,       // no such parameter, or a value that it does not take: see error; nothing was changed
    OutcomeUnknown // no proof came back: it may have been written
};

struct ParameterOutcome {
    quint32 id = 0;
    std::string name;
    ParameterEnd end = ParameterEnd::Done;
    std::optional<double> value; // physical, proven by reading; with Done only
    std::optional<modbus::LinkError> error;
};

enum class DownloadStage { Transferring, Sealing, Armed, Active, Failed, Canceled };

struct DownloadReport {
    DownloadStage stage = DownloadStage::Transferring;
    double fraction = 0; // of its frames, 0..1
    std::uint32_t crc = 0;
    bool isInterrupted = false; // waits for the connection to come back and then goes on
    // Failed for one of three reasons: no connection to begin with, another download under way, or `error`.
    bool isConnectionMissing = false;
    bool isBusy = false;
    std::optional<modbus::DownloadError> error;
};

} // namespace campanel::link
