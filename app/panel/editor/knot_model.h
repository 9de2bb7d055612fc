// SPDX-License-Identifier: Apache-2.0
// The knots of a point cam as a list and as handles on the curve. It displays the Editor's values and sends
// every change to the Editor.
#pragma once

#include "app/panel/editor/editor_field.h"
#include "app/panel/kit/row_model.h"
#include "profile/cam/point_cam_edit.h"

#include <QtQml/qqmlregistration.h>

#include <optional>

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

class KnotModel : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Knots belong to the Editor")
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ rows CONSTANT FINAL)
    Q_PROPERTY(int count READ count NOTIFY changed FINAL)
    Q_PROPERTY(int selected READ selected WRITE select NOTIFY changed FINAL)
    // The place of the selected knot; for the keypad.
    Q_PROPERTY(campanel::panel::EditorField* master READ master CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::EditorField* slave READ slave CONSTANT FINAL)
    // The times of the knots on the time axis of the curves, s.
    Q_PROPERTY(QList<double> times READ times NOTIFY changed FINAL)
    Q_PROPERTY(QString wrapText READ wrapText NOTIFY changed FINAL)
    Q_PROPERTY(bool canRepair READ canRepair NOTIFY changed FINAL)
    Q_PROPERTY(bool canRemove READ canRemove NOTIFY changed FINAL)

public:
    explicit KnotModel(QObject* parent);

    // Sets the program and the seconds of its cycle; nothing for other kinds.
    void show(const std::optional<profile::PointCamProgram>& program, double cycleS);

    [[nodiscard]] KnotRows* rows() { return &m_rows; }
    [[nodiscard]] int count() const;
    [[nodiscard]] int selected() const { return m_selected; }
    void select(int index);
    [[nodiscard]] EditorField* master() { return &m_master; }
    [[nodiscard]] EditorField* slave() { return &m_slave; }
    [[nodiscard]] QList<double> times() const;
    [[nodiscard]] QString wrapText() const;
    [[nodiscard]] bool canRepair() const;
    [[nodiscard]] bool canRemove() const;

    // Start and end a drag of a knot. The offset is in seconds of the time axis and mm of the curve, from the
    // start of the drag; endDrag() makes it one undo step.
    Q_INVOKABLE void beginDrag(int index);
    Q_INVOKABLE void drag(double seconds, double mm);
    Q_INVOKABLE void endDrag();
    // Inserts a knot on the curve at this time and selects it.
    Q_INVOKABLE void insert(double seconds);
    // Inserts a knot halfway to the next one; after the last knot, halfway to the previous one.
    Q_INVOKABLE void insertAfterSelected();
    Q_INVOKABLE void removeSelected();
    // Sets periodic ends, so that nothing jumps at the wrap.
    Q_INVOKABLE void repairWrap();

signals:
    void changed();
    void edited(const campanel::profile::PointCamProgram& program);
    void dragged(const campanel::profile::PointCamProgram& program);
    void dragEnded();

private:
    [[nodiscard]] bool isValid() const;
    [[nodiscard]] const profile::Knot& at(int index) const
    {
        return m_program->knots[static_cast<std::size_t>(index)];
    }
    void insertAt(double masterDeg);
    void moveSelected(const profile::Knot& wanted);
    void showRows();
    void showFields();

    std::optional<profile::PointCamProgram> m_program;
    std::optional<profile::PointCamProgram> m_beforeDrag;
    KnotRows m_rows{this};
    double m_cycleS = 1;
    int m_selected = 0;
    EditorField m_master{QStringLiteral("knotMaster"), this};
    EditorField m_slave{QStringLiteral("knotSlave"), this};
};

} // namespace campanel::panel
