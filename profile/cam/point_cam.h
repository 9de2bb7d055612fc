// SPDX-License-Identifier: Apache-2.0
// Free-form cams of the paper on electronic cams: a spline through knots, executed once per cam cycle of a
// virtual master that turns at its full speed.
#pragma once

#include "profile/cam/spline.h"
#include "profile/model/axis_motion.h"
#include "profile/program/programs.h"

#include <cstddef>
#include <optional>
#include <tl/expected.hpp>

namespace campanel::profile {

inline constexpr std::size_t leastKnots = 5;
inline constexpr std::size_t mostKnots = 100;
inline constexpr double camCycleDeg = 360;
inline constexpr double leastKnotSpacingDeg = 0.1;
inline constexpr double knotMasterStepDeg = 1e-4; // grid of a knot in the controller
inline constexpr double knotSlaveStepMm = 1e-3;
inline constexpr double mostSlaveMm = info(Field::Distance).max; // either side of zero
// The master's position is updated, and the slave's pulses are spread evenly, every so many seconds.
inline constexpr double masterUpdateS = 0.002;

// The first thing that is wrong with the knots: KnotCount, KnotRange, KnotOrder, KnotSpacing, KnotEnds.
[[nodiscard]] std::optional<Refusal> checkKnots(std::span<const Knot> knots);

// Knots as entered, before scaling: slave mm over master degrees. The knots must pass checkKnots.
[[nodiscard]] Spline camCurve(const PointCamProgram& program);

// Net advance of a cycle in mm, before scaling: last slave - first slave. 0 for a closed cam.
[[nodiscard]] double netAdvanceMm(const PointCamProgram& program);

// Seconds of one cam cycle at full speed: 60 / |rate| * masterRatio * masterScale. Infinite at rate 0.
[[nodiscard]] double camCycleS(const PointCamProgram& program);

// One cam cycle from the phase on, the master turning forwards whatever the sign of its rate. The cam table
// is made of this one: at a negative rate the controller runs the same table backwards.
[[nodiscard]] MotionProfile forwardMotion(const PointCamProgram& program);

// One cam cycle in time, from the phase on, backwards at a negative rate. Position is slave * slaveScale.
// Refusals: FieldRange, NoMotion (master rate, slave scale or the knots' span is 0), those of checkKnots.
// `broken`: limits of the axis; Overshoot of the curve (actual, allowed: mm before scaling); WrapJump when
// the step of speed where the cycle closes, spread over one update of the master, takes more than the largest
// acceleration or torque (mm/s); the peaks of both include it. The nearest master rate is added when it alone
// mends everything.
[[nodiscard]] tl::expected<AxisMotion, Refusal> solve(const PointCamProgram& program, const Machine& machine);

} // namespace campanel::profile
