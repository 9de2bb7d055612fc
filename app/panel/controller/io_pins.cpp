// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/io_pins.h"

#include "app/panel/controller/controller.h"

namespace campanel::panel {

IoPins::IoPins(Controller& machine, QObject* parent)
    : QObject(parent)
    , m_machine(machine)
{
    connect(&machine, &Controller::connectionChanged, this, [this] {
        if (!present())
            m_status.reset();
        emit changed();
    });
}

bool IoPins::present() const
{
    return m_machine.identity() && m_machine.identity()->mapMinor >= modbus::ioMapMinor;
}

void IoPins::read()
{
    if (m_isAsked || !m_machine.isConnected() || !present())
        return;
    m_isAsked = true;
    m_machine.link().readRegisters({0, modbus::ioAddress, modbus::ioRegisters},
                                   {this, [this](const link::ReadOutcome& outcome) { takeRead(outcome); }});
}

void IoPins::takeRead(const link::ReadOutcome& outcome)
{
    m_isAsked = false;
    const bool isDone =
        outcome.end == link::ReadEnd::Done && outcome.registers.size() == modbus::ioRegisters && present();
    if (isDone)
        m_status = modbus::decodeIo(outcome.registers);
    else if (outcome.end == link::ReadEnd::Failed)
        m_status.reset();
    emit changed();
}

} // namespace campanel::panel
