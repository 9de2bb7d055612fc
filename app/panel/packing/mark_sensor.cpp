// SPDX-License-Identifier: Apache-2.0
#include "app/panel/packing/mark_sensor.h"

#include "app/panel/controller/controller.h"

#include <algorithm>
#include <utility>

using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

// The controller keeps 12 edges: at 600 bags a minute those of 1.2 s.
constexpr link::SteadyTime::duration edgePeriod = 700ms;
// The maximum share of a slow line's time.
constexpr int edgeShareOfTheLine = 10;

} // namespace

MarkSensor::MarkSensor(Controller& controller, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_entered(controller.parameter("parameter.mark_dead_time"))
{
    connect(controller.packing(), &PackingLine::changed, this, &MarkSensor::ask);
    connect(&controller.link(), &link::Link::registersRead, this, &MarkSensor::take);
    connect(&controller, &Controller::connectionChanged, this, &MarkSensor::noteConnection);
    connect(&m_entered, &Parameter::changed, this, &MarkSensor::watchDrift);
    connect(&controller, &Controller::programChanged, this, [this] { m_estimate.startFilm(); });
}

bool MarkSensor::isRecorded() const
{
    const auto& identity = m_controller.identity();
    return m_controller.packing()->recordsBags() && identity->mapMinor >= modbus::sensorMapMinor;
}

void MarkSensor::noteConnection()
{
    m_isAsked = false;
    const auto& identity = m_controller.identity();
    if (!identity || m_controllerId == identity->uniqueId)
        return;
    m_controllerId = identity->uniqueId; // another machine has another sensor
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

void MarkSensor::ask()
{
    const bool moves = m_controller.state() == Controller::State::Running ||
                       m_controller.state() == Controller::State::Stopping;
    if (m_isAsked || !moves || !isRecorded() || !m_controller.packing()->fresh() ||
        m_controller.now() < m_nextAt)
        return;
    m_isAsked = true;
    m_askedAt = m_controller.now();
    m_controller.link().readRegisters({0, modbus::sensorAddress, modbus::sensorRegisters});
}

void MarkSensor::take(const link::ReadOutcome& outcome)
{
    if (outcome.request.address != modbus::sensorAddress)
        return;
    m_isAsked = false;
    m_nextAt =
        m_controller.now() + std::max(edgePeriod, edgeShareOfTheLine * (m_controller.now() - m_askedAt));
    if (outcome.end != link::ReadEnd::Done)
        return;
    const auto edges = modbus::markEdges(outcome.registers, m_last);
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
