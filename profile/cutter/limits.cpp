// SPDX-License-Identifier: Apache-2.0
// Computes peaks by formula. Finds the time spans of an exceeded limit by bisection between monotone
// sections.
#include "profile/cutter/limits.h"

#include "profile/cutter/nearest.h"
#include "profile/laws/laws.h"
#include "profile/model/limit_tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace campanel::profile {
namespace {

bool exceeds(double actual, double limit)
{
    return actual > limit * (1 + detail::limitTolerance);
}

struct CutterComparison {
    Limit limit;
    Field field; // the machine's limit
    double actual;
    double allowed;
};

std::array<CutterComparison, 4> compareCutter(const CycleNumbers& cycle, const Peaks& peak,
                                              const Machine& machine)
{
    return {{{Limit::MachineRate, Field::MaxRate, cycle.rateBagsPerMin, machine.maxRateBagsPerMin},
             {Limit::MotorSpeed, Field::MaxMotorRpm, peak.motorRpm, machine.maxMotorRpm},
             {Limit::KnifeAcceleration, Field::MaxKnifeAcceleration, peak.accelerationMmPerS2,
              machine.maxKnifeAccelerationMmPerS2},
             {Limit::PulseFrequency, Field::MaxPulseFrequency, peak.pulseFrequencyHz,
              pulseFrequencyLimitHz(machine)}}};
}

// Appends the part of [fromS, toS] above the limit; |quantity| must be monotone there.
template <typename Quantity>
void appendBrokenCutterSpan(std::vector<TimeSpan>& spans, double fromS, double toS, double limit,
                            Quantity quantity)
{
    const bool startBroken = exceeds(std::abs(quantity(fromS)), limit);
    const bool endBroken = exceeds(std::abs(quantity(toS)), limit);
    if ((!startBroken && !endBroken) || !(toS > fromS))
        return;
    TimeSpan span{fromS, toS};
    if (startBroken != endBroken) {
        double whole = startBroken ? fromS : toS;
        double sound = startBroken ? toS : fromS;
        constexpr int halvings = 50;
        for (int i = 0; i < halvings; ++i) {
            const double middle = (whole + sound) / 2;
            (exceeds(std::abs(quantity(middle)), limit) ? whole : sound) = middle;
        }
        (startBroken ? span.toS : span.fromS) = whole;
    }
    if (!spans.empty() && spans.back().toS == span.fromS)
        spans.back().toS = span.toS;
    else
        spans.push_back(span);
}

std::vector<TimeSpan> brokenCutterSpans(const RotaryCutter& cutter, Limit limit, double allowed)
{
    std::vector<TimeSpan> spans;
    if (limit == Limit::MachineRate)
        return spans;
    const bool isAcceleration = limit == Limit::KnifeAcceleration;
    const double perSpeed =
        limit == Limit::MotorSpeed ? motorRpmPerMmPerS(cutter.machine) : pulsesPerMm(cutter.machine);
    for (const Segment& segment : cutter.motion.segments()) {
        const auto quantity = [&](double timeS) {
            const MotionPoint p = segment.at(timeS);
            return isAcceleration ? p.accelerationMmPerS2 : p.velocityMmPerS * perSpeed;
        };
        double peakAt = segment.startS;
        if (isAcceleration && segment.law != nullptr) {
            const double x = segment.law->peaks(segment.parameters).cvAt;
            peakAt += segment.durationS * (segment.isMirrored ? 1 - x : x);
        }
        appendBrokenCutterSpan(spans, segment.startS, peakAt, allowed, quantity);
        appendBrokenCutterSpan(spans, peakAt, segment.endS(), allowed, quantity);
    }
    return spans;
}

bool holdsLimits(const CycleNumbers& cycle, const RotaryCutterProgram& program, const Machine& machine)
{
    const auto compared = compareCutter(cycle, peaks(cycle, program, machine), machine);
    return std::none_of(compared.begin(), compared.end(),
                        [](const CutterComparison& c) { return exceeds(c.actual, c.allowed); });
}

} // namespace

