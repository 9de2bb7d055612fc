// SPDX-License-Identifier: Apache-2.0
// Least squares of y = d v + k a by the normal equations; the covariance of (d, k) is the variance of a
// distance times the inverse of their matrix (C. F. Gauss, Theoria combinationis, 1823). The variance comes
// from the distances at constant speed, which the ramps do not disturb. Neighboring distances share a mark
// and its noise with opposite sign; in a ramp their v has the same sign, so that the true scatter is smaller.
// The pitch is known from the marks before a ramp: no ramp counts before `steadyMarks` of them. What biases
// d: an acceleration that changes within the 20 ms in which the controller measures it.
#include "app/program/dead_time_estimate.h"

#include <algorithm>
#include <cmath>

namespace campanel::program {

namespace {

constexpr double mmPerUm = 0.001;
constexpr int steadyMarks = 8;
constexpr double pitchGain = 0.1;
constexpr double noiseGain = 0.02;
constexpr double steadyMPerS = 0.005; // smaller changes of speed and
constexpr double steadyMPerS2 = 0.05; // accelerations are those of a correction
constexpr double farShare = 0.1;      // farther from the pitch, a mark is missing or false between
constexpr double forgetting = 0.997;  // a distance in a ramp; the last 300 count
constexpr double stepMs = 0.01;
constexpr double smallestMs = 0.02; // 0.03 mm at 1.5 m/s
constexpr double marginsApart = 2.0;
constexpr double driftMs = 0.2; // 0.3 mm at 1.5 m/s
constexpr double driftMarginsApart = 3.0;
constexpr double driftEndShare = 0.7;
constexpr double minDeterminant = 1e-12; // of the normal equations

} // namespace

std::optional<double> offeredMs(double foundMs, double marginMs, double presentMs)
{
    const double ms = std::clamp(std::round(foundMs / stepMs) * stepMs, 0.0, maxDeadTimeMs);
    const bool differs = std::abs(ms - presentMs) > std::max(marginsApart * marginMs, smallestMs);
    return differs ? std::optional(ms) : std::nullopt;
}

void DeadTimeEstimate::startFilm()
{
    m_before.reset();
    m_steady = 0;
}

void DeadTimeEstimate::take(const modbus::MarkEdge& edge)
{
    const bool follows = m_before && edge.number == m_before->number + 1;
    if (edge.verdict != modbus::MarkVerdict::Taken) {
        m_before.reset();
        return;
    }
    if (follows)
        takeGap(*m_before, edge);
    m_before = edge;
}

void DeadTimeEstimate::takeGap(const modbus::MarkEdge& before, const modbus::MarkEdge& edge)
{
    const double gapMm = static_cast<std::int32_t>(edge.filmUm - before.filmUm) * mmPerUm;
    // m/s x ms are mm. As seen without compensation:
    const double seenMm = gapMm + edge.deadMs * edge.speedMPerS - before.deadMs * before.speedMPerS;
    const double v = edge.speedMPerS - before.speedMPerS;
    const double a = edge.accelerationMPerS2 - before.accelerationMPerS2;
    const double fastest = std::max(std::abs(edge.accelerationMPerS2), std::abs(before.accelerationMPerS2));
    if (std::abs(v) < steadyMPerS && fastest < steadyMPerS2) {
        learnPitch(seenMm);
        return;
    }
    const double y = seenMm - m_pitchMm;
    if (m_steady < steadyMarks || std::abs(y) > farShare * m_pitchMm || std::abs(v) < steadyMPerS)
        return;
    m_vv = forgetting * m_vv + v * v;
    m_va = forgetting * m_va + v * a;
    m_aa = forgetting * m_aa + a * a;
    m_vy = forgetting * m_vy + v * y;
    m_ay = forgetting * m_ay + a * y;
    ++m_ramps;
}

void DeadTimeEstimate::learnPitch(double gapMm)
{
    const double y = gapMm - m_pitchMm;
    if (m_steady > 0 && std::abs(y) > farShare * m_pitchMm) {
        m_steady = 0; // another film, or a mark is missing between
        return;
    }
    ++m_steady;
    const double gain = std::max(pitchGain, 1.0 / m_steady);
    m_pitchMm += gain * y;
    if (m_steady > 1)
        m_noiseMm2 += std::max(noiseGain, 1.0 / (m_steady - 1)) * (y * y - m_noiseMm2);
}

std::optional<DeadTime> DeadTimeEstimate::estimate() const
{
    const double determinant = m_vv * m_aa - m_va * m_va;
    if (determinant < minDeterminant)
        return std::nullopt;
    DeadTime result;
    result.ms = (m_aa * m_vy - m_va * m_ay) / determinant;
    result.slipMm = (m_vv * m_ay - m_va * m_vy) / determinant;
    result.marginMs = std::sqrt(m_noiseMm2 * m_aa / determinant);
    result.ramps = m_ramps;
    return result.marginMs <= maxMarginMs ? std::optional(result) : std::nullopt;
}

std::optional<DeadTime> DeadTimeEstimate::drift(double enteredMs, bool isKnown) const
{
    const auto found = estimate();
    if (!found || enteredMs <= 0)
        return std::nullopt;
    const double limitMs = std::max(driftMs, driftMarginsApart * found->marginMs);
    const bool differs = std::abs(found->ms - enteredMs) > (isKnown ? driftEndShare : 1.0) * limitMs;
    return differs ? found : std::nullopt;
}

std::optional<double> DeadTimeEstimate::offered(double presentMs) const
{
    const auto found = estimate();
    return found ? offeredMs(found->ms, found->marginMs, presentMs) : std::nullopt;
}

} // namespace campanel::program
