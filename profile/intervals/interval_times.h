// SPDX-License-Identifier: Apache-2.0
// One interval of constant acceleration as given by the paper's CamMov: its row for the accumulators, and the
// time of each pulse.
#pragma once

#include "profile/intervals/intervals.h"

#include <tl/expected.hpp>
#include <vector>

namespace campanel::profile {

struct ScaledInterval {
    IntervalRow row;
    int fractionBits = 0;
};

// Returns the row. Speeds are in pulses/s, the acceleration is a magnitude in pulses/s^2; all are above zero.
// Refuses values that do not fit the registers (TableRange).
[[nodiscard]] tl::expected<ScaledInterval, Refusal> intervalRow(std::uint32_t pulses, double firstHz,
                                                                double lastHz, double accelerationHzPerS,
                                                                IntervalMode mode);

// Returns the times of the pulses in s from the start, by the generator's arithmetic: both accumulators start
// at 0.
[[nodiscard]] std::vector<double> pulseTimesS(const IntervalRow& row, int fractionBits);

// Returns the time of the last pulse of the ideal motion: constant acceleration to the last speed, then that
// speed.
[[nodiscard]] double intervalTheoryS(std::uint32_t pulses, double firstHz, double lastHz,
                                     double accelerationHzPerS);

} // namespace campanel::profile
