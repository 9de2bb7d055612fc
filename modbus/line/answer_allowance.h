// SPDX-License-Identifier: Apache-2.0
// The waiting time for an answer beyond the wire time of its frames: three times the p99 of the turnaround
// measured on this connection, within limits. It starts from a safe value and grows at once after a missing
// answer.
#pragma once

#include "modbus/line/latency_histogram.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace campanel::modbus {

class AnswerAllowance {
public:
    using Milliseconds = std::chrono::milliseconds;

    // The minimum: a USB adapter that collects bytes for 16 ms, and a panel or controller busy for two time
    // slices, must not look like silence.
    static constexpr Milliseconds shortest{50};
    // The maximum: two unanswered questions and their draining fit into the second after which a line counts
    // as lost.
    static constexpr Milliseconds longest{400};
    // The answers in one generation of measurements; two generations are used.
    static constexpr std::uint64_t window = 200;
    static constexpr std::uint64_t minCount = 50; // below this number the start value is used
    static constexpr int margin = 3;              // multiple of the p99

    explicit AnswerAllowance(Milliseconds start)
        : m_value(start)
    {
    }

    // Adds the time from the request's last byte on the wire to the answer's first, including adapters and
    // scheduling.
    void noteTurnaround(std::chrono::nanoseconds turnaround)
    {
        m_recent.note(turnaround);
        if (m_recent.count() >= window)
            m_before = std::exchange(m_recent, {});
        else if (m_recent.count() != minCount)
            return;
        LatencyHistogram both = m_before;
        both += m_recent;
        m_value =
            std::clamp(std::chrono::ceil<Milliseconds>(both.percentile(0.99) * margin), shortest, longest);
    }

    // Increases the allowance after a missing answer and restarts the measurements: they do not include later
    // answers.
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
