// SPDX-License-Identifier: Apache-2.0
#include "profile/intervals.h"

#include "profile/interval_plan.h"
#include "profile/speed_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace campanel::profile {

namespace {

using detail::PlanRules;
using detail::SpeedCurve;

constexpr double publishedIterationS = 1.0 / (1 << detail::accumulatorBits);
constexpr int mostFractionBits = 8;
constexpr int samplesPerStretch = 64; // of the motion or of a row, to find extremes

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

// The first time at which the motion goes against its whole.
std::optional<Refusal> findReversal(const MotionProfile& motion, double direction)
{
    constexpr double roundingShare = 1e-9;
    double fastest = 0;
    std::optional<Refusal> result;
    for (const Segment& segment : motion.segments()) {
        for (int i = 0; i <= samplesPerStretch; ++i) {
            const double time = segment.startS + segment.durationS * i / samplesPerStretch;
            const double speed = segment.at(time).velocityMmPerS * direction;
            fastest = std::max(fastest, speed);
            if (speed < -roundingShare * fastest && !result) {
                result = refusal(Limit::Reversal, speed * direction, 0, "mm/s");
                result->timeS = time;
            }
        }
    }
    return result;
}

double fastestHz(const SpeedCurve& curve)
{
    return std::ranges::max(curve.samples(), {}, &detail::CurveSample::speedHz).speedHz;
}

double steepestHzPerS(const SpeedCurve& curve)
{
    double result = 0;
    const auto& samples = curve.samples();
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const double time = samples[i].timeS - samples[i - 1].timeS;
        if (time > 0)
            result = std::max(result, std::abs(samples[i].speedHz - samples[i - 1].speedHz) / time);
    }
    return result;
}

// As many bits as leave room in the acceleration's register for rows twice as steep as the curve.
int fractionBits(const SpeedCurve& curve)
{
    const double perBit =
        2 * steepestHzPerS(curve) * std::pow(detail::realIterationS / publishedIterationS, 2);
    int bits = mostFractionBits;
    while (bits > 0 && std::ldexp(perBit, bits) > std::numeric_limits<std::uint32_t>::max())
        --bits;
    return bits;
}

// The speed error less what the search does not see: the stretch to whole pulses, the speed's steps, and what
// lies between the samples compared.
PlanRules planRules(const SpeedCurve& curve, const Machine& machine, IntervalMode mode, double speedErrorHz)
{
    constexpr double sampledShare = 0.99;
    PlanRules rules;
    rules.iterationS = mode == IntervalMode::Published ? publishedIterationS : detail::realIterationS;
    rules.fractionBits = mode == IntervalMode::Published ? 0 : fractionBits(curve);
    const double unitHz = 1 / std::ldexp(rules.iterationS, detail::accumulatorBits + rules.fractionBits);
    rules.toleranceHz =
        sampledShare * speedErrorHz - 2 * unitHz - std::abs(1 - 1 / curve.stretch()) * fastestHz(curve);
    rules.maxSpeedHz = pulseFrequencyLimitHz(machine);
    return rules;
}

void measure(IntervalTable& table, const MotionProfile& motion, double pulsesPerMm, double iterationS)
{
    const int bits = detail::accumulatorBits + table.fractionBits;
    const double startMm = motion.at(0).positionMm;
    const double unitsPerHz = std::ldexp(iterationS, bits);
    std::uint64_t before = 0;
    std::uint64_t rest = 0;
    std::int64_t pulses = 0;
    const auto compare = [&](const IntervalRow& row, std::uint64_t iteration) {
        const double time = static_cast<double>(before + iteration) * iterationS;
        if (time > motion.durationS())
            return;
        const MotionPoint point = motion.at(time);
        const double speed =
            static_cast<double>(detail::speedAfter(row, iteration)) / unitsPerHz / pulsesPerMm;
        const double position =
            static_cast<double>(pulses) +
            std::ldexp(static_cast<double>(detail::positionAfter(row, rest, iteration)), -bits);
        const double speedError = std::abs(speed - std::abs(point.velocityMmPerS));
        const double positionError = std::abs(position - std::abs(point.positionMm - startMm) * pulsesPerMm);
        if (speedError > table.errors.speedMmPerS) {
            table.errors.speedMmPerS = speedError;
            table.errors.speedTimeS = time;
        }
        if (positionError > table.errors.positionPulses) {
            table.errors.positionPulses = positionError;
            table.errors.positionTimeS = time;
        }
    };
    for (const IntervalRow& row : table.rows) {
        const detail::RowEnd end = detail::rowEnd(row, rest, table.fractionBits);
        for (std::uint64_t i = 0; i <= samplesPerStretch; ++i)
            compare(row, end.iterations * i / samplesPerStretch);
        for (const Segment& segment : motion.segments()) {
            const double here = segment.startS / iterationS - static_cast<double>(before);
            if (here > 0 && here < static_cast<double>(end.iterations))
                compare(row, static_cast<std::uint64_t>(here));
        }
        before += end.iterations;
        rest = end.rest;
        pulses += row.pulses;
    }
    table.timeS = static_cast<double>(before) * detail::realIterationS;
}

