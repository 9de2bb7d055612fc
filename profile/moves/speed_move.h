// SPDX-License-Identifier: Apache-2.0
// The speed move: from one speed to another by a speed law, in a given time, over a given distance or as fast
// as the machine allows. The servo paper uses half a modified sine.
#pragma once

#include "profile/model/axis_motion.h"
#include "profile/program/programs.h"

#include <tl/expected.hpp>

namespace campanel::profile {

// Solves the move: one ramp, v = v0 + (v1 - v0) g(t / T), for increasing speed. For decreasing speed (|v1| <
// |v0|) the law is mirrored in time, as the servo paper does with the second half of its curve. Refuses
// inputs out of range, a law that is not for speeds, and equal speeds. Refuses a distance that the speeds
// cannot travel, and a derived time outside the range of MoveTime. A refusal names valid inputs. A move that
// exceeds limits of the machine is solved; `broken` then names the limits and the nearest inputs that make
// the program feasible.
[[nodiscard]] tl::expected<AxisMotion, Refusal> solve(const SpeedMoveProgram& program,
                                                      const Machine& machine);

// Returns true when the program can be solved and exceeds no limit. Cheap.
[[nodiscard]] bool isFeasible(const SpeedMoveProgram& program, const Machine& machine);

// Returns the mean speed during the change: v0 + (v1 - v0) G(1), with 1 - G(1) for a mirrored law. Distance =
// mean speed times time. The law must be a speed law.
[[nodiscard]] double meanSpeedMmPerS(const SpeedMoveProgram& program);

} // namespace campanel::profile
