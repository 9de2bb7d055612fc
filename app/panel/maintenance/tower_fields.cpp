// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/tower_fields.h"

#include "app/panel/controller/controller.h"
#include "app/panel/words/controller_sentences.h"
#include "app/panel/words/register_words.h"

#include <utility>
#include <vector>

namespace campanel::panel {

namespace {

constexpr std::string_view tableMode = "SignalMode";
constexpr std::string_view tableCondition = "SignalBit";

} // namespace

TowerFields::TowerFields(Controller& controller, QObject* parent)
    : ParameterFields(controller, parent)
{
    std::vector<Field> fields;
    for (const modbus::RegisterInfo& info : modbus::registers()) {
        if (info.enumName == tableMode)
            fields.push_back({&controller.parameter(info.name), nullptr, true});
    }
    m_first = fields.front().parameter;
    setFields(std::move(fields));
    connect(&controller, &Controller::connectionChanged, this, &TowerFields::changed);
}

QStringList TowerFields::conditions()
{
    return ControllerSentences::texts(tableCondition);
}

QStringList TowerFields::lights()
{
    return {tr("Red"), tr("Yellow"), tr("Green"), tr("Horn")};
}

QStringList TowerFields::modes()
{
    return ControllerSentences::texts(tableMode);
}

QString TowerFields::emptyText() const
{
    if (!controller().isConnected())
        return tr("No data of the light tower. Connect the controller.");
    if (m_first->isMissing())
        return tr("This controller has no light tower. Update the controller: its register map must be 1.6 "
                  "or newer.");
    return {};
}

QString TowerFields::words(const QString& name)
{
    const modbus::RegisterInfo* info = modbus::findRegister(name.toStdString());
    if (info == nullptr || info->enumName != tableMode)
        return {};
    const auto cell = info->address - modbus::findRegister("signal.fault_red")->address;
    const QStringList columns = lights();
    return tr("%1, %2").arg(conditions().value(cell / columns.size()), columns.value(cell % columns.size()));
}

QString TowerFields::label(const Field& field) const
{
    return words(RegisterWords::name(field.info()));
}

} // namespace campanel::panel
