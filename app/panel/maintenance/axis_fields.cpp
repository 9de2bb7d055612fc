// SPDX-License-Identifier: Apache-2.0
#include "app/panel/maintenance/axis_fields.h"

#include "app/panel/controller/controller.h"

#include <algorithm>
#include <array>
#include <vector>

namespace campanel::panel {

namespace {

struct AxisField {
    const char* name;
    const char* words;
    bool hasChoices = false;
    bool isMeasurable = true;
};

// The fields in the order of the screen.
constexpr std::array axisFields{
    AxisField{"signal.knife_reversed",
              QT_TRANSLATE_NOOP("campanel::panel::AxisFields", "Main motor: reversed"), true},
    AxisField{"signal.film_reversed", QT_TRANSLATE_NOOP("campanel::panel::AxisFields", "Film motor: reversed"),
              true},
    AxisField{"signal.infeed_reversed",
              QT_TRANSLATE_NOOP("campanel::panel::AxisFields", "Infeed motor: reversed"), true},
    AxisField{"parameter.film_pulses",
              QT_TRANSLATE_NOOP("campanel::panel::AxisFields", "Film motor: pulses per revolution")},
    AxisField{"parameter.film_feed",
              QT_TRANSLATE_NOOP("campanel::panel::AxisFields", "Film motor: film per revolution")},
    AxisField{"parameter.flight_pulses",
              QT_TRANSLATE_NOOP("campanel::panel::AxisFields", "Infeed motor: pulses per product")},
    AxisField{"signal.film_index_contact",
              QT_TRANSLATE_NOOP("campanel::panel::AxisFields", "Film motor: index sensor"), true,
              false},
    AxisField{"signal.infeed_index_contact",
              QT_TRANSLATE_NOOP("campanel::panel::AxisFields", "Infeed motor: index sensor"), true, false},
};

} // namespace

AxisFields::AxisFields(Controller& controller, QObject* parent)
    : ParameterFields(controller, parent)
{
    std::vector<Field> fields;
    for (const AxisField& field : axisFields)
        fields.push_back({&controller.parameter(field.name), field.words, field.hasChoices});
    setFields(std::move(fields));
}

QString AxisFields::words(const QString& name)
{
    const auto found = std::ranges::find_if(
        axisFields, [&name](const AxisField& field) { return name == QLatin1StringView(field.name); });
    return found == axisFields.end() ? QString() : tr(found->words);
}

const char* AxisFields::nameOf(int row) const
{
    return axisFields[static_cast<std::size_t>(row)].name;
}

QString AxisFields::label(const Field& field) const
{
    return tr(field.words);
}

QString AxisFields::objection(const Field& field, double value) const
{
    if (field.info().name.ends_with("_reversed") && value > 0 && !m_isReversible)
        return tr("This controller cannot turn a motor the other way. Set the direction at the drive.");
    return {};
}

bool AxisFields::isMeasurable(const Field& field) const
{
    const auto found = std::ranges::find_if(
        axisFields, [&field](const AxisField& row) { return field.info().name == row.name; });
    return found != axisFields.end() && found->isMeasurable && !field.parameter->isMissing();
}

} // namespace campanel::panel
