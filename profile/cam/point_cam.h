// SPDX-License-Identifier: Apache-2.0
// The free-form cams of the paper on electronic cams: a spline through knots. The spline is executed once per
// cam cycle of a virtual master that turns at its full speed.
#pragma once

#include "profile/cam/cam_cycle.h"
#include "profile/cam/spline.h"

#include <cstddef>
#include <optional>
#include <tl/expected.hpp>

namespace campanel::profile {

inline constexpr std::size_t minKnots = 5;
inline constexpr std::size_t maxKnots = 100;

// Returns the first fault of the knots: KnotCount, KnotRange, KnotOrder, KnotSpacing, KnotEnds.
[[nodiscard]] std::optional<Refusal> checkKnots(std::span<const Knot> knots);

// Returns the curve through the knots before scaling: slave mm over master degrees. A closing error is
// closed: the curve ends at the first slave. The knots must pass checkKnots().
[[nodiscard]] Spline camCurve(const PointCamProgram& program);

// Returns the net advance of a cycle in mm, before scaling: last slave - first slave, 0 within the closing
// error.
[[nodiscard]] double netAdvanceMm(const PointCamProgram& program);
// Returns last slave - first slave where that is a closing error, which the curve does not have; else 0.
[[nodiscard]] double closingErrorMm(const PointCamProgram& program);

// Returns one cam cycle from the phase on with a forward master, regardless of the sign of the rate. The cam
// table is built from this motion: at a negative rate the controller runs the same table backward.
[[nodiscard]] MotionProfile forwardMotion(const PointCamProgram& program);

// Returns one cam cycle in time, from the phase on, backward at a negative rate. The position is slave *
// slaveScale. Refusals: FieldRange, NoMotion (master rate, slave scale or the span of the knots is 0), those
// of checkKnots(). `broken` lists limits of the axis and Overshoot of the curve (actual, allowed: mm before
// scaling). It lists WrapJump when the speed step at the wrap exceeds the maximum acceleration or torque
// (mm/s). The step is spread over one update of the master, and the peaks include it. The nearest master rate
// is added when it alone corrects everything.
[[nodiscard]] tl::expected<AxisMotion, Refusal> solve(const PointCamProgram& program, const Machine& machine);

} // namespace campanel::profile
