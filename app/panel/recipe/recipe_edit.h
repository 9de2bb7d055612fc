// SPDX-License-Identifier: Apache-2.0
// What a person does to a recipe: enter a number, pin another pair, pick a law, drag the end of a stretch.
// Recipes are values; these functions know no screen.
#pragma once

#include "app/program/recipe.h"
#include "profile/cutter/rotary_cutter.h"
#include "profile/laws/laws.h"

namespace campanel::machine {

using program::Recipe;

[[nodiscard]] bool isPinnable(profile::Field field);

// Enters a value. A derived one of the four becomes pinned, and the pinned one that was edited longest ago
// derived.
void enterField(Recipe& recipe, profile::Field field, double value);

// Pins a derived field at its present value, or releases a pinned one in favor of its counterpart (bag length
// and film speed, rate and base speed), so that no number changes.
void togglePin(Recipe& recipe, profile::Field field);

// Takes over the four numbers of a solution, so that a derived one can be pinned as it is.
void adopt(Recipe& recipe, const profile::CycleNumbers& cycle);

void chooseLaw(Recipe& recipe, const profile::Law& law);

// Range within which the end of stretch `index` (0..3) may be put, in shares of the cycle: a gap is kept to
// the neighbors.
struct ShareRange {
    double from = 0;
    double to = 1;
};
[[nodiscard]] ShareRange ratioRange(const Recipe& recipe, int index);
// Puts it at that share of the cycle, or as near as the range allows.
void dragRatio(Recipe& recipe, int index, double share);

// True when both describe the same motion of the same machine under the same name; derived numbers do not
// count.
[[nodiscard]] bool sameRecipe(const Recipe& left, const Recipe& right);

} // namespace campanel::machine
