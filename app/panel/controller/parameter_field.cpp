// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/parameter_field.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/connection_sentences.h"
#include "app/panel/words/recipe_words.h"
#include "app/panel/words/register_words.h"

namespace campanel::panel {

ParameterField::ParameterField(Controller& controller, const ParameterRow& row)
    : Value(&controller)
    , m_controller(controller)
    , m_row(row)
    , m_parameter(controller.parameter(row.name))
{
    connect(&m_parameter, &Parameter::changed, this, &ParameterField::update);
    LanguageNotifier::follow(this, &ParameterField::update);
    connect(this, &Value::setRequested, this, &ParameterField::write);
    connect(&controller, &Controller::programChanged, this, &ParameterField::shownChanged);
    update();
}

QString ParameterField::shown() const
{
    const std::optional<double> value = m_parameter.value();
    if (!value)
        return Format::unknownText();
    const Format format;
    const modbus::RegisterInfo& info = m_parameter.info();
    const QString number =
        format.measure(*value, RegisterWords::decimals(info), RecipeWords::unit(info.unit));
    const auto& program = m_controller.program();
    if (info.unit != "Hz" || !program || program->pulsesPerMm <= 0)
        return number;
    return QStringLiteral("%1 · %2").arg(
        format.measure(*value / program->pulsesPerMm, 1, QStringLiteral("mm/s")), number);
}

void ParameterField::update()
{
    const modbus::RegisterInfo& info = m_parameter.info();
    const int decimals = RegisterWords::decimals(info);
    const QString unit = RecipeWords::unit(info.unit);
    const double value = m_parameter.value().value_or(unknown);
    show({tr(m_row.label), unit, Format().amount(value, decimals, unit), info.minimum, info.maximum,
          info.defaultValue, decimals, value});
    emit shownChanged();
}

void ParameterField::write(double value)
{
    m_failure.clear();
    m_parameter.write(value, {this, [this](const link::ParameterOutcome& outcome) {
                                  m_failure = ConnectionSentences::parameter(label(), outcome);
                                  emit shownChanged();
                              }});
    emit shownChanged();
}

} // namespace campanel::panel
