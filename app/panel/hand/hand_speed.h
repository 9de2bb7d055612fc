// SPDX-License-Identifier: Apache-2.0
// `HandSpeed` in QML: the speed at which an operator lets a cutter or a cam run, in percent of its program's
// rate. It acts at once, by the ramp; the controller keeps it until its power goes.
#pragma once

#include "app/panel/hand/hand_value.h"
#include "app/panel/kit/singleton.h"
#include "app/panel/kit/watched.h"
#include "app/store/logs/audit_log.h"

#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class HandSpeed : public campanel::panel::Watched, public Singleton<HandSpeed> {
    Q_OBJECT
    QML_ELEMENT
    QML_SINGLETON
    // True while the controller runs a program whose speed a hand may set, or one that it has set.
    Q_PROPERTY(bool offered READ offered NOTIFY changed FINAL)
    // Percent; NaN while it is unknown.
    Q_PROPERTY(double percent READ percent NOTIFY changed FINAL)
    Q_PROPERTY(bool canSlower READ canSlower NOTIFY changed FINAL)
    Q_PROPERTY(bool canFaster READ canFaster NOTIFY changed FINAL)
    // The program's rate at this speed: "240 bags/min"; empty without one.
    Q_PROPERTY(QString rateText READ rateText NOTIFY changed FINAL)
    // Why the last touch has not reached the controller; empty: it has.
    Q_PROPERTY(QString message READ message NOTIFY changed FINAL)

public:
    static constexpr double stepPercent = 5;

    // The controller must outlive the object.
    HandSpeed(Controller& controller, QObject* parent);

    [[nodiscard]] bool offered() const;
    [[nodiscard]] double percent() const { return m_percent.value(); }
    [[nodiscard]] bool canSlower() const;
    [[nodiscard]] bool canFaster() const;
    [[nodiscard]] QString rateText() const;
    [[nodiscard]] QString message() const;

    // One step each, and back to the program's rate. For operators.
    Q_INVOKABLE void slower();
    Q_INVOKABLE void faster();
    Q_INVOKABLE void full();

signals:
    void changed();
    // Emitted for the audit trail, once behind the last touch of a row.
    void noted(const campanel::store::AuditEntry& entry);

private:
    void set(double percent);

    Controller& m_controller;
    HandValue m_percent;
};

} // namespace campanel::panel
