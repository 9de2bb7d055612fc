// SPDX-License-Identifier: Apache-2.0
// `Maintenance.tower` in QML: what each condition shows on the lights of the tower and on the horn. The rows
// are those of one condition after the other, each with all lights.
#pragma once

#include "app/panel/controller/parameter_fields.h"

namespace campanel::panel {

class TowerFields final : public campanel::panel::ParameterFields {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The light tower belongs to Maintenance")
    Q_PROPERTY(QStringList conditions READ conditions NOTIFY changed FINAL)
    Q_PROPERTY(QStringList lights READ lights NOTIFY changed FINAL)
    Q_PROPERTY(QStringList modes READ modes NOTIFY changed FINAL)
    // The reason why there is no table; empty when there is one.
    Q_PROPERTY(QString emptyText READ emptyText NOTIFY changed FINAL)

public:
    // The controller must outlive the object.
    TowerFields(Controller& controller, QObject* parent);

    [[nodiscard]] static QStringList conditions();
    [[nodiscard]] static QStringList lights();
    [[nodiscard]] static QStringList modes();
    [[nodiscard]] QString emptyText() const;

    // Returns the label of a parameter; empty for one of something else.
    [[nodiscard]] static QString words(const QString& name);

protected:
    [[nodiscard]] QString label(const Field& field) const override;

private:
    Parameter* m_first = nullptr; // of the table
};

} // namespace campanel::panel
