// SPDX-License-Identifier: Apache-2.0
// The data between the GUI thread and the link thread: plain values, copied by queued signals.
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
#include "modbus/map/io_status.h"
#include "modbus/map/jam_status.h"
#include "modbus/map/measure_status.h"
#include "modbus/map/master_status.h"
#include "modbus/map/order_status.h"
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

// The number of consecutive doubtful answers above which the line counts as broken. A job's requests may be
// repeated without harm.
inline constexpr int maxFailuresInARow = 5;

// The connection to the controller.
struct ConnectionSettings {
    bool simulated = true;
    QString port; // device path; not used when simulated
    modbus::LineSettings line;
    int unit = 1;
    QString simulatorProgram;       // empty: searched beside this program, see SimulatedController
    QString simulatorStateDir;      // folder of the simulated controller's flash
    QStringList simulatorArguments; // options of the simulated machine
};

enum class LinkState {
    Searching,   // the port does not exist (yet)
    Connecting,  // open; identifying the device
    Connected,   // receiving status blocks
    Lost,        // was connected; searching for the port
    WrongDevice, // another device answers
    PortProblem, // the port exists and cannot be used
};

enum class SimulatorState { NotUsed, Starting, Serving, NotFound, Ended };

struct LinkReport {
    LinkState state = LinkState::Searching;
    QString portName;             // the path in use, empty while there is none
    bool hasSerialNumber = false; // the adapter has one: it is found in any socket
    bool simulated = true;
    SimulatorState simulator = SimulatorState::NotUsed;
    QString simulatorDetail;                // its output before it ended, or the searched paths
    std::optional<modbus::LinkError> error; // reason why it is not connected
    std::optional<modbus::Identity> identity;
    // The Stop that was pressed without a connection: sent when the line is back, unless withdrawn.
    std::optional<modbus::Command> pendingStop;
    bool isScanning = false; // a scan uses the ports; the connection is restored afterwards
};

struct StatusSample {
    SteadyTime receivedAt;
    modbus::StatusBlock status;
    std::chrono::nanoseconds latency{0}; // from request to answer, including repetitions; 0: unknown
};

// The samples since the last batch, oldest first. Those before the last differ in nothing but the motion;
// while only the machine moves, at most 33 batches a second.
struct StatusBatch {
    QList<StatusSample> samples;
    int failedExchanges = 0; // since the last batch
};

// The header of the controller's active bank, and the knots or segments of a cam. The header is empty
// without a program.
struct ActiveProgram {
    std::uint32_t generation = 0;
    std::uint32_t crc = 0;
    std::vector<std::uint16_t> header;
    std::vector<std::uint16_t> list{}; // registers of the knots or segments

    [[nodiscard]] bool isEmpty() const { return header.empty(); }
};

struct CommandRequest {
    quint32 id = 0; // chosen by the caller; returned with the outcome
    modbus::Command command = modbus::Command::None;
    modbus::CommandArguments arguments;
};

enum class JogDirection { None, Forward, Reverse };

// A held jog key. It is valid until this time; without a repetition it counts as released.
struct JogRequest {
    JogDirection direction = JogDirection::None;
    SteadyTime until;
};

// The validity of one setJog(). Repeat it several times within this time.
inline constexpr std::chrono::milliseconds jogCounts{200};

// The permit of the panel (modbus::PermitBit), valid until this time.
struct PermitRequest {
    std::uint16_t bits = 0;
    SteadyTime until;
};

// The validity of one setPermit(): a panel that hangs permits nothing.
inline constexpr std::chrono::milliseconds permitCounts{2000};

enum class CommandEnd {
    Done,
    Refused, // by the controller, see `reason`
    NotSent, // no connection; nothing was sent
    NotReceived,
    OutcomeUnknown, // may have been executed
    Withdrawn       // a waiting Stop that was withdrawn, or replaced by a later one; not sent
};

struct CommandOutcome {
    quint32 id = 0;
    modbus::Command command = modbus::Command::None;
    CommandEnd end = CommandEnd::Done;
    modbus::Refusal reason = modbus::Refusal::None;
    std::optional<modbus::LinkError> error;
};

// One register of the table by its name, to read, or to write and read back.
struct ParameterRequest {
    quint32 id = 0;              // chosen by the caller; returned with the outcome
    std::string name;            // read: any numeric register; write: one that is written alone
    std::optional<double> value; // physical value to write; empty: read only
};

