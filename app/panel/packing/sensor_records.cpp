// SPDX-License-Identifier: Apache-2.0
#include "app/panel/packing/sensor_records.h"

#include "app/panel/controller/controller.h"
#include "app/program/dead_time_estimate.h"

#include <algorithm>

using namespace std::chrono_literals;

namespace campanel::panel {

namespace {

// The controller keeps 12 edges of marks: at 600 bags a minute those of 1.2 s.
constexpr link::SteadyTime::duration edgePeriod = 700ms;
// The maximum share of a slow line's time.
constexpr int edgeShareOfTheLine = 10;

} // namespace

SensorRecords::SensorRecords(Controller& controller, const link::ReadRequest& range, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_range(range)
{
    connect(controller.packing(), &PackingLine::changed, this, &SensorRecords::ask);
    connect(&controller.link(), &link::Link::registersRead, this, &SensorRecords::take);
    connect(&controller, &Controller::connectionChanged, this, &SensorRecords::noteConnection);
}

bool SensorRecords::isRecorded() const
{
    const auto& identity = m_controller.identity();
    return m_controller.packing()->recordsBags() && identity->mapMinor >= modbus::sensorMapMinor;
}

void SensorRecords::noteConnection()
{
    m_isAsked = false;
    const auto& identity = m_controller.identity();
    if (!identity || m_controllerId == identity->uniqueId)
        return;
    m_controllerId = identity->uniqueId;
    emit controllerChanged();
}

void SensorRecords::ask()
{
    const bool moves = m_controller.state() == Controller::State::Running ||
                       m_controller.state() == Controller::State::Stopping;
    if (m_isAsked || !moves || !isRecorded() || !m_controller.packing()->fresh() ||
        m_controller.now() < m_nextAt)
        return;
    m_isAsked = true;
    m_askedAt = m_controller.now();
    m_controller.link().readRegisters(m_range);
}

void SensorRecords::take(const link::ReadOutcome& outcome)
{
    if (outcome.request.address != m_range.address)
        return;
    m_isAsked = false;
    m_nextAt =
        m_controller.now() + std::max(edgePeriod, edgeShareOfTheLine * (m_controller.now() - m_askedAt));
    if (outcome.end == link::ReadEnd::Done)
        emit read(outcome.registers);
}

} // namespace campanel::panel