Peaks peaks(const CycleNumbers& cycle, const RotaryCutterProgram& program, const Machine& machine)
{
    const Law& law = *findLaw(program.speedLaw);
    const LawPeaks lawPeaks = law.peaks(program.speedLawParameters);
    const double change = std::abs(cycle.filmSpeedMmPerS - cycle.baseSpeedMmPerS);
    const double rampThere = cycle.tbS - cycle.taS;
    const double rampBack = cycle.tdS - cycle.tcS;
    const double ramp = std::min(rampThere, rampBack);
    Peaks peak;
    peak.speedMmPerS = std::max(cycle.baseSpeedMmPerS, cycle.filmSpeedMmPerS);
    peak.speedTimeS = cycle.filmSpeedMmPerS > cycle.baseSpeedMmPerS ? cycle.tbS : 0;
    peak.motorRpm = peak.speedMmPerS * motorRpmPerMmPerS(machine);
    peak.pulseFrequencyHz = peak.speedMmPerS * pulsesPerMm(machine);
    peak.accelerationMmPerS2 = change * lawPeaks.cv / ramp;
    peak.accelerationTimeS =
        rampThere <= rampBack ? cycle.taS + lawPeaks.cvAt * rampThere : cycle.tdS - lawPeaks.cvAt * rampBack;
    const bool accelerationSteps = law.at(0, program.speedLawParameters).g1 > 0;
    peak.jerkMmPerS3 = accelerationSteps && change > 0 ? std::numeric_limits<double>::infinity()
                                                       : change * lawPeaks.ca / (ramp * ramp);
    return peak;
}

Peaks peaks(const RotaryCutter& cutter)
{
    return peaks(cutter.cycle, cutter.program, cutter.machine);
}

std::vector<Refusal> checkLimits(const RotaryCutter& cutter)
{
    const Peaks peak = peaks(cutter);
    std::vector<Refusal> broken;
    for (const CutterComparison& c : compareCutter(cutter.cycle, peak, cutter.machine)) {
        if (!exceeds(c.actual, c.allowed))
            continue;
        Refusal refusal;
        refusal.limit = c.limit;
        refusal.field = c.field;
        refusal.actual = c.actual;
        refusal.allowed = c.allowed;
        refusal.unit = info(c.field).unit;
        if (c.limit != Limit::MachineRate) {
            const bool isAcceleration = c.limit == Limit::KnifeAcceleration;
            refusal.timeS = isAcceleration ? peak.accelerationTimeS : peak.speedTimeS;
            refusal.angleDeg = cutter.angleDegAt(*refusal.timeS);
        }
        refusal.brokenDuring = brokenCutterSpans(cutter, c.limit, c.allowed);
        refusal.nearest = broken.empty() ? detail::nearestFeasible(cutter.program, cutter.machine, refusal)
                                         : broken.front().nearest;
        broken.push_back(std::move(refusal));
    }
    return broken;
}

bool isFeasible(const RotaryCutterProgram& program, const Machine& machine)
{
    const tl::expected<CycleNumbers, Refusal> cycle = solveNumbers(program, machine);
    return cycle && holdsLimits(*cycle, program, machine);
}

std::optional<FastestRate> fastestRate(const RotaryCutter& cutter)
{
    // With a fixed bag length, speeds are proportional to the rate and the acceleration to its square.
    const Peaks peak = peaks(cutter);
    const double rate = cutter.cycle.rateBagsPerMin;
    FastestRate fastest{std::min(info(Field::Rate).max, cutter.machine.maxRateBagsPerMin),
                        Limit::MachineRate};
    const auto lower = [&fastest](double candidate, Limit limit) {
        if (candidate < fastest.rateBagsPerMin)
            fastest = {candidate, limit};
    };
    for (const CutterComparison& c : compareCutter(cutter.cycle, peak, cutter.machine)) {
        if (c.limit == Limit::MachineRate || !(c.actual > 0))
            continue;
        const double share = c.allowed / c.actual;
        lower(rate * (c.limit == Limit::KnifeAcceleration ? std::sqrt(share) : share), c.limit);
    }
    lower(rate * info(Field::BaseSpeed).max / peak.speedMmPerS, Limit::FieldRange);

    RotaryCutterProgram program = cutter.program;
    program.pinned = {Field::BagLength, Field::Rate};
    program.bagLengthMm = cutter.cycle.bagLengthMm;
    const double step = info(Field::Rate).resolution();
    // The grid point below, and one on either side because of the rounding of the formula.
    for (const int offset : {1, 0, -1}) {
        program.rateBagsPerMin =
            snapToGrid(Field::Rate, std::floor(fastest.rateBagsPerMin / step) * step + offset * step);
        if (isFeasible(program, cutter.machine))
            return FastestRate{program.rateBagsPerMin, fastest.limitedBy};
    }
    return std::nullopt;
}

} // namespace campanel::profile
