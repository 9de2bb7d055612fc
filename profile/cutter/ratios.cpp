// SPDX-License-Identifier: Apache-2.0
// The ratios on the grid of their fields, around the closed forms of the ramps.
#include "profile/cutter/ratios.h"

#include "profile/cutter/cutter_search.h"
#include "profile/cutter/validate.h"
#include "profile/laws/laws.h"
#include "profile/model/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace campanel::profile {
namespace {

using detail::CutterFigures;
using Ratios = std::array<double, 4>;

constexpr int bisections = 60; // to the precision of a double

// The window keeps its place while the ramps are shortened by at most this share of their length for it: the
// acceleration rises by less than its square near the optimum.
constexpr double placeTolerance = 0.01;

// Returns the task without its ramps: what is given by the window, the law and the machine.
RampTask emptyTask(const RotaryCutterProgram& program, const CutterFigures& figures)
{
    const MotionLimits limits = detail::motionLimits(figures);
    RampTask task;
    task.strokeMm = figures.shape.strokeMm;
    task.window = 1 / program.k[2] - 1 / program.k[1];
    task.lawTravel = figures.shape.lawTravel;
    task.lawPeak = figures.shape.lawPeaks.cv;
    task.lawSquare = figures.lawSquare;
    task.maxSpeedMmPerS = limits.maxSpeedMmPerS;
    task.maxAccelerationMmPerS2 = limits.maxAccelerationMmPerS2;
    task.maxSlowingMmPerS2 = limits.maxSlowingMmPerS2;
    task.maxRmsAccelerationMmPerS2 = limits.maxRmsAccelerationMmPerS2;
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

// The two ramps of a cycle, as shares of it.
struct Ramps {
    double there = 0;
    double back = 0;
};

// Returns the factor with which the ramps just fit beside the window.
double roomBeside(const Ratios& k, const Ramps& ramps)
{
    return minOf((1 / k[1] - minCycleShare) / ramps.there, (1 - 1 / k[2] - minCycleShare) / ramps.back);
}

// Moves the window to the middle of what the ramps leave when they do not fit beside it. It gets no narrower.
Ratios withRoom(Ratios k, const Ramps& ramps, double tolerance)
{
    const double room = roomBeside(k, ramps);
    if (room * (1 + tolerance) >= 1 && room > 0)
        return k;
    const double window = 1 / k[2] - 1 / k[1];
    k[2] = gridBelow(2 / (1 + window + ramps.there - ramps.back));
    k[1] = gridAbove(1 / (1 / k[2] - window));
    return k;
}

// Returns the ratios on the grid around these ramps beside the present window: the ramp back has the coarser
// grid, the other one follows it.
std::array<Ratios, 6> ratiosAround(const Ratios& present, const Ramps& ramps)
{
    const double step = info(Field::K1).resolution();
    const double begin = 1 / present[1];
    const double end = 1 / present[2];
    const double fitting = maxOf(ramps.back * minOf(1.0, roomBeside(present, ramps)), minCycleShare);
    std::array<Ratios, 6> found;
    found.fill(present);
    for (std::size_t i = 0; i < found.size(); ++i) {
        Ratios& k = found[i];
        k[3] =
            snapToGrid(Field::K4, gridBelow(1 / (end + fitting)) + (static_cast<double>(i / 2) - 1) * step);
        const double base = maxOf(begin - (1 / k[3] - end) * ramps.there / ramps.back, minCycleShare);
        // A large k1 needs few digits for its small time.
        constexpr double precision = 1e-5; // of the cycle
        const double coarse = maxOf(step, std::pow(10, std::floor(std::log10(precision / (base * base)))));
        const double below = std::floor(1 / base / coarse) * coarse;
        k[0] = snapToGrid(Field::K1, below + static_cast<double>(i % 2) * coarse);
    }
    return found;
}

// Returns the ramps whose mean suits the cycle that it makes itself. skewOf() gives their skew in a cycle.
template <typename Optimum, typename Skew>
Ramps solvedRamps(const RotaryCutterProgram& program, const CutterFigures& figures, Optimum optimum,
                  Skew skewOf)
{
    const RampTask empty = emptyTask(program, figures);
    const double mean = solvedRamp(program, empty, optimum);
    const RampTask task = taskAt(empty, program, mean);
    const double skew = task.filmMm > task.strokeMm ? skewOf(task) : -skewOf(task); // of the ramp there
    return {mean * (1 + skew), mean * (1 - skew)};
}

// Returns the ratios on the grid around the ramps of `optimum`, beside the window of the program.
template <typename Optimum, typename Skew>
std::array<Ratios, 6> ratiosFor(RotaryCutterProgram program, const CutterFigures& figures, Optimum optimum,
                                Skew skewOf, double tolerance)
{
    Ramps ramps = solvedRamps(program, figures, optimum, skewOf);
    if (const Ratios moved = withRoom(program.k, ramps, tolerance); moved != program.k) {
        program.k = moved; // its window is wider by the rounding
        ramps = solvedRamps(program, figures, optimum, skewOf);
    }
    return ratiosAround(program.k, ramps);
}

// Returns the ratios of ramps that are alike.
template <typename Optimum>
std::array<Ratios, 6> evenRatiosFor(const RotaryCutterProgram& program, const CutterFigures& figures,
                                    Optimum optimum, double tolerance = placeTolerance)
{
    return ratiosFor(
        program, figures, optimum, [](const RampTask&) { return 0.0; }, tolerance);
}

// Returns the ratios of the highest rate.
std::array<Ratios, 6> fastestRatiosFor(const RotaryCutterProgram& program, const CutterFigures& figures)
{
    return ratiosFor(
        program, figures, [](const RampTask& task) { return fastestRamps(task).mean; },
        [](const RampTask& task) { return fastestRamps(task).skew; }, placeTolerance);
}

// Returns the program with the ratios among these that have the lowest rank.
template <typename Rank>
RotaryCutterProgram withLowest(const RotaryCutterProgram& program, const std::array<Ratios, 6>& ratios,
                               Rank rank)
{
    RotaryCutterProgram best = program;
    std::optional<decltype(rank(program))> bestRank;
    for (const Ratios& k : ratios) {
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

// Returns the cycle of a program whose inputs are valid but for the order of its ratios.
std::optional<CycleNumbers> solved(const RotaryCutterProgram& program, const CutterFigures& figures)
{
    if (!detail::hasDescendingRatios(program))
        return std::nullopt;
    const auto cycle = detail::solveValid(program, detail::cycleShape(program, figures.shape));
    return cycle ? std::optional(*cycle) : std::nullopt;
}

// Ranks feasible programs first, then those with the lowest acceleration.
std::pair<bool, double> demandOf(const RotaryCutterProgram& program, const CutterFigures& figures)
{
    const auto cycle = solved(program, figures);
    return {!cycle || detail::firstBroken(*cycle, figures),
            cycle ? detail::peaks(*cycle, figures).accelerationMmPerS2
                  : std::numeric_limits<double>::infinity()};
}

// Returns the highest rate with these ratios, nothing when there is none.
std::optional<FastestRate> fastestOf(const RotaryCutterProgram& program, const CutterFigures& figures)
{
    const auto cycle = solved(program, figures);
    return cycle ? detail::fastestByHand(*cycle, program, figures) : std::nullopt;
}

// Returns true when the window leaves room for ramps.
bool leavesRoom(const RotaryCutterProgram& program)
{
    const double window = 1 / program.k[2] - 1 / program.k[1];
    return (1 - window) / 2 > 2 * minCycleShare;
}

// Returns true when everything but k1 and k4 is valid, and the window leaves room for ramps.
bool hasWindow(RotaryCutterProgram program, const Machine& machine)
{
    program.k[0] = info(Field::K1).max;
    program.k[3] = info(Field::K4).min;
    return !detail::findInvalid(program, machine) && leavesRoom(program);
}

} // namespace

RotaryCutterProgram withRatios(const RotaryCutterProgram& program, const Machine& machine)
{
    if (program.ratioMode == RatioMode::ByHand || !hasWindow(program, machine))
        return program;
    const CutterFigures figures(program, machine);
    const auto demand = [&figures](const RotaryCutterProgram& tried) { return demandOf(tried, figures); };
    const auto suiting = [&program](const RampTask& task) {
        return rampFor(program.ratioMode, program.rampPositionPercent, task);
    };
    RotaryCutterProgram wanted = withLowest(program, evenRatiosFor(program, figures, suiting), demand);
    if (detail::isFeasible(wanted, figures))
        return wanted;
    // Near a limit no ramp may be shortened to keep the place of the window.
    wanted = withLowest(program, evenRatiosFor(program, figures, suiting, 0), demand);
    if (detail::isFeasible(wanted, figures))
        return wanted;
    // At the limit a ramp may be feasible only before it is rounded.
    RotaryCutterProgram fastest = withLowest(program, fastestRatiosFor(program, figures), demand);
    return detail::isFeasible(fastest, figures) || !isFeasible(program, machine) ? fastest : program;
}

RotaryCutterProgram detail::withFastestRatios(RotaryCutterProgram program, double bagLengthMm,
                                              const CutterFigures& figures)
{
    // The ratios do not depend on the rate; at a low one every speed is within the range of its field.
    constexpr double lowRateBagsPerMin = 2;
    program.pinned = {Field::BagLength, Field::Rate};
    program.bagLengthMm = bagLengthMm;
    program.rateBagsPerMin = lowRateBagsPerMin;
    if (!leavesRoom(program))
        return program;
    // Where no rate is possible, a cycle that exists names the limit.
    const auto slowness = [&figures](const RotaryCutterProgram& tried) {
        const auto fastest = fastestOf(tried, figures);
        return fastest ? -fastest->rateBagsPerMin : solved(tried, figures) ? 0 : 1;
    };
    return withLowest(program, fastestRatiosFor(program, figures), slowness);
}

RotaryCutterProgram withFastestRatios(const RotaryCutter& cutter)
{
    return detail::withFastestRatios(cutter.program, cutter.cycle.bagLengthMm,
                                     {cutter.program, cutter.machine});
}

double rampPosition(const RotaryCutter& cutter)
{
    const CycleNumbers& cycle = cutter.cycle;
    RampTask task = emptyTask(cutter.program, {cutter.program, cutter.machine});
    task.filmMm = cutter.program.syncRatio * cycle.bagLengthMm;
    task.cycleTimeS = cycle.cycleTimeS;
    const double ramp = minOf(cycle.tbS - cycle.taS, cycle.tdS - cycle.tcS) / cycle.cycleTimeS;
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
    const double half = minOf(share / 2, middle - 2 * minCycleShare, 1 - middle - 2 * minCycleShare);
    if (!(half > 0))
        return program;
    program.k[1] = gridAbove(1 / (middle - half));
    program.k[2] = gridBelow(1 / (middle + half));
    const double begin = 1 / program.k[1] - there;
    const double end = 1 / program.k[2] + back;
    program.k[0] = snapToGrid(Field::K1, 1 / maxOf(begin, minCycleShare));
    program.k[3] = snapToGrid(Field::K4, 1 / minOf(end, 1 - minCycleShare));
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
        return minOf(1 / each.k[1] - 1 / each.k[0], 1 / each.k[3] - 1 / each.k[2]);
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
    const auto fastest = fastestRate(*solved, other, machine);
    offer.rateBagsPerMin = fastest ? fastest->rateBagsPerMin : 0;
    const auto present =
        detail::findInvalid(program, machine) ? std::nullopt : fastestOf(program, {program, machine});
    return offer.rateBagsPerMin > (present ? present->rateBagsPerMin : 0) ? std::optional(offer)
                                                                          : std::nullopt;
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
