// SPDX-License-Identifier: Apache-2.0
// Comparison of two bank headers, field by field.
#include "app/program/differences.h"

#include "app/program/register_fields.h"
#include "modbus/codec.h"

#include <algorithm>

namespace campanel::program {

std::vector<Difference> differences(std::span<const std::uint16_t> a, std::span<const std::uint16_t> b)
{
    std::vector<Difference> found;
    const modbus::RegisterReader readA(a, 0);
    const modbus::RegisterReader readB(b, 0);
    for (const modbus::RegisterInfo& info : modbus::bankFields()) {
        if (!info.name.starts_with("program.") ||
            !info.appliesTo(modbus::ProgramKind::RotaryCutter, modbus::TableLayout::StepTable))
            continue;
        if (std::ranges::equal(a.subspan(info.address, info.count), b.subspan(info.address, info.count)))
            continue;
        Difference difference;
        difference.info = &info;
        const auto known = std::ranges::find(registerFields, info.name, &RegisterField::registerName);
        if (known != registerFields.end())
            difference.field = known->field;
        if (info.type == modbus::RegisterType::Text) {
            difference.textA = readA.text(info);
            difference.textB = readB.text(info);
        } else {
            difference.a = readA.physical(info);
            difference.b = readB.physical(info);
        }
        found.push_back(std::move(difference));
    }
    return found;
}

} // namespace campanel::program
