// SPDX-License-Identifier: Apache-2.0
// The position move: from rest to rest over a distance by a displacement law, in a given time or as fast as
// the machine allows. The servo paper makes it with the quintic.
#pragma once

#include "profile/model/axis_motion.h"
#include "profile/program/programs.h"

#include <array>
#include <optional>
#include <tl/expected.hpp>

namespace campanel::profile {

// One stretch: s = S g(t / T). Refuses inputs out of range, a law that is none for displacements, a distance
// of zero, and Fastest when no time in the range of MoveTime will do; a refusal names inputs that work. A
// given time that asks too much of the machine is solved; `broken` then names the limits and the nearest
// inputs with which the whole program is feasible. OverDistance means the same as GivenTime: a distance is
// always given.
[[nodiscard]] tl::expected<AxisMotion, Refusal> solve(const PositionMoveProgram& program,
                                                      const Machine& machine);

// True when the program can be solved and breaks no limit. Cheap.
[[nodiscard]] bool isFeasible(const PositionMoveProgram& program, const Machine& machine);

// C0 to C7 of s = sum of C_i t^i, s in mm and t in ms, as the servo paper writes its quintic; nothing for a
// law that is not one polynomial.
using PolynomialCoefficients = std::array<double, 8>;
[[nodiscard]] std::optional<PolynomialCoefficients> polynomialCoefficients(LawId law, double distanceMm,
                                                                           double timeS);

} // namespace campanel::profile
