// SPDX-License-Identifier: Apache-2.0
// One number of the recipe as a person reads and enters it. The Editor owns it and alone updates it.
#pragma once

#include "app/panel/kit/access_check.h"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <limits>

namespace campanel::panel {

// The contents of the field, computed by the Editor after each change.
struct FieldView {
    QString label;
    QString unit;
    double value = std::numeric_limits<double>::quiet_NaN();
    QString text;       // the value in localized digits, "--" when unknown
    QString activeText; // the same for the controller's program, empty when there is none
    double minimum = 0;
    double maximum = 0;
    double defaultValue = 0;
    int decimals = 0;
    bool pinnable = false;
    bool pinned = false;
    bool derived = false;
    bool visible = true;
    QString explanation;

    bool operator==(const FieldView&) const = default;
};

class EditorField : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Fields belong to the Editor")

    Q_PROPERTY(QString fieldId READ fieldId CONSTANT FINAL)
    // The level needed to change it, as Access.level.
    Q_PROPERTY(int neededLevel READ neededLevel CONSTANT FINAL)
    Q_PROPERTY(QString label READ label NOTIFY changed FINAL)
    Q_PROPERTY(QString unit READ unit NOTIFY changed FINAL)
    Q_PROPERTY(double value READ value NOTIFY changed FINAL)
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    Q_PROPERTY(QString activeText READ activeText NOTIFY changed FINAL)
    Q_PROPERTY(double minimum READ minimum NOTIFY changed FINAL)
    Q_PROPERTY(double maximum READ maximum NOTIFY changed FINAL)
    Q_PROPERTY(double defaultValue READ defaultValue NOTIFY changed FINAL)
    Q_PROPERTY(int decimals READ decimals NOTIFY changed FINAL)
    Q_PROPERTY(bool pinnable READ pinnable NOTIFY changed FINAL)
    Q_PROPERTY(bool pinned READ pinned NOTIFY changed FINAL)
    Q_PROPERTY(bool derived READ derived NOTIFY changed FINAL)
    Q_PROPERTY(bool visible READ visible NOTIFY changed FINAL)
    Q_PROPERTY(QString explanation READ explanation NOTIFY changed FINAL)

public:
    EditorField(QString fieldId, QObject* parent);

    [[nodiscard]] QString fieldId() const { return m_fieldId; }
    [[nodiscard]] int neededLevel() const { return static_cast<int>(m_neededLevel); }
    void setNeededLevel(Level level) { m_neededLevel = level; }
    [[nodiscard]] QString label() const { return m_view.label; }
    [[nodiscard]] QString unit() const { return m_view.unit; }
    [[nodiscard]] double value() const { return m_view.value; }
    [[nodiscard]] QString text() const { return m_view.text; }
    [[nodiscard]] QString activeText() const { return m_view.activeText; }
    [[nodiscard]] double minimum() const { return m_view.minimum; }
    [[nodiscard]] double maximum() const { return m_view.maximum; }
    [[nodiscard]] double defaultValue() const { return m_view.defaultValue; }
    [[nodiscard]] int decimals() const { return m_view.decimals; }
    [[nodiscard]] bool pinnable() const { return m_view.pinnable; }
    [[nodiscard]] bool pinned() const { return m_view.pinned; }
    [[nodiscard]] bool derived() const { return m_view.derived; }
    [[nodiscard]] bool visible() const { return m_view.visible; }
    [[nodiscard]] QString explanation() const { return m_view.explanation; }

    // Returns an empty text when the value may be entered, else a sentence with the limit.
    Q_INVOKABLE QString check(double value) const;
    // Sets the value. Values refused by check() change nothing.
    Q_INVOKABLE void set(double value);
    Q_INVOKABLE void togglePin();

    // Updates the field; called by the Editor.
    void show(FieldView view);

signals:
    void changed();
    void setRequested(double value);
    void pinToggleRequested();

private:
    QString m_fieldId;
    Level m_neededLevel = Level::Technician;
    FieldView m_view;
};

} // namespace campanel::panel
