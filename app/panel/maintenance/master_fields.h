// SPDX-License-Identifier: Apache-2.0
// The machine data of an encoder that leads the line, with the measured delay as a suggestion.
#pragma once

#include "app/panel/controller/parameter_fields.h"
#include "app/program/master_delay.h"

namespace campanel::panel {

class MasterFields final : public campanel::panel::ParameterFields {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The fields belong to the page of the master")

public:
    // The controller must outlive the object.
    MasterFields(Controller& controller, QObject* parent);

    // `smoothingMs`: the time constant in use, NaN while unknown.
    void update(bool isAvailable, double smoothingMs, const program::MasterDelay& delay);

protected:
    [[nodiscard]] QString label(const Field& field) const override;
    [[nodiscard]] QString note(const Field& field) const override;
    [[nodiscard]] QString objection(const Field& field, double value) const override;

private:
    [[nodiscard]] QString smoothingNote(const Field& field) const;

    bool m_isAvailable = false;
    double m_smoothingMs = 0.0;
};

} // namespace campanel::panel
