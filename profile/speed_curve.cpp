// SPDX-License-Identifier: Apache-2.0
#include "profile/speed_curve.h"

#include <algorithm>
#include <cmath>

namespace campanel::profile::detail {

namespace {

constexpr int totalSamples = 1024;
constexpr int leastSamples = 16; // of a stretch
// Slower than this at the end is rest.
constexpr double restShare = 1e-9;

CurveSample sampleOf(const Segment& segment, double timeS, double startMm, double pulsesPerMm)
{
    const MotionPoint p = segment.at(timeS);
    const double jerk = p.velocityMmPerS < 0 ? -p.jerkMmPerS3 : p.jerkMmPerS3;
    return {timeS, std::abs(p.positionMm - startMm) * pulsesPerMm, std::abs(p.velocityMmPerS) * pulsesPerMm,
            jerk};
}

// Of the jerk, its sign where it is more than rounding.
void makeBends(std::vector<CurveSample>& samples)
{
    constexpr double roundingShare = 1e-9;
    double largest = 0;
    for (const CurveSample& sample : samples)
        largest = std::max(largest, std::abs(sample.bend));
    for (CurveSample& sample : samples)
        sample.bend = std::abs(sample.bend) <= roundingShare * largest ? 0 : (sample.bend > 0 ? 1 : -1);
}

// Pulses between two samples as the cubic with their speeds.
double hermite(const CurveSample& a, const CurveSample& b, double timeS)
{
    const double h = b.timeS - a.timeS;
    const double x = (timeS - a.timeS) / h;
    const double d = b.pulses - a.pulses;
    return a.pulses + x * (h * a.speedHz + x * ((3 * d - h * (2 * a.speedHz + b.speedHz)) +
                                                x * (h * (a.speedHz + b.speedHz) - 2 * d)));
}

} // namespace

SpeedCurve::SpeedCurve(const MotionProfile& motion, double pulsesPerMm)
{
    const double duration = motion.durationS();
    const double startMm = motion.at(0).positionMm;
    for (const Segment& segment : motion.segments()) {
        if (segment.durationS <= 0)
            continue;
        if (!m_samples.empty())
            m_joints.push_back(m_samples.size());
        const int pieces =
            std::max(leastSamples, static_cast<int>(totalSamples * segment.durationS / duration));
        for (int i = 0; i <= pieces; ++i) {
            const double time = segment.startS + segment.durationS * i / pieces;
            m_samples.push_back(sampleOf(segment, time, startMm, pulsesPerMm));
        }
    }
    if (m_samples.empty())
        m_samples.push_back({});
    makeBends(m_samples);
    const double pulses = m_samples.back().pulses;
    m_wholePulses = std::llround(pulses);
    const double fastest = std::ranges::max(m_samples, {}, &CurveSample::speedHz).speedHz;
    if (m_wholePulses == 0 || m_samples.back().speedHz > restShare * fastest)
        return;
    m_stretch = static_cast<double>(m_wholePulses) / pulses;
    for (CurveSample& sample : m_samples) {
        sample.pulses *= m_stretch;
        sample.speedHz *= m_stretch;
    }
}

double SpeedCurve::timeAt(std::int64_t pulses) const
{
    constexpr int maxSteps = 60;
    constexpr double tolerancePulses = 1e-9;
    const auto target = static_cast<double>(pulses);
    const CurveSample& last = m_samples.back();
    if (target >= last.pulses)
        return last.speedHz > 0 ? last.timeS + (target - last.pulses) / last.speedHz : last.timeS;
    const auto next = std::ranges::upper_bound(m_samples, target, {}, &CurveSample::pulses);
    if (next == m_samples.begin())
        return m_samples.front().timeS;
    const CurveSample& a = *(next - 1);
    const CurveSample& b = *next;
    double low = a.timeS;
    double high = b.timeS;
    double time = low + (high - low) * (target - a.pulses) / (b.pulses - a.pulses);
    for (int step = 0; step < maxSteps; ++step) {
        const double ahead = hermite(a, b, time) - target;
        if (std::abs(ahead) < tolerancePulses)
            break;
        (ahead > 0 ? high : low) = time;
        const double x = (time - a.timeS) / (b.timeS - a.timeS);
        const double speed = a.speedHz + (b.speedHz - a.speedHz) * x;
        const double newton = speed > 0 ? time - ahead / speed : low;
        time = newton > low && newton < high ? newton : (low + high) / 2;
    }
    return time;
}

std::size_t SpeedCurve::indexAt(double timeS) const
{
    const auto next = std::ranges::upper_bound(m_samples, timeS, {}, &CurveSample::timeS);
    return next == m_samples.begin() ? 0 : static_cast<std::size_t>(next - m_samples.begin()) - 1;
}

double SpeedCurve::speedAt(double timeS) const
{
    const std::size_t i = indexAt(timeS);
    if (i + 1 >= m_samples.size())
        return m_samples.back().speedHz;
    const CurveSample& a = m_samples[i];
    const CurveSample& b = m_samples[i + 1];
    if (b.timeS <= a.timeS)
        return b.speedHz;
    return a.speedHz +
           (b.speedHz - a.speedHz) * std::clamp((timeS - a.timeS) / (b.timeS - a.timeS), 0.0, 1.0);
}

} // namespace campanel::profile::detail
