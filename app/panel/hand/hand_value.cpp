// SPDX-License-Identifier: Apache-2.0
#include "app/panel/hand/hand_value.h"

#include "app/panel/controller/controller.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

// Touches that follow each other within this time are a row.
constexpr auto rowTime = 5s;

} // namespace

HandValue::HandValue(Controller& controller, std::string_view name)
    : m_controller(controller)
    , m_parameter(controller.parameter(name))
{
    m_rowTimer.setSingleShot(true);
    m_rowTimer.setInterval(rowTime);
    connect(&m_rowTimer, &QTimer::timeout, this, &HandValue::endRow);
    connect(&m_parameter, &Parameter::changed, this, &HandValue::changed);
    connect(&controller, &Controller::connectionChanged, this, &HandValue::follow);
    connect(&controller, &Controller::stateChanged, this, &HandValue::follow);
    connect(&controller, &Controller::programChanged, this, &HandValue::follow);
}

const modbus::RegisterInfo& HandValue::info() const
{
    return m_parameter.info();
}

double HandValue::value() const
{
    return m_wanted.value_or(m_parameter.lastValue());
}

void HandValue::follow()
{
    const auto& identity = m_controller.identity();
    if (!m_controller.isConnected())
        m_wanted = m_sent = std::nullopt;
    else if (identity && identity->hasRegister(info().name))
        m_parameter.readIfUncertain();
    emit changed();
}

void HandValue::read()
{
    if (!m_wanted)
        m_parameter.read();
}

void HandValue::set(double value)
{
    if (!m_before)
        m_before = this->value();
    m_rowTimer.start();
    m_failure.reset();
    m_wanted = std::clamp(value, info().minimum, info().maximum);
    send();
    emit changed();
}

void HandValue::send()
{
    if (m_sent || !m_wanted)
        return;
    m_sent = m_wanted;
    m_controller.link().exchange(
        {0, std::string(info().name), m_wanted},
        {this, [this](const link::ParameterOutcome& outcome) { onAnswer(outcome); }});
}

void HandValue::onAnswer(const link::ParameterOutcome& outcome)
{
    const auto sent = std::exchange(m_sent, std::nullopt);
    if (outcome.end != link::ParameterEnd::Done) {
        m_wanted.reset();
        m_failure = outcome;
        m_parameter.read();
    } else if (m_wanted == sent) {
        m_wanted.reset();
    }
    send();
    emit changed();
}

void HandValue::endRow()
{
    const auto before = std::exchange(m_before, std::nullopt);
    if (before && *before != value())
        emit moved(*before, value());
}

} // namespace campanel::panel
