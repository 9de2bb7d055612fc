// SPDX-License-Identifier: Apache-2.0
// Finds the time spans of an exceeded limit by bisection between the extrema of speed or acceleration.
#include "profile/model/limit_check.h"

#include "profile/model/law.h"

#include <cmath>
#include <limits>

namespace campanel::profile::detail {
namespace {

// The distance below which two spans are joined.
constexpr double joinedS = 1e-9;

bool exceeds(double actual, double limit)
{
    return actual > limit + limitTolerance * std::abs(limit);
}

// Returns the elapsed time of the extremum of the speed's parabola, when it is inside.
double vertexS(const Segment& cubic)
{
    return -cubic.startAccelerationMmPerS2 / cubic.jerkMmPerS3;
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
template <typename CutterQuantity>
void appendBrokenSpan(std::vector<TimeSpan>& spans, double fromS, double toS, double limit,
                      CutterQuantity quantity)
{
    const auto isOver = [&](double timeS) { return exceeds(std::abs(quantity(timeS)), limit); };
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

std::vector<TimeSpan> brokenSpans(const MotionProfile& motion, const LimitComparison& comparison)
{
    const double allowed = comparison.allowedInMotion;
    std::vector<TimeSpan> spans;
    if (comparison.bounded == Bounded::Rate)
        return spans;
    if (comparison.bounded == Bounded::Window)
        return {comparison.window};
    if (allowed < 0)
        return {{0, motion.durationS()}}; // friction alone
    const bool isAcceleration = comparison.bounded == Bounded::Acceleration;
    for (const Segment& segment : motion.segments()) {
        const auto quantity = [&](double timeS) {
            const MotionPoint p = segment.at(timeS);
            return isAcceleration ? p.accelerationMmPerS2 : p.velocityMmPerS;
        };
        const std::vector<double> turns = isAcceleration ? accelerationTurns(segment) : speedTurns(segment);
        for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
            const double fromS = turns[i];
            const double toS = turns[i + 1];
            const double sign = quantity(fromS) > 0 ? 1 : -1;
            if (quantity(fromS) * quantity(toS) >= 0) {
                appendBrokenSpan(spans, fromS, toS, allowed, quantity);
                continue;
            }
            // The magnitude has its minimum where the quantity is zero, possibly for some time.
            const auto hasFirstSign = [&](double timeS) { return sign * quantity(timeS) > 0; };
            const auto hasLastSign = [&](double timeS) { return sign * quantity(timeS) < 0; };
            appendBrokenSpan(spans, fromS, lastTrueS(fromS, toS, hasFirstSign), allowed, quantity);
            appendBrokenSpan(spans, lastTrueS(toS, fromS, hasLastSign), toS, allowed, quantity);
        }
    }
    return spans;
}

} // namespace

bool hasAcceleration(const Segment& segment)
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

std::vector<double> speedTurns(const Segment& s)
{
    if (s.form == SegmentForm::Displacement && hasAcceleration(s))
        return {s.startS, s.startS + s.law->peaks(s.parameters).cvAt * s.durationS, s.endS()};
    if (s.form == SegmentForm::Cubic && vertexS(s) > 0 && vertexS(s) < s.durationS)
        return {s.startS, s.startS + vertexS(s), s.endS()};
    return {s.startS, s.endS()};
}

// A displacement law is symmetric: it has extrema at caAt and at 1 - caAt.
std::vector<double> accelerationTurns(const Segment& s)
{
    if (!hasAcceleration(s) || s.form == SegmentForm::Cubic)
        return {s.startS, s.endS()};
    const LawPeaks law = s.law->peaks(s.parameters);
    if (s.form == SegmentForm::Ramp)
        return {s.startS, s.startS + (s.isMirrored ? 1 - law.cvAt : law.cvAt) * s.durationS, s.endS()};
    return {s.startS, s.startS + law.caAt * s.durationS, s.endS() - law.caAt * s.durationS, s.endS()};
}

LimitComparison compareRmsTorque(const Peaks& peaks, const Machine& machine)
{
    const double allowed =
        machine.ratedTorqueNm > 0 ? machine.ratedTorqueNm : std::numeric_limits<double>::max();
    return {Limit::RmsTorque, Field::RatedTorque, peaks.rmsTorqueNm, allowed, Bounded::Rate, allowed};
}

bool isBroken(const LimitComparison& c, const Peaks& peaks)
{
    switch (c.bounded) {
    case Bounded::Speed:
        return exceeds(peaks.speedMmPerS, c.allowedInMotion);
    case Bounded::Acceleration:
        return exceeds(peaks.accelerationMmPerS2, c.allowedInMotion);
    case Bounded::Window:
        return exceeds(c.allowed, c.actual);
    case Bounded::Rate:
        break;
    }
    return exceeds(c.actual, c.allowed);
}

std::vector<Refusal> brokenLimits(std::span<const LimitComparison> comparisons, const MotionProfile& motion,
                                  const Peaks& peaks)
{
    std::vector<Refusal> broken;
    for (const LimitComparison& c : comparisons) {
        if (!isBroken(c, peaks))
            continue;
        Refusal refusal;
        refusal.limit = c.limit;
        refusal.field = c.field;
        refusal.actual = c.actual;
        refusal.allowed = c.allowed;
        refusal.unit = info(c.field).unit;
        if (c.bounded == Bounded::Window)
            refusal.timeS = c.window.fromS;
        else if (c.bounded != Bounded::Rate)
            refusal.timeS = c.bounded == Bounded::Speed ? peaks.speedTimeS : peaks.accelerationTimeS;
        refusal.brokenDuring = brokenSpans(motion, c);
        broken.push_back(std::move(refusal));
    }
    return broken;
}

} // namespace campanel::profile::detail
