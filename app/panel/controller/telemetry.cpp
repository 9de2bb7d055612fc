// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/telemetry.h"

#include "app/link/link_values.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/numbers.h"
#include "app/panel/words/recipe_words.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace campanel::panel {

namespace {

using modbus::RegisterInfo;
using modbus::RegisterType;

QString nameOf(const RegisterInfo& info)
{
    return QString::fromLatin1(info.name);
}

// Returns the numbers of the group that is read while a cutter's program runs, in the order of their
// addresses.
const std::vector<const RegisterInfo*>& numbers()
{
    static const auto found = [] {
        std::vector<const RegisterInfo*> result;
        for (const RegisterInfo& info : modbus::registers()) {
            const bool isNumber =
                info.type != RegisterType::Text && info.type != RegisterType::Block && info.enumName.empty();
            if (isNumber && info.address >= modbus::packerAddress &&
                info.address < modbus::packerAddress + modbus::packerRegisters())
                result.push_back(&info);
        }
        return result;
    }();
    return found;
}

// Returns the decimals that a person reads of a measure.
int decimalsOf(const RegisterInfo& info)
{
    if (info.scale >= 1)
        return 0;
    return info.unit == "m" ? 1 : 2;
}

} // namespace

Telemetry::Telemetry(QObject* parent)
    : QQmlPropertyMap(this, parent)
{
    forget();
    freeze();
}

void Telemetry::take(std::uint16_t base, std::span<const std::uint16_t> registers)
{
    const modbus::RegisterReader reader(registers, base);
    for (const RegisterInfo* info : numbers()) {
        if (info->address >= base && info->address + info->count <= base + registers.size())
            insert(nameOf(*info), reader.physical(*info));
    }
}

void Telemetry::forget()
{
    for (const RegisterInfo* info : numbers())
        insert(nameOf(*info), unknown);
}

double Telemetry::number(const char* name) const
{
    return value(QString::fromLatin1(name)).toDouble();
}

QVariant Telemetry::updateValue(const QString& name, const QVariant& /*input*/)
{
    return value(name);
}

QString Telemetry::text(const QString& name, double value) const
{
    const RegisterInfo* info = modbus::findRegister(name.toStdString());
    if (info == nullptr || std::isnan(value))
        return Format::unknownText();
    const bool isSigned = info->type == RegisterType::I16 || info->type == RegisterType::I32;
    const QString sign = isSigned && value > 0 ? QStringLiteral("+") : QString();
    const int decimals = decimalsOf(*info);
    return sign + Format().measure(value, decimals, RecipeWords::unit(info->unit));
}

} // namespace campanel::panel
