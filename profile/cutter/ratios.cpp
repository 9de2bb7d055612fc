// SPDX-License-Identifier: Apache-2.0
// The closed forms of the ramps, and the ratios on the grid of their fields.
#include "profile/cutter/ratios.h"

#include "profile/cutter/cycle_shape.h"
#include "profile/cutter/validate.h"
#include "profile/laws/laws.h"
#include "profile/model/torque.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace campanel::profile {
namespace {

using Ratios = std::array<double, 4>;

constexpr int bisections = 60; // to the precision of a double

// The window keeps its place while the ramps are shortened by at most this share of their length for it: the
// acceleration rises by less than its square near the optimum.
constexpr double placeTolerance = 0.01;

double remaining(const RampTask& task)
{
    return 1 - task.window; // S
}

double longestRamp(const RampTask& task)
{
    return remaining(task) / 2 - minCycleShare;
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
    const double coolest = std::clamp(coolestRamp(task), range.shortest, range.longest);
    if (!(squareTimeByRms(task, coolest) <= square))
        return std::nullopt;
    for (double* end : {&range.shortest, &range.longest}) {
        double kept = coolest;
        for (int i = 0; i < bisections && squareTimeByRms(task, *end) > square; ++i) {
            const double middle = (kept + *end) / 2;
            (squareTimeByRms(task, middle) <= square ? kept : *end) = middle;
        }
        if (squareTimeByRms(task, *end) > square)
            *end = kept;
    }
    return range;
}

// Returns the task without its ramps: what is given by the window, the law and the machine.
RampTask emptyTask(const RotaryCutterProgram& program, const Machine& machine)
{
    const Law& law = *findLaw(program.speedLaw);
    const MotionLimits limits = motionLimits(machine);
    RampTask task;
    task.strokeMm = strokeMm(machine);
    task.window = 1 / program.k[2] - 1 / program.k[1];
    task.lawTravel = law.at(1, program.speedLawParameters).integral;
    task.lawPeak = law.peaks(program.speedLawParameters).cv;
    task.maxSpeedMmPerS = limits.maxSpeedMmPerS;
    task.maxAccelerationMmPerS2 = limits.maxAccelerationMmPerS2;
    task.maxRmsAccelerationMmPerS2 = limits.maxRmsAccelerationMmPerS2;
    if (std::isfinite(task.maxRmsAccelerationMmPerS2))
        task.lawSquare = lawSpeedSquare(law, program.speedLawParameters);
    return task;
}

// Completes the task by the bag length and the cycle time that follow from the pinned values with this ramp.
// They are not finite or negative where no cycle exists.
RampTask taskAt(RampTask task, const RotaryCutterProgram& program, double ramp)
{
    detail::CycleShape shape;
    shape.strokeMm = task.strokeMm;
    shape.weight = task.window + 2 * task.lawTravel * ramp;
    shape.syncRatio = program.syncRatio;
    const detail::CycleValues values =
        detail::closeCycle(shape, {program.pinned[0], value(program, program.pinned[0])},
                           {program.pinned[1], value(program, program.pinned[1])});
    task.filmMm = program.syncRatio * values.bagLengthMm;
    task.cycleTimeS = values.cycleTimeS;
    return task;
}

// Returns the ramp that suits the cycle that it makes itself. With a pinned v_a bag length or rate depend on
// the ramp: the ramp that equals its own optimum is found by bisection.
template <typename Optimum>
double solvedRamp(const RotaryCutterProgram& program, const RampTask& task, Optimum optimum)
{
    double low = minCycleShare;
    double high = longestRamp(task);
    if (!isPinned(program, Field::BaseSpeed))
        return optimum(taskAt(task, program, high));
    for (int i = 0; i < bisections; ++i) {
        const double middle = (low + high) / 2;
        const RampTask tried = taskAt(task, program, middle);
        const bool hasTime = std::isfinite(tried.cycleTimeS) && tried.cycleTimeS > 0;
        const bool hasFilm = std::isfinite(tried.filmMm) && tried.filmMm > 0;
        // Too much film for the stroke asks for shorter ramps, too fast a knife for longer ones.
        const bool isTooShort = hasTime && (!hasFilm || optimum(tried) > middle);
        (isTooShort ? low : high) = middle;
    }
    return (low + high) / 2;
}

double gridBelow(double value)
{
    const double scale = std::round(1 / info(Field::K1).resolution());
    return std::floor(value * scale * (1 + std::numeric_limits<double>::epsilon())) / scale;
}

double gridAbove(double value)
{
    const double scale = std::round(1 / info(Field::K1).resolution());
    return std::ceil(value * scale * (1 - std::numeric_limits<double>::epsilon())) / scale;
}

double roomBeside(const Ratios& k)
{
    return std::min(1 / k[1], 1 - 1 / k[2]) - minCycleShare;
}

// Moves the window to the middle of the cycle when the ramps do not fit beside it. It gets no narrower.
Ratios withRoom(Ratios k, double ramp, double tolerance)
{
    if (ramp <= roomBeside(k) * (1 + tolerance) && roomBeside(k) > 0)
        return k;
    const double window = 1 / k[2] - 1 / k[1];
    k[2] = gridBelow(2 / (1 + window));
    k[1] = gridAbove(1 / (1 / k[2] - window));
    return k;
}

// Returns the ratios on the grid around this ramp beside the present window: the ramp back has the coarser
// grid, the other one follows it.
std::array<Ratios, 6> ratiosAround(const Ratios& present, double ramp)
{
    const double step = info(Field::K1).resolution();
    const double begin = 1 / present[1];
    const double end = 1 / present[2];
    const double fitting = std::max(std::min(ramp, roomBeside(present)), minCycleShare);
    std::array<Ratios, 6> found;
    found.fill(present);
    for (std::size_t i = 0; i < found.size(); ++i) {
        Ratios& k = found[i];
        k[3] =
            snapToGrid(Field::K4, gridBelow(1 / (end + fitting)) + (static_cast<double>(i / 2) - 1) * step);
        const double base = std::max(begin - (1 / k[3] - end), minCycleShare);
        // A large k1 needs few digits for its small time.
        constexpr double precision = 1e-5; // of the cycle
        const double coarse = std::max(step, std::pow(10, std::floor(std::log10(precision / (base * base)))));
        const double below = std::floor(1 / base / coarse) * coarse;
        k[0] = snapToGrid(Field::K1, below + static_cast<double>(i % 2) * coarse);
    }
    return found;
}

// Returns the program with those ratios on the grid around the ramp of `optimum` that have the lowest rank.
template <typename Optimum, typename Rank>
RotaryCutterProgram withOptimum(RotaryCutterProgram program, const Machine& machine, Optimum optimum,
                                Rank rank, double tolerance = placeTolerance)
{
    double ramp = solvedRamp(program, emptyTask(program, machine), optimum);
    if (const Ratios moved = withRoom(program.k, ramp, tolerance); moved != program.k) {
        program.k = moved; // its window is wider by the rounding
        ramp = solvedRamp(program, emptyTask(program, machine), optimum);
    }
    RotaryCutterProgram best = program;
    std::optional<decltype(rank(program))> bestRank;
    for (const Ratios& k : ratiosAround(program.k, ramp)) {
        RotaryCutterProgram tried = program;
        tried.k = k;
        const auto triedRank = rank(tried);
        if (bestRank && *bestRank <= triedRank)
            continue;
        bestRank = triedRank;
        best = tried;
    }
    return best;
}

// Ranks feasible programs first, then those with the lowest acceleration.
std::pair<bool, double> demandOf(const RotaryCutterProgram& program, const Machine& machine)
{
    const auto cycle = solveNumbers(program, machine);
    return {!isFeasible(program, machine), cycle ? peaks(*cycle, program, machine).accelerationMmPerS2
                                                 : std::numeric_limits<double>::infinity()};
}

// Returns the highest rate with these ratios, 0 when there is none.
double highestRate(RotaryCutterProgram program, const Machine& machine)
{
    program.ratioMode = RatioMode::ByHand;
    const auto cycle = solveNumbers(program, machine);
    const auto fastest =
        cycle ? fastestRate(RotaryCutter{program, machine, *cycle, {}}) : std::optional<FastestRate>{};
    return fastest ? fastest->rateBagsPerMin : 0;
}

// Returns true when everything but k1 and k4 is valid, and the window leaves room for ramps.
bool hasWindow(RotaryCutterProgram program, const Machine& machine)
{
    const double window = 1 / program.k[2] - 1 / program.k[1];
    program.k[0] = info(Field::K1).max;
    program.k[3] = info(Field::K4).min;
    return !detail::findInvalid(program, machine) && (1 - window) / 2 > 2 * minCycleShare;
}

} // namespace

