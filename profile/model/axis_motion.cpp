// SPDX-License-Identifier: Apache-2.0
// Computes peaks from Cv, Ca and Cj of each segment's law. Finds the time spans of an exceeded limit by
// bisection between the extrema of speed or acceleration.
#include "profile/model/axis_motion.h"

#include "profile/model/limit_tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace campanel::profile {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
// The share of the peak below which differences of acceleration or speed are rounding.
constexpr double stepTolerance = 1e-6;
// The distance below which two spans are joined.
constexpr double joinedS = 1e-9;

bool exceedsAllowance(double actual, double limit)
{
    return actual > limit + detail::limitTolerance * std::abs(limit);
}

// Replaces the peak only by a really larger one, so that the first of equal peaks is named.
void takeLarger(double& peak, double& peakTimeS, double candidate, double timeS)
{
    if (std::abs(candidate) > peak * (1 + detail::limitTolerance)) {
        peak = std::abs(candidate);
        peakTimeS = timeS;
    }
}

bool isMoving(const Segment& segment)
{
    switch (segment.form) {
    case SegmentForm::Ramp:
        return segment.durationS > 0 && segment.startVelocityMmPerS != segment.endVelocityMmPerS;
    case SegmentForm::Displacement:
        return segment.durationS > 0 && segment.distanceMm != 0;
    case SegmentForm::Cubic:
        return segment.durationS > 0;
    case SegmentForm::Constant:
        break;
    }
    return false;
}

// Returns the elapsed time of the extremum of the speed's parabola, when it is inside.
double vertexS(const Segment& cubic)
{
    return -cubic.startAccelerationMmPerS2 / cubic.jerkMmPerS3;
}

// Returns the times between which the speed is monotone, including the ends.
std::vector<double> speedTurns(const Segment& s)
{
    if (s.form == SegmentForm::Displacement && isMoving(s))
        return {s.startS, s.startS + s.law->peaks(s.parameters).cvAt * s.durationS, s.endS()};
    if (s.form == SegmentForm::Cubic && vertexS(s) > 0 && vertexS(s) < s.durationS)
        return {s.startS, s.startS + vertexS(s), s.endS()};
    return {s.startS, s.endS()};
}

// Returns the times between which the acceleration is monotone. A displacement law is symmetric: it has
// extrema at caAt and at 1 - caAt.
std::vector<double> accelerationTurns(const Segment& s)
{
    if (!isMoving(s) || s.form == SegmentForm::Cubic)
        return {s.startS, s.endS()};
    const LawPeaks law = s.law->peaks(s.parameters);
    if (s.form == SegmentForm::Ramp)
        return {s.startS, s.startS + (s.isMirrored ? 1 - law.cvAt : law.cvAt) * s.durationS, s.endS()};
    return {s.startS, s.startS + law.caAt * s.durationS, s.endS() - law.caAt * s.durationS, s.endS()};
}

void takeSpeeds(AxisPeaks& peaks, const Segment& segment)
{
    for (const double timeS : speedTurns(segment))
        takeLarger(peaks.speedMmPerS, peaks.speedTimeS, segment.at(timeS).velocityMmPerS, timeS);
}

void takeAccelerations(AxisPeaks& peaks, const Segment& s)
{
    if (!isMoving(s))
        return;
    const auto take = [&peaks](double acceleration, double timeS, double jerk) {
        takeLarger(peaks.accelerationMmPerS2, peaks.accelerationTimeS, acceleration, timeS);
        peaks.jerkMmPerS3 = std::max(peaks.jerkMmPerS3, std::abs(jerk));
    };
    if (s.form == SegmentForm::Cubic) {
        take(s.startAccelerationMmPerS2, s.startS, s.jerkMmPerS3);
        take(s.startAccelerationMmPerS2 + s.jerkMmPerS3 * s.durationS, s.endS(), s.jerkMmPerS3);
        return;
    }
    const LawPeaks law = s.law->peaks(s.parameters);
    const double peakTimeS = accelerationTurns(s)[1];
    if (s.form == SegmentForm::Ramp) {
        const double mean = (s.endVelocityMmPerS - s.startVelocityMmPerS) / s.durationS;
        take(mean * law.cv, peakTimeS, mean / s.durationS * law.ca);
    } else {
        const double perSquare = s.distanceMm / (s.durationS * s.durationS);
        take(perSquare * law.ca, peakTimeS, perSquare / s.durationS * law.cj);
    }
}

bool hasAccelerationStep(const MotionProfile& motion, const AxisPeaks& peaks)
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
           std::max(std::abs(first.accelerationMmPerS2), std::abs(last.accelerationMmPerS2)) > room;
}

struct AxisComparison {
    Limit limit;
    Field field; // the machine's limit
    double actual;
    double allowed;
    bool isAcceleration;    // selects one of the two quantities below
    double allowedInMotion; // the limit as a speed, mm/s, or an acceleration, mm/s^2
};

double torqueAllowance(const Machine& machine)
{
    const double left = machine.maxTorqueNm - machine.frictionNm;
    const double perAcceleration = axisTorqueNm(machine, 1) - axisTorqueNm(machine, 0);
    if (perAcceleration > 0)
        return left / perAcceleration;
    return left >= 0 ? std::numeric_limits<double>::max() : std::numeric_limits<double>::lowest();
}

// Compares in the motion's own quantity, like the spans: beside a large friction a small torque would be lost
// in the tolerance.
bool isBroken(const AxisComparison& c, const AxisPeaks& peaks)
{
    return exceedsAllowance(c.isAcceleration ? peaks.accelerationMmPerS2 : peaks.speedMmPerS,
                            c.allowedInMotion);
}

