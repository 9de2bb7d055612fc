// SPDX-License-Identifier: Apache-2.0
// The statistics of the line: a plain value of fixed size that its owner updates and copies. Times of day are
// parameters, so that a test can choose them.
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

// The classes of failed exchanges, in the order of the counters.
inline constexpr std::array countedErrors{LinkErrorKind::NoAnswer,  LinkErrorKind::BadChecksum,
                                          LinkErrorKind::BadFrame,  LinkErrorKind::ForeignAnswer,
                                          LinkErrorKind::Exception, LinkErrorKind::PortGone};
using ErrorCounts = std::array<std::uint32_t, countedErrors.size()>;

// The figures of one minute of the strip.
struct MinuteFigures {
    std::int64_t minute = -1; // since 1970-01-01 UTC; negative: no exchange
    std::uint32_t answers = 0;
    ErrorCounts errors{};
    std::uint32_t latencyP99Us = 0;
    std::uint32_t latencyMaxUs = 0;
};

// The controller's own counters since the figures began, summed over wraps and restarts.
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
    // Adds an answer. `latency`: from the request at the port to the complete answer. `wire`: time on the
    // line of both frames and the silences. `spent`: until the line is free again.
    void noteAnswer(std::chrono::nanoseconds latency, std::chrono::nanoseconds wire,
                    std::chrono::nanoseconds spent, WallTime at);
    // Adds a failed exchange; its time counts as well.
    void noteError(LinkErrorKind kind, std::chrono::nanoseconds spent, WallTime at);
    void noteDrain(int droppedBytes);
    // Adds bytes beside an answer that belong to no frame.
    void noteStrays(std::size_t bytes);
    // Adds an answer with such bytes behind it.
    void noteFollowedAnswer(std::size_t strayBytes);
    void noteController(const StatusBlock& status);

    [[nodiscard]] std::uint64_t requests() const { return m_requests; }
    [[nodiscard]] std::uint64_t answers() const { return m_answers; }
    [[nodiscard]] std::uint64_t retries() const { return m_retries; } // questions repeated without harm
    [[nodiscard]] std::uint64_t drains() const { return m_drains; }
    [[nodiscard]] std::uint64_t sentBytes() const { return m_sentBytes; }
    [[nodiscard]] std::uint64_t receivedBytes() const { return m_receivedBytes; } // including dropped ones
    [[nodiscard]] std::uint64_t droppedBytes() const { return m_droppedBytes; }
    [[nodiscard]] std::uint64_t strayBytes() const { return m_strayBytes; }
    [[nodiscard]] std::uint64_t followedAnswers() const { return m_followedAnswers; }
    [[nodiscard]] const ErrorCounts& errors() const { return m_errors; }
    [[nodiscard]] std::uint32_t errors(LinkErrorKind kind) const;
    [[nodiscard]] const LatencyHistogram& latency() const { return m_latency; }
    // Returns the time of the frames at this baud rate, with the standard's silences, divided by the time of
    // the exchanges: 1 is the wire's limit. Empty before the first exchange.
    [[nodiscard]] std::optional<double> wireShare() const;
    [[nodiscard]] std::chrono::nanoseconds wireTime() const { return m_wireTime; }
    [[nodiscard]] std::chrono::nanoseconds spentTime() const { return m_spentTime; }
    // Returns an empty value before the first status.
    [[nodiscard]] const std::optional<ControllerCounts>& controller() const { return m_controller; }
    // Returns the 24 hours up to the last minute with an exchange, oldest first. There is one entry per
    // minute, also for minutes without exchanges. Empty before the first exchange.
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
    std::uint64_t m_strayBytes = 0;
    std::uint64_t m_followedAnswers = 0;
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
    std::int64_t m_minute = -1;         // newest minute
};

} // namespace campanel::modbus
