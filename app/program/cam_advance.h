// SPDX-License-Identifier: Apache-2.0
// The net advance of a cam, by which every cycle moves its axis on, and the confirmation that it is wanted.
#pragma once

#include "app/program/recipe.h"

#include <cstdint>
#include <span>

namespace campanel::program {

// Returns the net advance of the axis in mm per cycle, as in the table: to 1e-6 mm, with the slave scale,
// backward at a negative master rate. 0 for a closed cam, an invalid list and the other kinds.
[[nodiscard]] double advanceMm(const profile::Program& program);

// Returns the same for the table in a bank: the header and the recipe that it was decoded to.
[[nodiscard]] double advanceMm(std::span<const std::uint16_t> header, const Recipe& recipe);

// Returns the difference between the entered ends that the table closes, in mm before scaling.
[[nodiscard]] double closingErrorMm(const profile::Program& program);

// Returns true for a cam without an advance, or when a person has confirmed this one.
[[nodiscard]] bool isAdvanceConfirmed(const profile::Program& program);
void confirmAdvance(profile::Program& program);
// Returns the value that was confirmed, 0 for none.
[[nodiscard]] double confirmedAdvanceMm(const profile::Program& program);
void setConfirmedAdvance(profile::Program& program, double advanceMm);

// Changes the last knot, or the last segment that moves, so that the cam ends where it began.
void closeCam(profile::Program& program);

} // namespace campanel::program
