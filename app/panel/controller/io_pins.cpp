// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/io_pins.h"

#include "app/panel/controller/controller.h"

#include <cmath>

namespace campanel::panel {

namespace {

constexpr double umPerMm = 1000;

} // namespace

IoPins::IoPins(Controller& controller, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
{
    connect(&controller, &Controller::connectionChanged, this, [this] {
        if (!present()) {
            m_status.reset();
            m_infeed.reset();
        }
        emit changed();
    });
}

bool IoPins::present() const
{
    return m_controller.identity() && m_controller.identity()->mapMinor >= modbus::ioMapMinor;
}

void IoPins::read()
{
    if (m_isAsked || !m_controller.isConnected() || !present())
        return;
    m_isAsked = true;
    m_controller.link().readRegisters(
        {0, modbus::ioAddress, modbus::ioRegisters(m_controller.identity()->mapMinor)},
        {this, [this](const link::ReadOutcome& outcome) { takeRead(outcome); }});
}

void IoPins::takeRead(const link::ReadOutcome& outcome)
{
    m_isAsked = false;
    const bool isDone = outcome.end == link::ReadEnd::Done && present() &&
                        outcome.registers.size() == modbus::ioRegisters(m_controller.identity()->mapMinor);
    if (isDone) {
        m_status = modbus::decodeIo(outcome.registers);
        if (m_status->infeedPositionMm)
            m_infeed.note(static_cast<std::int32_t>(std::llround(*m_status->infeedPositionMm * umPerMm)));
    } else if (outcome.end == link::ReadEnd::Failed)
        m_status.reset();
    emit changed();
}

std::optional<double> IoPins::infeedTravelMm() const
{
    if (!m_status || !m_status->infeedPositionMm || !m_infeed.value())
        return std::nullopt;
    return static_cast<double>(*m_infeed.value()) / umPerMm;
}

} // namespace campanel::panel
