// SPDX-License-Identifier: Apache-2.0
// All angles are those of the knife's shaft, not of the master.
#include "profile/cutter/jaw.h"

#include "profile/cutter/cycle_shape.h"

#include <numbers>

namespace campanel::profile {
namespace {

constexpr double radPerDeg = std::numbers::pi / 180;
constexpr double msPerS = 1000;

} // namespace

double jawArcMm(const Machine& machine)
{
    return machine.knifeRadiusMm * machine.contactAngleDeg * radPerDeg;
}

double requiredWindowDeg(const Machine& machine)
{
    return machine.contactAngleDeg > 0 ? machine.contactAngleDeg + jawMarginDeg : 0;
}

double windowDeg(const CycleNumbers& cycle, const Machine& machine)
{
    return cycle.filmSpeedMmPerS * (cycle.tcS - cycle.tbS) / machine.knifeRadiusMm / radPerDeg;
}

double sealTimeMs(const CycleNumbers& cycle, const Machine& machine)
{
    return msPerS * jawArcMm(machine) / cycle.filmSpeedMmPerS;
}

CutterLengths cutterLengths(const RotaryCutterProgram& program, const Machine& machine)
{
    const detail::CycleShape shape = detail::cycleShape(program, machine);
    const double window = 1 / program.k[2] - 1 / program.k[1];
    const double c = shape.syncRatio;
    CutterLengths lengths;
    lengths.equalSpeedMm = shape.strokeMm / c;
    lengths.jawMm = jawArcMm(machine) / (c * window);
    lengths.jawWithMarginMm = machine.knifeRadiusMm * requiredWindowDeg(machine) * radPerDeg / (c * window);
    lengths.dwellMm = (2 * shape.strokeMm - jawArcMm(machine)) / c;
    lengths.strokeMm = shape.strokeMm / (c * shape.weight);
    return lengths;
}

} // namespace campanel::profile
