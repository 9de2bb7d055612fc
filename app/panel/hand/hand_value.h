// SPDX-License-Identifier: Apache-2.0
// A register of the group `hand` that touches move: what was read, or a touch that is on its way. Touches on
// a slow line are one write, and a row of them is one move().
#pragma once

#include "app/link/link_values.h"

#include <QObject>
#include <QTimer>

#include <optional>
#include <string_view>

namespace campanel::panel {

class Controller;
class Parameter;

class HandValue final : public QObject {
    Q_OBJECT

public:
    // The controller must outlive the object, and have this register in its map.
    HandValue(Controller& controller, std::string_view name);

    [[nodiscard]] const modbus::RegisterInfo& info() const;
    // Returns the value as it will be after the last touch; NaN while it is unknown.
    [[nodiscard]] double value() const;
    // Returns how the last touch ended that has not reached the controller; empty: it has.
    [[nodiscard]] const std::optional<link::ParameterOutcome>& failure() const { return m_failure; }

    // Writes the nearest value within the limits, for a person who may do so.
    void set(double value);
    // Reads it unless a touch is on its way: somebody else may have set it.
    void read();

signals:
    void changed();
    // Emitted behind the last touch of a row.
    void moved(double before, double after);

private:
    void follow();
    void send();
    void onAnswer(const link::ParameterOutcome& outcome);
    void endRow();

    Controller& m_controller;
    Parameter& m_parameter;
    std::optional<double> m_wanted; // by the last touch, until it is read back
    std::optional<double> m_sent;   // what is being written
    std::optional<double> m_before; // the first touch of a row
    std::optional<link::ParameterOutcome> m_failure;
    QTimer m_rowTimer;
};

} // namespace campanel::panel
