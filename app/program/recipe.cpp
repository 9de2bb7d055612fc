// SPDX-License-Identifier: Apache-2.0
// Access to a recipe's values by field, and rounding to register values.
#include "app/program/recipe.h"

#include "app/program/register_fields.h"
#include "modbus/map/codec.h"
#include "modbus/map/register_map.h"
#include "profile/cutter/ratios.h"
#include "profile/laws/laws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

namespace campanel::program {

const modbus::RegisterInfo* registerOf(const KindInfo& kind, std::string_view suffix)
{
    if (suffix.empty())
        return nullptr;
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

namespace {

std::vector<RegisterField> findRegisterFields(const KindInfo& kind)
{
    std::vector<RegisterField> found;
    for (const profile::FieldInfo& field : profile::fields) {
        if (const auto* info = registerOf(kind, field.registerName))
            found.push_back({field.field, info, field.unit == "s" && info->unit == "ms" ? 1000.0 : 1.0});
    }
    return found;
}

} // namespace

std::span<const RegisterField> registerFields(const KindInfo& kind)
{
    static const auto found = [] {
        std::vector<std::vector<RegisterField>> fields;
        std::ranges::transform(kinds(), std::back_inserter(fields), findRegisterFields);
        return fields;
    }();
    return found[static_cast<std::size_t>(kind.kind) - 1];
}

bool isProgramField(const Recipe& recipe, profile::Field field)
{
    const auto fields = kindInfo(recipe.kind()).programFields;
    return std::ranges::find(fields, field) != fields.end();
}

bool isInController(const Recipe& recipe, profile::Field field)
{
    const auto registers = registerFields(kindInfo(recipe.kind()));
    return isProgramField(recipe, field) &&
           std::ranges::find(registers, field, &RegisterField::field) != registers.end();
}

bool isCount(const Recipe& recipe, profile::Field field)
{
    const auto isCountOf = [field]<typename P>(const P&) {
        const profile::Member<P>* member = profile::memberOf<P>(field);
        return member != nullptr && member->isCount();
    };
    return isProgramField(recipe, field) ? std::visit(isCountOf, recipe.program) : isCountOf(recipe.machine);
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
    for (const RegisterField& entry : registerFields(kind)) {
        if (profile::isCycleField(entry.field) && !isRead(recipe.program, entry.field)) {
            setValue(result, entry.field, 0.0);
            continue;
        }
        if (const auto rounded = modbus::quantise(*entry.info, value(recipe, entry.field) * entry.perUnit))
            setValue(result, entry.field, *rounded / entry.perUnit);
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

double maxTrimMm(Trim trim)
{
    return modbus::findRegister(trimTable[static_cast<std::size_t>(trim)].registerName)->maximum;
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
