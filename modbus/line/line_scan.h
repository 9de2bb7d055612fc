// SPDX-License-Identifier: Apache-2.0
// Why there is no connection, and where a controller is: asks for the identity block with one reading
// question after the other, the likeliest settings first. Nothing is ever written. Use from the thread that
// owns the port, which must not be open elsewhere.
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
    Controller,       // a CamPanel controller answers, see `identity`
    WrongUnit,        // it does, with the line's settings but at another unit than the configured one
    OtherMapVersion,  // a CamPanel controller of another map major version, see `code`
    OtherDevice,      // something else answers; `code` is its identity.device_type, 0 when it has none
    Garbage,          // bytes came, but no frame: wrong baud rate or parity, or noise
    NoBytes,          // nothing came at all
    EchoOnly,         // what was sent came back, and nothing else
    PortAbsent,       // no such device node
    PortNotPermitted, // see `group`
    PortBusy,         // see `holders`
    PortNotSerial,    // exists, but is no serial port
    PortSettings,     // the settings cannot be used with it, see `detail`
    PortGone,         // the adapter disappeared while it was asked
};

struct LineFinding {
    LineCondition condition = LineCondition::NoBytes;
    std::string port;
    LineSettings line; // with which it was found, or the last ones tried
    int unit = 1;
    std::optional<Identity> identity;
    int code = 0;
    std::uint64_t bytesSeen = 0; // on this port
    std::string group;           // that owns the node
    std::vector<PortHolder> holders;
    std::string detail;
    std::optional<int> latencyTimerMs; // of an FTDI adapter

    // A controller that can be connected to with port, line and unit.
    [[nodiscard]] bool isController() const
    {
        return condition == LineCondition::Controller || condition == LineCondition::WrongUnit;
    }
    [[nodiscard]] bool isLatencyTooLong() const { return latencyTimerMs.value_or(0) > longestGoodLatencyMs; }
};

// What is the matter, and what to do.
[[nodiscard]] std::string describe(const LineFinding& finding);

struct ScanPlan {
    enum class Depth : std::uint8_t {
        Diagnosis, // the configured port and line, the configured unit and a few others
        Search,    // every port, baud rate, parity, stop bits and unit, until a controller is found
    };

    std::string port; // the configured one; may be empty
    LineSettings line;
    int unit = 1;
    std::vector<std::string> otherPorts;
    Depth depth = Depth::Diagnosis;
};

struct ScanProgress {
    int done = 0; // questions
    int total = 0;
    std::string port; // tried next
    LineSettings line;
    int unit = 1;
    std::chrono::milliseconds remaining{0}; // at most, when nothing answers
};

class LineScan {
public:
    explicit LineScan(ScanPlan plan);

    // One question, or one port that cannot be opened. May be broken off after any.
    void advance();
    [[nodiscard]] bool ended() const { return m_ended; }

    [[nodiscard]] ScanProgress progress() const;
    // In the order of finding: every device that answered, and for each port without one why there is none.
    [[nodiscard]] const std::vector<LineFinding>& findings() const { return m_findings; }
    [[nodiscard]] const LineFinding* controller() const; // empty: none found

private:
    struct Candidate {
        std::uint16_t port = 0; // of m_ports
        std::uint8_t unit = 1;
        LineSettings line;
        std::chrono::milliseconds allowance{0};
    };
    struct Port {
        std::string path;
        std::uint64_t bytesSeen = 0;
        bool isDone = false; // has a finding of its own
        bool isTried = false;
        bool isEchoing = false;
    };

    void planDiagnosis();
    void planSearch();
    void planUnits(std::uint16_t port, const LineSettings& line);
    [[nodiscard]] bool openFor(const Candidate& candidate);
    void ask(const Candidate& candidate);
    [[nodiscard]] bool mayBeLate(const Candidate& candidate) const;
    void askAgainPatiently();
    [[nodiscard]] LineFinding findingAt(const Candidate& candidate, LineCondition condition) const;
    void skipDone();
    void finish();

    ScanPlan m_plan;
    std::vector<Port> m_ports;
    std::vector<Candidate> m_candidates;
    std::size_t m_next = 0;
    int m_attempt = 0; // at the next candidate
    int m_skipped = 0;
    std::optional<Candidate>
        m_patient; // the last one that was asked again: a line of a port is asked again once
    std::chrono::nanoseconds m_remaining{0};
    std::unique_ptr<RtuClient> m_client;
    std::size_t m_openPort = 0;
    std::vector<LineFinding> m_findings;
    bool m_ended = false;
};

// In the order of likelihood; the given one first.
[[nodiscard]] std::vector<LineSettings> likelyLines(const LineSettings& first);

} // namespace campanel::modbus
