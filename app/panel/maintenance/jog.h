// SPDX-License-Identifier: Apache-2.0
// Jogging from the screen: the axis moves while exactly one key is held, and no longer. The link is told
// again and again as long as it is; a panel that hangs lets go. What ended it by itself must be let go first.
#pragma once

#include "app/panel/controller/axis_speed.h"

#include <QObject>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

namespace campanel::machine {

class Machine;

class Jog : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Jog belongs to the Service")
    // A key that is pressed now would move the axis.
    Q_PROPERTY(bool possible READ possible NOTIFY changed FINAL)
    // What the controller is asked for: 1 forward, -1 in reverse, 0 nothing.
    Q_PROPERTY(int held READ held NOTIFY changed FINAL)
    // What it does, what blocks it, or what ended it.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    Q_PROPERTY(bool troubled READ troubled NOTIFY changed FINAL) // the text is a reason not to move
    Q_PROPERTY(QString forwardNote READ forwardNote NOTIFY changed FINAL)
    Q_PROPERTY(QString reverseNote READ reverseNote NOTIFY changed FINAL)
    Q_PROPERTY(double positionPulses READ positionPulses NOTIFY positionChanged FINAL)
    Q_PROPERTY(campanel::machine::AxisSpeed* speed READ speed CONSTANT FINAL)

public:
    // What ended a jog.
    enum class End { Released, Stopped, Blocked, BothKeys, LeftScreen };

    // The machine must outlive it.
    Jog(Machine& machine, QObject* parent);

    [[nodiscard]] bool possible() const;
    [[nodiscard]] int held() const { return m_held; }
    [[nodiscard]] QString text() const;
    [[nodiscard]] bool troubled() const;
    [[nodiscard]] QString forwardNote() const;
    [[nodiscard]] QString reverseNote() const;
    [[nodiscard]] double positionPulses() const;
    [[nodiscard]] AxisSpeed* speed() { return &m_speed; }

    // A finger goes down on a key and up again; direction 1 or -1. For technicians.
    Q_INVOKABLE void press(int direction);
    Q_INVOKABLE void release(int direction);
    // The keys are not on the screen any more, or the window is not in front.
    Q_INVOKABLE void letGo();

    void retranslate() { emit changed(); }

signals:
    void changed();
    void positionChanged();
    // For the audit trail, with the position in pulses, NaN when it is not known: a key is held; and once the
    // axis stands again, or the line is lost.
    void begun(int direction, double positionPulses);
    void ended(int direction, campanel::machine::Jog::End end, double positionPulses);

private:
    [[nodiscard]] QString blockedReason() const;
    [[nodiscard]] QString endText() const;
    void begin(int direction);
    void finish(End end);
    void check();
    void tellEnd();

    Machine& m_machine;
    AxisSpeed m_speed;
    QTimer m_repeatTimer;
    QTimer m_patienceTimer; // with a controller that does not move
    QTimer m_settleTimer;   // until it stands
    unsigned m_pressed = 0; // keys under a finger, as bits
    int m_held = 0;
    int m_endedDirection = 0; // one that is not yet told as ended
    End m_end = End::Released;
    bool m_isRefused = false; // held for some time, and the controller does not move
};

} // namespace campanel::machine
