// SPDX-License-Identifier: Apache-2.0
// `Maintenance.packing.jam` in QML: the knife's torque over the angle of its shaft, the band that the
// controller has learned of it, and the jams. Read while a page shows them, else once a minute for the
// residue. Angles in degrees from the cut, negative before it; torques in per cent of the rated torque; NaN
// while unknown.
#pragma once

#include "app/panel/controller/io_pins.h"
#include "app/panel/kit/numbers.h"
#include "app/panel/kit/watched.h"
#include "profile/cutter/rotary_cutter.h"

#include <QList>
#include <QPointF>
#include <QTimer>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class Controller;
class Parameter;

class JamWatch : public campanel::panel::Watched {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The jams belong to the packing setup")
    // The learned band: (angle, expected torque), and half of its width at each of them.
    Q_PROPERTY(QList<QPointF> expected READ expected NOTIFY changed FINAL)
    Q_PROPERTY(QList<double> halfWidths READ halfWidths NOTIFY changed FINAL)
    // The last readings of the running machine, (angle, torque), the newest at the end.
    Q_PROPERTY(QList<QPointF> readings READ readings NOTIFY changed FINAL)
    // The last jam that was seen in the torque, (angle, torque).
    Q_PROPERTY(QPointF jam READ jam NOTIFY changed FINAL)
    // The end of the band there.
    Q_PROPERTY(double limitPercent READ limitPercent NOTIFY changed FINAL)
    // The ends of the picture.
    Q_PROPERTY(double fromDeg READ fromDeg NOTIFY changed FINAL)
    Q_PROPERTY(double toDeg READ toDeg NOTIFY changed FINAL)
    // The angle from which the torque is monitored.
    Q_PROPERTY(double closingDeg READ closingDeg NOTIFY changed FINAL)
    // The state of the monitoring in a sentence, and what to do.
    Q_PROPERTY(QString stateText READ stateText NOTIFY changed FINAL)
    // True when the torque cannot show a jam although the detection is on.
    Q_PROPERTY(bool blind READ blind NOTIFY changed FINAL)
    Q_PROPERTY(QString intervalText READ intervalText NOTIFY changed FINAL)
    Q_PROPERTY(QString lastText READ lastText NOTIFY changed FINAL)
    Q_PROPERTY(QString countText READ countText NOTIFY changed FINAL)
    Q_PROPERTY(QString residueText READ residueText NOTIFY changed FINAL)
    // The sentence in place of the page while there is nothing to show; else empty.
    Q_PROPERTY(QString emptyText READ emptyText NOTIFY changed FINAL)

public:
    static constexpr int maxReadings = 100;

    // The controller must outlive the object.
    JamWatch(Controller& controller, QObject* parent);

    [[nodiscard]] QList<QPointF> expected() const;
    [[nodiscard]] QList<double> halfWidths() const;
    [[nodiscard]] QList<QPointF> readings() const { return m_readings; }
    [[nodiscard]] QPointF jam() const;
    [[nodiscard]] double limitPercent() const;
    [[nodiscard]] double fromDeg() const;
    [[nodiscard]] double toDeg() const;
    [[nodiscard]] double closingDeg() const;
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] bool blind() const;
    [[nodiscard]] QString intervalText() const;
    [[nodiscard]] QString lastText() const;
    [[nodiscard]] QString countText() const;
    [[nodiscard]] QString residueText() const;
    [[nodiscard]] QString emptyText() const;

signals:
    void changed();
    // Emitted for a new record of the mean torque at the cut.
    void residueRecorded(double percent);

private:
    [[nodiscard]] bool isReported() const;
    void read();
    void takeRead(const link::ReadOutcome& outcome);
    void followResidue();
    void takePins();
    void noteConnection();
    void noteProgram();
    [[nodiscard]] double fromCutDeg(double masterDeg) const;

    Controller& m_controller;
    Parameter& m_closing;
    IoPins m_pins;
    std::optional<profile::RotaryCutter> m_cutter; // of the active program
    std::optional<modbus::JamStatus> m_status;
    std::optional<std::uint32_t> m_residueNumber; // the last one; empty before the first reading
    QList<QPointF> m_readings;
    QTimer m_slowTimer;
    bool m_isAsked = false;
};

} // namespace campanel::panel
