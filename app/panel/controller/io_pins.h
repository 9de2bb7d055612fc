// SPDX-License-Identifier: Apache-2.0
// The levels of the controller's pins, its infeed and its torque, read while somebody looks at them.
#pragma once

#include "app/link/link.h"
#include "app/panel/kit/wide_counter.h"

#include <QObject>

#include <optional>

namespace campanel::panel {

class Controller;

class IoPins : public QObject {
    Q_OBJECT

public:
    // The controller must outlive the object.
    IoPins(Controller& controller, QObject* parent);

    // Returns true when the controller reports its pins; those of older register maps do not.
    [[nodiscard]] bool present() const;
    // Reads the pins unless a reading is under way.
    void read();
    // Returns the last reading; empty before it, or when it failed.
    [[nodiscard]] const std::optional<modbus::IoStatus>& status() const { return m_status; }
    // Returns the position of the infeed, which does not wrap; empty without an infeed.
    [[nodiscard]] std::optional<double> infeedTravelMm() const;

signals:
    void changed();

private:
    void takeRead(const link::ReadOutcome& outcome);

    Controller& m_controller;
    std::optional<modbus::IoStatus> m_status;
    WideCounter m_infeed; // 0.001 mm
    bool m_isAsked = false;
};

} // namespace campanel::panel
