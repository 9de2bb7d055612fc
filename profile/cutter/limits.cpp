// SPDX-License-Identifier: Apache-2.0
// Computes peaks by formula.
#include "profile/cutter/limits.h"

#include "profile/cutter/cutter_search.h"
#include "profile/cutter/cycle_shape.h"
#include "profile/cutter/jaw.h"
#include "profile/cutter/nearest.h"
#include "profile/cutter/ratios.h"
#include "profile/cutter/validate.h"
#include "profile/laws/laws.h"
#include "profile/model/bounds.h"
#include "profile/model/torque.h"
#include "profile/model/vibration.h"

#include <array>
#include <cmath>
#include <limits>

namespace campanel::profile {
namespace {

using detail::Bounded;
using detail::CutterFigures;
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
                                             const CutterFigures& figures)
{
    const Machine& machine = figures.machine;
    const double pulses = figures.maxPulseFrequencyHz;
    const TimeSpan window{cycle.tbS, cycle.tcS};
    return {
        {{Limit::JawWindow, Field::ContactAngle, windowDeg(cycle, machine), requiredWindowDeg(machine),
          Bounded::Window, 0, window},
         {Limit::SealTime, Field::MinSealTime, sealTimeMs(cycle, machine), figures.minSealTimeMs,
          Bounded::Window, 0, window},
         {Limit::MachineRate, Field::MaxRate, cycle.rateBagsPerMin, machine.maxRateBagsPerMin, Bounded::Rate,
          machine.maxRateBagsPerMin},
         {Limit::MotorSpeed, Field::MaxMotorRpm, peak.motorRpm, machine.maxMotorRpm, Bounded::Speed,
          machine.maxMotorRpm / figures.rpmPerMmPerS},
         {Limit::KnifeAcceleration, Field::MaxKnifeAcceleration, peak.accelerationMmPerS2,
          machine.maxKnifeAccelerationMmPerS2, Bounded::Acceleration, machine.maxKnifeAccelerationMmPerS2},
         {Limit::PulseFrequency, Field::MaxPulseFrequency, peak.pulseFrequencyHz, pulses, Bounded::Speed,
          pulses / figures.pulsesPerMm},
         detail::compareTorque(peak, machine, figures.load),
         detail::compareRmsTorque(peak, machine),
         compareNaturalFrequency(cycle, machine)}};
}

// Returns the mean of the squared acceleration for a law with this I2.
double meanSquare(const CycleNumbers& cycle, double lawSquare)
{
    const double change = cycle.filmSpeedMmPerS - cycle.baseSpeedMmPerS;
    const double ramps = 1 / (cycle.tbS - cycle.taS) + 1 / (cycle.tdS - cycle.tcS);
    return change * change * lawSquare * ramps / cycle.cycleTimeS;
}

// Returns the extremes of the knife's acceleration. The film's speed is not 0, so friction alone remains
// there.
AccelerationExtremes extremesOf(const CycleNumbers& cycle, const LawPeaks& law)
{
    const double change = cycle.filmSpeedMmPerS - cycle.baseSpeedMmPerS;
    const double there = cycle.tbS - cycle.taS;
    const double back = cycle.tdS - cycle.tcS;
    AccelerationExtremes extremes;
    extremes.add(0, cycle.tbS);
    extremes.add(change * law.cv / there, cycle.taS + law.cvAt * there);
    extremes.add(-change * law.cv / back, cycle.tdS - law.cvAt * back);
    return extremes;
}

// Returns the RMS acceleration that the rated torque allows, as a share of that of the cycle; infinite while
// no torque is known.
double rmsShare(const CycleNumbers& cycle, const CutterFigures& figures)
{
    const double allowed = figures.load.rmsAllowance(figures.machine.ratedTorqueNm, movingShare(cycle));
    return maxOf(allowed, 0.0) / std::sqrt(meanSquare(cycle, figures.lawSquare));
}

} // namespace

