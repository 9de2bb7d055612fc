// SPDX-License-Identifier: Apache-2.0
// Computes peaks by formula.
#include "profile/cutter/limits.h"

#include "profile/cutter/nearest.h"
#include "profile/laws/laws.h"
#include "profile/model/torque.h"
#include "profile/model/vibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace campanel::profile {
namespace {

using detail::Bounded;
using detail::LimitComparison;

// Returns the share of the cycle in which the knife turns: all of it, unless it stands at its base speed.
double movingShare(const CycleNumbers& cycle)
{
    return cycle.baseSpeedMmPerS > 0 ? 1 : (cycle.tdS - cycle.taS) / cycle.cycleTimeS;
}

// Compares the cycle's frequency with the natural frequency of the shaft.
LimitComparison compareNaturalFrequency(const CycleNumbers& cycle, const Machine& machine)
{
    const double allowed =
        machine.naturalFrequencyHz > 0 ? machine.naturalFrequencyHz : std::numeric_limits<double>::max();
    return {Limit::NaturalFrequency, Field::NaturalFrequency,
            1 / cycle.cycleTimeS,    allowed,
            Bounded::Rate,           allowed};
}

std::array<LimitComparison, 7> compareCutter(const CycleNumbers& cycle, const Peaks& peak,
                                             const Machine& machine)
{
    const double pulses = pulseFrequencyLimitHz(machine);
    return {
        {{Limit::MachineRate, Field::MaxRate, cycle.rateBagsPerMin, machine.maxRateBagsPerMin, Bounded::Rate,
          machine.maxRateBagsPerMin},
         {Limit::MotorSpeed, Field::MaxMotorRpm, peak.motorRpm, machine.maxMotorRpm, Bounded::Speed,
          machine.maxMotorRpm / motorRpmPerMmPerS(machine)},
         {Limit::KnifeAcceleration, Field::MaxKnifeAcceleration, peak.accelerationMmPerS2,
          machine.maxKnifeAccelerationMmPerS2, Bounded::Acceleration, machine.maxKnifeAccelerationMmPerS2},
         {Limit::PulseFrequency, Field::MaxPulseFrequency, peak.pulseFrequencyHz, pulses, Bounded::Speed,
          pulses / pulsesPerMm(machine)},
         {Limit::MotorTorque, Field::MaxTorque, peak.torqueNm, machine.maxTorqueNm, Bounded::Acceleration,
          knifeLoad(machine).peakAllowance(machine.maxTorqueNm)},
         detail::compareRmsTorque(peak, machine),
         compareNaturalFrequency(cycle, machine)}};
}

bool holdsLimits(const CycleNumbers& cycle, const RotaryCutterProgram& program, const Machine& machine)
{
    const Peaks peak = peaks(cycle, program, machine);
    const auto compared = compareCutter(cycle, peak, machine);
    return std::none_of(compared.begin(), compared.end(),
                        [&peak](const LimitComparison& c) { return detail::isBroken(c, peak); });
}

// Returns the RMS acceleration that the rated torque allows, as a share of that of the cycle.
double rmsShare(const RotaryCutter& cutter)
{
    const double allowed =
        knifeLoad(cutter.machine).rmsAllowance(cutter.machine.ratedTorqueNm, movingShare(cutter.cycle));
    return std::max(allowed, 0.0) / std::sqrt(squareAcceleration(cutter.cycle, cutter.program));
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
    const TorqueLoad load = knifeLoad(machine);
    peak.torqueNm = load.peakNm(peak.accelerationMmPerS2);
    peak.rmsTorqueNm =
        load.rmsNm({load.isKnown() ? squareAcceleration(cycle, program) : 0, 0, movingShare(cycle)});
    peak.jerkMmPerS3 = accelerationSteps && change > 0 ? std::numeric_limits<double>::infinity()
                                                       : change * lawPeaks.ca / (ramp * ramp);
    return peak;
}

double squareAcceleration(const CycleNumbers& cycle, const RotaryCutterProgram& program)
{
    const double change = cycle.filmSpeedMmPerS - cycle.baseSpeedMmPerS;
    const double ramps = 1 / (cycle.tbS - cycle.taS) + 1 / (cycle.tdS - cycle.tcS);
    return change * change * lawSpeedSquare(*findLaw(program.speedLaw), program.speedLawParameters) * ramps /
           cycle.cycleTimeS;
}

Peaks peaks(const RotaryCutter& cutter)
{
    return peaks(cutter.cycle, cutter.program, cutter.machine);
}

double sealErrorMm(const RotaryCutter& cutter)
{
    return windowErrorMm(cutter.motion, cutter.cycle.tbS, cutter.cycle.tcS, shaftMode(cutter.machine));
}

std::vector<Refusal> checkLimits(const RotaryCutter& cutter)
{
    const Peaks peak = peaks(cutter);
    std::vector<Refusal> broken =
        detail::brokenLimits(compareCutter(cutter.cycle, peak, cutter.machine), cutter.motion, peak);
    for (Refusal& refusal : broken) {
        if (refusal.timeS)
            refusal.angleDeg = cutter.angleDegAt(*refusal.timeS);
        refusal.nearest = &refusal == &broken.front()
                              ? detail::nearestFeasible(cutter.program, cutter.machine, refusal)
                              : broken.front().nearest;
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
    for (const LimitComparison& c : compareCutter(cutter.cycle, peak, cutter.machine)) {
        if (c.limit == Limit::MachineRate || c.limit == Limit::RmsTorque || !(c.actual > 0))
            continue;
        const bool isAcceleration = c.bounded == Bounded::Acceleration;
        const double share = isAcceleration ? std::max(c.allowedInMotion, 0.0) / peak.accelerationMmPerS2
                                            : c.allowed / c.actual;
        lower(rate * (isAcceleration ? std::sqrt(share) : share), c.limit);
    }
    lower(rate * std::sqrt(rmsShare(cutter)), Limit::RmsTorque);
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
