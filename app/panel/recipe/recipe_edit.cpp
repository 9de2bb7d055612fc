// SPDX-License-Identifier: Apache-2.0
#include "app/panel/recipe/recipe_edit.h"

#include "app/program/cam_advance.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace campanel::panel {

namespace {

using profile::Field;

// The minimum share of a cycle between two ends of segments after a drag.
constexpr double minGap = 0.01;

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

// Pins a field; pinned[0] is the one with the oldest edit.
void pin(profile::RotaryCutterProgram& program, Field field)
{
    if (program.pinned[1] == field)
        return;
    program.pinned = {program.pinned[1], field};
}

} // namespace

void enterField(Recipe& recipe, Field field, double value)
{
    program::setValue(recipe, field, value);
    if (profile::isRatio(field))
        recipe.cutter().ratioMode = profile::RatioMode::ByHand;
    if (profile::isCycleField(field))
        pin(recipe.cutter(), field);
}

void togglePin(Recipe& recipe, Field field)
{
    if (!profile::isCycleField(field))
        return;
    auto& pinned = recipe.cutter().pinned;
    if (!profile::isPinned(recipe.cutter(), field)) {
        pin(recipe.cutter(), field);
        return;
    }
    Field successor = counterpart(field);
    if (profile::isPinned(recipe.cutter(), successor)) {
        const auto isFree = [&](Field candidate) { return !profile::isPinned(recipe.cutter(), candidate); };
        successor = *std::ranges::find_if(profile::cycleFields, isFree);
    }
    const Field kept = pinned[0] == field ? pinned[1] : pinned[0];
    pinned = {kept, successor};
}

void adopt(Recipe& recipe, const profile::CycleNumbers& cycle)
{
    recipe.cutter().bagLengthMm = cycle.bagLengthMm;
    recipe.cutter().rateBagsPerMin = cycle.rateBagsPerMin;
    recipe.cutter().baseSpeedMmPerS = cycle.baseSpeedMmPerS;
    recipe.cutter().filmSpeedMmPerS = cycle.filmSpeedMmPerS;
}

void chooseLaw(Recipe& recipe, const profile::Law& law)
{
    const auto code = static_cast<std::uint16_t>(law.id);
    profile::LawParameters* parameters = program::lawParameters(recipe.program);
    if (parameters == nullptr || program::choice(recipe.program, program::Choice::Law) == code)
        return;
    program::setChoice(recipe.program, program::Choice::Law, code);
    *parameters = profile::defaultParameters(law);
}

ShareRange ratioRange(const Recipe& recipe, int index)
{
    const auto& k = recipe.cutter().k;
    const auto at = static_cast<std::size_t>(index);
    ShareRange range;
    range.from = at == 0 ? minGap : 1 / k[at - 1] + minGap;
    range.to = at + 1 == k.size() ? 1 - minGap : 1 / k[at + 1] - minGap;
    range.from = std::min(range.from, range.to);
    return range;
}

void dragRatio(Recipe& recipe, int index, double share)
{
    const ShareRange range = ratioRange(recipe, index);
    const double kept = std::clamp(std::isfinite(share) ? share : range.from, range.from, range.to);
    recipe.cutter().k[static_cast<std::size_t>(index)] = profile::snapToGrid(Field::K1, 1 / kept);
    recipe.cutter().ratioMode = profile::RatioMode::ByHand;
}

bool sameRecipe(const Recipe& left, const Recipe& right)
{
    if (left.name != right.name || left.kind() != right.kind() || !program::sameCodes(left, right) ||
        left.master != right.master || left.trims != right.trims || left.windows != right.windows)
        return false;
    const program::KindInfo& kind = program::kindInfo(left.kind());
    const auto sameChoice = [&](const program::ChoiceInfo& each) {
        return program::choice(left.program, each.choice) == program::choice(right.program, each.choice);
    };
    if (!std::ranges::all_of(kind.choices, sameChoice))
        return false;
    if (const auto* parameters = program::lawParameters(left.program)) {
        const auto law = static_cast<profile::LawId>(program::choice(left.program, program::Choice::Law));
        const auto* known = profile::findLaw(law);
        const std::size_t count = known ? known->parameters.size() : 0;
        if (!std::equal(parameters->begin(), parameters->begin() + count,
                        program::lawParameters(right.program)->begin()))
            return false;
    }
    const auto isSame = [&](Field field) {
        const bool isRead = program::isRead(left.program, field);
        return isRead == program::isRead(right.program, field) &&
               (!isRead || program::value(left, field) == program::value(right, field));
    };
    const auto sameMachine = [&](Field field) {
        return program::value(left, field) == program::value(right, field);
    };
    return (!kind.list || kind.list->isEqual(left.program, right.program)) &&
           program::confirmedAdvanceMm(left.program) == program::confirmedAdvanceMm(right.program) &&
           std::ranges::all_of(kind.programFields, isSame) &&
           std::ranges::all_of(kind.machineFields, sameMachine);
}

} // namespace campanel::panel
