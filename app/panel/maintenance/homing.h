// SPDX-License-Identifier: Apache-2.0
// Homing: whether the controller knows where its axis is, what finding that out does, and what came of the
// last time.
#pragma once

#include "app/panel/controller/io_pins.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Controller;

class Homing : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Homing belongs to Maintenance")
    Q_PROPERTY(Place place READ place NOTIFY changed FINAL)
    Q_PROPERTY(QString placeText READ placeText NOTIFY changed FINAL)
    // The effect of Home on this machine.
    Q_PROPERTY(QString explanation READ explanation NOTIFY changed FINAL)
    Q_PROPERTY(QString keyText READ keyText NOTIFY changed FINAL)
    Q_PROPERTY(bool possible READ possible NOTIFY changed FINAL)
    Q_PROPERTY(QString blockedReason READ blockedReason NOTIFY changed FINAL)
    // True when Home is displayed beside Start, where it may be touched by mistake. False for a press with a
    // known upper position: homing would make all its strokes wrong.
    Q_PROPERTY(bool offered READ offered NOTIFY changed FINAL)
    // The result of the last homing; empty before the first.
    Q_PROPERTY(QString resultText READ resultText NOTIFY changed FINAL)
    Q_PROPERTY(bool failed READ failed NOTIFY changed FINAL)
    // True when homing moves the axis; on a press nothing moves.
    Q_PROPERTY(bool moves READ moves NOTIFY changed FINAL)

public:
    enum class Place { Unknown, Homed, NotHomed, NotNeeded };
    Q_ENUM(Place)
    enum class Result { None, UnderWay, Done, Stopped, Failed, Interrupted };

    // The controller must outlive the object.
    Homing(Controller& controller, QObject* parent);

    [[nodiscard]] Place place() const;
    [[nodiscard]] QString placeText() const;
    [[nodiscard]] QString explanation() const;
    [[nodiscard]] QString keyText() const;
    [[nodiscard]] bool possible() const { return blockedReason().isEmpty(); }
    [[nodiscard]] QString blockedReason() const;
    [[nodiscard]] bool offered() const;
    [[nodiscard]] QString resultText() const;
    [[nodiscard]] bool failed() const;
    [[nodiscard]] bool moves() const;

    // Asks what the controller can do; call it when the page opens.
    Q_INVOKABLE void open() { m_pins.read(); }
    // Calls Controller::home(), when nothing blocks it.
    Q_INVOKABLE void home();

signals:
    void changed();
    // Emitted for the audit trail: Done, Stopped, Failed or Interrupted.
    void ended(campanel::panel::Homing::Result result);

private:
    void note();
    void noteProgram();
    void end(Result result);
    // Returns true when the position survives a power cut, so that no index mark is searched.
    [[nodiscard]] bool isKept() const;

    Controller& m_controller;
    IoPins m_pins;
    Result m_result = Result::None;
    bool m_wasStopping = false;
};

} // namespace campanel::panel
