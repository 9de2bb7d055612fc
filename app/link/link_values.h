// SPDX-License-Identifier: Apache-2.0
// What travels between the GUI thread and the link thread: plain values, copied by queued signals.
#pragma once

#include "modbus/download/download.h"
#include "modbus/line/frame_text.h"
#include "modbus/line/line_scan.h"
#include "modbus/line/link_error.h"
#include "modbus/line/link_figures.h"
#include "modbus/line/rtu_client.h"
#include "modbus/line/wire_time.h"
#include "modbus/map/bank_header.h"
#include "modbus/map/blocks.h"
#include "modbus/map/packer_status.h"
#include "modbus/map/register_values.h"

#include <QList>
#include <QString>
#include <QStringList>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace campanel::link {

using SteadyTime = std::chrono::steady_clock::time_point;

// More doubtful answers than this in a row are a broken line. What a job asks may be repeated without harm.
inline constexpr int maxFailuresInARow = 5;

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
    // A Stop that was pressed while the line was gone: sent the moment it is back, unless withdrawn.
    std::optional<modbus::Command> pendingStop;
    bool isScanning = false; // a scan has the ports; the connection comes back after
};

struct StatusSample {
    SteadyTime receivedAt;
    modbus::StatusBlock status;
    std::chrono::nanoseconds latency{0}; // from asking to the answer, repetitions included; 0: not known
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

enum class JogDirection { None, Forward, Reverse };

// A jog key that is held. It counts until then only: who stops telling, for whatever reason, has let go.
struct JogRequest {
    JogDirection direction = JogDirection::None;
    SteadyTime until;
};

// How long one setJog() counts. Tell again several times meanwhile.
inline constexpr std::chrono::milliseconds jogCounts{200};

enum class CommandEnd {
    Done,
    Refused,        // by the controller: see reason
    NotSent,        // there was no connection; nothing went out
    NotReceived,    // the controller did not get it
    OutcomeUnknown, // it may have been carried out
    Withdrawn // a Stop that waited for the line and was taken back, or replaced by a later one; not sent
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

// Registers to read, as they are at one moment: 1..modbus::readbackRegisters of them.
struct ReadRequest {
    quint32 id = 0; // chosen by who asks; comes back with the outcome
    quint16 address = 0;
    quint16 count = 1;
};

enum class ReadEnd {
    Done,
    NotSent, // there is no connection, or too many wait already
    Failed   // see error; the question was repeated a few times
};

struct ReadOutcome {
    ReadRequest request;
    ReadEnd end = ReadEnd::Done;
    std::vector<std::uint16_t>
        registers{}; // as many as asked for; empty unless Done. See modbus::namedValues()
    SteadyTime receivedAt{};
    std::optional<modbus::LinkError> error{};
};

enum class ComparisonStage { Reading, Equal, Different, ProgramChanged, NoProgram, Failed, Canceled };

// The bank that the controller executes, read back and compared register by register with what was sent.
struct ComparisonReport {
    ComparisonStage stage = ComparisonStage::Reading;
    double fraction = 0;        // 0..1
    bool isInterrupted = false; // waits for the connection to come back and then goes on
    std::uint32_t generation = 0;
    std::uint32_t expectedCrc = 0;   // of what was given; without that, of the controller's status
    std::uint32_t controllerCrc = 0; // in its status
    std::uint32_t readCrc = 0;       // of what was read back, once all of it was
    int differingRegisters = 0;
    struct Difference {
        quint16 offset = 0; // from the bank's base
        std::uint16_t expected = 0;
        std::uint16_t actual = 0;
    };
    std::optional<Difference> firstDifference;
    // Failed for one of three reasons: no connection to begin with, another comparison under way, or `error`.
    bool isConnectionMissing = false;
    bool isBusy = false;
    std::optional<modbus::LinkError> error;
};

struct ScanReport {
    modbus::ScanPlan::Depth depth = modbus::ScanPlan::Depth::Diagnosis;
    bool isRunning = false;
    bool isCanceled = false;
    modbus::ScanProgress progress;
    QList<modbus::LineFinding> findings;     // so far
    std::optional<ConnectionSettings> found; // ready for connectTo()
};

enum class FaultsEnd {
    Accepted,
    Refused,      // by the controller, see detail; the rules before are still in force
    NotSimulated, // a real line has its own faults
    NotServing    // the simulated controller is not running, or ended before it answered
};

struct FaultsOutcome {
    FaultsEnd end = FaultsEnd::Accepted;
    QString detail; // its sentence
};

enum class RulerEnd {
    Read,
    NoBag,        // none has been cut since the controller's start
    NotSimulated, // a real machine needs a real ruler
    NotServing    // the simulated controller is not running, or ended before it answered
};

// The last bag as it lies on the table of the simulated machine.
struct RulerOutcome {
    RulerEnd end = RulerEnd::Read;
    double lengthMm = 0.0;     // 0: the cut before does not count
    double behindMarkMm = 0.0; // of its cut, behind the nearest printed mark; negative: before it
};

// What has passed on the line since the panel was started or the figures were reset.
struct FiguresReport {
    SteadyTime takenAt;
    modbus::LinkFigures figures;
    std::chrono::milliseconds answerAllowance{0}; // of the next answer, beyond wire time; 0: not connected
};

} // namespace campanel::link
