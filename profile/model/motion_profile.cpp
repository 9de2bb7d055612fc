// SPDX-License-Identifier: Apache-2.0
// Evaluates a profile. A mirrored ramp is the law reversed in time, also valid for asymmetric laws: v(x) = v0
// + (v1 - v0) (1 - g(1 - x)), and its travel uses G(1) - G(1 - x).
#include "profile/model/motion_profile.h"

#include "profile/model/bounds.h"

#include <algorithm>
#include <cmath>

namespace campanel::profile {

namespace {

MotionPoint rampAt(const Segment& segment, double elapsedS)
{
    const double duration = segment.durationS;
    const double change = segment.endVelocityMmPerS - segment.startVelocityMmPerS;
    const double x = clamped(elapsedS / duration, 0.0, 1.0);
    const LawPoint p = segment.law->at(segment.isMirrored ? 1 - x : x, segment.parameters);
    const double acceleration = change / duration * p.g1;
    const double jerk = change / (duration * duration) * p.g2;
    if (!segment.isMirrored) {
        return {segment.startPositionMm + segment.startVelocityMmPerS * elapsedS +
                    change * duration * p.integral,
                segment.startVelocityMmPerS + change * p.g, acceleration, jerk};
    }
    const double whole = segment.law->isSymmetric ? 0.5 : segment.law->at(1, segment.parameters).integral;
    return {segment.startPositionMm + segment.endVelocityMmPerS * elapsedS -
                change * duration * (whole - p.integral),
            segment.endVelocityMmPerS - change * p.g, acceleration, -jerk};
}

MotionPoint displacementAt(const Segment& segment, double elapsedS)
{
    const double duration = segment.lawDurationS();
    const double from = segment.lawFrom;
    const double x = clamped(from + elapsedS / duration, from, segment.lawTo);
    const LawPoint p = segment.law->at(x, segment.parameters);
    const double passed = from > 0 ? p.g - segment.law->at(from, segment.parameters).g : p.g;
    return {segment.startPositionMm + segment.startVelocityMmPerS * elapsedS + segment.distanceMm * passed,
            segment.startVelocityMmPerS + segment.distanceMm / duration * p.g1,
            segment.distanceMm / (duration * duration) * p.g2,
            segment.distanceMm / (duration * duration * duration) * p.g3};
}

MotionPoint polynomialPoint(const Segment& segment, double t)
{
    const double v0 = segment.startVelocityMmPerS;
    const double a0 = segment.startAccelerationMmPerS2;
    const double j0 = segment.jerkMmPerS3;
    const double s0 = segment.snapMmPerS4;
    const double c = segment.crackleMmPerS5;
    return {segment.startPositionMm + t * (v0 + t * (a0 / 2 + t * (j0 / 6 + t * (s0 / 24 + t * c / 120)))),
            v0 + t * (a0 + t * (j0 / 2 + t * (s0 / 6 + t * c / 24))),
            a0 + t * (j0 + t * (s0 / 2 + t * c / 6)), j0 + t * (s0 + t * c / 2)};
}

} // namespace

MotionPoint Segment::at(double timeS) const
{
    const double elapsed = timeS - startS;
    if (form == SegmentForm::Polynomial)
        return polynomialPoint(*this, elapsed);
    if (form == SegmentForm::Ramp && durationS > 0)
        return rampAt(*this, elapsed);
    if (form == SegmentForm::Displacement && durationS > 0)
        return displacementAt(*this, elapsed);
    return {startPositionMm + startVelocityMmPerS * elapsed, startVelocityMmPerS, 0, 0};
}

void MotionProfile::append(Segment segment)
{
    segment.startPositionMm = m_startPositionMm;
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
    segment.form = SegmentForm::Ramp;
    segment.durationS = durationS;
    segment.startVelocityMmPerS = fromMmPerS;
    segment.endVelocityMmPerS = toMmPerS;
    segment.law = &law;
    segment.parameters = parameters;
    segment.isMirrored = isMirrored;
    append(segment);
}

void MotionProfile::addDisplacement(double durationS, double distanceMm, const Law& law,
                                    const LawParameters& parameters, double velocityMmPerS)
{
    Segment segment;
    segment.form = SegmentForm::Displacement;
    segment.durationS = durationS;
    segment.startVelocityMmPerS = velocityMmPerS;
    segment.endVelocityMmPerS = velocityMmPerS;
    segment.distanceMm = distanceMm;
    segment.law = &law;
    segment.parameters = parameters;
    append(segment);
}

void MotionProfile::addCubic(double durationS, double velocityMmPerS, double accelerationMmPerS2,
                             double jerkMmPerS3)
{
    Segment segment;
    segment.form = SegmentForm::Polynomial;
    segment.durationS = durationS;
    segment.startVelocityMmPerS = velocityMmPerS;
    segment.startAccelerationMmPerS2 = accelerationMmPerS2;
    segment.jerkMmPerS3 = jerkMmPerS3;
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
    const double time = clamped(timeS, 0.0, durationS());
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
    double time = clamped(guessS, low, high);
    // Newton's method with bisection whenever a step leaves the bracket or the speed is zero.
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