enum class ParameterEnd {
    Done,
    NotSent,       // no connection; nothing was sent
    Refused,       // no such parameter, or an invalid value: see error; nothing was changed
    OutcomeUnknown // no proof received: it may have been written
};

struct ParameterOutcome {
    quint32 id = 0;
    std::string name;
    ParameterEnd end = ParameterEnd::Done;
    std::optional<double> value; // physical, proven by reading; only with Done
    std::optional<modbus::LinkError> error;
};

enum class DownloadStage { Transferring, Sealing, Armed, Active, Failed, Canceled };

struct DownloadReport {
    DownloadStage stage = DownloadStage::Transferring;
    double fraction = 0; // share of its frames, 0..1
    std::uint32_t crc = 0;
    bool isInterrupted = false; // waiting for the connection, then continues
    // The reasons of a failure: no connection at the start, another download running, or `error`.
    bool isConnectionMissing = false;
    bool isBusy = false;
    std::optional<modbus::DownloadError> error;
};

// The registers to read in one exchange: 1..modbus::readbackRegisters.
struct ReadRequest {
    quint32 id = 0; // chosen by the caller; returned with the outcome
    quint16 address = 0;
    quint16 count = 1;
};

enum class ReadEnd {
    Done,
    NotSent, // no connection, or too many reads are waiting
    Failed   // see error; the read was repeated several times
};

struct ReadOutcome {
    ReadRequest request;
    ReadEnd end = ReadEnd::Done;
    std::vector<std::uint16_t>
        registers{}; // as many as requested; empty unless Done. See modbus::namedValues()
    SteadyTime receivedAt{};
    std::optional<modbus::LinkError> error{};
};

enum class ComparisonStage { Reading, Equal, Different, ProgramChanged, NoProgram, Failed, Canceled };

// The comparison of the controller's active bank, read back, with the downloaded registers.
struct ComparisonReport {
    ComparisonStage stage = ComparisonStage::Reading;
    double fraction = 0;        // 0..1
    bool isInterrupted = false; // waiting for the connection, then continues
    std::uint32_t generation = 0;
    std::uint32_t expectedCrc = 0;   // CRC-32 of the given bank; without one, that of the controller's status
    std::uint32_t controllerCrc = 0; // from its status
    std::uint32_t readCrc = 0;       // CRC-32 of the bank read back, when complete
    int differingRegisters = 0;
    struct Difference {
        quint16 offset = 0; // from the bank's base
        std::uint16_t expected = 0;
        std::uint16_t actual = 0;
    };
    std::optional<Difference> firstDifference;
    // The reasons of a failure: no connection at the start, another comparison running, or `error`.
    bool isConnectionMissing = false;
    bool isBusy = false;
    std::optional<modbus::LinkError> error;
};

struct ScanReport {
    modbus::ScanPlan::Depth depth = modbus::ScanPlan::Depth::Diagnosis;
    bool isRunning = false;
    bool isCanceled = false;
    modbus::ScanProgress progress;
    QList<modbus::LineFinding> findings;     // up to now
    std::optional<ConnectionSettings> found; // ready for connectTo()
};

enum class FaultsEnd {
    Accepted,
    Refused,      // by the controller, see `detail`; the earlier rules stay active
    NotSimulated, // a real line cannot simulate faults
    NotServing    // the simulated controller is not running, or ended before it answered
};

struct FaultsOutcome {
    FaultsEnd end = FaultsEnd::Accepted;
    QString detail; // the controller's sentence
};

enum class RulerEnd {
    Read,
    NoBag,        // none was cut since the controller's start
    NotSimulated, // a real machine needs a real ruler
    NotServing    // the simulated controller is not running, or ended before it answered
};

// The last bag of the simulated machine.
struct RulerOutcome {
    RulerEnd end = RulerEnd::Read;
    double lengthMm = 0.0;     // 0: the previous cut is not valid
    double behindMarkMm = 0.0; // distance of its cut behind the nearest printed mark; negative: before it
};

// The statistics of the line since the start of the panel or the last reset.
struct FiguresReport {
    SteadyTime takenAt;
    modbus::LinkFigures figures;
    std::chrono::milliseconds answerAllowance{0}; // for the next answer, beyond wire time; 0: not connected
};

} // namespace campanel::link