double gentlestRamp(const RampTask& task)
{
    return std::min(longestRamp(task), remaining(task) / (4 * task.lawTravel));
}

double coolestRamp(const RampTask& task)
{
    return std::min(longestRamp(task), remaining(task) / (6 * task.lawTravel));
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
    RampRange range{std::max(minCycleShare, 2 * least / (s + root)),
                    std::min({longestRamp(task), (s + root) / (4 * g), longestBeforeReversal(task)})};
    if (task.filmMm < task.strokeMm && task.filmMm < travel)
        range.longest = std::min(range.longest,
                                 ((travel - task.strokeMm) / (travel - task.filmMm) - task.window) / (2 * g));
    if (!(range.shortest <= range.longest))
        return std::nullopt;
    return std::isfinite(task.maxRmsAccelerationMmPerS2) ? withinRms(range, task) : std::optional(range);
}

double fastestRamp(const RampTask& task)
{
    const double longest = std::max(minCycleShare, std::min(gentlestRamp(task), longestBeforeReversal(task)));
    // Longer ramps need less acceleration and, for a bag shorter than the stroke, a higher base speed. The
    // functions are the squares of the shortest cycle times; the largest of them has one minimum.
    const double g = task.lawTravel;
    const auto byAcceleration = [&](double ramp) {
        return task.lawPeak * change(task) /
               (task.maxAccelerationMmPerS2 * ramp * (remaining(task) - 2 * g * ramp));
    };
    const auto bySpeed = [&](double ramp) {
        if (task.filmMm >= task.strokeMm)
            return 0.0;
        const double weight = task.window + 2 * g * ramp;
        return std::pow((task.strokeMm - task.filmMm * weight) / ((1 - weight) * task.maxSpeedMmPerS), 2);
    };
    const auto byRms = [&](double ramp) {
        return std::isfinite(task.maxRmsAccelerationMmPerS2) ? squareTimeByRms(task, ramp) : 0;
    };
    if (byAcceleration(longest) >= std::max(bySpeed(longest), byRms(longest)))
        return longest;
    const auto square = [&](double ramp) {
        return std::max({byAcceleration(ramp), bySpeed(ramp), byRms(ramp)});
    };
    double low = minCycleShare;
    double high = longest;
    for (int i = 0; i < 2 * bisections; ++i) {
        const double third = (high - low) / 3;
        if (square(low + third) > square(high - third))
            low += third;
        else
            high -= third;
    }
    return (low + high) / 2;
}

