// SPDX-License-Identifier: Apache-2.0
// One interval of constant acceleration for the two cascaded accumulators of the controller, and their
// arithmetic in closed form. The result is exactly what the controller does, not an approximation.
#pragma once

#include <cstdint>

namespace campanel::profile {

// Speeds and acceleration are in 2^-fractionBits pulses/s and pulses/s^2 at 2^23 iterations per second. The
// speed changes from the first to the last one; the remaining distance passes at the last speed.
struct IntervalRow {
    std::uint32_t pulses = 0;
    std::uint32_t firstSpeed = 0;
    std::uint32_t lastSpeed = 0;
    std::uint32_t acceleration = 0; // magnitude

    bool operator==(const IntervalRow&) const = default;
};

namespace detail {

inline constexpr int accumulatorBits = 23;
inline constexpr double realIterationS = 6 / 50e6; // 6 clocks of 50 MHz

// Returns the number of iterations until the row reaches its last speed.
[[nodiscard]] std::uint64_t rampIterations(const IntervalRow& row);
// Returns the position accumulator after this number of iterations, in 2^-(23 + fractionBits) pulses; `rest`
// is its initial value.
[[nodiscard]] std::uint64_t positionAfter(const IntervalRow& row, std::uint64_t rest,
                                          std::uint64_t iterations);

struct RowEnd {
    std::uint64_t iterations = 0;
    std::uint64_t rest = 0; // remainder of the position accumulator, for the next row
};
// Returns the iteration of the row's last pulse, and the remainder.
[[nodiscard]] RowEnd rowEnd(const IntervalRow& row, std::uint64_t rest, int fractionBits);

} // namespace detail

} // namespace campanel::profile
