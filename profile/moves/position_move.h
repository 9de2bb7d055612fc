// SPDX-License-Identifier: Apache-2.0
// The position move: from rest to rest over a distance by a displacement law, in a given time or as fast as
// the machine allows. The servo paper uses the quintic.
#pragma once

#include "profile/model/axis_motion.h"
#include "profile/program/programs.h"

#include <array>
#include <optional>
#include <tl/expected.hpp>

namespace campanel::profile {

// Solves the move: one segment s = S g(t / T). Refuses inputs out of range, a law that is not for
// displacements, and a distance of zero. Refuses Fastest when no time in the range of MoveTime is sufficient.
// A refusal names valid inputs. A given time that exceeds limits of the machine is solved; `broken` then
// names the limits and the nearest inputs that make the program feasible. OverDistance means the same as
// GivenTime: a distance is always given.
[[nodiscard]] tl::expected<AxisMotion, Refusal> solve(const PositionMoveProgram& program,
                                                      const Machine& machine);

// Returns true when the program can be solved and exceeds no limit. Cheap.
[[nodiscard]] bool isFeasible(const PositionMoveProgram& program, const Machine& machine);

// The coefficients C0 to C7 of s = sum of C_i t^i, s in mm and t in ms, as in the servo paper's quintic.
// Nothing for a law that is not one polynomial.
using PolynomialCoefficients = std::array<double, 8>;
[[nodiscard]] std::optional<PolynomialCoefficients> polynomialCoefficients(LawId law, double distanceMm,
                                                                           double timeS);

} // namespace campanel::profile
