// SPDX-License-Identifier: Apache-2.0
// `Maintenance.switches` in QML: the parameters of one cam switch at a time, those of the drives, those of
// an input that is a contact, or those of the date coder.
#pragma once

#include "app/panel/controller/parameter_fields.h"

namespace campanel::panel {

class CamSwitches final : public campanel::panel::ParameterFields {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Cam switches belong to the Maintenance")
    // The cam switch 1 to 8, `drives`, an input behind it, or the date coder as the last one.
    Q_PROPERTY(int current READ current NOTIFY currentChanged FINAL)
    // The names of what can be chosen, from 1 on.
    Q_PROPERTY(QStringList names READ names NOTIFY changed FINAL)

public:
    // The controller must outlive the object.
    CamSwitches(Controller& controller, QObject* parent);

    [[nodiscard]] int current() const { return m_current; }
    [[nodiscard]] static int drives();
    [[nodiscard]] QStringList names() const;
    // Displays the parameters of one of `names`, and reads them.
    Q_INVOKABLE void choose(int current);

    // Returns the label of a parameter; empty for one of something else.
    [[nodiscard]] static QString words(const QString& name);

signals:
    void currentChanged();

protected:
    [[nodiscard]] QString label(const Field& field) const override;

private:
    int m_current = 1;
};

} // namespace campanel::panel
