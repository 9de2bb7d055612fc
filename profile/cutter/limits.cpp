// SPDX-License-Identifier: Apache-2.0
// Computes peaks by formula.
#include "profile/cutter/limits.h"

#include "profile/cutter/jaw.h"
#include "profile/cutter/nearest.h"
#include "profile/cutter/ratios.h"
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

std::array<LimitComparison, 9> compareCutter(const CycleNumbers& cycle, const Peaks& peak,
                                             const RotaryCutterProgram& program, const Machine& machine)
{
    const double pulses = pulseFrequencyLimitHz(machine);
    const TimeSpan window{cycle.tbS, cycle.tcS};
    return {
        {{Limit::JawWindow, Field::ContactAngle, windowDeg(cycle, machine), requiredWindowDeg(machine),
          Bounded::Window, 0, window},
         {Limit::SealTime, Field::MinSealTime, sealTimeMs(cycle, machine), program.minSealTimeMs,
          Bounded::Window, 0, window},
         {Limit::MachineRate, Field::MaxRate, cycle.rateBagsPerMin, machine.maxRateBagsPerMin, Bounded::Rate,
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

// Returns the RMS acceleration that the rated torque allows, as a share of that of the cycle.
double rmsShare(const CycleNumbers& cycle, const RotaryCutterProgram& program, const Machine& machine)
{
    const double allowed = knifeLoad(machine).rmsAllowance(machine.ratedTorqueNm, movingShare(cycle));
    return std::max(allowed, 0.0) / std::sqrt(squareAcceleration(cycle, program));
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

std::optional<Limit> firstBroken(const CycleNumbers& cycle, const RotaryCutterProgram& program,
                                 const Machine& machine)
{
    const Peaks peak = peaks(cycle, program, machine);
    for (const LimitComparison& each : compareCutter(cycle, peak, program, machine)) {
        if (detail::isBroken(each, peak))
            return each.limit;
    }
    return std::nullopt;
}

double sealErrorMm(const RotaryCutter& cutter)
{
    return windowErrorMm(cutter.motion, cutter.cycle.tbS, cutter.cycle.tcS, shaftMode(cutter.machine));
}

std::vector<Refusal> checkLimits(const RotaryCutter& cutter)
{
    const Peaks peak = peaks(cutter);
    std::vector<Refusal> broken = detail::brokenLimits(
        compareCutter(cutter.cycle, peak, cutter.program, cutter.machine), cutter.motion, peak);
    for (Refusal& refusal : broken) {
        if (refusal.timeS)
            refusal.angleDeg = cutter.angleDegAt(*refusal.timeS);
        if (&refusal == &broken.front()) {
            refusal.nearest = detail::nearestFeasible(cutter.program, cutter.machine, refusal);
            refusal.ramps = otherRamps(cutter.program, cutter.machine);
        } else {
            refusal.nearest = broken.front().nearest;
            refusal.ramps = broken.front().ramps;
        }
    }
    return broken;
}

bool isFeasible(const RotaryCutterProgram& program, const Machine& machine)
{
    const tl::expected<CycleNumbers, Refusal> cycle = solveNumbers(program, machine);
    return cycle && !firstBroken(*cycle, program, machine);
}

MotionLimits motionLimits(const Machine& machine)
{
    const double fieldLimit = std::min(info(Field::BaseSpeed).max, info(Field::FilmSpeed).max);
    MotionLimits limits{fieldLimit, info(Field::MaxKnifeAcceleration).max};
    for (const LimitComparison& c : compareCutter({}, {}, {}, machine)) {
        if (c.bounded == Bounded::Speed)
            limits.maxSpeedMmPerS = std::min(limits.maxSpeedMmPerS, c.allowedInMotion);
        if (c.bounded == Bounded::Acceleration)
            limits.maxAccelerationMmPerS2 = std::min(limits.maxAccelerationMmPerS2, c.allowedInMotion);
    }
    if (machine.ratedTorqueNm > 0 && knifeLoad(machine).isKnown())
        limits.maxRmsAccelerationMmPerS2 =
            std::max(knifeLoad(machine).rmsAllowance(machine.ratedTorqueNm), 0.0);
    return limits;
}

std::optional<FastestRate> fastestRate(const RotaryCutter& cutter)
{
    return fastestRate(cutter.cycle, cutter.program, cutter.machine);
}

std::optional<FastestRate> fastestRate(const CycleNumbers& cycle, const RotaryCutterProgram& solved,
                                       const Machine& machine)
{
    if (solved.ratioMode != RatioMode::ByHand) {
        RotaryCutterProgram program = withFastestRatios({solved, machine, cycle, {}});
        program.ratioMode = RatioMode::ByHand;
        const auto numbers = solveNumbers(program, machine);
        return numbers ? fastestRate(*numbers, program, machine) : std::nullopt;
    }
    // With a fixed bag length, speeds are proportional to the rate and the acceleration to its square. The
    // window does not depend on the rate, the seal time is inversely proportional to it.
    const Peaks peak = peaks(cycle, solved, machine);
    const double rate = cycle.rateBagsPerMin;
    FastestRate fastest{std::min(info(Field::Rate).max, machine.maxRateBagsPerMin), Limit::MachineRate};
    const auto lower = [&fastest](double candidate, Limit limit) {
        if (candidate < fastest.rateBagsPerMin)
            fastest = {candidate, limit};
    };
    for (const LimitComparison& c : compareCutter(cycle, peak, solved, machine)) {
        if (c.limit == Limit::MachineRate || c.limit == Limit::JawWindow || c.limit == Limit::RmsTorque ||
            !(c.actual > 0))
            continue;
        if (c.bounded == Bounded::Acceleration)
            lower(rate * std::sqrt(std::max(c.allowedInMotion, 0.0) / peak.accelerationMmPerS2), c.limit);
        else
            lower(rate * (c.bounded == Bounded::Window ? c.actual / c.allowed : c.allowed / c.actual),
                  c.limit);
    }
    lower(rate * std::sqrt(rmsShare(cycle, solved, machine)), Limit::RmsTorque);
    lower(rate * info(Field::BaseSpeed).max / peak.speedMmPerS, Limit::FieldRange);

    RotaryCutterProgram program = solved;
    program.pinned = {Field::BagLength, Field::Rate};
    program.bagLengthMm = cycle.bagLengthMm;
    const double step = info(Field::Rate).resolution();
    // The grid point below, and one on either side because of the rounding of the formula.
    for (const int offset : {1, 0, -1}) {
        program.rateBagsPerMin =
            snapToGrid(Field::Rate, std::floor(fastest.rateBagsPerMin / step) * step + offset * step);
        if (isFeasible(program, machine))
            return FastestRate{program.rateBagsPerMin, fastest.limitedBy};
    }
    return std::nullopt;
}

} // namespace campanel::profile
