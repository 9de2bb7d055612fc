// SPDX-License-Identifier: Apache-2.0
#include "profile/intervals/interval_times.h"

#include <cmath>
#include <limits>

namespace campanel::profile {
namespace {

// The factor by which the generator's clock is too slow: 2^23 iterations take this many seconds.
const double clockFactor = std::ldexp(1.0, detail::accumulatorBits) * detail::realIterationS;
constexpr int correctedBits = 8;

} // namespace

tl::expected<ScaledInterval, Refusal> intervalRow(std::uint32_t pulses, double firstHz, double lastHz,
                                                  double accelerationHzPerS, IntervalMode mode)
{
    const bool isCorrected = mode == IntervalMode::Corrected;
    const double k = isCorrected ? clockFactor : 1;
    ScaledInterval scaled;
    scaled.fractionBits = isCorrected ? correctedBits : 0;
    const double unit = std::ldexp(1.0, scaled.fractionBits);
    const double first = std::round(firstHz * k * unit);
    const double last = std::round(lastHz * k * unit);
    const double acceleration = std::round(accelerationHzPerS * k * k * unit);
    constexpr double maxRaw = std::numeric_limits<std::uint32_t>::max();
    for (const double value : {first, last, acceleration}) {
        if (value >= 1 && value <= maxRaw)
            continue;
        Refusal refusal;
        refusal.limit = Limit::TableRange;
        refusal.actual = value;
        refusal.allowed = maxRaw;
        return tl::unexpected(refusal);
    }
    scaled.row = {pulses, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last),
                  static_cast<std::uint32_t>(acceleration)};
    return scaled;
}

std::vector<double> pulseTimesS(const IntervalRow& row, int fractionBits)
{
    std::vector<double> times;
    times.reserve(row.pulses);
    IntervalRow part = row;
    for (part.pulses = 1; part.pulses <= row.pulses; ++part.pulses)
        times.push_back(static_cast<double>(detail::rowEnd(part, 0, fractionBits).iterations) *
                        detail::realIterationS);
    return times;
}

double intervalTheoryS(std::uint32_t pulses, double firstHz, double lastHz, double accelerationHzPerS)
{
    const double rampS = std::abs(lastHz - firstHz) / accelerationHzPerS;
    const double rampPulses = rampS * (firstHz + lastHz) / 2;
    return rampS + (pulses - rampPulses) / lastHz;
}

} // namespace campanel::profile
