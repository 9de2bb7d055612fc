// SPDX-License-Identifier: Apache-2.0
// Computes peaks from Cv, Ca and Cj of each segment's law.
#include "profile/model/axis_motion.h"

#include "profile/model/bounds.h"
#include "profile/model/torque.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace campanel::profile {
namespace {

using detail::accelerationTurns;
using detail::Bounded;
using detail::hasAcceleration;
using detail::LimitComparison;
using detail::speedTurns;

constexpr double inf = std::numeric_limits<double>::infinity();
// The share of the peak below which differences of acceleration or speed are rounding.
constexpr double stepTolerance = 1e-6;
// Replaces the peak only by a really larger one, so that the first of equal peaks is named.
void takeLarger(double& peak, double& peakTimeS, double candidate, double timeS)
{
    raise(peak, peakTimeS, candidate, timeS, detail::limitTolerance);
}

void takeSpeeds(Peaks& peaks, const Segment& segment)
{
    for (const double timeS : speedTurns(segment))
        takeLarger(peaks.speedMmPerS, peaks.speedTimeS, segment.at(timeS).velocityMmPerS, timeS);
}

void takeAccelerations(Peaks& peaks, const Segment& s)
{
    if (!hasAcceleration(s))
        return;
    const auto take = [&peaks](double acceleration, double timeS, double jerk) {
        takeLarger(peaks.accelerationMmPerS2, peaks.accelerationTimeS, acceleration, timeS);
        peaks.jerkMmPerS3 = maxOf(peaks.jerkMmPerS3, std::abs(jerk));
    };
    if (s.form == SegmentForm::Polynomial) {
        for (const double timeS : accelerationTurns(s))
            take(s.at(timeS).accelerationMmPerS2, timeS, s.at(timeS).jerkMmPerS3);
        const double jerkVertexS = -s.snapMmPerS4 / s.crackleMmPerS5;
        if (jerkVertexS > 0 && jerkVertexS < s.durationS)
            take(0, s.startS, s.at(s.startS + jerkVertexS).jerkMmPerS3);
        return;
    }
    const LawPeaks law = s.law->peaks(s.parameters);
    if (s.form == SegmentForm::Displacement && s.lawTo - s.lawFrom < 1) {
        const double lawS = s.lawDurationS();
        for (const double timeS : accelerationTurns(s))
            take(s.at(timeS).accelerationMmPerS2, timeS, s.distanceMm / (lawS * lawS * lawS) * law.cj);
        return;
    }
    const double peakTimeS = accelerationTurns(s)[1];
    if (s.form == SegmentForm::Ramp) {
        const double mean = (s.endVelocityMmPerS - s.startVelocityMmPerS) / s.durationS;
        take(mean * law.cv, peakTimeS, mean / s.durationS * law.ca);
    } else {
        const double perSquare = s.distanceMm / (s.durationS * s.durationS);
        take(perSquare * law.ca, peakTimeS, perSquare / s.durationS * law.cj);
    }
}

bool hasAccelerationStep(const MotionProfile& motion, const Peaks& peaks)
{
    const auto segments = motion.segments();
    const double room = stepTolerance * peaks.accelerationMmPerS2;
    for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
        const double before = segments[i].at(segments[i].endS()).accelerationMmPerS2;
        const double after = segments[i + 1].at(segments[i + 1].startS).accelerationMmPerS2;
        if (std::abs(after - before) > room)
            return true;
    }
    const MotionPoint first = segments.front().at(segments.front().startS);
    const MotionPoint last = segments.back().at(segments.back().endS());
    const bool mayRepeat =
        std::abs(last.accelerationMmPerS2 - first.accelerationMmPerS2) <= room &&
        std::abs(last.velocityMmPerS - first.velocityMmPerS) <= stepTolerance * peaks.speedMmPerS;
    return !mayRepeat &&
           maxOf(std::abs(first.accelerationMmPerS2), std::abs(last.accelerationMmPerS2)) > room;
}

std::array<LimitComparison, 5> compareAxis(const Peaks& peaks, const Machine& m)
{
    const double pulses = pulseFrequencyLimitHz(m);
    return {{{Limit::MotorSpeed, Field::MaxMotorRpm, peaks.motorRpm, m.maxMotorRpm, Bounded::Speed,
              m.maxMotorRpm / axisRpmPerMmPerS(m)},
             {Limit::AxisAcceleration, Field::MaxAcceleration, peaks.accelerationMmPerS2,
              m.maxAccelerationMmPerS2, Bounded::Acceleration, m.maxAccelerationMmPerS2},
             detail::compareTorque(peaks, m, axisLoad(m)),
             detail::compareRmsTorque(peaks, m),
             {Limit::PulseFrequency, Field::MaxPulseFrequency, peaks.pulseFrequencyHz, pulses, Bounded::Speed,
              pulses / axisPulsesPerMm(m)}}};
}

} // namespace

AxisAllowance axisAllowance(const Machine& machine)
{
    const TorqueLoad load = axisLoad(machine);
    return {minOf(machine.maxMotorRpm / axisRpmPerMmPerS(machine),
                  pulseFrequencyLimitHz(machine) / axisPulsesPerMm(machine)),
            minOf(machine.maxAccelerationMmPerS2, load.speedingAllowance(machine.maxTorqueNm)),
            minOf(machine.maxAccelerationMmPerS2, load.slowingAllowance(machine.maxTorqueNm))};
}

AccelerationExtremes accelerationExtremes(const MotionProfile& motion)
{
    AccelerationExtremes extremes;
    for (const Segment& segment : motion.segments()) {
        for (const detail::DirectedPart& part : detail::directedParts(segment)) {
            if (part.direction == 0)
                continue;
            const double first = part.direction * segment.at(part.fromS).accelerationMmPerS2;
            const double last = part.direction * segment.at(part.toS).accelerationMmPerS2;
            extremes.add(first, part.fromS);
            extremes.add(last, part.toS);
            if (first * last < 0)
                extremes.add(0, part.fromS);
        }
    }
    return extremes;
}

Peaks axisPeaks(const MotionProfile& motion, const Machine& machine)
{
    Peaks peaks;
    if (motion.segments().empty())
        return peaks;
    for (const Segment& segment : motion.segments()) {
        takeSpeeds(peaks, segment);
        takeAccelerations(peaks, segment);
    }
    peaks.motorRpm = peaks.speedMmPerS * axisRpmPerMmPerS(machine);
    peaks.pulseFrequencyHz = peaks.speedMmPerS * axisPulsesPerMm(machine);
    const TorqueLoad load = axisLoad(machine);
    if (load.isKnown())
        peaks.extremes = accelerationExtremes(motion);
    const TorquePeak torque = load.peak(peaks.extremes);
    peaks.torqueNm = torque.nm;
    peaks.torqueTimeS = torque.timeS;
    peaks.rmsTorqueNm = load.isKnown() ? load.rmsNm(torqueMeans(motion)) : load.rmsNm({});
    if (hasAccelerationStep(motion, peaks))
        peaks.jerkMmPerS3 = inf;
    return peaks;
}

std::vector<Refusal> checkAxis(const MotionProfile& motion, const Peaks& peaks, const Machine& machine)
{
    return detail::brokenLimits(compareAxis(peaks, machine), motion, peaks);
}

bool isWithinLimits(const Peaks& peaks, const Machine& machine)
{
    const auto compared = compareAxis(peaks, machine);
    return std::none_of(compared.begin(), compared.end(),
                        [&peaks](const LimitComparison& c) { return detail::isBroken(c, peaks); });
}

} // namespace campanel::profile
