// SPDX-License-Identifier: Apache-2.0
#include "app/machine/recipe_edit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace campanel::machine {

namespace {

using profile::Field;

// Smallest share of a cycle between two ends of stretches that a finger can leave.
constexpr double smallestGap = 0.01;

using program::pinnableFields;

Field counterpart(Field field)
{
    switch (field) {
    case Field::BagLength:
        return Field::FilmSpeed;
    case Field::FilmSpeed:
        return Field::BagLength;
    case Field::Rate:
        return Field::BaseSpeed;
    default:
        return Field::Rate;
    }
}

// pinned[0] is the one that was edited longest ago.
void pin(profile::RotaryCutterProgram& program, Field field)
{
    if (program.pinned[1] == field)
        return;
    program.pinned = {program.pinned[1], field};
}

} // namespace

bool isPinnable(Field field)
{
    return std::ranges::find(pinnableFields, field) != pinnableFields.end();
}

void enterField(Recipe& recipe, Field field, double value)
{
    program::setValue(recipe, field, value);
    if (isPinnable(field))
        pin(recipe.program, field);
}

void togglePin(Recipe& recipe, Field field)
{
    auto& pinned = recipe.program.pinned;
    if (!profile::isPinned(recipe.program, field)) {
        pin(recipe.program, field);
        return;
    }
    Field successor = counterpart(field);
    if (profile::isPinned(recipe.program, successor)) {
        const auto isFree = [&](Field candidate) { return !profile::isPinned(recipe.program, candidate); };
        successor = *std::ranges::find_if(pinnableFields, isFree);
    }
    const Field kept = pinned[0] == field ? pinned[1] : pinned[0];
    pinned = {kept, successor};
}

void adopt(Recipe& recipe, const profile::CycleNumbers& cycle)
{
    recipe.program.bagLengthMm = cycle.bagLengthMm;
    recipe.program.rateBagsPerMin = cycle.rateBagsPerMin;
    recipe.program.baseSpeedMmPerS = cycle.baseSpeedMmPerS;
    recipe.program.filmSpeedMmPerS = cycle.filmSpeedMmPerS;
}

void chooseLaw(Recipe& recipe, const profile::Law& law)
{
    if (recipe.program.speedLaw == law.id)
        return;
    recipe.program.speedLaw = law.id;
    recipe.program.speedLawParameters = profile::defaultParameters(law);
}

ShareRange ratioRange(const Recipe& recipe, int index)
{
    const auto& k = recipe.program.k;
    const auto at = static_cast<std::size_t>(index);
    ShareRange range;
    range.from = at == 0 ? smallestGap : 1 / k[at - 1] + smallestGap;
    range.to = at + 1 == k.size() ? 1 - smallestGap : 1 / k[at + 1] - smallestGap;
    range.from = std::min(range.from, range.to);
    return range;
}

void dragRatio(Recipe& recipe, int index, double share)
{
    const ShareRange range = ratioRange(recipe, index);
    const double kept = std::clamp(std::isfinite(share) ? share : range.from, range.from, range.to);
    recipe.program.k[static_cast<std::size_t>(index)] = profile::snapToGrid(Field::K1, 1 / kept);
}

bool sameRecipe(const Recipe& leftGiven, const Recipe& rightGiven)
{
    // As the controller holds them: a derived number that was pinned has more digits than its register.
    const Recipe left = program::quantised(leftGiven);
    const Recipe right = program::quantised(rightGiven);
    if (left.name != right.name || left.program.speedLaw != right.program.speedLaw)
        return false;
    const auto* law = profile::findLaw(left.program.speedLaw);
    const std::size_t parameters = law ? law->parameters.size() : 0;
    if (!std::equal(left.program.speedLawParameters.begin(),
                    left.program.speedLawParameters.begin() + parameters,
                    right.program.speedLawParameters.begin()))
        return false;
    const auto isSame = [&](Field field) {
        if (isPinnable(field) && !profile::isPinned(left.program, field))
            return !profile::isPinned(right.program, field);
        return program::value(left, field) == program::value(right, field);
    };
    const auto samePins = [&](Field field) {
        return profile::isPinned(left.program, field) == profile::isPinned(right.program, field);
    };
    return std::ranges::all_of(pinnableFields, samePins) &&
           std::ranges::all_of(program::programFields, isSame) &&
           std::ranges::all_of(program::machineFields, isSame);
}

} // namespace campanel::machine
