// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/axis_speed.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/kit/language_notifier.h"
#include "app/panel/words/connection_sentences.h"

namespace campanel::panel {

namespace {

const char* parameterOf(AxisSpeed::Use use)
{
    return use == AxisSpeed::Use::Jog ? "parameter.jog_frequency" : "parameter.home_frequency";
}

} // namespace

AxisSpeed::AxisSpeed(Controller& controller, Use use, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_use(use)
    , m_parameter(controller.parameter(parameterOf(use)))
{
    connect(&m_parameter, &Parameter::changed, this, &AxisSpeed::updateValue);
    connect(LanguageNotifier::ofApplication(), &LanguageNotifier::languageChanged, this,
            &AxisSpeed::updateValue);
    connect(&m_value, &Value::setRequested, this, &AxisSpeed::write);
    updateValue();
    connect(&controller, &Controller::programChanged, this, &AxisSpeed::changed);
}

QString AxisSpeed::label() const
{
    return m_use == Use::Jog ? tr("Jog speed") : tr("Homing speed");
}

QString AxisSpeed::text() const
{
    const std::optional<double> frequencyHz = m_parameter.value();
    if (!frequencyHz)
        return Format::unknownText();
    const Format format;
    const QString frequency = tr("%1 Hz").arg(format.grouped(*frequencyHz, 0));
    const auto& program = m_controller.program();
    if (!program || program->pulsesPerMm <= 0)
        return frequency;
    return tr("%1 · %2 mm/s", "1,000 Hz · 3.1 mm/s")
        .arg(frequency, format.number(*frequencyHz / program->pulsesPerMm, 1));
}

void AxisSpeed::updateValue()
{
    const modbus::RegisterInfo& info = m_parameter.info();
    m_value.show({label(), QStringLiteral("Hz"), Format().number(frequencyHz(), 0), info.minimum,
                  info.maximum, info.defaultValue, 0});
    emit changed();
}

void AxisSpeed::write(double frequencyHz)
{
    m_failure.clear();
    m_parameter.write(frequencyHz, {this, [this](const link::ParameterOutcome& outcome) {
                                        m_failure = ConnectionSentences::parameter(label(), outcome);
                                        emit changed();
                                    }});
    emit changed();
}

} // namespace campanel::panel
