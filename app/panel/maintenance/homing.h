// SPDX-License-Identifier: Apache-2.0
// Homing: whether the controller knows where its axis is, what finding that out does, and what came of the
// last time.
#pragma once

#include "app/panel/controller/axis_speed.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::machine {

class Machine;

class Homing : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Homing belongs to the Service")
    Q_PROPERTY(Place place READ place NOTIFY changed FINAL)
    Q_PROPERTY(QString placeText READ placeText NOTIFY changed FINAL)
    // What pressing Home does to this machine.
    Q_PROPERTY(QString explanation READ explanation NOTIFY changed FINAL)
    Q_PROPERTY(QString keyText READ keyText NOTIFY changed FINAL)
    Q_PROPERTY(bool possible READ possible NOTIFY changed FINAL)
    Q_PROPERTY(QString blockedReason READ blockedReason NOTIFY changed FINAL)
    // Home stands beside Start, where it is touched in passing: not for a press whose upper position is
    // known, as all its strokes would become wrong.
    Q_PROPERTY(bool offered READ offered NOTIFY changed FINAL)
    // What came of the last homing that was seen; empty before one.
    Q_PROPERTY(QString resultText READ resultText NOTIFY changed FINAL)
    Q_PROPERTY(bool failed READ failed NOTIFY changed FINAL)
    // Of a press nothing turns.
    Q_PROPERTY(bool moves READ moves NOTIFY changed FINAL)
    Q_PROPERTY(campanel::machine::AxisSpeed* speed READ speed CONSTANT FINAL)

public:
    enum class Place { Unknown, Homed, NotHomed, NotNeeded };
    Q_ENUM(Place)
    enum class Result { None, UnderWay, Done, Stopped, Failed, Interrupted };

    // The machine must outlive it.
    Homing(Machine& machine, QObject* parent);

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
    [[nodiscard]] AxisSpeed* speed() { return &m_speed; }

    // Machine::home(), when nothing blocks it.
    Q_INVOKABLE void home();

    void retranslate() { emit changed(); }

signals:
    void changed();
    // For the audit trail: Done, Stopped, Failed or Interrupted.
    void ended(campanel::machine::Homing::Result result);

private:
    void note();
    void noteProgram();
    void end(Result result);

    Machine& m_machine;
    AxisSpeed m_speed;
    Result m_result = Result::None;
    bool m_wasStopping = false;
};

} // namespace campanel::machine
