// SPDX-License-Identifier: Apache-2.0
#include "app/program/program_change.h"

#include <algorithm>
#include <cmath>

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
        return (solved.cutter->cycle.bagLengthMm + parameters.lengthTrimMm) * parameters.filmPulsesPerMm /
               solved.cycleS();
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
    double share = std::min(1.0, 1.0 / ratio);
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
        limit(parameters.flightPulses / solvedFrom.cycleS(), parameters.flightPulses / solvedTo.cycleS(),
              parameters.infeedStepHz);
    }
    if (share < minShare)
        return std::nullopt;

    const double shareBehind = std::min(1.0, share * ratio);
    const RampPart down = rampFrom(share, before.hasSCurve());
    const RampPart up = rampFrom(shareBehind, behind.hasSCurve());
    const double downS = before.rampS(parameters);
    const double upS = behind.rampS(parameters);
    const bool hasProducts = from.isCutter() && parameters.filmPulsesPerMm > 0 && parameters.hasAntiCut;
    return ProgramChange{share, shareBehind, down.time * downS + up.time * upS,
                         down.travel * downS / solvedFrom.cycleS() + up.travel * upS / solvedTo.cycleS(),
                         hasProducts ? 2 * slowedCycleS(share, downS, solvedFrom.cycleS()) : 0.0};
}

} // namespace campanel::program
