// SPDX-License-Identifier: Apache-2.0
// The values of the machine for the plant's network, from what the panel shows. Nothing is read from the
// controller for it. A value that is not fresh is empty.
#pragma once

#include "app/plant/metric_value.h"

#include "app/link/link_values.h"

#include <QList>
#include <QObject>

#include <chrono>
#include <map>
#include <optional>
#include <utility>

namespace campanel::panel {

class Alarms;
class Controller;
class Orders;
class Stops;

// The objects that have the values; they must outlive what uses them.
struct PlantSources {
    Controller& controller;
    Alarms& alarms;
    Stops& stops;
    Orders& orders;
};

class PlantValues : public QObject {
    Q_OBJECT

public:
    PlantValues(const PlantSources& sources, QObject* parent);

    // Returns the present reading of each metric that the panel owns, in the order of the table. Counts the
    // time in the present state as well.
    [[nodiscard]] QList<plant::MetricReading> readings();

signals:
    // Emitted when a reading may have changed.
    void changed();

private:
    using Milliseconds = std::chrono::milliseconds;
    // A mode and a state of PackML.
    using Situation = std::pair<int, int>;

    [[nodiscard]] plant::MetricValue valueOf(plant::Metric metric) const;
    [[nodiscard]] plant::MetricValue valueOfProgram(plant::Metric metric) const;
    [[nodiscard]] plant::MetricValue valueOfPacking(plant::Metric metric) const;
    [[nodiscard]] plant::MetricValue valueOfOrder(plant::Metric metric) const;
    [[nodiscard]] std::int64_t ageMs(plant::Metric metric) const;
    // Returns empty while the state is unknown or not fresh.
    [[nodiscard]] std::optional<Situation> situation() const;
    void countTime();
    void noteBag(const modbus::BagRecord& bag);

    Controller& m_controller;
    Alarms& m_alarms;
    Stops& m_stops;
    Orders& m_orders;
    std::optional<Situation> m_situation; // the one that is counted
    link::SteadyTime m_since{};
    link::SteadyTime m_countedAt{};
    std::map<Situation, link::SteadyTime::duration> m_totals;
    std::optional<std::int64_t> m_defective; // empty until the first record of a bag
};

} // namespace campanel::panel