detail::CutterFigures::CutterFigures(const RotaryCutterProgram& program, const Machine& machineOfKnife)
    : machine(machineOfKnife)
    , minSealTimeMs(program.minSealTimeMs)
    , rpmPerMmPerS(motorRpmPerMmPerS(machineOfKnife))
    , pulsesPerMm(profile::pulsesPerMm(machineOfKnife))
    , maxPulseFrequencyHz(pulseFrequencyLimitHz(machineOfKnife))
    , load(knifeLoad(machineOfKnife))
{
    const Law& law = *findLaw(program.speedLaw);
    const LawParameters& parameters = program.speedLawParameters;
    shape = {strokeMm(machine), law.at(1, parameters).integral, law.peaks(parameters)};
    lawSquare = load.isKnown() ? lawSpeedSquare(law, parameters) : 0;
    accelerationSteps = law.at(0, parameters).g1 > 0;
}

Peaks detail::peaks(const CycleNumbers& cycle, const CutterFigures& figures)
{
    const LawPeaks& law = figures.shape.lawPeaks;
    const double change = std::abs(cycle.filmSpeedMmPerS - cycle.baseSpeedMmPerS);
    const double rampThere = cycle.tbS - cycle.taS;
    const double rampBack = cycle.tdS - cycle.tcS;
    const double ramp = minOf(rampThere, rampBack);
    Peaks peak;
    peak.speedMmPerS = maxOf(cycle.baseSpeedMmPerS, cycle.filmSpeedMmPerS);
    peak.speedTimeS = cycle.filmSpeedMmPerS > cycle.baseSpeedMmPerS ? cycle.tbS : 0;
    peak.motorRpm = peak.speedMmPerS * figures.rpmPerMmPerS;
    peak.pulseFrequencyHz = peak.speedMmPerS * figures.pulsesPerMm;
    peak.accelerationMmPerS2 = change * law.cv / ramp;
    peak.accelerationTimeS =
        rampThere <= rampBack ? cycle.taS + law.cvAt * rampThere : cycle.tdS - law.cvAt * rampBack;
    peak.extremes = extremesOf(cycle, law);
    const TorquePeak torque = figures.load.peak(peak.extremes);
    peak.torqueNm = torque.nm;
    peak.torqueTimeS = torque.timeS;
    peak.rmsTorqueNm = figures.load.rmsNm({meanSquare(cycle, figures.lawSquare), 0, movingShare(cycle)});
    peak.jerkMmPerS3 = figures.accelerationSteps && change > 0 ? std::numeric_limits<double>::infinity()
                                                               : change * law.ca / (ramp * ramp);
    return peak;
}

Peaks peaks(const CycleNumbers& cycle, const RotaryCutterProgram& program, const Machine& machine)
{
    return detail::peaks(cycle, {program, machine});
}

double squareAcceleration(const CycleNumbers& cycle, const RotaryCutterProgram& program)
{
    return meanSquare(cycle, lawSpeedSquare(*findLaw(program.speedLaw), program.speedLawParameters));
}

Peaks peaks(const RotaryCutter& cutter)
{
    return peaks(cutter.cycle, cutter.program, cutter.machine);
}

