// SPDX-License-Identifier: Apache-2.0
// The machine data of the axes that the controller can measure: pulses, film per turn, direction, and the
// index sensors of film and infeed.
#pragma once

#include "app/panel/controller/parameter_fields.h"

namespace campanel::panel {

class AxisFields final : public campanel::panel::ParameterFields {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The fields belong to the measurement of the axes")

public:
    // The controller must outlive the object.
    AxisFields(Controller& controller, QObject* parent);

    // Returns the label of a parameter; empty for one that is not in this list. `name` as in the register
    // table.
    [[nodiscard]] static QString words(const QString& name);
    // Returns the name of a row's parameter.
    [[nodiscard]] const char* nameOf(int row) const;
    // Sets whether the controller can turn a motor the other way.
    void setReversible(bool isReversible) { m_isReversible = isReversible; }

protected:
    [[nodiscard]] QString label(const Field& field) const override;
    [[nodiscard]] QString objection(const Field& field, double value) const override;
    [[nodiscard]] bool isMeasurable(const Field& field) const override;

private:
    bool m_isReversible = true;
};

} // namespace campanel::panel
