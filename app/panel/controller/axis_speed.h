// SPDX-License-Identifier: Apache-2.0
// The pulse frequency for jogging or homing, as stored in the controller: read on demand, written with proof.
// NaN while it is unknown.
#pragma once

#include "app/link/link_values.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class Controller;

class AxisSpeed : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Speeds belong to Jog and Homing")
    Q_PROPERTY(QString label READ label NOTIFY changed FINAL)
    Q_PROPERTY(double frequencyHz READ frequencyHz NOTIFY changed FINAL)
    // The value as text, "1,000 Hz · 3.1 mm/s"; the second figure needs a program.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    Q_PROPERTY(double minimum READ minimum CONSTANT FINAL)
    Q_PROPERTY(double maximum READ maximum CONSTANT FINAL)
    Q_PROPERTY(double defaultValue READ defaultValue CONSTANT FINAL)
    // The reason why the last value was not written; empty after a success.
    Q_PROPERTY(QString failure READ failure NOTIFY changed FINAL)

public:
    enum class Use { Jog, Home };

    // The machine must outlive the object.
    AxisSpeed(Controller& machine, Use use, QObject* parent);

    [[nodiscard]] QString label() const;
    [[nodiscard]] double frequencyHz() const;
    [[nodiscard]] QString text() const;
    [[nodiscard]] double minimum() const { return m_info.minimum; }
    [[nodiscard]] double maximum() const { return m_info.maximum; }
    [[nodiscard]] double defaultValue() const { return m_info.defaultValue; }
    [[nodiscard]] QString failure() const { return m_failure; }

    // Reads the value from the controller unless it is known.
    Q_INVOKABLE void read();
    // Writes the value; for technicians.
    Q_INVOKABLE void write(double frequencyHz);

signals:
    void changed();

private:
    void takeOutcome(const link::ParameterOutcome& outcome);
    void noteConnection();

    Controller& m_machine;
    Use m_use;
    const modbus::RegisterInfo& m_info;
    std::optional<double> m_frequencyHz;
    quint32 m_readId = 0;
    quint32 m_writeId = 0;
    QString m_failure;
};

} // namespace campanel::panel
