// SPDX-License-Identifier: Apache-2.0
// Counts durations in logarithmic buckets, 16 per octave from 64 us to 16.7 s, in fixed memory. A percentile
// is at most 6.25 % too high, never too low. Shorter and longer durations count in the first and last bucket.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace campanel::modbus {

class LatencyHistogram {
public:
    using Microseconds = std::chrono::microseconds;

    void note(std::chrono::nanoseconds duration)
    {
        const auto us = static_cast<std::uint64_t>(
            std::max<std::int64_t>(0, std::chrono::duration_cast<Microseconds>(duration).count()));
        ++m_buckets[bucketOf(us)];
        ++m_count;
        m_maximum = std::max(m_maximum, us);
    }

    // Returns the smallest duration that `share` (0..1) of the counted ones do not exceed, rounded up to the
    // end of its bucket. Returns 0 when none was counted.
    [[nodiscard]] Microseconds percentile(double share) const
    {
        const double wanted = share * static_cast<double>(m_count);
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < m_buckets.size(); ++i) {
            sum += m_buckets[i];
            if (sum > 0 && static_cast<double>(sum) >= wanted)
                return Microseconds{static_cast<std::int64_t>(std::min(endOf(i), m_maximum))};
        }
        return Microseconds{0};
    }

    [[nodiscard]] Microseconds maximum() const { return Microseconds{static_cast<std::int64_t>(m_maximum)}; }
    [[nodiscard]] std::uint64_t count() const { return m_count; }

    LatencyHistogram& operator+=(const LatencyHistogram& other)
    {
        for (std::size_t i = 0; i < m_buckets.size(); ++i)
            m_buckets[i] += other.m_buckets[i];
        m_count += other.m_count;
        m_maximum = std::max(m_maximum, other.m_maximum);
        return *this;
    }

private:
    static constexpr unsigned stepBits = 4;     // 16 buckets per octave
    static constexpr unsigned shortestBits = 6; // 64 us
    static constexpr unsigned octaves = 18;

    static constexpr std::size_t bucketOf(std::uint64_t us)
    {
        const auto octave = static_cast<unsigned>(std::bit_width(us | 1u) - 1);
        if (octave < shortestBits)
            return 0;
        if (octave >= shortestBits + octaves)
            return bucketCount - 1;
        const auto step = static_cast<std::size_t>(us >> (octave - stepBits)) & ((1u << stepBits) - 1u);
        return (static_cast<std::size_t>(octave - shortestBits) << stepBits) + step;
    }

    // Returns the last duration of the bucket.
    static constexpr std::uint64_t endOf(std::size_t bucket)
    {
        if (bucket == bucketCount - 1)
            return UINT64_MAX;
        const auto octave = static_cast<unsigned>(bucket >> stepBits) + shortestBits;
        const std::uint64_t step = (bucket & ((1u << stepBits) - 1u)) + (1u << stepBits);
        return ((step + 1) << (octave - stepBits)) - 1;
    }

    static constexpr std::size_t bucketCount = std::size_t{octaves} << stepBits;

    std::array<std::uint32_t, bucketCount> m_buckets{};
    std::uint64_t m_count = 0;
    std::uint64_t m_maximum = 0;
};

} // namespace campanel::modbus
