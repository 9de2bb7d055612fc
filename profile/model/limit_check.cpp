// SPDX-License-Identifier: Apache-2.0
// Finds the time spans of an exceeded limit by bisection between the extrema of speed or acceleration.
#include "profile/model/limit_check.h"

#include "profile/model/bounds.h"
#include "profile/model/law.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace campanel::profile::detail {
namespace {

// The distance below which two spans are joined.
constexpr double joinedS = 1e-9;

bool exceeds(double actual, double limit)
{
    return actual > limit + limitTolerance * std::abs(limit);
}

// Compares the accelerations, see isBroken().
bool exceedsTorque(const LimitComparison& c, const AccelerationExtremes& e)
{
    const double slowing = c.load.slowingAllowance(c.allowed);
    const double left = c.load.frictionNm - c.load.nmPerMmPerS2 * e.leastMmPerS2; // of the friction
    return (e.speedingMmPerS2 > 0 && exceeds(e.speedingMmPerS2, c.allowedInMotion)) ||
           exceeds(e.slowingMmPerS2, slowing) ||
           (c.load.isKnown() && c.allowed > 0 && exceeds(left, c.allowed));
}

// Returns the elapsed times inside the polynomial at which its acceleration has an extremum, ascending.
std::vector<double> accelerationVerticesS(const Segment& s)
{
    const double a = s.crackleMmPerS5 / 2;
    const double b = s.snapMmPerS4;
    const double c = s.jerkMmPerS3;
    const double discriminant = b * b - 4 * a * c;
    if ((a == 0 && b == 0) || discriminant < 0)
        return {};
    const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    std::vector<double> times;
    for (const double t : {a == 0 ? -1 : q / a, q == 0 ? -1 : c / q}) {
        if (t > 0 && t < s.durationS)
            times.push_back(t);
    }
    std::ranges::sort(times);
    return times;
}

// Returns the elapsed times inside the polynomial at which its acceleration is zero, ascending.
std::vector<double> accelerationZerosS(const Segment& s)
{
    if (s.snapMmPerS4 == 0 && s.crackleMmPerS5 == 0) {
        const double t = -s.startAccelerationMmPerS2 / s.jerkMmPerS3;
        return t > 0 && t < s.durationS ? std::vector{t} : std::vector<double>{};
    }
    std::vector<double> bounds{0};
    for (const double t : accelerationVerticesS(s))
        bounds.push_back(t);
    bounds.push_back(s.durationS);
    const auto accelerationAt = [&s](double t) { return s.at(s.startS + t).accelerationMmPerS2; };
    std::vector<double> zeros;
    for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
        double low = bounds[i];
        double high = bounds[i + 1];
        const double sign = accelerationAt(low) > 0 ? 1 : -1;
        if (accelerationAt(low) * accelerationAt(high) >= 0)
            continue;
        constexpr int halvings = 60;
        for (int step = 0; step < halvings; ++step) {
            const double middle = (low + high) / 2;
            (sign * accelerationAt(middle) > 0 ? low : high) = middle;
        }
        zeros.push_back(high);
    }
    return zeros;
}

// Returns the start, the given elapsed times and the end.
std::vector<double> withEnds(const Segment& s, const std::vector<double>& elapsedS)
{
    std::vector<double> times{s.startS};
    for (const double t : elapsedS)
        times.push_back(s.startS + t);
    times.push_back(s.endS());
    return times;
}

