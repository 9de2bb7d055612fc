// SPDX-License-Identifier: Apache-2.0
// The edits of a recipe: enter a number, pin another pair, choose a law, drag the end of a segment. Recipes
// are values; these functions are independent of the screen.
#pragma once

#include "app/program/recipe.h"
#include "profile/cutter/rotary_cutter.h"
#include "profile/laws/laws.h"

namespace campanel::panel {

using program::Recipe;

// Enters a value. A derived one of the four becomes pinned, and the pinned one with the oldest edit becomes
// derived.
void enterField(Recipe& recipe, profile::Field field, double value);

// Pins a derived field at its present value, or unpins a pinned one in favor of its counterpart; no number
// changes. The counterparts are bag length and film speed, rate and base speed.
void togglePin(Recipe& recipe, profile::Field field);

// Copies the four numbers of a solution, so that a derived one can be pinned unchanged.
void adopt(Recipe& recipe, const profile::CycleNumbers& cycle);

void chooseLaw(Recipe& recipe, const profile::Law& law);

// The range for the end of segment `index` (0..3), as shares of the cycle: a gap to the neighbors remains.
struct ShareRange {
    double from = 0;
    double to = 1;
};
[[nodiscard]] ShareRange ratioRange(const Recipe& recipe, int index);
// Sets the end to that share of the cycle, or as near as the range allows.
void dragRatio(Recipe& recipe, int index, double share);

// Returns true when both describe the same motion of the same machine and master with the same name; derived
// numbers are ignored.
[[nodiscard]] bool sameRecipe(const Recipe& left, const Recipe& right);

} // namespace campanel::panel
