// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/parameter.h"

#include "app/panel/controller/controller.h"

#include <tuple>

namespace campanel::panel {

Parameter::Parameter(Controller& controller, const modbus::RegisterInfo& info)
    : QObject(&controller)
    , m_controller(controller)
    , m_info(info)
{
    connect(&controller.link(), &link::Link::parameterEnded, this, &Parameter::handleOutcome);
}

void Parameter::read()
{
    if (!m_controller.isConnected() || m_readId != 0)
        return;
    m_readId = m_controller.link().nextId();
    m_controller.link().exchange({m_readId, std::string(m_info.name), std::nullopt});
}

void Parameter::readIfUncertain()
{
    if (!m_isCertain && !m_isMissing)
        read();
}

bool Parameter::write(double value, const Reply& reply)
{
    return m_controller.writeParameter(m_info, value,
                                       {this, [this, reply](const link::ParameterOutcome& outcome) {
                                            handleOutcome(outcome);
                                            if (reply.context)
                                                reply.receive(outcome);
                                        }});
}

void Parameter::handleOutcome(const link::ParameterOutcome& outcome)
{
    if (outcome.name != m_info.name)
        return;
    const auto before = std::tuple(m_value, m_isCertain, m_isMissing);
    const bool isOwnReading = outcome.id == m_readId && m_readId != 0;
    if (isOwnReading)
        m_readId = 0;
    if (outcome.value) {
        m_value = outcome.value;
        m_isCertain = true;
    } else {
        m_isCertain = false; // it may have been written
        m_isMissing = isOwnReading && outcome.end == link::ParameterEnd::Refused;
    }
    if (before != std::tuple(m_value, m_isCertain, m_isMissing))
        emit changed();
}

void Parameter::doubt()
{
    m_isCertain = m_isMissing = false;
    m_readId = 0; // a reading under way may be older than the change
    emit changed();
}

void Parameter::clear()
{
    m_value.reset();
    doubt();
}

} // namespace campanel::panel
