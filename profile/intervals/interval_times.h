// SPDX-License-Identifier: Apache-2.0
// One interval of constant acceleration as the paper's CamMov gives it: its row for the accumulators, and
// when each of its pulses comes.
#pragma once

#include "profile/intervals/intervals.h"

#include <tl/expected.hpp>
#include <vector>

namespace campanel::profile {

struct ScaledInterval {
    IntervalRow row;
    int fractionBits = 0;
};

// Speeds in pulses/s, acceleration in pulses/s^2 without its sign; all above zero. Refuses what does not fit
// the registers (TableRange).
[[nodiscard]] tl::expected<ScaledInterval, Refusal> intervalRow(std::uint32_t pulses, double firstHz,
                                                                double lastHz, double accelerationHzPerS,
                                                                IntervalMode mode);

// Times of the pulses in s from the beginning, by the generator's own arithmetic: both accumulators begin at
// 0.
[[nodiscard]] std::vector<double> pulseTimesS(const IntervalRow& row, int fractionBits);

// Time of the last pulse of the ideal motion: constant acceleration to the last speed, then that speed.
[[nodiscard]] double intervalTheoryS(std::uint32_t pulses, double firstHz, double lastHz,
                                     double accelerationHzPerS);

} // namespace campanel::profile
