// SPDX-License-Identifier: Apache-2.0
// Reads what the controller records of its mark sensor while the film runs, learns the sensor's dead time
// from it, and notices when that differs from the one that is entered.
#pragma once

#include "app/panel/packing/sensor_records.h"
#include "app/program/dead_time_estimate.h"

#include <QObject>

#include <optional>
#include <vector>

namespace campanel::panel {

class Controller;
class Parameter;

class MarkSensor : public QObject {
    Q_OBJECT

public:
    // The controller must outlive the object.
    MarkSensor(Controller& controller, QObject* parent);

    [[nodiscard]] const program::DeadTimeEstimate& estimate() const { return m_estimate; }

    // Returns false with a controller that records no edges.
    [[nodiscard]] bool isRecorded() const { return m_records.isRecorded(); }

signals:
    // Emitted for new edges, oldest first.
    void edgesRead(const std::vector<campanel::modbus::MarkEdge>& edges);
    // Emitted when the sensor has drifted from the dead time that is entered, and when it no longer has.
    void driftChanged(const std::optional<campanel::program::SensorDrift>& drift);

private:
    void take(const std::vector<std::uint16_t>& registers);
    // Another machine has another sensor.
    void forget();
    void watchDrift();
    void setDrift(double enteredMs, const std::optional<program::DeadTime>& learned);

    Parameter& m_entered;
    SensorRecords m_records;
    program::DeadTimeEstimate m_estimate;
    std::uint32_t m_last = 0;  // number of the newest edge
    double m_takenOffMs = 0.0; // by the controller, from the newest edge
    bool m_hasDrifted = false;
};

} // namespace campanel::panel