std::optional<Limit> detail::firstBroken(const CycleNumbers& cycle, const CutterFigures& figures)
{
    const Peaks peak = peaks(cycle, figures);
    for (const LimitComparison& each : compareCutter(cycle, peak, figures)) {
        if (isBroken(each, peak))
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
        compareCutter(cutter.cycle, peak, {cutter.program, cutter.machine}), cutter.motion, peak);
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

bool detail::isFeasible(const RotaryCutterProgram& program, const CutterFigures& figures)
{
    if (!hasDescendingRatios(program))
        return false;
    const auto cycle = solveValid(program, cycleShape(program, figures.shape));
    return cycle && !firstBroken(*cycle, figures);
}

bool isFeasible(const RotaryCutterProgram& program, const Machine& machine)
{
    return !detail::findInvalid(program, machine) && detail::isFeasible(program, {program, machine});
}

MotionLimits detail::motionLimits(const CutterFigures& figures)
{
    const double fieldLimit = minOf(info(Field::BaseSpeed).max, info(Field::FilmSpeed).max);
    const double acceleration = info(Field::MaxKnifeAcceleration).max;
    MotionLimits limits{fieldLimit, acceleration, acceleration};
    const auto lower = [](double& limit, double allowed) { limit = minOf(limit, allowed); };
    for (const LimitComparison& c : compareCutter({}, {}, figures)) {
        if (c.bounded == Bounded::Speed)
            lower(limits.maxSpeedMmPerS, c.allowedInMotion);
        if (c.bounded == Bounded::Acceleration || c.bounded == Bounded::Torque)
            lower(limits.maxAccelerationMmPerS2, c.allowedInMotion);
        if (c.bounded == Bounded::Acceleration)
            lower(limits.maxSlowingMmPerS2, c.allowedInMotion);
        if (c.bounded == Bounded::Torque)
            lower(limits.maxSlowingMmPerS2, c.load.slowingAllowance(c.allowed));
    }
    if (figures.machine.ratedTorqueNm > 0 && figures.load.isKnown())
        limits.maxRmsAccelerationMmPerS2 =
            maxOf(figures.load.rmsAllowance(figures.machine.ratedTorqueNm), 0.0);
    return limits;
}

MotionLimits motionLimits(const Machine& machine)
{
    return detail::motionLimits({RotaryCutterProgram{}, machine});
}

// With a fixed bag length, speeds are proportional to the rate and the acceleration to its square. The window
// does not depend on the rate, the seal time is inversely proportional to it.
std::optional<FastestRate> detail::fastestByHand(const CycleNumbers& cycle, const RotaryCutterProgram& solved,
                                                 const CutterFigures& figures)
{
    const Peaks peak = peaks(cycle, figures);
    const double rate = cycle.rateBagsPerMin;
    FastestRate fastest{minOf(info(Field::Rate).max, figures.machine.maxRateBagsPerMin), Limit::MachineRate};
    const auto lower = [&fastest](double candidate, Limit limit) {
        if (candidate < fastest.rateBagsPerMin)
            fastest = {candidate, limit};
    };
    for (const LimitComparison& c : compareCutter(cycle, peak, figures)) {
        if (c.limit == Limit::MachineRate || c.limit == Limit::JawWindow || c.limit == Limit::RmsTorque ||
            !(c.actual > 0))
            continue;
        if (c.bounded == Bounded::Torque)
            lower(rate * std::sqrt(c.load.peakShare(peak.extremes, c.allowed)), c.limit);
        else if (c.bounded == Bounded::Acceleration)
            lower(rate * std::sqrt(maxOf(c.allowedInMotion, 0.0) / peak.accelerationMmPerS2), c.limit);
        else
            lower(rate * (c.bounded == Bounded::Window ? c.actual / c.allowed : c.allowed / c.actual),
                  c.limit);
    }
    lower(rate * std::sqrt(rmsShare(cycle, figures)), Limit::RmsTorque);
    lower(rate * info(Field::BaseSpeed).max / peak.speedMmPerS, Limit::FieldRange);

    RotaryCutterProgram program = solved;
    program.pinned = {Field::BagLength, Field::Rate};
    program.bagLengthMm = cycle.bagLengthMm;
    const double step = info(Field::Rate).resolution();
    // The grid point below, and one on either side because of the rounding of the formula.
    constexpr double rounding = 1e-6; // much more than it is
    for (const int offset : {1, 0, -1}) {
        program.rateBagsPerMin =
            snapToGrid(Field::Rate, std::floor(fastest.rateBagsPerMin / step) * step + offset * step);
        if (program.rateBagsPerMin <= fastest.rateBagsPerMin * (1 + rounding) && isFeasible(program, figures))
            return FastestRate{program.rateBagsPerMin, fastest.limitedBy};
    }
    return std::nullopt;
}

std::optional<FastestRate> fastestRate(const RotaryCutter& cutter)
{
    return fastestRate(cutter.cycle, cutter.program, cutter.machine);
}

std::optional<FastestRate> fastestRate(const CycleNumbers& cycle, const RotaryCutterProgram& solved,
                                       const Machine& machine)
{
    const detail::CutterFigures figures(solved, machine);
    if (solved.ratioMode == RatioMode::ByHand)
        return detail::fastestByHand(cycle, solved, figures);
    const RotaryCutterProgram program = detail::withFastestRatios(solved, cycle.bagLengthMm, figures);
    const auto numbers = detail::solveValid(program, detail::cycleShape(program, figures.shape));
    return numbers ? detail::fastestByHand(*numbers, program, figures) : std::nullopt;
}

} // namespace campanel::profile
