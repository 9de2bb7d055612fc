// SPDX-License-Identifier: Apache-2.0
#include "app/panel/plant/plant_values.h"

#include "app/panel/alarms/alarms.h"
#include "app/panel/controller/controller.h"
#include "app/panel/orders/orders.h"
#include "app/panel/stops/stops.h"

#include <cmath>

namespace campanel::panel {

namespace {

using plant::Metric;
using plant::MetricValue;

constexpr int productionMode = 1;
constexpr int manualMode = 3;

MetricValue whole(double value)
{
    return std::isfinite(value) ? MetricValue(static_cast<std::int64_t>(std::llround(value))) : MetricValue();
}

MetricValue real(double value)
{
    return std::isfinite(value) ? MetricValue(value) : MetricValue();
}

// Returns the code of PackML; see plant::packmlStates.
int packmlState(Controller::State state, bool isWaiting)
{
    switch (state) {
    case Controller::State::Idle:
        return 2;
    case Controller::State::Ready:
        return 4;
    case Controller::State::Running:
        return isWaiting ? 5 : 6;
    case Controller::State::Jogging:
        return 6;
    case Controller::State::Stopping:
        return 7;
    case Controller::State::Fault:
        return 9;
    case Controller::State::Homing:
        return 15;
    case Controller::State::Unknown:
        break;
    }
    return 0;
}

std::int64_t millisecondsOf(link::SteadyTime::duration time)
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(time).count();
}

MetricValue secondsOf(link::SteadyTime::duration time)
{
    return std::int64_t(std::chrono::duration_cast<std::chrono::seconds>(time).count());
}

} // namespace

PlantValues::PlantValues(const PlantSources& sources, QObject* parent)
    : QObject(parent)
    , m_controller(sources.controller)
    , m_alarms(sources.alarms)
    , m_stops(sources.stops)
    , m_orders(sources.orders)
{
    for (const auto signal :
         {&Controller::connectionChanged, &Controller::qualityChanged, &Controller::freshChanged,
          &Controller::stateChanged, &Controller::liveChanged, &Controller::bagChanged,
          &Controller::programChanged, &Controller::savedChanged})
        connect(&m_controller, signal, this, &PlantValues::changed);
    connect(m_controller.packing(), &PackingLine::changed, this, &PlantValues::changed);
    connect(m_controller.packing(), &PackingLine::bagRecorded, this, &PlantValues::noteBag);
    connect(&m_alarms, &Alarms::changed, this, &PlantValues::changed);
    connect(&m_stops, &Stops::presentChanged, this, &PlantValues::changed);
    connect(&m_orders, &Orders::changed, this, &PlantValues::changed);
    connect(this, &PlantValues::changed, this, &PlantValues::countTime);
}

QList<plant::MetricReading> PlantValues::readings()
{
    countTime();
    QList<plant::MetricReading> all;
    for (const plant::MetricRow& row : plant::metricTable) {
        if (row.owner == plant::MetricOwner::Panel)
            all.append({row.metric, valueOf(row.metric), ageMs(row.metric)});
    }
    return all;
}

MetricValue PlantValues::valueOf(Metric metric) const
{
    switch (metric) {
    case Metric::Alarm:
        return m_alarms.urgentCode();
    case Metric::LinkQuality:
        return std::int64_t(m_controller.linkQuality());
    default:
        break;
    }
    if (!m_situation || !m_controller.fresh())
        return {};
    switch (metric) {
    case Metric::UnitModeCurrent:
        return std::int64_t(m_situation->first);
    case Metric::StateCurrent:
        return std::int64_t(m_situation->second);
    case Metric::StateCurrentTime:
        return secondsOf(m_countedAt - m_since);
    case Metric::StateCumulativeTime:
        return secondsOf(m_totals.at(*m_situation));
    case Metric::StopReason:
        return m_stops.reason();
    case Metric::CurMachSpeed:
        return real(m_controller.live().rateBagsPerMin);
    case Metric::ProdProcessedCount:
        return whole(m_controller.bags().count);
    case Metric::BagDeviationMean:
        return real(m_controller.bags().meanDeviationMm);
    case Metric::BagDeviationScatter:
        return real(m_controller.bags().scatterMm);
    case Metric::ProdDefectiveCount:
    case Metric::FilmSaved:
        return valueOfPacking(metric);
    case Metric::OrderName:
    case Metric::OrderLot:
    case Metric::OrderState:
    case Metric::OrderQuantity:
    case Metric::OrderGood:
    case Metric::OrderRejected:
    case Metric::OrderEmpty:
        return valueOfOrder(metric);
    default:
        return valueOfProgram(metric);
    }
}

