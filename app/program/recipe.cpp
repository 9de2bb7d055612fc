// SPDX-License-Identifier: Apache-2.0
// Access to a recipe's values by field, and rounding to register values.
#include "app/program/recipe.h"

#include "app/program/register_fields.h"
#include "modbus/map/codec.h"
#include "profile/cutter/ratios.h"
#include "profile/laws/laws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace campanel::program {
const modbus::RegisterInfo* registerOf(const KindInfo& kind, std::string_view suffix)
{
    const auto* found = modbus::findRegister(std::string(kind.registerPrefix).append(suffix));
    const auto code = static_cast<modbus::ProgramKind>(kind.kind);
    const bool isOfKind = found != nullptr && found->appliesTo(code, kind.layouts.front());
    return isOfKind ? found : nullptr;
}

Recipe defaultRecipe(profile::ProgramKind kind)
{
    const KindInfo& info = kindInfo(kind);
    Recipe recipe;
    recipe.name = info.defaultName;
    recipe.program = info.defaultProgram();
    info.adaptMachine(recipe.machine);
    return recipe;
}

bool isProgramField(const Recipe& recipe, profile::Field field)
{
    const auto fields = kindInfo(recipe.kind()).programFields;
    return std::ranges::find(fields, field) != fields.end();
}

bool isInController(const Recipe& recipe, profile::Field field)
{
    const auto entry = std::ranges::find(registerFields, field, &RegisterField::field);
    return isProgramField(recipe, field) && entry != registerFields.end() &&
           registerOf(kindInfo(recipe.kind()), entry->suffix) != nullptr;
}

double value(const Recipe& recipe, profile::Field field)
{
    return isProgramField(recipe, field) ? value(recipe.program, field)
                                         : profile::value(recipe.machine, field);
}

void setValue(Recipe& recipe, profile::Field field, double value)
{
    if (isProgramField(recipe, field))
        setValue(recipe.program, field, value);
    else
        profile::setValue(recipe.machine, field, value);
}

Recipe quantised(const Recipe& recipe)
{
    Recipe result = recipe;
    const KindInfo& kind = kindInfo(recipe.kind());
    for (const RegisterField& entry : registerFields) {
        const modbus::RegisterInfo* info = registerOf(kind, entry.suffix);
        if (info == nullptr)
            continue;
        const bool isCycleValue = std::ranges::find(pinnableFields, entry.field) != pinnableFields.end();
        if (isCycleValue && !isRead(recipe.program, entry.field)) {
            setValue(result, entry.field, 0.0);
            continue;
        }
        const double unit = registerUnits(entry.field);
        if (const auto rounded = modbus::quantise(*info, value(recipe, entry.field) * unit))
            setValue(result, entry.field, *rounded / unit);
    }
    if (profile::LawParameters* parameters = lawParameters(result.program)) {
        for (std::size_t i = 0; i < parameters->size(); ++i) {
            const auto rounded =
                modbus::quantise(*registerOf(kind, lawParameterSuffixes[i]), (*parameters)[i]);
            (*parameters)[i] = rounded.value_or((*parameters)[i]);
        }
    }
    result.name = modbus::fittingUtf8(recipe.name, longestNameBytes);
    if (result.isCutter())
        std::ranges::sort(result.cutter().pinned); // the order of pinning is not stored
    if (kind.list != nullptr)
        kind.list->quantise(result.program);
    return result;
}

void followRatios(Recipe& recipe)
{
    if (!recipe.isCutter() || recipe.cutter().ratioMode == profile::RatioMode::ByHand)
        return;
    const Recipe rounded = quantised(recipe); // the motion that the controller gets
    recipe.cutter().k = profile::withRatios(rounded.cutter(), rounded.machine).k;
}

Recipe gentleRecipe(Recipe recipe)
{
    if (recipe.isCutter())
        recipe.cutter().ratioMode = profile::RatioMode::Gentle;
    followRatios(recipe);
    return recipe;
}

profile::Machine withController(const profile::Machine& machine, const modbus::Identity& controller)
{
    profile::Machine result = machine;
    result.timerClockHz = controller.timerClockHz;
    result.timerBits = controller.timerBits;
    result.rowCapacity = controller.rowCapacity;
    result.maxPulseFrequencyHz =
        std::min(machine.maxPulseFrequencyHz, static_cast<double>(controller.maxPulseFrequencyHz));
    return result;
}

} // namespace campanel::program