double rampFor(RatioMode mode, double positionPercent, const RampTask& task)
{
    const std::optional<RampRange> range = possibleRamps(task);
    if (!range)
        return fastestRamp(task);
    const double gentle = std::clamp(gentlestRamp(task), range->shortest, range->longest);
    const double cool = std::clamp(coolestRamp(task), range->shortest, range->longest);
    switch (mode) {
    case RatioMode::Cool:
        return cool;
    case RatioMode::Slow:
        return range->shortest;
    case RatioMode::Between: {
        const double position = std::clamp(positionPercent / 50, 0.0, 2.0); // 1: coolest
        return position <= 1 ? std::lerp(range->shortest, cool, position)
                             : std::lerp(cool, gentle, position - 1);
    }
    default:
        return gentle;
    }
}

RotaryCutterProgram withRatios(const RotaryCutterProgram& program, const Machine& machine)
{
    if (program.ratioMode == RatioMode::ByHand || !hasWindow(program, machine))
        return program;
    const auto demand = [&machine](const RotaryCutterProgram& tried) { return demandOf(tried, machine); };
    const auto suiting = [&program](const RampTask& task) {
        return rampFor(program.ratioMode, program.rampPositionPercent, task);
    };
    RotaryCutterProgram wanted = withOptimum(program, machine, suiting, demand);
    if (isFeasible(wanted, machine))
        return wanted;
    // Near a limit no ramp may be shortened to keep the place of the window.
    wanted = withOptimum(program, machine, suiting, demand, 0);
    if (isFeasible(wanted, machine))
        return wanted;
    // At the limit a ramp may be feasible only before it is rounded.
    RotaryCutterProgram fastest = withOptimum(program, machine, fastestRamp, demand);
    return isFeasible(fastest, machine) || !isFeasible(program, machine) ? fastest : program;
}

RotaryCutterProgram withFastestRatios(const RotaryCutter& cutter)
{
    // The ratios do not depend on the rate; at a low one every speed is within the range of its field.
    constexpr double lowRateBagsPerMin = 2;
    const Machine& machine = cutter.machine;
    RotaryCutterProgram program = cutter.program;
    program.pinned = {Field::BagLength, Field::Rate};
    program.bagLengthMm = cutter.cycle.bagLengthMm;
    program.rateBagsPerMin = lowRateBagsPerMin;
    if (!hasWindow(program, machine))
        return program;
    return withOptimum(program, machine, fastestRamp,
                       [&machine](const RotaryCutterProgram& tried) { return -highestRate(tried, machine); });
}

