// SPDX-License-Identifier: Apache-2.0
#include "profile/intervals/intervals.h"

#include "profile/intervals/interval_plan.h"
#include "profile/intervals/speed_curve.h"
#include "profile/model/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace campanel::profile {

namespace {

using detail::SpeedCurve;

constexpr double publishedIterationS = 1.0 / (1 << detail::accumulatorBits);
constexpr int maxFractionBits = 8;
constexpr int samplesPerStretch = 64; // to find a reversal
constexpr int samplesToCheck = 1024;

Refusal refusal(Limit limit, double actual, double allowed, std::string_view unit)
{
    Refusal result;
    result.limit = limit;
    result.field = Field::MaxPulseFrequency;
    result.actual = actual;
    result.allowed = allowed;
    result.unit = unit;
    return result;
}

// Returns the first time at which the motion has the opposite direction of the whole.
std::optional<Refusal> findReversal(const MotionProfile& motion, double direction)
{
    constexpr double roundingShare = 1e-9;
    double fastest = 0;
    std::optional<Refusal> result;
    for (const Segment& segment : motion.segments()) {
        for (int i = 0; i <= samplesPerStretch; ++i) {
            const double time = segment.startS + segment.durationS * i / samplesPerStretch;
            const double speed = segment.at(time).velocityMmPerS * direction;
            fastest = maxOf(fastest, speed);
            if (speed < -roundingShare * fastest && !result) {
                result = refusal(Limit::Reversal, speed * direction, 0, "mm/s");
                result->timeS = time;
            }
        }
    }
    return result;
}

// Returns as many bits as leave space in the acceleration's register for rows twice as steep as the curve.
int fractionBits(const SpeedCurve& curve)
{
    const double perBit =
        2 * curve.steepestHzPerS() * std::pow(detail::realIterationS / publishedIterationS, 2);
    int bits = maxFractionBits;
    while (bits > 0 && std::ldexp(perBit, bits) > std::numeric_limits<std::uint32_t>::max())
        --bits;
    return bits;
}

detail::RowRules rowRules(const SpeedCurve& curve, const Machine& machine, IntervalMode mode)
{
    const bool isPublished = mode == IntervalMode::Published;
    detail::RowRules rules;
    rules.iterationS = isPublished ? publishedIterationS : detail::realIterationS;
    rules.fractionBits = isPublished ? 0 : fractionBits(curve);
    rules.minHz = 1 / std::ldexp(rules.iterationS, detail::accumulatorBits + rules.fractionBits);
    rules.maxHz = pulseFrequencyLimitHz(machine);
    return rules;
}

// Rounds up, so that the displayed error can be kept as well.
double roundedUp(double error)
{
    constexpr int digits = 4;
    constexpr double margin = 1 + 1e-12;
    if (!std::isfinite(error))
        return error;
    const double unit = std::pow(10, std::floor(std::log10(error)) + 1 - digits);
    return std::ceil(error / unit * margin) * unit;
}

double timeOf(std::span<const IntervalRow> rows, int fractionBits)
{
    std::uint64_t iterations = 0;
    std::uint64_t rest = 0;
    for (const IntervalRow& row : rows) {
        const detail::RowEnd end = detail::rowEnd(row, rest, fractionBits);
        iterations += end.iterations;
        rest = end.rest;
    }
    return static_cast<double>(iterations) * detail::realIterationS;
}

} // namespace

tl::expected<IntervalTable, Refusal> compileIntervals(const MotionProfile& motion, const Machine& machine,
                                                      double speedErrorMmPerS, IntervalMode mode)
{
    const double pulsesPerMm = axisPulsesPerMm(machine);
    const double duration = motion.durationS();
    const double travel = motion.at(duration).positionMm - motion.at(0).positionMm;
    const double direction = travel < 0 ? -1 : 1;
    if (std::abs(travel) * pulsesPerMm < 1)
        return tl::unexpected(refusal(Limit::TooFewPulses, std::abs(travel) * pulsesPerMm, 1, "pulses"));
    if (const auto reversal = findReversal(motion, direction))
        return tl::unexpected(*reversal);

    const SpeedCurve curve(motion, pulsesPerMm, samplesToCheck);
    const double limitHz = pulseFrequencyLimitHz(machine);
    if (curve.fastestHz() / curve.stretch() > limitHz * (1 + 1e-9))
        return tl::unexpected(refusal(Limit::PulseFrequency, curve.fastestHz(), limitHz, "Hz"));
    constexpr double maxPulses = std::numeric_limits<std::int32_t>::max();
    if (static_cast<double>(curve.wholePulses()) > maxPulses)
        return tl::unexpected(
            refusal(Limit::TableRange, static_cast<double>(curve.wholePulses()), maxPulses, "pulses"));
    constexpr double maxTicks = std::numeric_limits<std::uint32_t>::max();
    if (duration * 1.01 * machine.timerClockHz > maxTicks)
        return tl::unexpected(refusal(Limit::TableRange, duration * machine.timerClockHz, maxTicks, "ticks"));

    const detail::RowRules rules = rowRules(curve, machine, mode);
    const auto maxRows = static_cast<std::size_t>(minOf<std::int64_t>(intervalCapacity, curve.wholePulses()));
    detail::IntervalPlanner planner(motion, pulsesPerMm, rules, maxRows);
    const double error = std::isfinite(speedErrorMmPerS) ? maxOf(0.0, speedErrorMmPerS) : 0;
    auto plan = planner.minRows(error);
    if (!plan)
        return tl::unexpected(
            refusal(Limit::SpeedError, speedErrorMmPerS, roundedUp(planner.keptErrorMmPerS(error)), "mm/s"));
    IntervalTable table;
    table.rows = std::move(plan->rows);
    table.minLinks = static_cast<int>(planner.minLines(error));
    table.fractionBits = rules.fractionBits;
    table.advance = static_cast<std::int64_t>(direction) * curve.wholePulses();
    table.timeS = timeOf(table.rows, table.fractionBits);
    table.cycleTicks = static_cast<std::uint32_t>(std::ceil(table.timeS * machine.timerClockHz - 1e-6));
    table.profileTimeS = duration;
    table.errors = plan->errors;
    return table;
}

} // namespace campanel::profile
