// SPDX-License-Identifier: Apache-2.0
#include "profile/cam/cam_cycle.h"

#include "profile/cutter/validate.h"
#include "profile/model/bounds.h"
#include "profile/model/limit_check.h"
#include "profile/model/torque.h"

#include <array>
#include <limits>

namespace campanel::profile {
namespace {

constexpr double secondsPerMinute = 60;
constexpr double jumpTolerance = 1e-9; // share of the maximum speed: the rounding of a continuous speed

double angleOfTimeDeg(const CamMaster& master, double timeS)
{
    const double angle =
        std::fmod(detail::phaseWithinCycleDeg(master) + detail::camDegPerS(master) * timeS, camCycleDeg);
    return angle < 0 ? angle + camCycleDeg : angle;
}

// A speed step in time. It is spread over one update of the master.
struct StepInTime {
    double speedMmPerS = 0; // 0 or more
    double allowedMmPerS = 0;
    double masterDeg = 0;
    double timeS = 0;
    std::size_t index = 0;
    bool slows = false; // friction helps

    [[nodiscard]] double accelerationMmPerS2() const { return speedMmPerS / masterUpdateS; }
};

// Returns true when the motion goes on in its direction behind this time, but more slowly.
bool slowsAt(const MotionProfile& motion, double timeS)
{
    const std::span<const Segment> segments = motion.segments();
    const double joinedS = 1e-9 * motion.durationS();
    const auto next =
        std::ranges::find_if(segments, [&](const Segment& s) { return s.startS >= timeS - joinedS; });
    const Segment& after = next == segments.end() ? segments.front() : *next;
    const Segment& before = next == segments.begin() ? segments.back() : *(next - 1);
    const double fromMmPerS = before.at(before.endS()).velocityMmPerS;
    const double toMmPerS = after.at(after.startS).velocityMmPerS;
    return fromMmPerS * toMmPerS >= 0 && std::abs(toMmPerS) < std::abs(fromMmPerS);
}

std::vector<StepInTime> stepsInTime(const CamMaster& master, const Machine& machine,
                                    const MotionProfile& motion, std::span<const detail::SpeedStep> steps)
{
    const AxisAllowance allowance = axisAllowance(machine);
    std::vector<StepInTime> found;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        StepInTime step;
        step.speedMmPerS = std::abs(steps[i].speedMmPerDeg * master.slaveScale * detail::camDegPerS(master));
        step.masterDeg = steps[i].masterDeg;
        step.timeS = detail::timeOfAngleS(master, step.masterDeg);
        step.index = i;
        step.slows = slowsAt(motion, step.timeS);
        step.allowedMmPerS =
            maxOf(step.slows ? allowance.slowingMmPerS2 : allowance.accelerationMmPerS2, 0.0) * masterUpdateS;
        found.push_back(step);
    }
    return found;
}

// Returns the step that exceeds what the axis follows by most; nothing without a step.
std::optional<StepInTime> worstStep(std::span<const StepInTime> steps)
{
    std::optional<StepInTime> worst;
    for (const StepInTime& step : steps) {
        if (step.speedMmPerS > 0 &&
            (!worst || step.speedMmPerS * worst->allowedMmPerS > worst->speedMmPerS * step.allowedMmPerS))
            worst = step;
    }
    return worst;
}

std::optional<Refusal> findJump(const std::optional<StepInTime>& step, detail::StepRule rule)
{
    // Without any acceleration the rest of the cycle is refused as well, and a jump may be rounding.
    if (!step || step->speedMmPerS <= step->allowedMmPerS * (1 + detail::limitTolerance) ||
        step->allowedMmPerS <= 0)
        return std::nullopt;
    Refusal refusal;
    refusal.limit = rule.jump;
    refusal.actual = step->speedMmPerS;
    refusal.allowed = step->allowedMmPerS;
    refusal.unit = "mm/s";
    refusal.index = rule.isIndexed ? static_cast<int>(step->index) : -1;
    refusal.angleDeg = step->masterDeg;
    refusal.timeS = step->timeS;
    return refusal;
}

// Includes the accelerations and the torques of the steps in the peaks.
void addStepPeaks(Peaks& peaks, const Machine& machine, std::span<const StepInTime> steps)
{
    for (const StepInTime& step : steps) {
        if (step.speedMmPerS > jumpTolerance * peaks.speedMmPerS)
            peaks.jerkMmPerS3 = std::numeric_limits<double>::infinity();
        const double acceleration = step.accelerationMmPerS2();
        raise(peaks.accelerationMmPerS2, peaks.accelerationTimeS, acceleration, step.timeS);
        if (acceleration > 0)
            peaks.extremes.add(step.slows ? -acceleration : acceleration, step.timeS);
    }
    const TorquePeak torque = axisLoad(machine).peak(peaks.extremes);
    peaks.torqueNm = torque.nm;
    peaks.torqueTimeS = torque.timeS;
}

// Refuses a cycle that repeats faster than the natural frequency of the shaft.
std::optional<Refusal> findFastCycle(const CamMaster& master, const Machine& machine)
{
    const double cycleHz = 1 / camCycleS(master);
    if (!(machine.naturalFrequencyHz > 0) ||
        cycleHz <= machine.naturalFrequencyHz * (1 + detail::limitTolerance))
        return std::nullopt;
    Refusal refusal;
    refusal.limit = Limit::NaturalFrequency;
    refusal.field = Field::NaturalFrequency;
    refusal.actual = cycleHz;
    refusal.allowed = machine.naturalFrequencyHz;
    refusal.unit = info(Field::NaturalFrequency).unit;
    return refusal;
}

// The mean of the squared acceleration of a cycle, mm^2/s^4: of the motion itself and of its speed steps.
struct CycleMeans {
    TorqueMeans all;
    double stepSquareMm2PerS4 = 0;
};

// With its steps the cycle ends at the speed of its beginning.
CycleMeans cycleMeans(const CamMaster& master, const MotionProfile& motion,
                      std::span<const detail::SpeedStep> steps)
{
    CycleMeans means{torqueMeans(motion), 0};
    for (const detail::SpeedStep& step : steps) {
        const double speed = step.speedMmPerDeg * master.slaveScale * detail::camDegPerS(master);
        means.stepSquareMm2PerS4 += speed * speed / (masterUpdateS * camCycleS(master));
    }
    means.all.squareMm2PerS4 += means.stepSquareMm2PerS4;
    means.all.speedGainMmPerS2 = 0;
    return means;
}

// Returns the share of the rate at which the RMS torque is the rated one, 1 when it is below that already.
// The mean square grows with the fourth power of the rate; the part of the steps with its cube.
double rmsFactor(const CycleMeans& means, const Machine& machine)
{
    const double allowed =
        maxOf(axisLoad(machine).rmsAllowance(machine.ratedTorqueNm, means.all.movingShare), 0.0);
    const double step = means.stepSquareMm2PerS4;
    const auto isWithin = [&](double factor) {
        const double cube = factor * factor * factor;
        return std::sqrt(cube * (factor * (means.all.squareMm2PerS4 - step) + step)) <= allowed;
    };
    double within = 0;
    double beyond = 1;
    constexpr int halvings = 60;
    for (int i = 0; i < halvings && !isWithin(1); ++i) {
        const double middle = (within + beyond) / 2;
        (isWithin(middle) ? within : beyond) = middle;
    }
    return isWithin(1) ? 1 : within;
}

// Returns the feasible rate: speeds are proportional to it, accelerations to its square; the limits of both
// are known.
std::optional<Suggestion> feasibleRate(const CamMaster& master, const Machine& machine, const Peaks& peaks,
                                       const std::optional<StepInTime>& step, const CycleMeans& means)
{
    const AxisAllowance allowance = axisAllowance(machine);
    const double torqueShare = axisLoad(machine).peakShare(peaks.extremes, machine.maxTorqueNm);
    const auto share = [](double allowed, double actual) {
        return actual > allowed ? maxOf(allowed, 0.0) / actual : 1.0;
    };
    const double factor =
        minOf(share(allowance.speedMmPerS, peaks.speedMmPerS),
              std::sqrt(share(machine.maxAccelerationMmPerS2, peaks.accelerationMmPerS2)),
              std::sqrt(minOf(torqueShare, 1.0)), step ? share(step->allowedMmPerS, step->speedMmPerS) : 1.0,
              rmsFactor(means, machine),
              share(machine.naturalFrequencyHz > 0 ? machine.naturalFrequencyHz
                                                   : std::numeric_limits<double>::max(),
                    1 / camCycleS(master)));
    const double present = master.masterRateRevPerMin;
    const double grid = info(Field::MasterRate).resolution();
    const double steps = std::floor(std::abs(present) * factor / grid * (1 + detail::limitTolerance));
    if (steps < 1)
        return std::nullopt;
    return Suggestion{Field::MasterRate, snapToGrid(Field::MasterRate, std::copysign(steps * grid, present))};
}

} // namespace

