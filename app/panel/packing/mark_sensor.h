// SPDX-License-Identifier: Apache-2.0
// Reads what the controller records of its mark sensor while the film runs, and learns the sensor's dead time
// from it.
#pragma once

#include "app/link/link.h"
#include "app/program/dead_time_estimate.h"

#include <QObject>

namespace campanel::panel {

class Controller;

class MarkSensor : public QObject {
    Q_OBJECT

public:
    // The controller must outlive the object.
    MarkSensor(Controller& controller, QObject* parent);

    [[nodiscard]] const program::DeadTimeEstimate& estimate() const { return m_estimate; }

signals:
    // Emitted for new edges.
    void changed();

private:
    // Returns false with a controller that records no edges.
    [[nodiscard]] bool isRecorded() const;
    void ask();
    void take(const link::ReadOutcome& outcome);

    Controller& m_controller;
    program::DeadTimeEstimate m_estimate;
    std::uint32_t m_last = 0; // number of the newest edge
    link::SteadyTime m_askedAt;
    link::SteadyTime m_nextAt;
    bool m_isAsked = false;
};

} // namespace campanel::panel
