// SPDX-License-Identifier: Apache-2.0
// One parameter of the controller as a tile shows it, by its row: read on demand, written with proof. Unknown
// values are NaN.
#pragma once

#include "app/panel/controller/parameter.h"
#include "app/panel/controller/parameter_table.h"
#include "app/panel/kit/value.h"

namespace campanel::panel {

class Controller;

class ParameterField : public campanel::panel::Value {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Fields of parameters belong to the Controller")
    // The value as a tile shows it, "3.1 mm/s · 1,000 Hz"; the second figure needs a program.
    Q_PROPERTY(QString shown READ shown NOTIFY shownChanged FINAL)
    // The reason why the last value was not written; empty after a success.
    Q_PROPERTY(QString failure READ failure NOTIFY shownChanged FINAL)

public:
    // `controller` owns the object.
    ParameterField(Controller& controller, const ParameterRow& row);

    [[nodiscard]] QString shown() const;
    [[nodiscard]] QString failure() const { return m_failure; }

    // Reads the value from the controller unless it is known.
    Q_INVOKABLE void read() { m_parameter.readIfUncertain(); }

signals:
    void shownChanged();

private:
    void write(double value);
    void update();

    Controller& m_controller;
    const ParameterRow& m_row;
    Parameter& m_parameter;
    QString m_failure;
};

} // namespace campanel::panel
