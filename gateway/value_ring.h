// SPDX-License-Identifier: Apache-2.0
// Values that wait for the broker, oldest first. Bounded: the oldest are dropped and counted.
#pragma once

#include "app/plant/metric_value.h"

#include <cstddef>
#include <cstdint>
#include <deque>

namespace campanel::gateway {

// A value at a time.
struct Sample {
    plant::Metric metric{};
    plant::MetricValue value;
    std::int64_t timestampMs = 0; // since 1970 UTC, by the clock at its time

    bool operator==(const Sample&) const = default;
};

class ValueRing {
public:
    static constexpr std::size_t standardCapacity = 100'000;

    explicit ValueRing(std::size_t capacity = standardCapacity)
        : m_capacity(capacity)
    {
    }

    void push(const Sample& sample)
    {
        m_samples.push_back(sample);
        limit();
    }
    // Puts samples that are older than all others back, in their order.
    void putBack(const std::deque<Sample>& samples)
    {
        m_samples.insert(m_samples.begin(), samples.begin(), samples.end());
        limit();
    }
    // Removes and returns the oldest one; the ring must not be empty.
    Sample take()
    {
        Sample oldest = m_samples.front();
        m_samples.pop_front();
        return oldest;
    }

    [[nodiscard]] bool isEmpty() const { return m_samples.empty(); }
    [[nodiscard]] std::size_t size() const { return m_samples.size(); }
    // Returns the samples dropped since the start.
    [[nodiscard]] std::int64_t dropped() const { return m_dropped; }

private:
    void limit()
    {
        for (; m_samples.size() > m_capacity; ++m_dropped)
            m_samples.pop_front();
    }

    std::deque<Sample> m_samples;
    std::size_t m_capacity;
    std::int64_t m_dropped = 0;
};

} // namespace campanel::gateway
