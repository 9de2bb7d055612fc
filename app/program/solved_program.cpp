// SPDX-License-Identifier: Apache-2.0
// Solves each kind of program by a function of its own.
#include "app/program/solved_program.h"

#include "profile/cam/point_cam.h"
#include "profile/model/vibration.h"
#include "profile/moves/position_move.h"
#include "profile/moves/speed_move.h"
#include "profile/press/press.h"
#include "profile/segments/segment_cam.h"

#include <cmath>

namespace campanel::program {
namespace {

using Solved = tl::expected<SolvedProgram, profile::Refusal>;

Solved ofCutter(tl::expected<profile::RotaryCutter, profile::Refusal> cutter)
{
    if (!cutter)
        return tl::unexpected(std::move(cutter.error()));
    SolvedProgram solved;
    solved.machine = cutter->machine;
    solved.motion = cutter->motion;
    solved.peaks = profile::peaks(*cutter);
    solved.broken = profile::checkLimits(*cutter);
    solved.marksS = {cutter->cycle.taS, cutter->cycle.tbS, cutter->cycle.tcS, cutter->cycle.tdS};
    solved.pulsesPerMm = profile::pulsesPerMm(cutter->machine);
    solved.load = profile::knifeLoad(cutter->machine);
    solved.cutter = std::move(*cutter);
    return solved;
}

Solved ofAxis(tl::expected<profile::AxisMotion, profile::Refusal> axis, const profile::Machine& machine)
{
    if (!axis)
        return tl::unexpected(std::move(axis.error()));
    SolvedProgram solved;
    solved.machine = machine;
    solved.motion = std::move(axis->motion);
    solved.peaks = axis->peaks;
    solved.broken = std::move(axis->broken);
    solved.marksS = std::move(axis->marksS);
    solved.pulsesPerMm = profile::axisPulsesPerMm(machine);
    if (std::isfinite(solved.peaks.torqueNm))
        solved.load = profile::axisLoad(machine);
    return solved;
}

struct Solver {
    const profile::Machine& machine;

    Solved operator()(const profile::RotaryCutterProgram& program) const
    {
        return ofCutter(profile::solve(program, machine));
    }
    template <typename P> Solved operator()(const P& program) const
    {
        return ofAxis(profile::solve(program, machine), machine);
    }
};

} // namespace

tl::expected<SolvedProgram, profile::Refusal> solveProgram(const Recipe& recipe)
{
    return std::visit(Solver{recipe.machine}, recipe.program);
}

CamSource camSource(const Recipe& recipe, const SolvedProgram& solved)
{
    return std::visit(
        [&solved]<typename P>(const P& program) -> CamSource {
            if constexpr (std::is_base_of_v<profile::CamMaster, P>)
                return {profile::forwardMotion(program), profile::CamUse::Repeats};
            else
                return {solved.motion, profile::CamUse::Once};
        },
        recipe.program);
}

double vibrationMm(const Recipe& recipe, const SolvedProgram& solved)
{
    if (solved.cutter)
        return profile::sealErrorMm(*solved.cutter);
    const profile::ShaftMode mode = profile::shaftMode(solved.machine);
    return profile::camMaster(recipe.program) ? profile::cycleErrorMm(solved.motion, mode)
                                              : profile::residualAmplitudeMm(solved.motion, mode);
}

profile::Curves sampleCurves(const SolvedProgram& solved, std::size_t points)
{
    profile::Curves curves = profile::sampleCurves(solved.motion, solved.pulsesPerMm, points);
    profile::addTorque(curves, solved.load);
    return curves;
}

} // namespace campanel::program
