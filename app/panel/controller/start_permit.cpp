// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/start_permit.h"

#include "app/panel/controller/controller.h"

namespace campanel::panel {

namespace {

constexpr auto permitNeeded = "parameter.permit_needed";

} // namespace

StartPermit::StartPermit(Controller& controller, QObject* parent)
    : ParameterFields(controller, parent)
{
    setFields({{&controller.parameter(permitNeeded), nullptr, true}});
}

void StartPermit::turnOn()
{
    const auto& identity = controller().identity();
    if (controller().isConnected() && identity && identity->hasRegister(permitNeeded))
        write(permitNeeded, 1);
}

QString StartPermit::words(const QString& name)
{
    return name == QLatin1String(permitNeeded) ? tr("Start only with permit") : QString();
}

QString StartPermit::label(const Field&) const
{
    return words(QLatin1String(permitNeeded));
}

QString StartPermit::note(const Field& field) const
{
    return field.parameter->isMissing() ? ParameterFields::note(field)
                                        : tr("On: no start that the panel blocks.");
}

} // namespace campanel::panel
