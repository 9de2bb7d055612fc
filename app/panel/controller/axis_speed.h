// SPDX-License-Identifier: Apache-2.0
// The pulse frequency for jogging or homing, as stored in the controller: read on demand, written with proof.
// NaN while it is unknown.
#pragma once

#include "app/panel/controller/parameter.h"
#include "app/panel/kit/value.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Controller;

class AxisSpeed : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Speeds belong to Jog and Homing")
    Q_PROPERTY(campanel::panel::Value* value READ value CONSTANT FINAL)
    // The value as text, "1,000 Hz · 3.1 mm/s"; the second figure needs a program.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    // The reason why the last value was not written; empty after a success.
    Q_PROPERTY(QString failure READ failure NOTIFY changed FINAL)

public:
    enum class Use { Jog, Home };

    // The controller must outlive the object.
    AxisSpeed(Controller& controller, Use use, QObject* parent);

    [[nodiscard]] Value* value() { return &m_value; }
    [[nodiscard]] double frequencyHz() const { return m_parameter.value().value_or(unknown); }
    [[nodiscard]] QString text() const;
    [[nodiscard]] QString failure() const { return m_failure; }

    // Reads the value from the controller unless it is known.
    Q_INVOKABLE void read() { m_parameter.readIfUncertain(); }

signals:
    void changed();

private:
    [[nodiscard]] QString label() const;
    void write(double frequencyHz);
    void updateValue();

    Controller& m_controller;
    Use m_use;
    Parameter& m_parameter;
    Value m_value;
    QString m_failure;
};

} // namespace campanel::panel
