// SPDX-License-Identifier: Apache-2.0
// Shared by position and speed moves: the grid of the time field, refusals, and the checked motion. Internal
// to profile/.
#pragma once

#include "profile/model/axis_motion.h"

#include <tl/expected.hpp>

namespace campanel::profile::detail {

// Returns the refusal of a move without motion, caused by this value of `field`.
[[nodiscard]] Refusal noMotion(Field field, double value);

// Returns the refusal of a move in any time, because friction takes all the peak or rated torque.
[[nodiscard]] Refusal noTorqueLeft(const Machine& machine, Limit limit);

// Rounds the time up to the grid of Field::MoveTime, so that a feasible move stays feasible. Refuses a time
// beyond the range.
[[nodiscard]] tl::expected<double, Refusal> timeOnGrid(double shortestS);

// Returns the motion with its peaks and exceeded limits, without suggestions.
[[nodiscard]] AxisMotion checkedMotion(MotionProfile motion, const Machine& machine);

} // namespace campanel::profile::detail
