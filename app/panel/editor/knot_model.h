// SPDX-License-Identifier: Apache-2.0
// The knots of a point cam as a list and as handles on the curve.
#pragma once

#include "app/panel/editor/cam_handles.h"
#include "app/panel/editor/editor_field.h"
#include "app/panel/kit/row_model.h"
#include "profile/cam/point_cam_edit.h"

#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

struct KnotRow {
    Q_GADGET
    Q_PROPERTY(int number MEMBER number)
    Q_PROPERTY(QString masterText MEMBER masterText)
    Q_PROPERTY(QString slaveText MEMBER slaveText)
    Q_PROPERTY(bool selected MEMBER isSelected)

public:
    int number = 0; // from 1
    QString masterText;
    QString slaveText;
    bool isSelected = false;

    bool operator==(const KnotRow&) const = default;
};

using KnotRows = RowModel<KnotRow, &KnotRow::number>;

class KnotModel : public campanel::panel::CamHandles {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Knots belong to the Editor")
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ rows CONSTANT FINAL)
    // The place of the selected knot; for the keypad.
    Q_PROPERTY(campanel::panel::EditorField* master READ master CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::EditorField* slave READ slave CONSTANT FINAL)
    Q_PROPERTY(QString wrapText READ wrapText NOTIFY changed FINAL)
    Q_PROPERTY(bool canRepair READ canRepair NOTIFY changed FINAL)
    Q_PROPERTY(bool canRemove READ canRemove NOTIFY changed FINAL)

public:
    explicit KnotModel(QObject* parent);

    [[nodiscard]] KnotRows* rows() { return &m_rows; }
    [[nodiscard]] EditorField* master() { return &m_master; }
    [[nodiscard]] EditorField* slave() { return &m_slave; }
    [[nodiscard]] QString wrapText() const;
    [[nodiscard]] bool canRepair() const;
    [[nodiscard]] bool canRemove() const;

    // Inserts a knot on the curve at this time and selects it.
    Q_INVOKABLE void insert(double seconds);
    // Inserts a knot halfway to the next one; after the last knot, halfway to the previous one.
    Q_INVOKABLE void insertAfterSelected();
    Q_INVOKABLE void removeSelected();
    // Sets periodic ends, so that nothing jumps at the wrap.
    Q_INVOKABLE void repairWrap();

protected:
    [[nodiscard]] int listSize(const profile::Program& program) const override;
    [[nodiscard]] bool isValid(const profile::Program& program) const override;
    [[nodiscard]] double masterDegOf(const profile::Program& program, int index) const override;
    void moveBy(profile::Program& program, int index, double deg, double mm) const override;
    void showSelection() override;

private:
    [[nodiscard]] const profile::PointCamProgram& cam() const
    {
        return std::get<profile::PointCamProgram>(*program());
    }
    [[nodiscard]] const profile::Knot& at(int index) const
    {
        return cam().knots[static_cast<std::size_t>(index)];
    }
    void insertAt(double masterDeg);
    void moveSelected(const profile::Knot& wanted);
    void showFields();

    KnotRows m_rows{this};
    EditorField m_master{QStringLiteral("knotMaster"), this};
    EditorField m_slave{QStringLiteral("knotSlave"), this};
};

} // namespace campanel::panel
