// SPDX-License-Identifier: Apache-2.0
// How long to wait for an answer beyond the wire time of its frames: three times the p99 of the turnaround
// that was measured on this connection, within bounds. Starts from a safe value; grows at once when nothing
// comes.
#pragma once

#include "modbus/line/latency_histogram.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace campanel::modbus {

class AnswerAllowance {
public:
    using Milliseconds = std::chrono::milliseconds;

    // Below: a USB adapter that collects bytes for 16 ms, together with a panel or controller that was busy
    // for two time slices, must not look like silence.
    static constexpr Milliseconds shortest{50};
    // Above: two unanswered questions and their draining fit into the second after which a line counts as
    // lost.
    static constexpr Milliseconds longest{400};
    // Answers in one generation of measurements; two of them are looked at.
    static constexpr std::uint64_t window = 200;
    static constexpr std::uint64_t fewest = 50; // before there are so many, the start value holds
    static constexpr int margin = 3;            // times the p99

    explicit AnswerAllowance(Milliseconds start)
        : m_value(start)
    {
    }

    // From the request's last byte on the wire to the answer's first, adapters and scheduling included.
    void noteTurnaround(std::chrono::nanoseconds turnaround)
    {
        m_recent.note(turnaround);
        if (m_recent.count() >= window)
            m_before = std::exchange(m_recent, {});
        else if (m_recent.count() != fewest)
            return;
        LatencyHistogram both = m_before;
        both += m_recent;
        m_value =
            std::clamp(std::chrono::ceil<Milliseconds>(both.percentile(0.99) * margin), shortest, longest);
    }

    // An answer that would have come later was not measured: the measurements so far tell too little.
    void noteSilence()
    {
        m_value = std::max(m_value, std::min(2 * m_value, longest));
        m_recent = {};
    }

    [[nodiscard]] Milliseconds value() const { return m_value; }

private:
    Milliseconds m_value;
    LatencyHistogram m_recent;
    LatencyHistogram m_before;
};

} // namespace campanel::modbus
