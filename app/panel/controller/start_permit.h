// SPDX-License-Identifier: Apache-2.0
// `Controller.startPermit` in QML: the setting by which the controller starts only with the panel's permit.
#pragma once

#include "app/panel/controller/parameter_fields.h"

namespace campanel::panel {

class StartPermit final : public campanel::panel::ParameterFields {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Controller.startPermit is the only one")

public:
    // The controller must outlive the object.
    StartPermit(Controller& controller, QObject* parent);

    // Turns the setting on, as the first start does, in a controller that has it.
    Q_INVOKABLE void turnOn();

    // Returns the label of the parameter; empty for another one.
    [[nodiscard]] static QString words(const QString& name);

protected:
    [[nodiscard]] QString label(const Field& field) const override;
    [[nodiscard]] QString note(const Field& field) const override;
};

} // namespace campanel::panel
