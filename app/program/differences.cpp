// SPDX-License-Identifier: Apache-2.0
// Compares two bank headers field by field.
#include "app/program/differences.h"

#include "app/program/register_fields.h"
#include "modbus/map/codec.h"

#include <algorithm>

namespace campanel::program {

namespace {

constexpr std::uint16_t firstInput = 15; // start of the entered values in the header

std::string_view suffixOf(std::string_view name)
{
    return name.substr(name.find('.') + 1);
}

// Returns true for an input, or for the layout because the execution is an input; other figures follow from
// them.
bool isCompared(const modbus::RegisterInfo& info, const KindInfo& kind, modbus::TableLayout layout)
{
    if (!info.appliesTo(static_cast<modbus::ProgramKind>(kind.kind), layout) ||
        info.type == modbus::RegisterType::Block)
        return false;
    return info.address >= firstInput || info.name == "bank.layout" || info.name == "cam.master_ramp" ||
           info.name == "cam.ramp_shape";
}

} // namespace

std::vector<Difference> differences(std::span<const std::uint16_t> a, std::span<const std::uint16_t> b)
{
    std::vector<Difference> found;
    const modbus::RegisterReader readA(a, 0);
    const modbus::RegisterReader readB(b, 0);
    const auto compare = [&](const modbus::RegisterInfo& info) {
        if (std::ranges::equal(a.subspan(info.address, info.count), b.subspan(info.address, info.count)))
            return;
        Difference difference;
        difference.info = &info;
        const auto known =
            std::ranges::find(profile::fields, suffixOf(info.name), &profile::FieldInfo::registerName);
        if (known != profile::fields.end())
            difference.field = known->field;
        if (info.type == modbus::RegisterType::Text) {
            difference.textA = readA.text(info);
            difference.textB = readB.text(info);
        } else {
            difference.a = readA.physical(info);
            difference.b = readB.physical(info);
        }
        found.push_back(std::move(difference));
    };
    const modbus::RegisterInfo& kindRegister = modbus::registerNamed("bank.kind");
    const std::uint16_t kind = readA.u16("bank.kind");
    // Inputs of different kinds cannot be compared.
    if (kind != readB.u16("bank.kind") || kind == 0 || kind > kinds().size()) {
        compare(modbus::registerNamed("program.recipe_name"));
        compare(kindRegister);
        return found;
    }
    const KindInfo& info = kindInfo(static_cast<profile::ProgramKind>(kind));
    // Layouts use the same registers for different values: only common ones are compared.
    const auto layoutA = static_cast<modbus::TableLayout>(readA.u16("bank.layout"));
    const auto layoutB = static_cast<modbus::TableLayout>(readB.u16("bank.layout"));
    for (const modbus::RegisterInfo& each : modbus::bankFields()) {
        if (isCompared(each, info, layoutA) && isCompared(each, info, layoutB))
            compare(each);
    }
    return found;
}

} // namespace campanel::program
