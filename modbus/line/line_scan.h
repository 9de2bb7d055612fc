// SPDX-License-Identifier: Apache-2.0
// Finds out why there is no connection, and where a controller is: reads the identity block with one question
// after the other, the most likely settings first. It never writes. Use it from the thread that owns the
// port, which must not be open elsewhere.
#pragma once

#include "modbus/line/port_facts.h"
#include "modbus/line/rtu_client.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace campanel::modbus {

enum class LineCondition : std::uint8_t {
    Controller,      // a CamPanel controller answers, see `identity`
    WrongUnit,       // a controller with the line's settings, but at another unit than the configured one
    OtherMapVersion, // a CamPanel controller of another map major version, see `code`
    OtherDevice,     // another device; `code` is its identity.device_type, 0 when it has none
    Garbage,         // bytes without a frame: wrong baud rate or parity, or noise
    NoBytes,         // nothing received
    EchoOnly,
    Refused,          // only Modbus exceptions that say nothing of the device, see `code`
    PortAbsent,       // no such device node
    PortNotPermitted, // see `group`
    PortBusy,         // see `holders`
    PortNotSerial,    // exists, but is not a serial port
    PortSettings,     // the port does not support the settings, see `detail`
    PortGone,         // the adapter disappeared during the scan
};

struct LineFinding {
    LineCondition condition = LineCondition::NoBytes;
    std::string port;
    LineSettings line; // the successful ones, or the last ones tried
    int unit = 1;
    std::optional<Identity> identity;
    int code = 0;
    std::uint64_t bytesSeen = 0;  // on this port
    std::uint64_t strayBytes = 0; // of them beside answers
    std::string group;            // group that owns the node
    std::vector<PortHolder> holders;
    std::string detail;
    std::optional<int> latencyTimerMs; // only for an FTDI adapter

    // Returns true for a controller that accepts a connection with port, line and unit.
    [[nodiscard]] bool isController() const
    {
        return condition == LineCondition::Controller || condition == LineCondition::WrongUnit;
    }
    [[nodiscard]] bool isLatencyTooLong() const { return latencyTimerMs.value_or(0) > longestGoodLatencyMs; }
};

struct ScanPlan {
    enum class Depth : std::uint8_t {
        Diagnosis, // the configured port and line, the configured unit and several others
        Usual,     // every port and baud rate with 8N1 and 8E1, the configured unit and unit 1
        Search,    // every port, baud rate, parity, stop bits and unit, until a controller is found
    };

    std::string port; // the configured port; may be empty
    LineSettings line;
    int unit = 1;
    std::vector<std::string> otherPorts;
    Depth depth = Depth::Diagnosis;
};

struct ScanProgress {
    int done = 0; // questions
    int total = 0;
    std::string port; // next trial
    LineSettings line;
    int unit = 1;
    std::chrono::milliseconds remaining{0}; // maximum, without any answer
};

class LineScan {
public:
    explicit LineScan(ScanPlan plan);

    // Asks one question, or tries one port that cannot be opened. The scan may be stopped after any step.
    void advance();
    [[nodiscard]] bool ended() const { return m_ended; }

    [[nodiscard]] ScanProgress progress() const;
    // Returns the findings in their order: every device that answered, and for each port without one the
    // reason.
    [[nodiscard]] const std::vector<LineFinding>& findings() const { return m_findings; }
    [[nodiscard]] const LineFinding* controller() const; // null when none was found

private:
    struct Candidate {
        std::uint16_t port = 0; // index into m_ports
        std::uint8_t unit = 1;
        LineSettings line;
        std::chrono::milliseconds allowance{0};
    };
    struct Port {
        std::string path;
        std::uint64_t bytesSeen = 0;
        std::uint64_t strayBytes = 0;
        int exception = 0;   // Modbus exception of the last answer that was one
        bool isDone = false; // has its own finding
        bool isTried = false;
        bool isEchoing = false;
    };

    void planDiagnosis();
    void planSearch(bool isUsual);
    void planUnits(std::uint16_t port, const LineSettings& line);
    [[nodiscard]] bool openFor(const Candidate& candidate);
    void ask(const Candidate& candidate);
    [[nodiscard]] bool mayBeLate(const Candidate& candidate) const;
    void askAgainPatiently();
    [[nodiscard]] LineFinding findingAt(const Candidate& candidate, LineCondition condition) const;
    [[nodiscard]] LineFinding findingWithout(std::uint16_t port) const;
    void skipDone();
    void finish();

    ScanPlan m_plan;
    std::vector<Port> m_ports;
    std::vector<Candidate> m_candidates;
    std::size_t m_next = 0;
    int m_attempt = 0; // number of the attempt at the next candidate
    int m_skipped = 0;
    std::optional<Candidate>
        m_patient; // the last one that was asked again: a line of a port is asked again once
    std::chrono::nanoseconds m_remaining{0};
    std::unique_ptr<RtuClient> m_client;
    std::size_t m_openPort = 0;
    std::vector<LineFinding> m_findings;
    bool m_ended = false;
};

// Returns the lines by likelihood; the given one first, then every baud rate with each format.
[[nodiscard]] std::vector<LineSettings> likelyLines(const LineSettings& first);

} // namespace campanel::modbus
