// SPDX-License-Identifier: Apache-2.0
// The speed move: from one speed to another by a speed law, in a given time, over a given distance or as fast
// as the machine allows. The servo paper makes it with half a modified sine.
#pragma once

#include "profile/model/axis_motion.h"
#include "profile/program/programs.h"

#include <tl/expected.hpp>

namespace campanel::profile {

// One ramp, v = v0 + (v1 - v0) g(t / T), from rest or slowly to fast. From fast to slowly (|v1| < |v0|) it is
// the law mirrored in time, as the servo paper takes the second half of its curve to slow down. Refuses
// inputs out of range, a law that is none for speeds, equal speeds, a distance that the speeds cannot travel,
// and a time outside the range of MoveTime that follows from the others; a refusal names inputs that work.
// What asks too much of the machine is solved; `broken` then names the limits and the nearest inputs with
// which the whole program is feasible.
[[nodiscard]] tl::expected<AxisMotion, Refusal> solve(const SpeedMoveProgram& program,
                                                      const Machine& machine);

// True when the program can be solved and breaks no limit. Cheap.
[[nodiscard]] bool isFeasible(const SpeedMoveProgram& program, const Machine& machine);

// Mean speed while the speed changes: v0 + (v1 - v0) G(1), with 1 - G(1) for a mirrored law. Distance = mean
// speed times time. The law must be a speed law.
[[nodiscard]] double meanSpeedMmPerS(const SpeedMoveProgram& program);

} // namespace campanel::profile
