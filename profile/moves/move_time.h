// SPDX-License-Identifier: Apache-2.0
// What position and speed moves share: the grid of the time field, refusals, and the checked motion. Internal
// to profile/.
#pragma once

#include "profile/model/axis_motion.h"

#include <tl/expected.hpp>

namespace campanel::profile::detail {

// Nothing would move; `field` with this value is the reason.
[[nodiscard]] Refusal noMotion(Field field, double value);

// Friction alone takes all the torque that there is, so that no time is long enough.
[[nodiscard]] Refusal noTorqueLeft(const Machine& machine);

// The time rounded up to the grid of Field::MoveTime, so that what is feasible stays it; refuses what is
// beyond the range.
[[nodiscard]] tl::expected<double, Refusal> timeOnGrid(double shortestS);

// Peaks and broken limits, without suggestions.
[[nodiscard]] AxisMotion checkedMotion(MotionProfile motion, const Machine& machine);

} // namespace campanel::profile::detail
