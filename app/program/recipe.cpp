// SPDX-License-Identifier: Apache-2.0
// Access to a recipe's values by field, and their rounding to what the registers hold.
#include "app/program/recipe.h"

#include "app/program/register_fields.h"
#include "modbus/codec.h"

#include <algorithm>

namespace campanel::program {

bool isProgramField(profile::Field field)
{
    return std::ranges::find(programFields, field) != programFields.end();
}

double value(const Recipe& recipe, profile::Field field)
{
    return isProgramField(field) ? profile::value(recipe.program, field)
                                 : profile::value(recipe.machine, field);
}

void setValue(Recipe& recipe, profile::Field field, double value)
{
    if (isProgramField(field))
        profile::setValue(recipe.program, field, value);
    else
        profile::setValue(recipe.machine, field, value);
}

Recipe quantised(const Recipe& recipe)
{
    Recipe result = recipe;
    for (const RegisterField& entry : registerFields) {
        const bool unread = std::ranges::find(pinnableFields, entry.field) != pinnableFields.end() &&
                            !profile::isPinned(recipe.program, entry.field);
        if (unread) {
            setValue(result, entry.field, 0.0);
            continue;
        }
        const auto rounded =
            modbus::quantise(modbus::registerNamed(entry.registerName), value(recipe, entry.field));
        if (rounded)
            setValue(result, entry.field, *rounded);
    }
    const modbus::RegisterInfo& parameter = modbus::registerNamed("program.law_parameter1");
    for (double& given : result.program.speedLawParameters)
        given = modbus::quantise(parameter, given).value_or(given);
    result.name = modbus::fittingUtf8(recipe.name, longestNameBytes);
    // Which of the two was pinned first is not kept.
    std::ranges::sort(result.program.pinned);
    return result;
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
