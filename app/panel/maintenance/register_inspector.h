// SPDX-License-Identifier: Apache-2.0
// The controller's registers: the visible rows are read periodically. Parameters can be written and are
// displayed as read back.
#pragma once

#include "app/panel/kit/value.h"
#include "app/panel/kit/watched.h"
#include "app/panel/maintenance/register_model.h"

#include <QVariantList>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Controller;

class RegisterInspector : public campanel::panel::Watched {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The inspector belongs to Maintenance")
    Q_PROPERTY(campanel::panel::RegisterModel* registers READ registers CONSTANT FINAL)
    // The filter: a key of `groups`, "" for all.
    Q_PROPERTY(QString group READ group WRITE setGroup NOTIFY filterChanged FINAL)
    Q_PROPERTY(QString groupText READ groupText NOTIFY filterChanged FINAL)
    Q_PROPERTY(QString nameFilter READ nameFilter WRITE setNameFilter NOTIFY filterChanged FINAL)
    Q_PROPERTY(QVariantList groups READ groups NOTIFY filterChanged FINAL) // list of {key, text}
    // The selected row; -1: none.
    Q_PROPERTY(int selected READ selected NOTIFY selectionChanged FINAL)
    // The limits, the reason why it cannot be written, or the result of the last write.
    Q_PROPERTY(QString selectedText READ selectedText NOTIFY selectionChanged FINAL)
    Q_PROPERTY(bool failed READ failed NOTIFY selectionChanged FINAL)
    Q_PROPERTY(bool canWrite READ canWrite NOTIFY selectionChanged FINAL)
    Q_PROPERTY(bool writable READ writable NOTIFY selectionChanged FINAL)
    // The selected register, for the keypad.
    Q_PROPERTY(campanel::panel::Value* value READ value CONSTANT FINAL)

public:
    // The controller must outlive the object.
    RegisterInspector(Controller& controller, QObject* parent);

    [[nodiscard]] RegisterModel* registers() { return &m_registers; }
    [[nodiscard]] QString group() const { return m_group; }
    void setGroup(const QString& group);
    [[nodiscard]] QString groupText() const;
    [[nodiscard]] QString nameFilter() const { return m_nameFilter; }
    void setNameFilter(const QString& name);
    [[nodiscard]] QVariantList groups() const;
    [[nodiscard]] int selected() const { return m_selected; }
    [[nodiscard]] QString selectedName() const;
    [[nodiscard]] QString selectedText() const;
    [[nodiscard]] bool failed() const { return m_isFailed; }
    [[nodiscard]] bool writable() const;
    [[nodiscard]] bool canWrite() const;
    [[nodiscard]] Value* value() { return &m_value; }

    Q_INVOKABLE void setVisibleRows(int first, int last);
    Q_INVOKABLE void select(int row);

signals:
    void filterChanged();
    void selectionChanged();

private:
    void write(double value);
    // Updates what is said of the selected register.
    void updateSelected();
    void applyFilter();
    void noteConnection();
    void noteProgram();
    void readVisible();
    void takeRead(const link::ReadOutcome& outcome);
    void takeWritten(const link::ParameterOutcome& outcome);
    [[nodiscard]] const RegisterRow* row() const { return m_registers.rowAt(m_selected); }
    [[nodiscard]] QString number(double value) const; // format of the selected register, with unit

    Controller& m_controller;
    RegisterModel m_registers{this};
    int m_pendingReads = 0;
    bool m_isWriting = false;
    Value m_value;
    int m_first = 0;
    int m_last = -1;
    int m_selected = -1;
    QString m_group;
    QString m_nameFilter;
    QString m_outcome; // result of the last write
    bool m_isFailed = false;
};

} // namespace campanel::panel