// Returns the elapsed times of those places of the law that the segment covers.
std::vector<double> lawTimesS(const Segment& s, std::initializer_list<double> places)
{
    std::vector<double> times;
    for (const double x : places) {
        if (x >= s.lawFrom && x <= s.lawTo)
            times.push_back((x - s.lawFrom) * s.lawDurationS());
    }
    return times;
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

// Appends the parts of [fromS, toS] at which the magnitude of a monotone quantity exceeds the limit.
template <typename Quantity>
void appendBrokenSpans(std::vector<TimeSpan>& spans, double fromS, double toS, double limit,
                       Quantity quantity)
{
    const double sign = quantity(fromS) > 0 ? 1 : -1;
    if (quantity(fromS) * quantity(toS) >= 0) {
        appendBrokenSpan(spans, fromS, toS, limit, quantity);
        return;
    }
    // The magnitude has its minimum where the quantity is zero, possibly for some time.
    const auto hasFirstSign = [&](double timeS) { return sign * quantity(timeS) > 0; };
    const auto hasLastSign = [&](double timeS) { return sign * quantity(timeS) < 0; };
    appendBrokenSpan(spans, fromS, lastTrueS(fromS, toS, hasFirstSign), limit, quantity);
    appendBrokenSpan(spans, lastTrueS(toS, fromS, hasLastSign), toS, limit, quantity);
}

std::vector<TimeSpan> torqueSpans(const MotionProfile& motion, const LimitComparison& comparison)
{
    const TorqueLoad& load = comparison.load;
    std::vector<TimeSpan> spans;
    for (const Segment& segment : motion.segments()) {
        for (const DirectedPart& part : directedParts(segment)) {
            const auto torqueNm = [&](double timeS) {
                return load.at(part.direction, segment.at(timeS).accelerationMmPerS2);
            };
            appendBrokenSpans(spans, part.fromS, part.toS, comparison.allowed, torqueNm);
        }
    }
    return spans;
}

std::vector<TimeSpan> brokenSpans(const MotionProfile& motion, const LimitComparison& comparison)
{
    const double allowed = comparison.allowedInMotion;
    std::vector<TimeSpan> spans;
    if (comparison.bounded == Bounded::Rate)
        return spans;
    if (comparison.bounded == Bounded::Window)
        return {comparison.window};
    if (comparison.bounded == Bounded::Torque)
        return torqueSpans(motion, comparison);
    const bool isAcceleration = comparison.bounded == Bounded::Acceleration;
    for (const Segment& segment : motion.segments()) {
        const auto quantity = [&](double timeS) {
            const MotionPoint p = segment.at(timeS);
            return isAcceleration ? p.accelerationMmPerS2 : p.velocityMmPerS;
        };
        const std::vector<double> turns = isAcceleration ? accelerationTurns(segment) : speedTurns(segment);
        for (std::size_t i = 0; i + 1 < turns.size(); ++i)
            appendBrokenSpans(spans, turns[i], turns[i + 1], allowed, quantity);
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
    case SegmentForm::Polynomial:
        return segment.durationS > 0;
    case SegmentForm::Constant:
        break;
    }
    return false;
}

std::vector<double> speedTurns(const Segment& s)
{
    if (s.form == SegmentForm::Displacement && hasAcceleration(s))
        return withEnds(s, lawTimesS(s, {s.law->peaks(s.parameters).cvAt}));
    if (s.form == SegmentForm::Polynomial)
        return withEnds(s, accelerationZerosS(s));
    return {s.startS, s.endS()};
}

// A displacement law is symmetric: it has extrema at caAt and at 1 - caAt.
std::vector<double> accelerationTurns(const Segment& s)
{
    if (!hasAcceleration(s))
        return {s.startS, s.endS()};
    if (s.form == SegmentForm::Polynomial)
        return withEnds(s, accelerationVerticesS(s));
    const LawPeaks law = s.law->peaks(s.parameters);
    if (s.form == SegmentForm::Ramp)
        return {s.startS, s.startS + (s.isMirrored ? 1 - law.cvAt : law.cvAt) * s.durationS, s.endS()};
    return withEnds(s, lawTimesS(s, {law.caAt, 1 - law.caAt}));
}

std::vector<DirectedPart> directedParts(const Segment& s)
{
    constexpr double roundingShare = 1e-9; // of the larger speed: a reversal below it is none
    const auto speedAt = [&s](double timeS) { return s.at(timeS).velocityMmPerS; };
    std::vector<double> ends = accelerationTurns(s);
    const std::vector<double> turns = speedTurns(s);
    for (std::size_t i = 0; i + 1 < turns.size(); ++i) {
        const double first = speedAt(turns[i]);
        const double last = speedAt(turns[i + 1]);
        const double larger = maxOf(std::abs(first), std::abs(last));
        if (first * last >= 0 || minOf(std::abs(first), std::abs(last)) <= roundingShare * larger)
            continue;
        const auto hasFirstSign = [&](double timeS) { return speedAt(timeS) * first > 0; };
        ends.push_back(lastTrueS(turns[i], turns[i + 1], hasFirstSign));
    }
    std::ranges::sort(ends);
    std::vector<DirectedPart> parts;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double speed = speedAt((ends[i] + ends[i + 1]) / 2);
        if (ends[i + 1] > ends[i])
            parts.push_back({ends[i], ends[i + 1], speed > 0 ? 1.0 : speed < 0 ? -1.0 : 0.0});
    }
    return parts;
}

LimitComparison compareTorque(const Peaks& peaks, const Machine& machine, const TorqueLoad& load)
{
    return {Limit::MotorTorque,
            Field::MaxTorque,
            peaks.torqueNm,
            machine.maxTorqueNm,
            Bounded::Torque,
            load.speedingAllowance(machine.maxTorqueNm),
            {},
            load};
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
    case Bounded::Torque:
        return exceedsTorque(c, peaks.extremes);
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
            refusal.timeS = c.bounded == Bounded::Speed    ? peaks.speedTimeS
                            : c.bounded == Bounded::Torque ? peaks.torqueTimeS
                                                           : peaks.accelerationTimeS;
        refusal.brokenDuring = brokenSpans(motion, c);
        broken.push_back(std::move(refusal));
    }
    return broken;
}

} // namespace campanel::profile::detail