std::array<AxisComparison, 4> compareAxis(const AxisPeaks& peaks, const Machine& m)
{
    const double pulses = pulseFrequencyLimitHz(m);
    return {{{Limit::MotorSpeed, Field::MaxMotorRpm, peaks.motorRpm, m.maxMotorRpm, false,
              m.maxMotorRpm / axisRpmPerMmPerS(m)},
             {Limit::AxisAcceleration, Field::MaxAcceleration, peaks.accelerationMmPerS2,
              m.maxAccelerationMmPerS2, true, m.maxAccelerationMmPerS2},
             {Limit::MotorTorque, Field::MaxTorque, peaks.torqueNm, m.maxTorqueNm, true, torqueAllowance(m)},
             {Limit::PulseFrequency, Field::MaxPulseFrequency, peaks.pulseFrequencyHz, pulses, false,
              pulses / axisPulsesPerMm(m)}}};
}

// Returns the last time from `trueS` towards `falseS` at which the condition holds.
template <typename Condition> double lastTrueS(double trueS, double falseS, Condition condition)
{
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (trueS + falseS) / 2;
        (condition(middle) ? trueS : falseS) = middle;
    }
    return trueS;
}

// Appends the part of [fromS, toS] above the limit; |quantity| must be monotone there.
template <typename Quantity>
void appendBrokenAxisSpan(std::vector<TimeSpan>& spans, double fromS, double toS, double limit,
                          Quantity quantity)
{
    const auto isOver = [&](double timeS) { return exceedsAllowance(std::abs(quantity(timeS)), limit); };
    const bool startBroken = isOver(fromS);
    const bool endBroken = isOver(toS);
    if ((!startBroken && !endBroken) || !(toS > fromS))
        return;
    TimeSpan span{fromS, toS};
    if (!endBroken)
        span.toS = lastTrueS(fromS, toS, isOver);
    if (!startBroken)
        span.fromS = lastTrueS(toS, fromS, isOver);
    if (!spans.empty() && span.fromS - spans.back().toS <= joinedS)
        spans.back().toS = span.toS;
    else
        spans.push_back(span);
}

std::vector<TimeSpan> brokenAxisSpans(const MotionProfile& motion, const AxisComparison& comparison)
{
    const double allowed = comparison.allowedInMotion;
    if (allowed < 0)
        return {{0, motion.durationS()}}; // friction alone
    std::vector<TimeSpan> spans;
    for (const Segment& segment : motion.segments()) {
        const auto quantity = [&](double timeS) {
            const MotionPoint p = segment.at(timeS);
            return comparison.isAcceleration ? p.accelerationMmPerS2 : p.velocityMmPerS;
        };
        const std::vector<double> turns =
            comparison.isAcceleration ? accelerationTurns(segment) : speedTurns(segment);
        for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
            const double fromS = turns[i];
            const double toS = turns[i + 1];
            const double sign = quantity(fromS) > 0 ? 1 : -1;
            if (quantity(fromS) * quantity(toS) >= 0) {
                appendBrokenAxisSpan(spans, fromS, toS, allowed, quantity);
                continue;
            }
            // The magnitude has its minimum where the quantity is zero, possibly for some time.
            const auto hasFirstSign = [&](double timeS) { return sign * quantity(timeS) > 0; };
            const auto hasLastSign = [&](double timeS) { return sign * quantity(timeS) < 0; };
            appendBrokenAxisSpan(spans, fromS, lastTrueS(fromS, toS, hasFirstSign), allowed, quantity);
            appendBrokenAxisSpan(spans, lastTrueS(toS, fromS, hasLastSign), toS, allowed, quantity);
        }
    }
    return spans;
}

} // namespace

AxisAllowance axisAllowance(const Machine& machine)
{
    return {std::min(machine.maxMotorRpm / axisRpmPerMmPerS(machine),
                     pulseFrequencyLimitHz(machine) / axisPulsesPerMm(machine)),
            std::min(machine.maxAccelerationMmPerS2, torqueAllowance(machine))};
}

AxisPeaks axisPeaks(const MotionProfile& motion, const Machine& machine)
{
    AxisPeaks peaks;
    if (motion.segments().empty())
        return peaks;
    for (const Segment& segment : motion.segments()) {
        takeSpeeds(peaks, segment);
        takeAccelerations(peaks, segment);
    }
    peaks.motorRpm = peaks.speedMmPerS * axisRpmPerMmPerS(machine);
    peaks.pulseFrequencyHz = peaks.speedMmPerS * axisPulsesPerMm(machine);
    peaks.torqueNm = axisTorqueNm(machine, peaks.accelerationMmPerS2);
    if (hasAccelerationStep(motion, peaks))
        peaks.jerkMmPerS3 = inf;
    return peaks;
}

std::vector<Refusal> checkAxis(const MotionProfile& motion, const AxisPeaks& peaks, const Machine& machine)
{
    std::vector<Refusal> broken;
    for (const AxisComparison& c : compareAxis(peaks, machine)) {
        if (!isBroken(c, peaks))
            continue;
        Refusal refusal;
        refusal.limit = c.limit;
        refusal.field = c.field;
        refusal.actual = c.actual;
        refusal.allowed = c.allowed;
        refusal.unit = info(c.field).unit;
        refusal.timeS = c.isAcceleration ? peaks.accelerationTimeS : peaks.speedTimeS;
        refusal.brokenDuring = brokenAxisSpans(motion, c);
        broken.push_back(std::move(refusal));
    }
    return broken;
}

bool isWithinLimits(const AxisPeaks& peaks, const Machine& machine)
{
    const auto compared = compareAxis(peaks, machine);
    return std::none_of(compared.begin(), compared.end(),
                        [&peaks](const AxisComparison& c) { return isBroken(c, peaks); });
}

} // namespace campanel::profile
