// SPDX-License-Identifier: Apache-2.0
// Reads what the controller records of its mark sensor while the film runs, learns the sensor's dead time
// from it, and notices when that differs from the one that is entered.
#pragma once

#include "app/link/link.h"
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
    [[nodiscard]] bool isRecorded() const;

signals:
    // Emitted for new edges, oldest first.
    void edgesRead(const std::vector<campanel::modbus::MarkEdge>& edges);
    // Emitted when the sensor has drifted from the dead time that is entered, and when it no longer has.
    void driftChanged(const std::optional<campanel::program::SensorDrift>& drift);

private:
    void ask();
    void take(const link::ReadOutcome& outcome);
    void noteConnection();
    void watchDrift();
    void setDrift(double enteredMs, const std::optional<program::DeadTime>& learned);

    Controller& m_controller;
    Parameter& m_entered;
    program::DeadTimeEstimate m_estimate;
    std::uint32_t m_last = 0; // number of the newest edge
    link::SteadyTime m_askedAt;
    link::SteadyTime m_nextAt;
    bool m_isAsked = false;
    double m_takenOffMs = 0.0; // by the controller, from the newest edge
    bool m_hasDrifted = false;
    std::optional<std::uint64_t> m_controllerId; // of the estimate
};

} // namespace campanel::panel
