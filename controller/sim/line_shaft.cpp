// SPDX-License-Identifier: Apache-2.0
#include "line_shaft.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace campanel::controller {
namespace {

// Returns a number from -1 to 1 that belongs to an edge of the encoder.
double scatterOf(std::int64_t edge)
{
    auto bits = static_cast<std::uint64_t>(edge) * 0x9E3779B97F4A7C15u;
    bits = (bits ^ (bits >> 32u)) * 0xD6E8FEB86659FD93u;
    return static_cast<double>(static_cast<std::int64_t>(bits ^ (bits >> 32u))) / 9.223372036854775808e18;
}

} // namespace

LineShaft::LineShaft(const ShaftOptions& options)
    : m_options(options)
    , m_evenMmPerS(options.speedMmPerS)
    , m_targetMmPerS(options.speedMmPerS)
    , m_speedMmPerS(options.speedMmPerS)
{
}

double LineShaft::swingAt(double timeS) const
{
    constexpr double turn = 2.0 * std::numbers::pi;
    return 1.0 + m_options.ripple * std::sin(turn * m_options.rippleHz * timeS) +
           m_options.wave * std::sin(turn * timeS / m_options.wavePeriodS);
}

// By Simpson's rule, which is exact enough for steps of some milliseconds; a ramp that ends within the step
// divides it.
void LineShaft::advance(double stepS)
{
    if (m_evenMmPerS == 0.0 && m_targetMmPerS == 0.0) {
        m_speedMmPerS = 0.0;
        m_timeS += stepS;
        return;
    }
    const double turnsBefore = turns();
    const std::int64_t edgesBefore = m_options.noise > 0.0 ? edges() : 0;
    while (stepS > 0.0) {
        const double missing = m_targetMmPerS - m_evenMmPerS;
        const double rampS = std::abs(missing) / m_options.accelerationMmPerS2;
        const double partS = rampS > 0.0 ? std::min(rampS, stepS) : stepS;
        const double gained = rampS > 0.0 ? missing * (partS / rampS) : 0.0;
        const double middle = (m_evenMmPerS + gained / 2.0) * swingAt(m_timeS + partS / 2.0);
        const double end = (m_evenMmPerS + gained) * swingAt(m_timeS + partS);
        m_positionMm += partS / 6.0 * (m_evenMmPerS * swingAt(m_timeS) + 4.0 * middle + end);
        m_evenMmPerS = partS == rampS ? m_targetMmPerS : m_evenMmPerS + gained;
        m_speedMmPerS = end;
        m_timeS += partS;
        stepS -= partS;
    }
    passIndex(turnsBefore);
    if (m_options.noise > 0.0)
        passNoise(edgesBefore);
}

void LineShaft::setSpeed(double mmPerS)
{
    m_targetMmPerS = mmPerS;
    m_options.speedMmPerS = mmPerS;
}

void LineShaft::setReversed(bool isReversed)
{
    const std::int64_t counted = counts();
    m_edgesBefore = edges() - m_lost;
    m_countsBefore = counted;
    m_options.isReversed = isReversed;
}

void LineShaft::setSlip(double share)
{
    m_turnedMm = turns() * m_options.revolutionMm;
    m_slipFromMm = m_positionMm;
    m_options.slip = share;
}

double LineShaft::turns() const
{
    return (m_turnedMm + (m_positionMm - m_slipFromMm) * (1.0 - m_options.slip)) / m_options.revolutionMm;
}

std::int64_t LineShaft::edges() const
{
    const double exact = turns() * m_options.counts;
    const auto edge = static_cast<std::int64_t>(std::floor(exact));
    return static_cast<std::int64_t>(
        std::floor(exact + (m_options.jitterCounts > 0.0 ? m_options.jitterCounts * scatterOf(edge) : 0.0)));
}

std::int64_t LineShaft::countsAt(std::int64_t edges) const
{
    const std::int64_t counted = edges - m_lost - m_edgesBefore;
    return m_countsBefore + (m_options.isReversed ? -counted : counted);
}

std::int64_t LineShaft::counts() const
{
    return countsAt(edges());
}

// The mark is at each whole revolution; counts are lost before it.
void LineShaft::passIndex(double before)
{
    const double now = std::floor(turns());
    const double passes = now - std::floor(before);
    if (passes == 0.0)
        return;
    m_lost += static_cast<std::int64_t>(passes) * m_options.lost;
    m_indexPasses += static_cast<std::uint32_t>(std::abs(passes));
    m_indexCounts = countsAt(std::llround(passes > 0.0 ? now : now + 1.0) * m_options.counts);
}

// A decoder counts nothing where both signals change at once.
void LineShaft::passNoise(std::int64_t before)
{
    const std::int64_t now = edges();
    const std::int64_t step = now < before ? -1 : 1;
    for (std::int64_t edge = before; edge != now; edge += step) {
        if (std::abs(scatterOf(edge)) >= m_options.noise)
            continue;
        ++m_errors;
        m_lost += step;
    }
}

} // namespace campanel::controller
