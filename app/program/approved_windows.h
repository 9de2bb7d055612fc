// SPDX-License-Identifier: Apache-2.0
// The approved windows of a recipe: the lowest and the highest value that a technician has approved for an
// input. They are narrower than the limits of the machine, or equal, and never replace them.
#pragma once

#include "profile/model/fields.h"

#include <map>
#include <vector>

namespace campanel::program {

struct Recipe;

struct ApprovedWindow {
    double min = 0;
    double max = 0;

    bool operator==(const ApprovedWindow&) const = default;
};

using ApprovedWindows = std::map<profile::Field, ApprovedWindow>;

// A value outside its window.
struct Excess {
    profile::Field field = profile::Field::BagLength;
    double value = 0;
    ApprovedWindow window;

    bool operator==(const Excess&) const = default;
};

// Returns true for an input of the recipe's kind that is a measure: a count has no window.
[[nodiscard]] bool canHaveWindow(const Recipe& recipe, profile::Field field);

// Returns the values of the recipe that lie outside their windows, with the decimals that a person can enter.
// The numbers of a cutter's cycle that follow from the pinned ones count too; inputs that are not read do
// not.
[[nodiscard]] std::vector<Excess> outsideWindows(const Recipe& recipe);

} // namespace campanel::program
