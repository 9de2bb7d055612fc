// SPDX-License-Identifier: Apache-2.0
// The line with the faults of a script: sits where Line sits and gives way to it when there is no rule. One
// exchange is one request of the panel and what is answered to it; the first rule that strikes it is the only
// one. Knows times and bytes only. Times in ns, monotonic; call with times that do not go back.
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

// What the owner of port and controller has to do.
struct LineEvent {
    enum class Kind : std::uint8_t { Unplug, Plug, Restart };
    Kind kind = Kind::Unplug;
    std::string port; // of Plug: where the link is to be, empty: where it was
};

class FaultyLine {
public:
    struct Arrival {
        FrameBytes bytes;
        std::int64_t endNs = 0;
        std::uint64_t frame = 0; // to be named with its answer
    };

    FaultyLine(const LineSettings& settings, FaultScript script, std::int64_t nowNs);

    // Counters, windows of time and random numbers begin again; silence, garbling and restarts are over, and
    // an unplugged port comes back.
    void setScript(FaultScript script, std::int64_t nowNs);
    [[nodiscard]] const FaultScript& script() const { return m_script; }
    // Faults since the script was set.
    [[nodiscard]] std::uint64_t applied() const { return m_applied; }

    void fromPanel(std::span<const std::uint8_t> bytes, std::int64_t nowNs);
    [[nodiscard]] std::optional<Arrival> takeArrival(std::int64_t nowNs);
    // The answer to the frame whose last piece was `frame`.
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
    struct Waiting { // for its time to be put on the line
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
    std::int64_t m_characterNs = 0; // as long as on the wire, also where bytes take no time
    std::int64_t m_gapNs = 0;
    FaultScript m_script;
    std::mt19937_64 m_random;
    std::int64_t m_loadedNs = 0;
    std::uint64_t m_exchanges = 0; // since the script was set
    std::uint64_t m_applied = 0;
    std::vector<std::uint64_t> m_appliedByRule;

    std::deque<Exchange> m_open; // the last few
    std::uint64_t m_lastFrame = 0;
    std::int64_t m_requestEndNs = INT64_MIN; // of the panel's last request
    bool m_requestPasses = true;             // more bytes of it go to the controller
    std::deque<Waiting> m_toController;      // in order
    std::deque<std::uint64_t> m_frames;      // of the pieces that are on the line
    std::int64_t m_toControllerEndNs = INT64_MIN;
    std::multimap<std::int64_t, FrameBytes> m_toPanel; // by their time
    std::multimap<std::int64_t, LineEvent> m_events;
    std::int64_t m_muteUntilNs = INT64_MIN; // nothing passes
    std::int64_t m_garbleUntilNs = INT64_MIN;
    FaultPart m_garbledPart = FaultPart::Both;
    std::uint32_t m_busyLeft = 0;
};

} // namespace campanel::controller
