// SPDX-License-Identifier: Apache-2.0
// One number of the recipe as a person reads and enters it. The Editor owns it and alone updates it.
#pragma once

#include "app/panel/kit/value.h"

namespace campanel::panel {

// The contents of the field, computed by the Editor after each change.
struct FieldView : ValueView {
    QString activeText; // the text of the controller's program, empty when there is none
    bool pinnable = false;
    bool pinned = false;
    bool derived = false;
    bool visible = true;
    QString explanation;

    bool operator==(const FieldView&) const = default;
};

class EditorField : public campanel::panel::Value {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Fields belong to the Editor")

    Q_PROPERTY(QString fieldId READ fieldId CONSTANT FINAL)
    // The group of a program's input, empty for other numbers; see profile::FieldInfo.
    Q_PROPERTY(QString group READ group CONSTANT FINAL)
    Q_PROPERTY(double value READ value NOTIFY changed FINAL)
    Q_PROPERTY(QString activeText READ activeText NOTIFY changed FINAL)
    Q_PROPERTY(bool pinnable READ pinnable NOTIFY changed FINAL)
    Q_PROPERTY(bool pinned READ pinned NOTIFY changed FINAL)
    Q_PROPERTY(bool derived READ derived NOTIFY changed FINAL)
    Q_PROPERTY(bool visible READ visible NOTIFY changed FINAL)
    Q_PROPERTY(QString explanation READ explanation NOTIFY changed FINAL)

public:
    EditorField(QString fieldId, QObject* parent);

    [[nodiscard]] QString fieldId() const { return m_fieldId; }
    [[nodiscard]] QString group() const { return m_group; }
    void setGroup(const QString& group) { m_group = group; }
    [[nodiscard]] QString activeText() const { return m_view.activeText; }
    [[nodiscard]] bool pinnable() const { return m_view.pinnable; }
    [[nodiscard]] bool pinned() const { return m_view.pinned; }
    [[nodiscard]] bool derived() const { return m_view.derived; }
    [[nodiscard]] bool visible() const { return m_view.visible; }
    [[nodiscard]] QString explanation() const { return m_view.explanation; }

    Q_INVOKABLE void togglePin();

    // Updates the field; called by the Editor.
    void show(const FieldView& view);

signals:
    void pinToggleRequested();

private:
    QString m_fieldId;
    QString m_group;
    FieldView m_view;
};

} // namespace campanel::panel
