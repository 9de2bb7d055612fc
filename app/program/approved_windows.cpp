// SPDX-License-Identifier: Apache-2.0
#include "app/program/approved_windows.h"

#include "app/program/recipe.h"
#include "profile/cutter/rotary_cutter.h"

#include <algorithm>

namespace campanel::program {

namespace {

// Returns the recipe with all numbers of a cutter's cycle.
Recipe withCycle(Recipe recipe)
{
    if (!recipe.isCutter())
        return recipe;
    if (const auto cycle = profile::solveNumbers(recipe.cutter(), recipe.machine)) {
        recipe.cutter().bagLengthMm = cycle->bagLengthMm;
        recipe.cutter().rateBagsPerMin = cycle->rateBagsPerMin;
        recipe.cutter().baseSpeedMmPerS = cycle->baseSpeedMmPerS;
        recipe.cutter().filmSpeedMmPerS = cycle->filmSpeedMmPerS;
    }
    return recipe;
}

} // namespace

bool canHaveWindow(const Recipe& recipe, profile::Field field)
{
    return isProgramField(recipe, field) && !isCount(recipe, field);
}

std::vector<Excess> outsideWindows(const Recipe& recipe)
{
    std::vector<Excess> found;
    if (recipe.windows.empty())
        return found;
    const Recipe solved = withCycle(recipe);
    for (const auto& [field, window] : recipe.windows) {
        const bool isUsed =
            canHaveWindow(solved, field) && (profile::isCycleField(field) || isRead(solved.program, field));
        if (!isUsed)
            continue;
        const double number = value(solved, field);
        const double rounding = profile::info(field).resolution() / 2;
        if (!(number >= window.min - rounding && number <= window.max + rounding))
            found.push_back({field, number, window});
    }
    return found;
}

} // namespace campanel::program