// None where no table that keeps the error is found.
std::optional<IntervalTable> tableWithin(double speedErrorMmPerS, const SpeedCurve& curve,
                                         const MotionProfile& motion, const Machine& machine,
                                         IntervalMode mode)
{
    const double pulsesPerMm = axisPulsesPerMm(machine);
    const double duration = motion.durationS();
    const double direction = motion.at(duration).positionMm < motion.at(0).positionMm ? -1 : 1;
    PlanRules rules = planRules(curve, machine, mode, speedErrorMmPerS * pulsesPerMm);
    // What lies between the samples of the search is measured afterwards; a plan beyond the error is made
    // again.
    constexpr int attempts = 4;
    constexpr double tighter = 0.95;
    for (int attempt = 0; attempt < attempts; ++attempt) {
        if (!(rules.toleranceHz > 0))
            break;
        auto plan = detail::planRows(curve, rules, intervalCapacity);
        if (!plan)
            break;
        IntervalTable table;
        table.rows = std::move(plan->rows);
        table.fewestLinks = static_cast<int>(plan->fewestLinks);
        table.fractionBits = rules.fractionBits;
        table.advance = static_cast<std::int64_t>(direction) * curve.wholePulses();
        table.profileTimeS = duration;
        measure(table, motion, pulsesPerMm, rules.iterationS);
        table.cycleTicks = static_cast<std::uint32_t>(std::ceil(table.timeS * machine.timerClockHz - 1e-6));
        if (table.errors.speedMmPerS <= speedErrorMmPerS)
            return table;
        rules.toleranceHz *= tighter;
    }
    return std::nullopt;
}

// One that can be kept, more than the one tried: from above the last before one that cannot. Smaller ones may
// be kept again; but where the error is too small by little, each plan takes seconds.
double keptSpeedErrorMmPerS(double triedMmPerS, const SpeedCurve& curve, const MotionProfile& motion,
                            const Machine& machine, IntervalMode mode)
{
    constexpr double factor = 1.5;
    constexpr double leastShare = 1e-6; // of the largest
    const double largest = 2 * fastestHz(curve) / axisPulsesPerMm(machine);
    const double least = std::max(triedMmPerS, largest * leastShare);
    double kept = largest;
    while (kept / factor > least && tableWithin(kept / factor, curve, motion, machine, mode))
        kept /= factor;
    return kept;
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

    const SpeedCurve curve(motion, pulsesPerMm);
    const double limitHz = pulseFrequencyLimitHz(machine);
    if (fastestHz(curve) / curve.stretch() > limitHz * (1 + 1e-9))
        return tl::unexpected(refusal(Limit::PulseFrequency, fastestHz(curve), limitHz, "Hz"));
    constexpr double mostPulses = std::numeric_limits<std::int32_t>::max();
    if (static_cast<double>(curve.wholePulses()) > mostPulses)
        return tl::unexpected(
            refusal(Limit::TableRange, static_cast<double>(curve.wholePulses()), mostPulses, "pulses"));
    constexpr double mostTicks = std::numeric_limits<std::uint32_t>::max();
    if (duration * 1.01 * machine.timerClockHz > mostTicks)
        return tl::unexpected(
            refusal(Limit::TableRange, duration * machine.timerClockHz, mostTicks, "ticks"));

    const double error = std::isfinite(speedErrorMmPerS) ? speedErrorMmPerS : 0;
    if (auto table = tableWithin(error, curve, motion, machine, mode))
        return *std::move(table);
    return tl::unexpected(refusal(Limit::SpeedError, speedErrorMmPerS,
                                  keptSpeedErrorMmPerS(error, curve, motion, machine, mode), "mm/s"));
}

} // namespace campanel::profile
