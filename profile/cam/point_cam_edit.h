// SPDX-License-Identifier: Apache-2.0
// What a person does with the knots of a cam: check and repair where it closes, insert, move, remove.
#pragma once

#include "profile/cam/point_cam.h"

#include <cstddef>
#include <optional>

namespace campanel::profile {

// A cam whose last slave misses the first by no more than this share of the knots' span is meant to be
// closed; a greater difference is the net advance of a progressive cam.
inline constexpr double closingShare = 0.01;

// What the slave does where the cycle closes, as entered, before scaling: value just after 0 degrees (with
// the net advance taken off) less value just before 360 degrees.
struct WrapCheck {
    double positionMm = 0; // the closing error of a cam that is meant to be closed; else 0
    double speedMmPerDeg = 0;
    double accelerationMmPerDeg2 = 0;
    double advanceMm = 0; // net advance per cycle of a progressive cam; 0 for one that is meant to be closed

    // No jump: to 1e-9 of the knots' span, per degree and per degree^2.
    bool isSmooth = true;
};

// The knots must pass checkKnots.
[[nodiscard]] WrapCheck wrapCheck(const PointCamProgram& program);

// The program with periodic ends and, when it is meant to be closed, the last slave set to the first.
[[nodiscard]] PointCamProgram repaired(PointCamProgram program);

// A new knot on the curve, at the nearest place of the grid that keeps its distance from the neighbors, and
// its index. Nothing when the cam has all the knots it can have or there is no room between the neighbors.
// The knots must pass checkKnots.
std::optional<std::size_t> insertKnot(PointCamProgram& program, double masterDeg);

// False, and nothing done, for the first or last knot, a cam of the fewest knots, or no such knot.
bool removeKnot(PointCamProgram& program, std::size_t index);

// Moves a knot as near to `wanted` as its neighbors and the grid allow and returns where it is now. The first
// and the last one keep their master angle; with periodic ends and equal slaves they move together, so that a
// closed cam stays closed. The knots must pass checkKnots; index < knots.size().
Knot moveKnot(PointCamProgram& program, std::size_t index, const Knot& wanted);

} // namespace campanel::profile
