// SPDX-License-Identifier: Apache-2.0
#include "profile/intervals/speed_curve.h"

#include "profile/model/bounds.h"

#include <algorithm>
#include <cmath>

namespace campanel::profile::detail {

namespace {

constexpr int minSamples = 16;     // per segment
constexpr double restShare = 1e-9; // share of the maximum speed

CurveSample sampleOf(const MotionPoint& p, double timeS, double startMm, double pulsesPerMm)
{
    const double jerk = p.velocityMmPerS < 0 ? -p.jerkMmPerS3 : p.jerkMmPerS3;
    CurveSample sample;
    sample.timeS = timeS;
    sample.pulses = std::abs(p.positionMm - startMm) * pulsesPerMm;
    sample.speedHz = std::abs(p.velocityMmPerS) * pulsesPerMm;
    sample.bend = jerk;
    return sample;
}

struct TimeSpanS {
    double from = 0;
    double to = 0;
};

// Narrows a span that has a step of the acceleration down to the step.
TimeSpanS stepWithin(const Segment& segment, TimeSpanS span)
{
    constexpr int halvings = 40;
    double before = segment.at(span.from).accelerationMmPerS2;
    double after = segment.at(span.to).accelerationMmPerS2;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (span.from + span.to) / 2;
        if (middle <= span.from || middle >= span.to)
            break;
        const double here = segment.at(middle).accelerationMmPerS2;
        if (std::abs(here - before) > std::abs(here - after)) {
            span.to = middle;
            after = here;
        } else {
            span.from = middle;
            before = here;
        }
    }
    return span;
}

// Sets the bends: the sign of the jerk unless it is rounding.
void makeBends(std::vector<CurveSample>& samples)
{
    constexpr double roundingShare = 1e-9;
    double largest = 0;
    for (const CurveSample& sample : samples)
        largest = maxOf(largest, std::abs(sample.bend));
    for (CurveSample& sample : samples)
        sample.bend = std::abs(sample.bend) <= roundingShare * largest ? 0 : (sample.bend > 0 ? 1 : -1);
}

// Returns the pulses between two samples, by the cubic with their speeds.
double hermite(const CurveSample& a, const CurveSample& b, double timeS)
{
    const double h = b.timeS - a.timeS;
    const double x = (timeS - a.timeS) / h;
    const double d = b.pulses - a.pulses;
    return a.pulses + x * (h * a.speedHz + x * ((3 * d - h * (2 * a.speedHz + b.speedHz)) +
                                                x * (h * (a.speedHz + b.speedHz) - 2 * d)));
}

} // namespace

double jerkBound(const Segment& segment)
{
    const double t = segment.durationS;
    if (t <= 0 || segment.form == SegmentForm::Constant)
        return 0;
    if (segment.form == SegmentForm::Polynomial)
        return std::abs(segment.jerkMmPerS3) + std::abs(segment.snapMmPerS4) * t +
               std::abs(segment.crackleMmPerS5) * t * t / 2;
    const LawPeaks peaks = segment.law->peaks(segment.parameters);
    if (segment.form == SegmentForm::Ramp)
        return std::abs(segment.endVelocityMmPerS - segment.startVelocityMmPerS) / (t * t) * peaks.ca;
    // Laws with steps of the acceleration have a constant acceleration between them.
    const double lawS = segment.lawDurationS();
    return std::isfinite(peaks.cj) ? std::abs(segment.distanceMm) / (lawS * lawS * lawS) * peaks.cj : 0;
}

void SpeedCurve::sample(const Segment& segment, int pieces, double startMm, double pulsesPerMm)
{
    constexpr double roundingShare = 1e-6;
    const double pieceS = segment.durationS / pieces;
    const double jerk = jerkBound(segment);
    const double bulgeHz = jerk * pieceS * pieceS / 8 * pulsesPerMm;
    const auto add = [&](double timeS) {
        const MotionPoint p = segment.at(timeS);
        m_samples.push_back(sampleOf(p, timeS, startMm, pulsesPerMm));
        m_steepestHzPerS = maxOf(m_steepestHzPerS, std::abs(p.accelerationMmPerS2) * pulsesPerMm);
        m_samples.back().bulgeHz = bulgeHz;
    };
    double before = segment.at(segment.startS).accelerationMmPerS2;
    m_corners.push_back(m_samples.size());
    add(segment.startS);
    for (int i = 1; i <= pieces; ++i) {
        const TimeSpanS span{m_samples.back().timeS, segment.startS + segment.durationS * i / pieces};
        const double after = segment.at(span.to).accelerationMmPerS2;
        const double change = std::abs(after - before);
        if (change > 1.01 * jerk * pieceS + roundingShare * (std::abs(after) + std::abs(before))) {
            const TimeSpanS step = stepWithin(segment, span);
            for (const double timeS : {step.from, step.to}) {
                if (timeS > m_samples.back().timeS && timeS < span.to)
                    add(timeS);
            }
            m_corners.push_back(m_samples.size() - 1);
        }
        add(span.to);
        before = after;
    }
}

// Stores the sample at or before each of evenly spaced times.
void SpeedCurve::fillNearby()
{
    m_nearby.resize(m_samples.size());
    std::size_t sample = 0;
    for (std::size_t i = 0; i < m_nearby.size(); ++i) {
        const double timeS = durationS() * static_cast<double>(i) / static_cast<double>(m_nearby.size());
        while (sample + 1 < m_samples.size() && m_samples[sample + 1].timeS <= timeS)
            ++sample;
        m_nearby[i] = sample;
    }
}

SpeedCurve::SpeedCurve(const MotionProfile& motion, double pulsesPerMm, int sampleCount)
{
    const double duration = motion.durationS();
    const double startMm = motion.at(0).positionMm;
    for (const Segment& segment : motion.segments()) {
        if (segment.durationS > 0)
            sample(segment, maxOf(minSamples, static_cast<int>(sampleCount * segment.durationS / duration)),
                   startMm, pulsesPerMm);
    }
    if (m_samples.empty())
        m_samples.push_back({});
    makeBends(m_samples);
    fillNearby();
    const double pulses = m_samples.back().pulses;
    m_wholePulses = std::llround(pulses);
    for (const CurveSample& sample : m_samples)
        m_fastestHz = maxOf(m_fastestHz, sample.speedHz);
    m_restHz = restShare * m_fastestHz;
    if (m_wholePulses == 0 || !endsAtRest())
        return;
    m_stretch = static_cast<double>(m_wholePulses) / pulses;
    m_fastestHz *= m_stretch;
    for (CurveSample& sample : m_samples) {
        sample.pulses *= m_stretch;
        sample.speedHz *= m_stretch;
        sample.bulgeHz *= m_stretch;
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
    const double share = timeS / durationS() * static_cast<double>(m_nearby.size());
    const auto place =
        static_cast<std::size_t>(clamped(share, 0.0, static_cast<double>(m_nearby.size() - 1)));
    std::size_t i = m_nearby[place];
    while (i > 0 && m_samples[i].timeS > timeS)
        --i;
    while (i + 1 < m_samples.size() && m_samples[i + 1].timeS <= timeS)
        ++i;
    return i;
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
    return a.speedHz + (b.speedHz - a.speedHz) * clamped((timeS - a.timeS) / (b.timeS - a.timeS), 0.0, 1.0);
}

} // namespace campanel::profile::detail
