// SPDX-License-Identifier: Apache-2.0
// Jogging from the screen: the axis moves only while exactly one key is held. The link needs a periodic
// update from the screen, so a panel that hangs stops the axis. After an automatic stop the key must be
// released first.
#pragma once

#include <QObject>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Controller;

class Jog : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Jog belongs to Maintenance")
    // True when pressing a key would move the axis.
    Q_PROPERTY(bool possible READ possible NOTIFY changed FINAL)
    // The requested direction: 1 forward, -1 reverse, 0 none.
    Q_PROPERTY(int held READ held NOTIFY changed FINAL)
    // The present movement, or the reason why it is blocked or ended.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    Q_PROPERTY(bool blocked READ blocked NOTIFY changed FINAL) // the text is a reason not to move
    Q_PROPERTY(QString forwardNote READ forwardNote NOTIFY changed FINAL)
    Q_PROPERTY(QString reverseNote READ reverseNote NOTIFY changed FINAL)
    Q_PROPERTY(double positionPulses READ positionPulses NOTIFY positionChanged FINAL)

public:
    // The reason for the end of a jog.
    enum class End { Released, Stopped, Blocked, BothKeys, LeftScreen };

    // The controller must outlive the object.
    Jog(Controller& controller, QObject* parent);

    [[nodiscard]] bool possible() const;
    [[nodiscard]] int held() const { return m_held; }
    [[nodiscard]] QString text() const;
    [[nodiscard]] bool blocked() const;
    [[nodiscard]] QString forwardNote() const;
    [[nodiscard]] QString reverseNote() const;
    [[nodiscard]] double positionPulses() const;

    // Handle a finger on a key: down, held long enough, and up; direction 1 or -1. For technicians. A second
    // key or a command ends the jog, also while the first key is not held long enough yet.
    Q_INVOKABLE void touch(int direction);
    Q_INVOKABLE void press(int direction);
    Q_INVOKABLE void release(int direction);
    // Stops the jog when the keys leave the screen or the window is not in front.
    Q_INVOKABLE void letGo();

signals:
    void changed();
    void positionChanged();
    // Emitted for the audit trail, with the position in pulses, NaN when it is unknown. begun() comes with
    // the key; ended() when the axis stands still or the line is lost.
    void begun(int direction, double positionPulses);
    void ended(int direction, campanel::panel::Jog::End end, double positionPulses);

private:
    [[nodiscard]] QString endText() const;
    void begin(int direction);
    void finish(End end);
    void check();
    void reportEnd();

    Controller& m_controller;
    QTimer m_repeatTimer;
    QTimer m_patienceTimer;  // limits the wait for a controller that does not move
    QTimer m_settleTimer;    // until the axis stands still
    unsigned m_pressed = 0;  // keys under a finger, as bits
    bool m_mayBegin = false; // once the only one is held long enough
    int m_held = 0;
    int m_endedDirection = 0; // ended but not reported yet
    End m_end = End::Released;
    bool m_isRefused = false; // held for some time without movement
};

} // namespace campanel::panel
