// SPDX-License-Identifier: Apache-2.0
// Evaluation of a profile. A mirrored ramp is the law reversed in time, which is right for asymmetric laws as
// well: v(x) = v0 + (v1 - v0) (1 - g(1 - x)), and its travel uses G(1) - G(1 - x).
#include "profile/motion_profile.h"

#include <algorithm>
#include <cmath>

namespace campanel::profile {

MotionPoint Segment::at(double timeS) const
{
    const double elapsed = timeS - startS;
    if (law == nullptr || durationS <= 0)
        return {startPositionMm + startVelocityMmPerS * elapsed, startVelocityMmPerS, 0, 0};
    const double change = endVelocityMmPerS - startVelocityMmPerS;
    const double x = std::clamp(elapsed / durationS, 0.0, 1.0);
    const LawPoint p = law->at(isMirrored ? 1 - x : x, parameters);
    const double acceleration = change / durationS * p.g1;
    const double jerk = change / (durationS * durationS) * p.g2;
    if (!isMirrored) {
        return {startPositionMm + startVelocityMmPerS * elapsed + change * durationS * p.integral,
                startVelocityMmPerS + change * p.g, acceleration, jerk};
    }
    const double whole = law->isSymmetric ? 0.5 : law->at(1, parameters).integral;
    return {startPositionMm + endVelocityMmPerS * elapsed - change * durationS * (whole - p.integral),
            endVelocityMmPerS - change * p.g, acceleration, -jerk};
}

void MotionProfile::append(Segment segment)
{
    if (!m_segments.empty()) {
        const Segment& last = m_segments.back();
        segment.startS = last.endS();
        segment.startPositionMm = last.at(last.endS()).positionMm;
    }
    m_segments.push_back(segment);
}

void MotionProfile::addConstant(double durationS, double velocityMmPerS)
{
    Segment segment;
    segment.durationS = durationS;
    segment.startVelocityMmPerS = velocityMmPerS;
    segment.endVelocityMmPerS = velocityMmPerS;
    append(segment);
}

void MotionProfile::addRamp(double durationS, double fromMmPerS, double toMmPerS, const Law& law,
                            const LawParameters& parameters, bool isMirrored)
{
    Segment segment;
    segment.durationS = durationS;
    segment.startVelocityMmPerS = fromMmPerS;
    segment.endVelocityMmPerS = toMmPerS;
    segment.law = &law;
    segment.parameters = parameters;
    segment.isMirrored = isMirrored;
    append(segment);
}

double MotionProfile::durationS() const
{
    return m_segments.empty() ? 0 : m_segments.back().endS();
}

MotionPoint MotionProfile::at(double timeS) const
{
    if (m_segments.empty())
        return {};
    const double time = std::clamp(timeS, 0.0, durationS());
    const auto next = std::upper_bound(m_segments.begin() + 1, m_segments.end(), time,
                                       [](double t, const Segment& segment) { return t < segment.startS; });
    return (next - 1)->at(time);
}

double MotionProfile::timeAt(double positionMm, double guessS) const
{
    constexpr double positionToleranceMm = 1e-9;
    constexpr double timeToleranceS = 1e-10;
    constexpr int maxSteps = 100;
    double low = 0;
    double high = durationS();
    double time = std::clamp(guessS, low, high);
    // Newton's method, halving the bracket whenever a step leaves it or the speed is zero.
    for (int step = 0; step < maxSteps && high - low > timeToleranceS; ++step) {
        const MotionPoint p = at(time);
        const double ahead = p.positionMm - positionMm;
        if (std::abs(ahead) <= positionToleranceMm)
            break;
        (ahead > 0 ? high : low) = time;
        const double next = p.velocityMmPerS > 0 ? time - ahead / p.velocityMmPerS : low;
        const double previous = time;
        time = next > low && next < high ? next : (low + high) / 2;
        if (std::abs(time - previous) <= timeToleranceS)
            break;
    }
    return time;
}

} // namespace campanel::profile
