// SPDX-License-Identifier: Apache-2.0
// Trying an output from the screen: it is on only while its key is held, at standstill. The controller
// switches it off half a second after the last request, so a panel that hangs has let go.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/maintenance/jog.h"

#include <QObject>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Controller;

class OutputTry : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The test of an output belongs to Maintenance")
    // True when the controller has the command.
    Q_PROPERTY(bool offered READ offered NOTIFY changed FINAL)
    // True when pressing a key would switch its output on.
    Q_PROPERTY(bool possible READ possible NOTIFY changed FINAL)
    // The bit of the output that is held on; -1: none.
    Q_PROPERTY(int held READ held NOTIFY changed FINAL)
    // The present state, or the reason why an output is not on.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    Q_PROPERTY(bool blocked READ blocked NOTIFY changed FINAL) // the text is such a reason

public:
    using End = Jog::End;

    // The controller must outlive the object.
    OutputTry(Controller& controller, QObject* parent);

    [[nodiscard]] bool offered() const;
    [[nodiscard]] bool possible() const;
    [[nodiscard]] int held() const { return m_held; }
    [[nodiscard]] QString text() const;
    [[nodiscard]] bool blocked() const { return !m_reason.isEmpty(); }

    // Handle a finger on the key of an output, by its bit: down, held long enough, and up. For technicians. A
    // second key or a command ends the try, also while the first key is not held long enough yet.
    Q_INVOKABLE void touch(int output);
    Q_INVOKABLE void press(int output);
    Q_INVOKABLE void release(int output);
    // Switches the output off when the keys leave the screen or the window is not in front.
    Q_INVOKABLE void letGo();

signals:
    void changed();
    // Emitted for the audit trail, with the name of the output in the register map.
    void begun(const QString& output);
    void ended(const QString& output, campanel::panel::Jog::End end);

private:
    void send(bool isOn);
    void onAnswer(const link::CommandOutcome& outcome);
    void finish(End end, const QString& reason = {});

    Controller& m_controller;
    QTimer m_repeatTimer;
    unsigned m_pressed = 0;  // keys under a finger, as bits
    bool m_mayBegin = false; // once the only one is held long enough
    int m_held = -1;
    bool m_isAsked = false; // a request is under way
    QString m_reason;
};

} // namespace campanel::panel
