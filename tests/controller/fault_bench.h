// SPDX-License-Identifier: Apache-2.0
// Both ends of a faulty line on simulated time: a panel that asks, and a controller that answers at once.
#pragma once

#include "base/ctl_crc.h"
#include "faulty_line.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace campanel::test {

using namespace campanel::controller;

inline constexpr std::int64_t ms = 1'000'000;
inline const LineSettings slow{9600, 'N', 1, true}; // 1.04 ms a character, 3.65 ms between frames

inline FrameBytes framed(FrameBytes bytes)
{
    const std::uint16_t crc = ctl_crc16(bytes.data(), bytes.size());
    bytes.push_back(static_cast<std::uint8_t>(crc & 0xFF));
    bytes.push_back(static_cast<std::uint8_t>(crc >> 8));
    return bytes;
}

inline bool hasRightCrc(const FrameBytes& bytes)
{
    return bytes.size() >= 4 && ctl_crc16(bytes.data(), bytes.size()) == 0;
}

inline const FrameBytes question = framed({1, 3, 0, 0, 0, 3});
inline const FrameBytes reply = framed({1, 3, 6, 0xCA, 0x3D, 0, 1, 0, 1});

// Both ends of the line and the time between them.
class Bench {
public:
    explicit Bench(const char* script, const LineSettings& settings = slow)
        : m_gapNs(frameGapNs(settings))
        , m_line(settings, parseFaultScript(script).value(), 0)
    {
    }

    void ask(const FrameBytes& request = question) { m_line.fromPanel(request, m_nowNs); }
    void runTo(std::int64_t untilNs)
    {
        for (;;) {
            std::int64_t nextNs = m_line.nextEventNs().value_or(INT64_MAX);
            nextNs = std::min(nextNs, m_frameEndNs.value_or(INT64_MAX));
            if (nextNs > untilNs)
                break;
            m_nowNs = std::max(m_nowNs, nextNs);
            move();
        }
        m_nowNs = untilNs;
    }
    // Sends one request and returns everything received within this time.
    FrameBytes exchange(std::int64_t withinNs = 100 * ms)
    {
        m_panel.clear();
        ask();
        runTo(m_nowNs + withinNs);
        return m_panel;
    }

    std::vector<FrameBytes> m_heard; // frames received by the controller
    FrameBytes m_panel;              // bytes received by the panel
    std::vector<std::int64_t> m_panelTimes;
    std::vector<std::pair<std::int64_t, LineEvent>> m_events;
    FrameBytes m_reply = reply;
    std::int64_t m_nowNs = 0;
    std::int64_t m_gapNs = 0;
    FaultyLine m_line;

private:
    void move()
    {
        while (auto event = m_line.takeEvent(m_nowNs))
            m_events.emplace_back(m_nowNs, *event);
        while (const auto arrival = m_line.takeArrival(m_nowNs)) {
            if (m_frameEndNs && *m_frameEndNs <= arrival->endNs)
                endFrame();
            m_frame.insert(m_frame.end(), arrival->bytes.begin(), arrival->bytes.end());
            m_frameNumber = arrival->frame;
            m_frameEndNs = arrival->endNs + m_gapNs;
        }
        if (m_frameEndNs && *m_frameEndNs <= m_nowNs)
            endFrame();
        for (const std::uint8_t byte : m_line.takeForPanel(m_nowNs)) {
            m_panel.push_back(byte);
            m_panelTimes.push_back(m_nowNs);
        }
    }
    void endFrame()
    {
        m_heard.push_back(std::exchange(m_frame, {}));
        m_frameEndNs.reset();
        if (hasRightCrc(m_heard.back()))
            m_line.fromController(m_reply, m_frameNumber, m_nowNs);
    }

    FrameBytes m_frame;
    std::uint64_t m_frameNumber = 0;
    std::optional<std::int64_t> m_frameEndNs;
};

} // namespace campanel::test
