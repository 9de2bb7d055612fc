// SPDX-License-Identifier: Apache-2.0
// A parameter of the controller, as it was last read from it. Outcomes of all origins update the value: each
// is proven by reading.
#pragma once

#include "app/link/link.h"
#include "app/panel/kit/numbers.h"

#include <QObject>

#include <optional>

namespace campanel::panel {

class Controller;

class Parameter final : public QObject {
    Q_OBJECT

public:
    using Reply = link::Reply<link::ParameterOutcome>;

    // `controller` owns the object.
    Parameter(Controller& controller, const modbus::RegisterInfo& info);

    [[nodiscard]] const modbus::RegisterInfo& info() const { return m_info; }
    // Returns the physical value; empty while it is unknown or uncertain.
    [[nodiscard]] std::optional<double> value() const { return m_isCertain ? m_value : std::nullopt; }
    // Returns the value of the last reading, also when it is uncertain; NaN before the first.
    [[nodiscard]] double lastValue() const { return m_value.value_or(unknown); }
    // Returns true when the controller does not have this parameter.
    [[nodiscard]] bool isMissing() const { return m_isMissing; }

    // Reads the value unless a reading is under way or the line is down.
    void read();
    // Reads the value unless it is certain or missing.
    void readIfUncertain();
    // Writes a value; for technicians. `reply` receives the outcome after the value here. Returns false,
    // without a reply, when the access check refuses.
    bool write(double value, const Reply& reply);

    // Marks the value as uncertain, as after a lost connection or another program.
    void doubt();
    // Forgets the value, as for another controller.
    void clear();

signals:
    void changed();

private:
    void handleOutcome(const link::ParameterOutcome& outcome);

    Controller& m_controller;
    const modbus::RegisterInfo& m_info;
    std::optional<double> m_value;
    bool m_isCertain = false;
    bool m_isMissing = false;
    quint32 m_readId = 0; // 0: no reading under way
};

} // namespace campanel::panel