double rampPosition(const RotaryCutter& cutter)
{
    const CycleNumbers& cycle = cutter.cycle;
    RampTask task = emptyTask(cutter.program, cutter.machine);
    task.filmMm = cutter.program.syncRatio * cycle.bagLengthMm;
    task.cycleTimeS = cycle.cycleTimeS;
    const double ramp = std::min(cycle.tbS - cycle.taS, cycle.tdS - cycle.tcS) / cycle.cycleTimeS;
    const double shortest = rampFor(RatioMode::Slow, 0, task);
    const double cool = rampFor(RatioMode::Cool, 0, task);
    const double gentle = rampFor(RatioMode::Gentle, 0, task);
    if (ramp >= gentle)
        return 100;
    if (ramp <= shortest)
        return 0;
    return ramp < cool ? 50 * (ramp - shortest) / (cool - shortest)
                       : 50 + 50 * (ramp - cool) / (gentle - cool);
}

RotaryCutterProgram withWindow(RotaryCutterProgram program, const Machine& machine, double share)
{
    const double there = 1 / program.k[1] - 1 / program.k[0];
    const double back = 1 / program.k[3] - 1 / program.k[2];
    const double middle = (1 / program.k[1] + 1 / program.k[2]) / 2;
    const double half = std::min({share / 2, middle - 2 * minCycleShare, 1 - middle - 2 * minCycleShare});
    if (!(half > 0))
        return program;
    program.k[1] = gridAbove(1 / (middle - half));
    program.k[2] = gridBelow(1 / (middle + half));
    const double begin = 1 / program.k[1] - there;
    const double end = 1 / program.k[2] + back;
    program.k[0] = snapToGrid(Field::K1, 1 / std::max(begin, minCycleShare));
    program.k[3] = snapToGrid(Field::K4, 1 / std::min(end, 1 - minCycleShare));
    return withRatios(program, machine);
}

double rmsAcceleration(const CycleNumbers& cycle, const RotaryCutterProgram& program)
{
    return std::sqrt(squareAcceleration(cycle, program));
}

std::optional<RampOffer> otherRamps(const RotaryCutterProgram& program, const Machine& machine)
{
    if (program.ratioMode != RatioMode::ByHand)
        return std::nullopt;
    RotaryCutterProgram other = program;
    other.ratioMode = RatioMode::Gentle;
    other = withRatios(other, machine);
    const auto shorterRamp = [](const RotaryCutterProgram& each) {
        return std::min(1 / each.k[1] - 1 / each.k[0], 1 / each.k[3] - 1 / each.k[2]);
    };
    RampOffer offer;
    offer.isLonger = shorterRamp(other) > shorterRamp(program);
    const auto solved = solveNumbers(other, machine);
    if (!solved)
        return std::nullopt;
    offer.rateBagsPerMin = solved->rateBagsPerMin;
    if (isFeasible(other, machine))
        return offer;
    if (!isPinned(program, Field::BagLength) || !isPinned(program, Field::Rate))
        return std::nullopt;
    const auto fastest = fastestRate(RotaryCutter{other, machine, *solved, {}});
    offer.rateBagsPerMin = fastest ? fastest->rateBagsPerMin : 0;
    return offer.rateBagsPerMin > highestRate(program, machine) ? std::optional(offer) : std::nullopt;
}

std::vector<RankedLaw> rankLaws(const RotaryCutterProgram& program, const Machine& machine)
{
    std::vector<RankedLaw> ranked;
    for (const Law& law : laws()) {
        if (!law.isSpeedLaw)
            continue;
        RankedLaw each;
        each.program = program;
        if (law.id != program.speedLaw) {
            each.program.speedLaw = law.id;
            each.program.speedLawParameters = defaultParameters(law);
        }
        if (program.ratioMode == RatioMode::ByHand)
            each.program.ratioMode = RatioMode::Gentle;
        each.program = withRatios(each.program, machine);
        each.peaks.motorRpm = each.peaks.pulseFrequencyHz = each.peaks.accelerationMmPerS2 =
            each.peaks.jerkMmPerS3 = each.rmsAccelerationMmPerS2 = std::numeric_limits<double>::quiet_NaN();
        if (const auto cycle = solveNumbers(each.program, machine)) {
            each.cycle = *cycle;
            each.peaks = peaks(*cycle, each.program, machine);
            each.rmsAccelerationMmPerS2 = rmsAcceleration(*cycle, each.program);
            each.isFeasible = isFeasible(each.program, machine);
        }
        ranked.push_back(each);
    }
    const auto rank = [](const RankedLaw& each) {
        return std::tuple(!each.cycle, each.cycle ? each.peaks.accelerationMmPerS2 : 0,
                          each.cycle ? each.rmsAccelerationMmPerS2 : 0,
                          each.cycle ? each.peaks.jerkMmPerS3 : 0);
    };
    std::ranges::stable_sort(ranked, {}, rank);
    return ranked;
}

} // namespace campanel::profile
