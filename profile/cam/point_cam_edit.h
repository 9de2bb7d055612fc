// SPDX-License-Identifier: Apache-2.0
// Edits the knots of a cam: check and repair of the wrap, insert, move, remove.
#pragma once

#include "profile/cam/point_cam.h"

#include <cstddef>
#include <optional>

namespace campanel::profile {

// The jump of the curve at the wrap, before scaling. It is the value just after 0 degrees minus the value
// just before 360 degrees. The position never jumps: it is closed, or advances.
struct WrapCheck {
    double speedMmPerDeg = 0;
    double accelerationMmPerDeg2 = 0;
    double advanceMm = 0; // net advance per cycle of a progressive cam; 0 for a closed one

    // True without a jump: to 1e-9 of the knots' span, per degree and per degree^2.
    bool isSmooth = true;
};

// Computes the check. The knots must pass checkKnots().
[[nodiscard]] WrapCheck wrapCheck(const PointCamProgram& program);

// Returns the program with the last slave at the first one: without an advance, whatever it was.
[[nodiscard]] PointCamProgram closed(PointCamProgram program);

// Returns the program with periodic ends, and without its closing error.
[[nodiscard]] PointCamProgram repaired(PointCamProgram program);

// Inserts a knot on the curve, at the nearest grid point that keeps the minimum distance to the neighbors,
// and returns its index. Returns nothing when the cam has the maximum number of knots or the neighbors leave
// no room. The knots must pass checkKnots().
std::optional<std::size_t> insertKnot(PointCamProgram& program, double masterDeg);

// Removes a knot. Returns false without a change for the first or last knot, the minimum number of knots, or
// an invalid index.
bool removeKnot(PointCamProgram& program, std::size_t index);

// Moves a knot as near to `wanted` as its neighbors and the grid allow and returns its new place. The first
// and the last knot keep their master angle. With periodic ends and equal slaves they move together, so that
// a closed cam stays closed. The knots must pass checkKnots(); index < knots.size().
Knot moveKnot(PointCamProgram& program, std::size_t index, const Knot& wanted);

} // namespace campanel::profile
