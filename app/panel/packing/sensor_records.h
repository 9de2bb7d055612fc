// SPDX-License-Identifier: Apache-2.0
// Reads what the controller records of a sensor while the machine moves, often enough to miss little and
// seldom enough for a slow line.
#pragma once

#include "app/link/link.h"

#include <QObject>

#include <vector>

namespace campanel::panel {

class Controller;

class SensorRecords : public QObject {
    Q_OBJECT

public:
    // `range`: the registers of the sensor's group. The controller must outlive the object.
    SensorRecords(Controller& controller, const link::ReadRequest& range, QObject* parent);

    // Returns false with a controller that records no edges.
    [[nodiscard]] bool isRecorded() const;

signals:
    void read(const std::vector<std::uint16_t>& registers);
    // Another controller was connected, whose machine has other sensors.
    void controllerChanged();

private:
    void ask();
    void take(const link::ReadOutcome& outcome);
    void noteConnection();

    Controller& m_controller;
    link::ReadRequest m_range;
    link::SteadyTime m_askedAt;
    link::SteadyTime m_nextAt;
    bool m_isAsked = false;
    std::optional<std::uint64_t> m_controllerId;
};

} // namespace campanel::panel
