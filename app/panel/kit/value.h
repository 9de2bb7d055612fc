// SPDX-License-Identifier: Apache-2.0
// A number that a person can enter, as the keypad shows it. The owner updates it with show() and carries out
// setRequested().
#pragma once

#include "app/panel/kit/access_check.h"
#include "app/panel/kit/units.h"

#include <QObject>
#include <QString>
#include <QtQml/qqmlregistration.h>

#include <cmath>
#include <limits>
#include <optional>

namespace campanel::panel {

// In the metric unit; the keypad shows and takes the number in the units of the setting (Units).
struct ValueView {
    QString label;
    QString unit;
    QString text; // the value as it is shown, in localized digits, "--" when unknown
    double minimum = 0;
    double maximum = 0;
    double defaultValue = 0;
    int decimals = 0;
    double value = std::numeric_limits<double>::quiet_NaN();
    bool isRaw = false; // a register: never converted
    std::optional<double> possible =
        std::nullopt; // the largest value that works with the others; below the maximum

    bool operator==(const ValueView&) const = default;
};

class Value : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Values belong to the object that changes them")

    Q_PROPERTY(QString label READ label NOTIFY changed FINAL)
    Q_PROPERTY(QString unit READ unit NOTIFY changed FINAL)
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    Q_PROPERTY(double shownValue READ shownValue NOTIFY changed FINAL) // as it is typed; NaN: not known
    Q_PROPERTY(double minimum READ minimum NOTIFY changed FINAL)
    Q_PROPERTY(double maximum READ maximum NOTIFY changed FINAL)
    Q_PROPERTY(double defaultValue READ defaultValue NOTIFY changed FINAL)
    // The largest value that works with the others; NaN: not known.
    Q_PROPERTY(double possible READ possible NOTIFY changed FINAL)
    Q_PROPERTY(int decimals READ decimals NOTIFY changed FINAL)
    // The level needed to change it, as Access.level.
    Q_PROPERTY(int neededLevel READ neededLevel CONSTANT FINAL)

public:
    explicit Value(QObject* parent = nullptr);

    [[nodiscard]] QString label() const { return m_view.label; }
    [[nodiscard]] QString unit() const { return shown().unit; }
    [[nodiscard]] QString text() const { return m_view.text; }
    [[nodiscard]] double shownValue() const { return m_view.value * shown().factor; }
    [[nodiscard]] double minimum() const { return m_view.minimum * shown().factor; }
    [[nodiscard]] double maximum() const { return m_view.maximum * shown().factor; }
    [[nodiscard]] double defaultValue() const { return m_view.defaultValue * shown().factor; }
    [[nodiscard]] double possible() const { return m_view.possible.value_or(std::nan("")) * shown().factor; }
    [[nodiscard]] int decimals() const { return shown().decimals(m_view.decimals); }
    [[nodiscard]] double value() const { return m_view.value; } // metric
    [[nodiscard]] int neededLevel() const { return static_cast<int>(m_neededLevel); }
    void setNeededLevel(Level level) { m_neededLevel = level; }

    // Returns an empty text when the value may be entered, else a sentence with the limit. A value is one as
    // it is typed, in the shown unit; setRequested() has the metric one.
    Q_INVOKABLE QString check(double value) const;
    // Requests the value. Values refused by check() change nothing.
    Q_INVOKABLE void set(double value);
    // Requests the value changed by this much, at most up to its limits.
    Q_INVOKABLE void step(double by);

    [[nodiscard]] bool isInRange(double metric) const;
    [[nodiscard]] ShownUnit shown() const
    {
        return m_view.isRaw ? ShownUnit{m_view.unit} : Units::of(m_view.unit);
    }

    // Returns true when the view has changed.
    bool show(const ValueView& view);

signals:
    void changed();
    void setRequested(double metric);

private:
    ValueView m_view;
    Level m_neededLevel = Level::Technician;
};

} // namespace campanel::panel
