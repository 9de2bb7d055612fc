// SPDX-License-Identifier: Apache-2.0
// The knots or segments of a cam as handles on the curve: which one is selected, where they are, how a drag
// moves them. It displays the Editor's values and sends every change to the Editor.
#pragma once

#include "profile/program/programs.h"

#include <QList>
#include <QObject>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class CamHandles : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Handles belong to the Editor")
    Q_PROPERTY(int count READ count NOTIFY changed FINAL)
    Q_PROPERTY(int selected READ selected WRITE select NOTIFY changed FINAL)
    // The times of the handles on the time axis of the curves, s.
    Q_PROPERTY(QList<double> times READ times NOTIFY changed FINAL)
    // The selected entry on the time axis as pairs of start and end, s: twice the same time for a knot, two
    // pairs for a segment that goes over the end of the axis.
    Q_PROPERTY(QList<double> selection READ selection NOTIFY changed FINAL)

public:
    explicit CamHandles(QObject* parent);

    // Sets the program, and the seconds of its cycle. `isOfKind` is false for other kinds.
    void show(const profile::Program& program, double cycleS, bool isOfKind);

    [[nodiscard]] int count() const { return m_program ? listSize(*m_program) : 0; }
    [[nodiscard]] int selected() const { return m_selected; }
    void select(int index);
    [[nodiscard]] QList<double> times() const;
    [[nodiscard]] QList<double> selection() const;

    // Start and end a drag. The offset is in seconds of the time axis and mm of the curve, from the start of
    // the drag; endDrag() makes it one undo step.
    Q_INVOKABLE void beginDrag(int index);
    Q_INVOKABLE void drag(double seconds, double mm);
    Q_INVOKABLE void endDrag();

signals:
    void changed();
    void edited(const campanel::profile::Program& program);
    void dragged(const campanel::profile::Program& program);
    void dragEnded();

protected:
    [[nodiscard]] virtual int listSize(const profile::Program& program) const = 0;
    // Returns true when the entries can be edited.
    [[nodiscard]] virtual bool isValid(const profile::Program& program) const = 0;
    // Returns the master angle of a handle.
    [[nodiscard]] virtual double masterDegOf(const profile::Program& program, int index) const = 0;
    // Returns the master angle at which an entry begins; that of its handle for an entry without a length.
    [[nodiscard]] virtual double startDegOf(const profile::Program& program, int index) const
    {
        return masterDegOf(program, index);
    }
    // Moves a handle of the program by degrees of the cam, and by mm before scaling.
    virtual void moveBy(profile::Program& program, int index, double deg, double mm) const = 0;
    // Updates rows and fields after a change of program or selection.
    virtual void showSelection() = 0;

    [[nodiscard]] bool canEdit() const { return m_program && isValid(*m_program); }
    [[nodiscard]] const std::optional<profile::Program>& program() const { return m_program; }
    // Returns the angle of the cam at a time of the curves.
    [[nodiscard]] std::optional<double> masterDegAt(double seconds) const;
    void setSelected(int index) { m_selected = index; }

private:
    std::optional<profile::Program> m_program;
    std::optional<profile::Program> m_beforeDrag;
    double m_cycleS = 1;
    int m_selected = 0;
};

} // namespace campanel::panel
