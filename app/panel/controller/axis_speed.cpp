// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/axis_speed.h"

#include "app/panel/controller/controller.h"
#include "app/panel/kit/format.h"
#include "app/panel/words/connection_sentences.h"

#include <limits>

namespace campanel::panel {

namespace {

const char* parameterOf(AxisSpeed::Use use)
{
    return use == AxisSpeed::Use::Jog ? "parameter.jog_frequency" : "parameter.home_frequency";
}

} // namespace

AxisSpeed::AxisSpeed(Controller& machine, Use use, QObject* parent)
    : QObject(parent)
    , m_machine(machine)
    , m_use(use)
    , m_info(*modbus::findRegister(parameterOf(use)))
{
    connect(&machine, &Controller::parameterEnded, this, &AxisSpeed::takeOutcome);
    connect(&machine, &Controller::connectionChanged, this, &AxisSpeed::noteConnection);
    connect(&machine, &Controller::programChanged, this, &AxisSpeed::changed);
}

QString AxisSpeed::label() const
{
    return m_use == Use::Jog ? tr("Jog speed") : tr("Homing speed");
}

double AxisSpeed::frequencyHz() const
{
    return m_frequencyHz.value_or(std::numeric_limits<double>::quiet_NaN());
}

QString AxisSpeed::text() const
{
    if (!m_frequencyHz)
        return Format::unknownText();
    const Format format;
    const QString frequency = tr("%1 Hz").arg(format.grouped(*m_frequencyHz, 0));
    const auto& program = m_machine.program();
    if (!program || program->pulsesPerMm <= 0)
        return frequency;
    return tr("%1 · %2 mm/s", "1,000 Hz · 3.1 mm/s")
        .arg(frequency, format.number(*m_frequencyHz / program->pulsesPerMm, 1));
}

void AxisSpeed::read()
{
    if (m_machine.isConnected() && !m_frequencyHz && m_readId == 0)
        m_readId = m_machine.readParameter(parameterOf(m_use));
}

void AxisSpeed::write(double frequencyHz)
{
    m_failure.clear();
    m_writeId = m_machine.writeParameter(parameterOf(m_use), frequencyHz);
    emit changed();
}

// Uses also the readings and writes of others: every value in an outcome is proven by reading.
void AxisSpeed::takeOutcome(const link::ParameterOutcome& outcome)
{
    if (outcome.name != parameterOf(m_use))
        return;
    if (outcome.id == m_readId)
        m_readId = 0;
    if (outcome.value)
        m_frequencyHz = outcome.value;
    else if (outcome.end == link::ParameterEnd::OutcomeUnknown)
        m_frequencyHz.reset(); // possibly written
    if (outcome.id != 0 && outcome.id == m_writeId) {
        m_writeId = 0;
        m_failure = ConnectionSentences::parameter(label(), outcome);
    }
    emit changed();
}

void AxisSpeed::noteConnection()
{
    if (m_machine.isConnected())
        return;
    m_frequencyHz.reset();
    m_readId = 0;
    emit changed();
}

} // namespace campanel::panel
