// SPDX-License-Identifier: Apache-2.0
// The knots of a point cam as a list and as handles on the curve. It shows what the Editor gives it and asks
// the Editor for every change.
#pragma once

#include "app/panel/editor/editor_field.h"
#include "profile/cam/point_cam_edit.h"

#include <QAbstractListModel>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::machine {

class KnotModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Knots belong to the Editor")
    Q_PROPERTY(int count READ count NOTIFY changed FINAL)
    Q_PROPERTY(int selected READ selected WRITE select NOTIFY changed FINAL)
    // Place of the selected knot; for the keypad.
    Q_PROPERTY(campanel::machine::EditorField* master READ master CONSTANT FINAL)
    Q_PROPERTY(campanel::machine::EditorField* slave READ slave CONSTANT FINAL)
    // Where the knots stand on the time axis of the curves, s.
    Q_PROPERTY(QList<double> times READ times NOTIFY changed FINAL)
    Q_PROPERTY(QString wrapText READ wrapText NOTIFY changed FINAL)
    Q_PROPERTY(bool canRepair READ canRepair NOTIFY changed FINAL)
    Q_PROPERTY(bool canRemove READ canRemove NOTIFY changed FINAL)

public:
    enum Role { NumberRole = Qt::UserRole + 1, MasterTextRole, SlaveTextRole, SelectedRole };

    explicit KnotModel(QObject* parent);

    // The program as it is now and the seconds of its cycle; nothing for other kinds.
    void show(const std::optional<profile::PointCamProgram>& program, double cycleS);

    [[nodiscard]] int count() const;
    [[nodiscard]] int selected() const { return m_selected; }
    void select(int index);
    [[nodiscard]] EditorField* master() { return &m_master; }
    [[nodiscard]] EditorField* slave() { return &m_slave; }
    [[nodiscard]] QList<double> times() const;
    [[nodiscard]] QString wrapText() const;
    [[nodiscard]] bool canRepair() const;
    [[nodiscard]] bool canRemove() const;

    // Moves a knot by so many seconds of the time axis and mm of the curve from where it was when the drag
    // began; endDrag() makes it one step of undo.
    Q_INVOKABLE void beginDrag(int index);
    Q_INVOKABLE void drag(double seconds, double mm);
    Q_INVOKABLE void endDrag();
    // A new knot on the curve at this time; it becomes the selected one.
    Q_INVOKABLE void insert(double seconds);
    // The same halfway to the next one, of the last one halfway to the one before.
    Q_INVOKABLE void insertAfterSelected();
    Q_INVOKABLE void removeSelected();
    // Periodic ends, so that nothing jumps where the cycle closes.
    Q_INVOKABLE void repairWrap();

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

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
    void showFields();

    std::optional<profile::PointCamProgram> m_program;
    std::optional<profile::PointCamProgram> m_beforeDrag;
    double m_cycleS = 1;
    int m_selected = 0;
    EditorField m_master{QStringLiteral("knotMaster"), this};
    EditorField m_slave{QStringLiteral("knotSlave"), this};
};

} // namespace campanel::machine
