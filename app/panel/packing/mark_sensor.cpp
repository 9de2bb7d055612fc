// SPDX-License-Identifier: Apache-2.0
#include "app/panel/packing/mark_sensor.h"

#include "app/panel/controller/controller.h"

#include <utility>

namespace campanel::panel {

MarkSensor::MarkSensor(Controller& controller, QObject* parent)
    : QObject(parent)
    , m_entered(controller.parameter("parameter.mark_dead_time"))
    , m_records(controller, {0, modbus::sensorAddress, modbus::sensorRegisters}, this)
{
    connect(&m_records, &SensorRecords::read, this, &MarkSensor::take);
    connect(&m_records, &SensorRecords::controllerChanged, this, &MarkSensor::forget);
    connect(&m_entered, &Parameter::changed, this, &MarkSensor::watchDrift);
    connect(&controller, &Controller::programChanged, this, [this] { m_estimate.startFilm(); });
}

void MarkSensor::forget()
{
    m_estimate = {};
    m_takenOffMs = 0.0;
    setDrift(0.0, std::nullopt);
}

// A few scattered marks make the margin too large for an estimate; they say nothing against what was known.
void MarkSensor::watchDrift()
{
    const double enteredMs = m_entered.value().value_or(m_takenOffMs);
    if (enteredMs <= 0 || m_estimate.estimate())
        setDrift(enteredMs, m_estimate.drift(enteredMs, m_hasDrifted));
}

void MarkSensor::setDrift(double enteredMs, const std::optional<program::DeadTime>& learned)
{
    const bool hasDrifted = learned.has_value();
    if (std::exchange(m_hasDrifted, hasDrifted) != hasDrifted)
        emit driftChanged(learned ? std::optional(program::SensorDrift{enteredMs, *learned}) : std::nullopt);
}

void MarkSensor::take(const std::vector<std::uint16_t>& registers)
{
    const auto edges = modbus::markEdges(registers, m_last);
    for (const modbus::MarkEdge& edge : edges)
        m_estimate.take(edge);
    if (edges.empty())
        return;
    m_last = edges.back().number;
    m_takenOffMs = edges.back().deadMs;
    watchDrift();
    emit edgesRead(edges);
}

} // namespace campanel::panel
