// SPDX-License-Identifier: Apache-2.0
// The line with the faults of a script, in place of a Line; without rules it works like one. One exchange is
// one request of the panel and its answer; the first rule that matches it is the only one. Works on times and
// bytes only. Times are in ns and monotonic; calls must be in order of time.
#pragma once

#include "fault_frames.h"
#include "fault_rules.h"
#include "line.h"

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace campanel::controller {

// An action for the owner of port and controller.
struct LineEvent {
    enum class Kind : std::uint8_t { Unplug, Plug, Restart };
    Kind kind = Kind::Unplug;
    std::string port; // Plug: the path of the link, empty: unchanged
};

class FaultyLine {
public:
    struct Arrival {
        FrameBytes bytes;
        std::int64_t endNs = 0;
        std::uint64_t frame = 0; // to pass with its answer
    };

    FaultyLine(const LineSettings& settings, FaultScript script, std::int64_t nowNs);

    // Sets the script. Counters, time windows and random numbers restart; silence, garbling and restarts end,
    // and an unplugged port returns.
    void setScript(FaultScript script, std::int64_t nowNs);
    [[nodiscard]] const FaultScript& script() const { return m_script; }
    // Returns the number of faults since the script was set.
    [[nodiscard]] std::uint64_t applied() const { return m_applied; }

    void fromPanel(std::span<const std::uint8_t> bytes, std::int64_t nowNs);
    [[nodiscard]] std::optional<Arrival> takeArrival(std::int64_t nowNs);
    // Receives the answer to the frame whose last piece was `frame`.
    void fromController(std::span<const std::uint8_t> bytes, std::uint64_t frame, std::int64_t nowNs);
    [[nodiscard]] FrameBytes takeForPanel(std::int64_t nowNs);
    [[nodiscard]] std::optional<LineEvent> takeEvent(std::int64_t nowNs);

    [[nodiscard]] std::optional<std::int64_t> nextEventNs() const;

private:
    struct Exchange {
        std::uint64_t frame = 0;
        FrameBytes request;
        std::optional<FaultRule> fault;
    };
    struct Waiting { // waiting for its time on the line
        FrameBytes bytes;
        std::uint64_t frame = 0;
        std::int64_t startNs = 0;
    };

    [[nodiscard]] std::optional<FaultRule> strike(std::int64_t nowNs);
    [[nodiscard]] bool strikes(const FaultRule& rule, std::size_t index, std::int64_t nowNs);
    void beginExchange(std::span<const std::uint8_t> bytes, std::int64_t nowNs);
    void putRequest(const FaultRule& rule, const Exchange& exchange, std::int64_t nowNs);
    void putDamagedRequest(const FaultRule& rule, const Exchange& exchange, std::int64_t nowNs);
    [[nodiscard]] FrameBytes damaged(const FaultRule& rule, const Exchange& exchange, FrameBytes frame);
    void putAnswer(const FaultRule& rule, const Exchange& exchange, FrameBytes answer, std::int64_t nowNs);
    void secondMaster(const Exchange& exchange, std::int64_t startNs);
    void unplug(const FaultRule& rule, std::int64_t atNs);
    void toController(FrameBytes bytes, std::uint64_t frame, std::int64_t startNs);
    void toPanel(FrameBytes bytes, std::int64_t startNs);
    void putOnLine(std::int64_t nowNs);
    [[nodiscard]] static std::int64_t scaled(std::int64_t timeNs, double factor);
    [[nodiscard]] std::int64_t lengthNs(std::size_t characters) const;

    LineSettings m_settings;
    Line m_line;
    std::int64_t m_characterNs = 0; // time on the wire, also for an unpaced line
    std::int64_t m_gapNs = 0;
    FaultScript m_script;
    std::mt19937_64 m_random;
    std::int64_t m_loadedNs = 0;
    std::uint64_t m_exchanges = 0; // since the script was set
    std::uint64_t m_applied = 0;
    std::vector<std::uint64_t> m_appliedByRule;

    std::deque<Exchange> m_open; // the last few exchanges
    std::uint64_t m_lastFrame = 0;
    std::int64_t m_requestEndNs = INT64_MIN;
    bool m_requestPasses = true;        // the last request goes to the controller
    std::deque<Waiting> m_toController; // sorted by time
    std::deque<std::uint64_t> m_frames; // frames of the pieces on the line
    std::int64_t m_toControllerEndNs = INT64_MIN;
    std::multimap<std::int64_t, FrameBytes> m_toPanel; // by time
    std::multimap<std::int64_t, LineEvent> m_events;
    std::int64_t m_muteUntilNs = INT64_MIN; // nothing passes until then
    std::int64_t m_garbleUntilNs = INT64_MIN;
    FaultPart m_garbledPart = FaultPart::Both;
    std::uint32_t m_busyLeft = 0;
};

} // namespace campanel::controller
