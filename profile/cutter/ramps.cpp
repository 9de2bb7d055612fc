// SPDX-License-Identifier: Apache-2.0
// Each limit is a shortest cycle time as a function of the ramp; the best ramp is an end of their range, the
// minimum of one or the crossing of two.
#include "profile/cutter/ramps.h"

#include "profile/model/bounds.h"

#include <cmath>

namespace campanel::profile {
namespace {

constexpr int rampBisections = 60; // to the precision of a double

double remaining(const RampTask& task)
{
    return 1 - task.window; // S
}

double change(const RampTask& task)
{
    return std::abs(task.filmMm - task.strokeMm); // D
}

// Returns the longest ramp with v_a >= 0, which is infinite for a bag shorter than the stroke.
double longestBeforeReversal(const RampTask& task)
{
    if (task.filmMm <= task.strokeMm)
        return std::numeric_limits<double>::infinity();
    return (task.strokeMm / task.filmMm - task.window) / (2 * task.lawTravel);
}

// Returns the square of the shortest cycle time, s^2, that keeps the peak acceleration with this ramp.
double squareTimeByAcceleration(const RampTask& task, double ramp)
{
    return task.lawPeak * change(task) /
           (task.maxAccelerationMmPerS2 * ramp * (remaining(task) - 2 * task.lawTravel * ramp));
}

// Returns the square of the shortest cycle time, s^2, that keeps the RMS acceleration with this ramp:
// a_rms = sqrt(2 I2 / tau) D / ((S - 2 G tau) T^2).
double squareTimeByRms(const RampTask& task, double ramp)
{
    return std::sqrt(2 * task.lawSquare / ramp) * change(task) /
           (task.maxRmsAccelerationMmPerS2 * (remaining(task) - 2 * task.lawTravel * ramp));
}

// Shortens the range to the ramps that keep the RMS acceleration, which has one minimum at the coolest.
std::optional<RampRange> withinRms(RampRange range, const RampTask& task)
{
    const double square = task.cycleTimeS * task.cycleTimeS;
    const double coolest = clamped(coolestRamp(task), range.shortest, range.longest);
    if (!(squareTimeByRms(task, coolest) <= square))
        return std::nullopt;
    for (double* end : {&range.shortest, &range.longest}) {
        double kept = coolest;
        for (int i = 0; i < rampBisections && squareTimeByRms(task, *end) > square; ++i) {
            const double middle = (kept + *end) / 2;
            (squareTimeByRms(task, middle) <= square ? kept : *end) = middle;
        }
        if (squareTimeByRms(task, *end) > square)
            *end = kept;
    }
    return range;
}

// Returns the root of a rising function between a place where it is negative and one where it is positive, by
// the Illinois method.
template <typename Function> double risingRoot(double low, double high, Function function)
{
    constexpr double precision = 1e-15; // of a share of the cycle
    double atLow = function(low);
    double atHigh = function(high);
    double root = low;
    int side = 0;
    for (int i = 0; i < rampBisections; ++i) {
        const double next = (low * atHigh - high * atLow) / (atHigh - atLow);
        const bool isSame = std::abs(next - root) <= precision;
        root = next;
        const double value = function(root);
        if (isSame || value == 0)
            break;
        if (value < 0) {
            low = root;
            atLow = value;
            atHigh /= side < 0 ? 2 : 1;
            side = -1;
        } else {
            high = root;
            atHigh = value;
            atLow /= side > 0 ? 2 : 1;
            side = 1;
        }
    }
    return root;
}

} // namespace

double longestRamp(const RampTask& task)
{
    return remaining(task) / 2 - minCycleShare;
}

double gentlestRamp(const RampTask& task)
{
    return minOf(longestRamp(task), remaining(task) / (4 * task.lawTravel));
}

double coolestRamp(const RampTask& task)
{
    return minOf(longestRamp(task), remaining(task) / (6 * task.lawTravel));
}

std::optional<RampRange> possibleRamps(const RampTask& task)
{
    const double s = remaining(task);
    const double g = task.lawTravel;
    const double least = // the product tau (S - 2 G tau) of the largest acceleration
        task.lawPeak * change(task) / (task.maxAccelerationMmPerS2 * task.cycleTimeS * task.cycleTimeS);
    const double discriminant = s * s - 8 * g * least;
    const double travel = task.maxSpeedMmPerS * task.cycleTimeS;
    if (!(discriminant >= 0) || task.filmMm > travel)
        return std::nullopt;
    const double root = std::sqrt(discriminant);
    RampRange range{maxOf(minCycleShare, 2 * least / (s + root)),
                    minOf(longestRamp(task), (s + root) / (4 * g), longestBeforeReversal(task))};
    if (task.filmMm < task.strokeMm && task.filmMm < travel)
        range.longest =
            minOf(range.longest, ((travel - task.strokeMm) / (travel - task.filmMm) - task.window) / (2 * g));
    if (!(range.shortest <= range.longest))
        return std::nullopt;
    return std::isfinite(task.maxRmsAccelerationMmPerS2) ? withinRms(range, task) : std::optional(range);
}

double fastestRamp(const RampTask& task)
{
    const double longest = maxOf(minCycleShare, minOf(gentlestRamp(task), longestBeforeReversal(task)));
    // The functions are the squares of the shortest cycle times. That of the acceleration falls, that of a
    // bag shorter than the stroke rises with its base speed, that of the RMS acceleration falls to the
    // coolest ramp and rises behind it.
    const double g = task.lawTravel;
    const bool isRmsLimited = std::isfinite(task.maxRmsAccelerationMmPerS2);
    const auto byAcceleration = [&](double ramp) { return squareTimeByAcceleration(task, ramp); };
    const auto bySpeed = [&](double ramp) {
        if (task.filmMm >= task.strokeMm)
            return 0.0;
        const double weight = task.window + 2 * g * ramp;
        const double time = (task.strokeMm - task.filmMm * weight) / ((1 - weight) * task.maxSpeedMmPerS);
        return time * time;
    };
    const auto byRms = [&](double ramp) { return isRmsLimited ? squareTimeByRms(task, ramp) : 0; };
    if (byAcceleration(longest) >= maxOf(bySpeed(longest), byRms(longest)))
        return longest;
    // Acceleration and RMS acceleration are equal at (Cv a_rms / a_max)^2 / (2 I2); behind it the RMS
    // decides.
    double best = longest;
    if (isRmsLimited) {
        const double ratio = task.lawPeak * task.maxRmsAccelerationMmPerS2 / task.maxAccelerationMmPerS2;
        best =
            clamped(maxOf(ratio * ratio / (2 * task.lawSquare), coolestRamp(task)), minCycleShare, longest);
    }
    // Up to there one falls and the other rises. Their inverses are nearly straight.
    const auto difference = [&](double ramp) {
        return 1 / maxOf(byAcceleration(ramp), byRms(ramp)) - 1 / bySpeed(ramp);
    };
    if (!(bySpeed(best) > 0) || !(difference(best) > 0))
        return best;
    return difference(minCycleShare) < 0 ? risingRoot(minCycleShare, best, difference) : minCycleShare;
}

RampPair fastestRamps(const RampTask& task)
{
    const auto skewed = [&task](double skew) {
        RampTask each = task;
        each.maxAccelerationMmPerS2 *= 1 + skew;
        each.lawSquare /= 1 - skew * skew;
        return each;
    };
    // A larger skew lowers the acceleration of the ramp that speeds up, and raises the RMS acceleration.
    const auto isRmsLimited = [&](double skew) {
        const RampTask each = skewed(skew);
        const double ramp = fastestRamp(each);
        return squareTimeByRms(each, ramp) > squareTimeByAcceleration(each, ramp);
    };
    const double slowing = task.maxSlowingMmPerS2;
    const double speeding = task.maxAccelerationMmPerS2;
    double skew = speeding > 0 && slowing > speeding ? (slowing - speeding) / (slowing + speeding) : 0;
    if (skew > 0 && std::isfinite(task.maxRmsAccelerationMmPerS2) && isRmsLimited(skew)) {
        constexpr int halvings = 20;
        double low = 0;
        for (int i = 0; i < halvings; ++i) {
            const double middle = (low + skew) / 2;
            (isRmsLimited(middle) ? skew : low) = middle;
        }
    }
    return {fastestRamp(skewed(skew)), skew};
}

double rampFor(RatioMode mode, double positionPercent, const RampTask& task)
{
    const std::optional<RampRange> range = possibleRamps(task);
    if (!range)
        return fastestRamp(task);
    const double gentle = clamped(gentlestRamp(task), range->shortest, range->longest);
    const double cool = clamped(coolestRamp(task), range->shortest, range->longest);
    switch (mode) {
    case RatioMode::Cool:
        return cool;
    case RatioMode::Slow:
        return range->shortest;
    case RatioMode::Between: {
        const double position = clamped(positionPercent / 50, 0.0, 2.0); // 1: coolest
        return position <= 1 ? std::lerp(range->shortest, cool, position)
                             : std::lerp(cool, gentle, position - 1);
    }
    default:
        return gentle;
    }
}

} // namespace campanel::profile
