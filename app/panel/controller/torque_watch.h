// SPDX-License-Identifier: Apache-2.0
// `Controller.torque` in QML: the torque that the drive reports beside the one that program and machine data
// predict, while somebody looks at them. In per cent of the rated torque; NaN while unknown.
#pragma once

#include "app/panel/controller/io_pins.h"
#include "app/panel/controller/parameter.h"
#include "app/panel/kit/numbers.h"
#include "app/panel/kit/watched.h"
#include "profile/model/machine.h"
#include "profile/model/motion_profile.h"
#include "profile/model/torque.h"

#include <QList>
#include <QPointF>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class TorqueWatch : public campanel::panel::Watched {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The torque belongs to the Controller")
    // The largest magnitude of measured minus predicted among the last readings at full speed.
    Q_PROPERTY(QString text READ text NOTIFY changed FINAL)
    Q_PROPERTY(QString shortText READ shortText NOTIFY changed FINAL)
    Q_PROPERTY(double measuredPercent READ measuredPercent NOTIFY changed FINAL)
    // The largest torque of the motor by the machine data.
    Q_PROPERTY(double limitPercent READ limitPercent NOTIFY changed FINAL)
    // The following error above which the controller stops, beside it on Run.
    Q_PROPERTY(double followingLimitMm READ followingLimitMm NOTIFY changed FINAL)

public:
    // The readings that the difference is of: half a minute of them.
    static constexpr int maxReadings = 100;

    struct Reading {
        double angleDeg = unknown; // of the master
        double measuredPercent = unknown;
        double predictedPercent = unknown;

        [[nodiscard]] double difference() const { return measuredPercent - predictedPercent; }
    };

    // The controller must outlive the object.
    explicit TorqueWatch(Controller& controller);

    [[nodiscard]] double measuredPercent() const;
    [[nodiscard]] double limitPercent() const;
    [[nodiscard]] double followingLimitMm() const;
    [[nodiscard]] double predictedPercent() const { return m_last.predictedPercent; }
    [[nodiscard]] double differencePercent() const;
    [[nodiscard]] QString text() const; // empty when nothing is known
    [[nodiscard]] QString shortText() const;
    [[nodiscard]] QString missingText() const;

    // Returns the readings at full speed, and the one with the largest difference; empty without any.
    [[nodiscard]] const QList<Reading>& readings() const { return m_readings; }
    [[nodiscard]] std::optional<Reading> worst() const;
    [[nodiscard]] const profile::TorqueLoad& load() const { return m_load; }
    [[nodiscard]] double ratedTorqueNm() const { return m_machineData ? m_machineData->ratedTorqueNm : 0; }

    // Sets the machine data for the kind of the active program; empty: nobody has entered any.
    void setMachineData(const std::optional<profile::Machine>& machine);
    [[nodiscard]] const std::optional<profile::Machine>& machineData() const { return m_machineData; }
    // Handle events of the Controller.
    void noteConnection();
    void noteProgram();
    void noteStatus();

signals:
    void changed();

private:
    [[nodiscard]] QString measuredText() const;
    void takePins();
    void prepare();
    // Returns true when the machine data are those of the axis that the active program was made for.
    [[nodiscard]] bool isSameAxis() const;
    [[nodiscard]] bool isAtFullSpeed() const;
    // Returns the torque at this angle of the master, in per cent of the rated torque.
    [[nodiscard]] double predictedAt(double angleDeg) const;

    Controller& m_controller;
    Parameter& m_followingLimit;
    IoPins m_pins;
    std::optional<profile::Machine> m_machineData;
    profile::MotionProfile m_motion; // of the active program, forward; empty while unknown
    profile::TorqueLoad m_load;
    Reading m_last;
    bool m_isPending = false; // the last reading counts if the next status is at full speed as well
    QList<Reading> m_readings;
};

} // namespace campanel::panel