MetricValue PlantValues::valueOfProgram(Metric metric) const
{
    const auto& status = m_controller.status();
    if (metric == Metric::RecipeGeneration)
        return std::int64_t(status->generation);
    if (metric == Metric::RecipeCrc)
        return status->activeCrc ? MetricValue(std::int64_t(*status->activeCrc)) : MetricValue();
    // After a download the name is read a moment later than the status; the old one is not sent as new.
    const auto& program = m_controller.program();
    if (!program || program->generation != status->generation || program->crc != status->activeCrc)
        return {};
    switch (metric) {
    case Metric::MachSpeed:
        return real(program->rateBagsPerMin);
    case Metric::RecipeName:
        return QString::fromStdString(program->name);
    case Metric::RecipeVersion:
        return whole(program->version);
    default:
        return {};
    }
}

MetricValue PlantValues::valueOfPacking(Metric metric) const
{
    const PackingLine& packing = *m_controller.packing();
    if (metric == Metric::ProdDefectiveCount)
        return m_defective ? MetricValue(*m_defective) : MetricValue();
    return packing.fresh() ? real(m_controller.telemetry()->number("packer.film_saved")) : MetricValue();
}

MetricValue PlantValues::valueOfOrder(Metric metric) const
{
    const store::OrderRow order = m_orders.current().order;
    if (!m_orders.fresh() || order.id == 0)
        return {};
    switch (metric) {
    case Metric::OrderName:
        return order.text;
    case Metric::OrderLot:
        return order.lot;
    case Metric::OrderState:
        return store::nameOf(order.state);
    case Metric::OrderQuantity:
        return std::int64_t(order.quantity);
    case Metric::OrderGood:
        return std::int64_t(order.good);
    case Metric::OrderRejected:
        return std::int64_t(order.rejected);
    default:
        return std::int64_t(order.empty);
    }
}

std::int64_t PlantValues::ageMs(Metric metric) const
{
    if (metric == Metric::Alarm || metric == Metric::LinkQuality)
        return 0;
    if (metric == Metric::FilmSaved && m_controller.packing()->fresh())
        return millisecondsOf(m_controller.now() - m_controller.packing()->receivedAt());
    if (metric >= Metric::OrderName && m_orders.fresh())
        return millisecondsOf(m_controller.now() - m_orders.readAt());
    const double age = m_controller.fresh() ? m_controller.ageMs() : 0;
    return std::isfinite(age) && age > 0 ? std::llround(age) : 0;
}

std::optional<PlantValues::Situation> PlantValues::situation() const
{
    if (!m_controller.fresh() || m_controller.state() == Controller::State::Unknown)
        return {};
    const PackingLine& packing = *m_controller.packing();
    const bool isWaiting = packing.fresh() && packing.status()->filmGate != modbus::GateState::Running;
    const int mode = m_controller.state() == Controller::State::Jogging ? manualMode : productionMode;
    return Situation{mode, packmlState(m_controller.state(), isWaiting)};
}

void PlantValues::countTime()
{
    const link::SteadyTime now = m_controller.now();
    if (m_situation)
        m_totals[*m_situation] += now - m_countedAt;
    const auto present = situation();
    if (present != m_situation) {
        m_since = now;
        m_situation = present;
    }
    if (m_situation)
        m_totals.try_emplace(*m_situation, 0);
    m_countedAt = now;
}

void PlantValues::noteBag(const modbus::BagRecord& bag)
{
    const bool isOutside = std::abs(bag.deviationMm) > m_controller.bags().toleranceMm;
    m_defective = m_defective.value_or(0) + (bag.isScrap() || isOutside ? 1 : 0);
    emit changed();
}

} // namespace campanel::panel
