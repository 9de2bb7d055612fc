// SPDX-License-Identifier: Apache-2.0
// What happened on the line, counted: a plain value of fixed size that its owner updates and copies out.
// Times of day are passed in, so that a test can choose them.
#pragma once

#include "modbus/line/latency_histogram.h"
#include "modbus/line/link_error.h"
#include "modbus/map/blocks.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace campanel::modbus {

// The classes in which exchanges fail, and the order in which they are counted.
inline constexpr std::array countedErrors{LinkErrorKind::NoAnswer,  LinkErrorKind::BadChecksum,
                                          LinkErrorKind::BadFrame,  LinkErrorKind::ForeignAnswer,
                                          LinkErrorKind::Exception, LinkErrorKind::PortGone};
using ErrorCounts = std::array<std::uint32_t, countedErrors.size()>;

// "no_answer", "bad_checksum" ...: keys of CSV and JSON, in the order of countedErrors.
inline constexpr std::array<std::string_view, countedErrors.size()> countedErrorKeys{
    "no_answer", "bad_checksum", "bad_frame", "foreign_answer", "exception", "port_gone"};

// One minute of the strip.
struct MinuteFigures {
    std::int64_t minute = -1; // since 1970-01-01 UTC; negative: nothing was counted
    std::uint32_t answers = 0;
    ErrorCounts errors{};
    std::uint32_t latencyP99Us = 0;
    std::uint32_t latencyMaxUs = 0;
};

// The controller's own counters, summed over their wrapping and its restarts, since the figures began.
struct ControllerCounts {
    std::uint32_t crcErrors = 0;
    std::uint32_t frameErrors = 0;
    std::uint32_t exceptions = 0;
    std::uint32_t requests = 0;
};

class LinkFigures {
public:
    using WallTime = std::chrono::system_clock::time_point;

    static constexpr int stripMinutes = 24 * 60;

    LinkFigures()
        : m_strip(stripMinutes)
    {
    }

    void noteRequest(int bytes, bool isRetry);
    void noteReceived(int bytes) { m_receivedBytes += static_cast<std::uint64_t>(bytes); }
    // `latency`: request handed to the port to answer complete. `wire`: what the line needs for both frames
    // and the silences. `spent`: from there to where the line is free again, included.
    void noteAnswer(std::chrono::nanoseconds latency, std::chrono::nanoseconds wire,
                    std::chrono::nanoseconds spent, WallTime at);
    // Time spent on an exchange that failed counts as well.
    void noteError(LinkErrorKind kind, std::chrono::nanoseconds spent, WallTime at);
    void noteDrain(int droppedBytes);
    void noteController(const StatusBlock& status);

    [[nodiscard]] std::uint64_t requests() const { return m_requests; }
    [[nodiscard]] std::uint64_t answers() const { return m_answers; }
    [[nodiscard]] std::uint64_t retries() const { return m_retries; } // harmless questions asked again
    [[nodiscard]] std::uint64_t drains() const { return m_drains; }
    [[nodiscard]] std::uint64_t sentBytes() const { return m_sentBytes; }
    [[nodiscard]] std::uint64_t receivedBytes() const { return m_receivedBytes; } // dropped ones included
    [[nodiscard]] std::uint64_t droppedBytes() const { return m_droppedBytes; }
    [[nodiscard]] const ErrorCounts& errors() const { return m_errors; }
    [[nodiscard]] std::uint32_t errors(LinkErrorKind kind) const;
    [[nodiscard]] const LatencyHistogram& latency() const { return m_latency; }
    // Time that the frames need at this baud rate, with the silences of the standard, against the time that
    // the exchanges took: 1 is the wire's limit. Empty before the first exchange.
    [[nodiscard]] std::optional<double> wireShare() const;
    [[nodiscard]] std::chrono::nanoseconds wireTime() const { return m_wireTime; }
    [[nodiscard]] std::chrono::nanoseconds spentTime() const { return m_spentTime; }
    // Empty before the first status.
    [[nodiscard]] const std::optional<ControllerCounts>& controller() const { return m_controller; }
    // The last 24 hours up to the last minute in which anything was counted, oldest first: one entry a
    // minute, also for minutes without anything. Empty before the first exchange.
    [[nodiscard]] std::vector<MinuteFigures> strip() const;

private:
    MinuteFigures& minuteAt(WallTime at);

    std::uint64_t m_requests = 0;
    std::uint64_t m_answers = 0;
    std::uint64_t m_retries = 0;
    std::uint64_t m_drains = 0;
    std::uint64_t m_sentBytes = 0;
    std::uint64_t m_receivedBytes = 0;
    std::uint64_t m_droppedBytes = 0;
    ErrorCounts m_errors{};
    LatencyHistogram m_latency;
    LatencyHistogram m_latencyOfMinute;
    std::chrono::nanoseconds m_wireTime{0};
    std::chrono::nanoseconds m_spentTime{0};
    struct Raw {
        std::uint16_t crcErrors = 0;
        std::uint16_t frameErrors = 0;
        std::uint16_t exceptions = 0;
        std::uint16_t requests = 0;
        std::uint32_t uptimeS = 0;
    };
    std::optional<Raw> m_lastRaw;
    std::optional<ControllerCounts> m_controller;
    std::vector<MinuteFigures> m_strip; // ring by minute
    std::int64_t m_minute = -1;         // the latest one
};

// One line "key,value" for each figure.
[[nodiscard]] std::string figuresCsv(const LinkFigures& figures);
// A heading and one line for each minute of the strip; times in UTC, ISO 8601.
[[nodiscard]] std::string stripCsv(const LinkFigures& figures);

} // namespace campanel::modbus
