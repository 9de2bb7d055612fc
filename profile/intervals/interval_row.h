// SPDX-License-Identifier: Apache-2.0
// One interval of constant acceleration as the two cascaded accumulators of the controller take it, and the
// accumulators' arithmetic in closed form: what the controller does is computed here, not approximated.
#pragma once

#include <cstdint>

namespace campanel::profile {

// Speeds and acceleration count 2^-fraction bits pulses/s and pulses/s^2 at 2^23 iterations per second. The
// speed goes from the first to the last one; what is left of the distance then passes at the last one.
struct IntervalRow {
    std::uint32_t pulses = 0;
    std::uint32_t firstSpeed = 0;
    std::uint32_t lastSpeed = 0;
    std::uint32_t acceleration = 0; // without its sign

    bool operator==(const IntervalRow&) const = default;
};

namespace detail {

inline constexpr int accumulatorBits = 23;
inline constexpr double realIterationS = 6 / 50e6; // 6 clocks of 50 MHz

// Iterations until the row has its last speed.
[[nodiscard]] std::uint64_t rampIterations(const IntervalRow& row);
// Speed register after so many iterations of the row.
[[nodiscard]] std::uint64_t speedAfter(const IntervalRow& row, std::uint64_t iterations);
// Position accumulator after so many iterations, in 2^-(23 + fraction bits) pulses; `rest` is what it began
// with.
[[nodiscard]] std::uint64_t positionAfter(const IntervalRow& row, std::uint64_t rest,
                                          std::uint64_t iterations);

struct RowEnd {
    std::uint64_t iterations = 0;
    std::uint64_t rest = 0; // of the position accumulator, for the next row
};
// The iteration that brings the row's last pulse.
[[nodiscard]] RowEnd rowEnd(const IntervalRow& row, std::uint64_t rest, int fractionBits);

} // namespace detail

} // namespace campanel::profile
