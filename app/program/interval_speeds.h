// SPDX-License-Identifier: Apache-2.0
// Converts the numbers of an interval to real pulses/s at the generator's clock, for display.
#pragma once

#include "profile/intervals/interval_times.h"

#include <cmath>

namespace campanel::program {

struct IntervalSpeeds {
    double firstHz = 0;
    double lastHz = 0;
    double accelerationHzPerS = 0; // magnitude
    double timeS = 0;
};

// Returns the real speeds. The registers count 2^-fractionBits pulses/s at 2^23 iterations a second; the real
// rate is 50 MHz / 6.
[[nodiscard]] inline IntervalSpeeds speedsOf(const profile::IntervalRow& row, int fractionBits)
{
    const double iterations = std::ldexp(profile::detail::realIterationS, profile::detail::accumulatorBits);
    const double hz = std::ldexp(1.0, -fractionBits) / iterations;
    IntervalSpeeds speeds{row.firstSpeed * hz, row.lastSpeed * hz, row.acceleration * hz / iterations, 0};
    speeds.timeS =
        row.firstSpeed == row.lastSpeed
            ? row.pulses / speeds.lastHz
            : profile::intervalTheoryS(row.pulses, speeds.firstHz, speeds.lastHz, speeds.accelerationHzPerS);
    return speeds;
}

} // namespace campanel::program