double camCycleS(const CamMaster& master)
{
    return secondsPerMinute / std::abs(master.masterRateRevPerMin) * master.masterRatio * master.masterScale;
}

namespace detail {

double withoutClosingError(double differenceMm, double spanMm)
{
    return std::abs(differenceMm) <= closingShare * spanMm * (1 + limitTolerance) ? 0 : differenceMm;
}

double onStep(double value, double step)
{
    const double perUnit = std::round(1 / step);
    return std::round(value * perUnit) / perUnit;
}

double slaveOnGrid(double slaveMm)
{
    return std::isfinite(slaveMm) ? onStep(clamped(slaveMm, -maxSlaveMm, maxSlaveMm), slaveStepMm) : 0;
}

std::optional<double> masterBetween(double beforeDeg, double afterDeg, double wantedDeg)
{
    const double perDeg = std::round(1 / masterStepDeg);
    constexpr double rounding = 1e-6; // share of a grid step
    const double low = std::ceil((beforeDeg + minMasterSpacingDeg) * perDeg - rounding);
    const double high = std::floor((afterDeg - minMasterSpacingDeg) * perDeg + rounding);
    if (!(low <= high))
        return std::nullopt;
    const double wanted = std::isfinite(wantedDeg) ? std::round(wantedDeg * perDeg) : low;
    return clamped(wanted, low, high) / perDeg;
}

double phaseWithinCycleDeg(const CamMaster& master)
{
    const double phase = std::fmod(master.phaseDeg, camCycleDeg);
    return phase < 0 ? phase + camCycleDeg : phase;
}

double camDegPerS(const CamMaster& master)
{
    return std::copysign(camCycleDeg / camCycleS(master), master.masterRateRevPerMin);
}

double timeOfAngleS(const CamMaster& master, double angleDeg)
{
    const double turned = (angleDeg - phaseWithinCycleDeg(master)) / camDegPerS(master);
    return turned < 0 ? turned + camCycleS(master) : turned;
}

AxisMotion solveCycle(const CamMaster& master, const Machine& machine, MotionProfile motion,
                      std::span<const SpeedStep> steps, StepRule rule, std::optional<Refusal> unmendable)
{
    AxisMotion solved;
    solved.motion = std::move(motion);
    solved.peaks = axisPeaks(solved.motion, machine);
    const CycleMeans means = cycleMeans(master, solved.motion, steps);
    if (const TorqueLoad load = axisLoad(machine); load.isKnown())
        solved.peaks.rmsTorqueNm = load.rmsNm(means.all);
    solved.broken = checkAxis(solved.motion, solved.peaks, machine);
    for (Refusal& refusal : solved.broken) {
        if (refusal.timeS)
            refusal.angleDeg = angleOfTimeDeg(master, *refusal.timeS);
    }
    const std::vector<StepInTime> inTime = stepsInTime(master, machine, solved.motion, steps);
    const std::optional<StepInTime> step = worstStep(inTime);
    if (auto jump = findJump(step, rule))
        solved.broken.push_back(*std::move(jump));
    if (auto fast = findFastCycle(master, machine))
        solved.broken.push_back(*std::move(fast));
    if (unmendable) {
        solved.broken.push_back(*std::move(unmendable)); // no rate corrects the curve
    } else if (!solved.broken.empty()) {
        if (const auto rate = feasibleRate(master, machine, solved.peaks, step, means)) {
            for (Refusal& refusal : solved.broken)
                refusal.nearest.push_back(*rate);
        }
    }
    addStepPeaks(solved.peaks, machine, inTime);
    return solved;
}

std::optional<Refusal> findInvalidMaster(const CamMaster& master, const Machine& machine)
{
    if (auto refusal = findInvalidMachine(machine, machine_use::axis))
        return refusal;
    return findOutOfRange(master, [](const auto&) { return true; });
}

std::optional<Refusal> findNoMotion(const CamMaster& master, bool isFlat)
{
    if (master.masterRateRevPerMin != 0 && master.slaveScale != 0 && !isFlat)
        return std::nullopt;
    Refusal refusal;
    refusal.limit = Limit::NoMotion;
    refusal.field =
        master.masterRateRevPerMin == 0 ? Field::MasterRate : (isFlat ? Field::Distance : Field::SlaveScale);
    refusal.unit = info(refusal.field).unit;
    return refusal;
}

Refusal indexedRefusal(Limit limit, std::size_t index, double actual, double allowed, std::string_view unit)
{
    Refusal refusal;
    refusal.limit = limit;
    refusal.index = static_cast<int>(index);
    refusal.actual = actual;
    refusal.allowed = allowed;
    refusal.unit = unit;
    return refusal;
}

} // namespace detail
} // namespace campanel::profile
