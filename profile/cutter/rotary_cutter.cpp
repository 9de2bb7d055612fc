// SPDX-License-Identifier: Apache-2.0
// Solves a rotary cutter program. Equation (8) of the paper holds only for symmetric ramps. The weight W here
// does not need symmetry, because a mirrored ramp has exactly the travel of the ramp.
#include "profile/cutter/rotary_cutter.h"

#include "profile/cutter/cycle_shape.h"
#include "profile/cutter/nearest.h"
#include "profile/cutter/ratios.h"
#include "profile/cutter/validate.h"
#include "profile/laws/laws.h"
#include "profile/model/bounds.h"

#include <algorithm>
#include <cmath>

namespace campanel::profile {
namespace {

// The tolerance for negative base speeds: rounding of an exactly closing stroke.
constexpr double zeroSpeedToleranceMmPerS = 1e-6;

Refusal strokeCannotClose(const detail::CycleShape& shape, double bagLengthMm)
{
    Refusal refusal;
    refusal.limit = Limit::StrokeCannotClose;
    refusal.field = Field::BagLength;
    refusal.actual = bagLengthMm;
    refusal.allowed = shape.strokeMm / (shape.weight * shape.syncRatio);
    refusal.unit = info(Field::BagLength).unit;
    return refusal;
}

MotionProfile cycleMotion(const RotaryCutterProgram& program, const CycleNumbers& cycle)
{
    const Law& law = *findLaw(program.speedLaw);
    const double va = cycle.baseSpeedMmPerS;
    const double vb = cycle.filmSpeedMmPerS;
    MotionProfile motion;
    motion.addConstant(cycle.taS, va);
    motion.addRamp(cycle.tbS - cycle.taS, va, vb, law, program.speedLawParameters, false);
    motion.addConstant(cycle.tcS - cycle.tbS, vb);
    motion.addRamp(cycle.tdS - cycle.tcS, vb, va, law, program.speedLawParameters, true);
    motion.addConstant(cycle.cycleTimeS - cycle.tdS, va);
    return motion;
}

} // namespace

bool isPinned(const RotaryCutterProgram& program, Field field)
{
    return program.pinned[0] == field || program.pinned[1] == field;
}

tl::expected<CycleNumbers, Refusal> detail::solveValid(const RotaryCutterProgram& program,
                                                       const CycleShape& shape)
{
    CycleValues values = closeCycle(shape, {program.pinned[0], value(program, program.pinned[0])},
                                    {program.pinned[1], value(program, program.pinned[1])});
    if (values.baseSpeedMmPerS < -zeroSpeedToleranceMmPerS || values.cycleTimeS <= 0)
        return tl::unexpected(strokeCannotClose(shape, values.bagLengthMm));
    values.baseSpeedMmPerS = maxOf(values.baseSpeedMmPerS, 0.0);
    for (const Field field : cycleFields) {
        if (!isPinned(program, field) && !inRange(field, values.of(field)))
            return tl::unexpected(outOfRange(field, values.of(field)));
    }

    const double time = values.cycleTimeS;
    CycleNumbers cycle;
    cycle.bagLengthMm = values.bagLengthMm;
    cycle.rateBagsPerMin = 60 / time;
    cycle.baseSpeedMmPerS = values.baseSpeedMmPerS;
    cycle.filmSpeedMmPerS = values.filmSpeedMmPerS;
    cycle.cycleTimeS = time;
    cycle.strokeMm = shape.strokeMm;
    cycle.weightS = shape.weight * time;
    cycle.speedRatio = values.filmSpeedMmPerS / values.baseSpeedMmPerS;
    cycle.taS = time / program.k[0];
    cycle.tbS = time / program.k[1];
    cycle.tcS = time / program.k[2];
    cycle.tdS = time / program.k[3];
    return cycle;
}

tl::expected<CycleNumbers, Refusal> solveNumbers(const RotaryCutterProgram& program, const Machine& machine)
{
    if (auto refusal = detail::findInvalid(program, machine))
        return tl::unexpected(*std::move(refusal));
    return detail::solveValid(program, detail::cycleShape(program, machine));
}

tl::expected<RotaryCutter, Refusal> solve(const RotaryCutterProgram& program, const Machine& machine)
{
    tl::expected<CycleNumbers, Refusal> cycle = solveNumbers(program, machine);
    if (!cycle) {
        cycle.error().nearest = detail::nearestFeasible(program, machine, cycle.error());
        cycle.error().ramps = otherRamps(program, machine);
        return tl::unexpected(std::move(cycle.error()));
    }
    return RotaryCutter{program, machine, *cycle, cycleMotion(program, *cycle)};
}

} // namespace campanel::profile
