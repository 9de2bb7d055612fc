// SPDX-License-Identifier: Apache-2.0
#include "app/program/program_change.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace campanel::program {
namespace {

constexpr double minShare = 1.0 / 2048;

struct Side {
    const Recipe& recipe;
    const SolvedProgram& solved;

    [[nodiscard]] const profile::CamMaster& cam() const { return *profile::camMaster(recipe.program); }
    // The speed that goes on over the boundary: of the film, or of the master.
    [[nodiscard]] double referenceSpeed() const
    {
        return recipe.isCutter() ? solved.cutter->cycle.bagLengthMm / solved.cycleS()
                                 : std::abs(cam().masterRateRevPerMin);
    }
    [[nodiscard]] double boundaryHz(bool atEnd) const
    {
        return solved.pulsesPerMm * solved.motion.at(atEnd ? solved.cycleS() : 0.0).velocityMmPerS;
    }
    [[nodiscard]] double filmHz(const ChangeParameters& parameters) const
    {
        return solved.cutter->cycle.bagLengthMm * parameters.filmPulsesPerMm / solved.cycleS();
    }
    [[nodiscard]] double rampS(const ChangeParameters& parameters) const
    {
        return recipe.isCutter() || cam().masterRampS <= 0 ? parameters.rampS : cam().masterRampS;
    }
    [[nodiscard]] bool hasSCurve() const
    {
        return !recipe.isCutter() && cam().masterRamp == profile::RampShape::SCurve;
    }
};

// Of a ramp: its time and its travel at full speed, both over its whole time, from this share to full speed.
struct RampPart {
    double time = 0;
    double travel = 0;
};

// The S-curve has the share 2 x^2 up to x = 1/2 and 1 - 2 (1 - x)^2 beyond.
RampPart rampFrom(double share, bool isSCurve)
{
    if (!isSCurve)
        return {1 - share, (1 - share * share) / 2};
    if (share <= 0.5) {
        const double x = std::sqrt(share / 2);
        return {1 - x, 0.5 - 2 * x * x * x / 3};
    }
    const double left = std::sqrt((1 - share) / 2);
    return {left, left - 2 * left * left * left / 3};
}

// Returns the time of one cycle that begins and ends at this share of full speed, faster in between.
double slowedCycleS(double share, double rampS, double cycleS)
{
    const double peak = std::sqrt(share * share + cycleS / rampS);
    return peak < 1 ? 2 * rampS * (peak - share) : cycleS + rampS * (1 - share) * (1 - share);
}

// Returns the largest share of full speed before the boundary at which each axis keeps its step.
double shareOfSteps(const Side& before, const Side& behind, double ratio, const ChangeParameters& parameters)
{
    const Recipe& from = before.recipe;
    double share = std::numeric_limits<double>::infinity();
    const auto limit = [&](double beforeHz, double behindHz, double largestHz) {
        const double step = std::abs(behindHz * ratio - beforeHz);
        if (step > largestHz)
            share = std::min(share, largestHz / step);
    };
    const bool runsBackward =
        !from.isCutter() && (before.cam().masterRateRevPerMin < 0) != parameters.isReversed;
    limit(before.boundaryHz(!runsBackward), behind.boundaryHz(runsBackward), parameters.knifeStepHz);
    if (from.isCutter() && parameters.filmPulsesPerMm > 0) {
        limit(before.filmHz(parameters), behind.filmHz(parameters), parameters.filmStepHz);
        limit(parameters.flightPulses / before.solved.cycleS(),
              parameters.flightPulses / behind.solved.cycleS(), parameters.infeedStepHz);
    }
    return share;
}

bool waitsForProducts(const Recipe& from, const ChangeParameters& parameters)
{
    return from.isCutter() && parameters.filmPulsesPerMm > 0 && parameters.hasAntiCut;
}

// Returns the stretch in which a clutch engages at this share of full speed, in cycles: the film is
// accelerated as by the ramp.
double stretchCycles(const Side& side, double share, const ChangeParameters& parameters)
{
    return std::max(parameters.line->engage,
                    1.5 * share * share * side.rampS(parameters) / side.solved.cycleS());
}

ProgramChange behindLine(const Side& before, const Side& behind, double ratio, double steps,
                         const ChangeParameters& parameters)
{
    constexpr double slowest = 0.01; // a line that stands
    ProgramChange change;
    change.way = ChangeWay::FollowsLine;
    change.speedRatio = 1 / ratio;
    change.speedBefore = std::max(slowest, parameters.line->share);
    change.speedBehind = change.speedBefore * ratio;
    change.shareBefore = change.speedBefore;
    change.shareBehind = change.speedBehind;
    const double beforeS = before.solved.cycleS() / change.speedBefore;
    if (change.speedBehind > parameters.line->maxShare) {
        change.way = ChangeWay::TooFast;
    } else if (change.speedBefore > steps) {
        const double off = stretchCycles(before, change.speedBefore, parameters);
        const double on = stretchCycles(behind, change.speedBehind, parameters);
        change.way = ChangeWay::LeavesLine;
        change.slowingS = off * beforeS;
        change.timeS = off * beforeS + on * behind.solved.cycleS() / change.speedBehind;
        change.cycles = (off + on) / 2;
    } else if (waitsForProducts(before.recipe, parameters)) {
        change.productWaitS = 2 * beforeS;
    }
    return change;
}

} // namespace

bool changesWhileRunning(const Recipe& from, const Recipe& to)
{
    return from.kind() == to.kind() && (to.isCutter() || profile::camMaster(to.program) != nullptr);
}

std::optional<ProgramChange> programChange(const Recipe& from, const SolvedProgram& solvedFrom,
                                           const Recipe& to, const SolvedProgram& solvedTo,
                                           const ChangeParameters& parameters)
{
    const Side before{from, solvedFrom};
    const Side behind{to, solvedTo};
    const double ratio = before.referenceSpeed() / behind.referenceSpeed();
    const double steps = shareOfSteps(before, behind, ratio, parameters);
    if (parameters.line)
        return behindLine(before, behind, ratio, steps, parameters);
    const double share = std::min({1.0, 1.0 / ratio, steps});
    if (share < minShare)
        return std::nullopt;

    const double shareBehind = std::min(1.0, share * ratio);
    const RampPart down = rampFrom(share, before.hasSCurve());
    const RampPart up = rampFrom(shareBehind, behind.hasSCurve());
    const double downS = before.rampS(parameters);
    const double upS = behind.rampS(parameters);
    ProgramChange change;
    change.speedRatio = 1 / ratio;
    change.shareBefore = share;
    change.shareBehind = shareBehind;
    change.slowingS = down.time * downS;
    change.timeS = down.time * downS + up.time * upS;
    change.cycles = down.travel * downS / solvedFrom.cycleS() + up.travel * upS / solvedTo.cycleS();
    if (waitsForProducts(from, parameters))
        change.productWaitS = 2 * slowedCycleS(share, downS, solvedFrom.cycleS());
    return change;
}

} // namespace campanel::program
