// SPDX-License-Identifier: Apache-2.0
// Reports of the controller as values for QML. NaN, empty or -1 while unknown.
#pragma once

#include "app/panel/kit/numbers.h"

#include <QList>
#include <QObject>
#include <QString>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

// `Controller.live` in QML: the last status. Values in mm and bags need the program that the status names.
struct LiveValues {
    Q_GADGET
    QML_VALUE_TYPE(liveValues)
    Q_PROPERTY(double rateBagsPerMin MEMBER rateBagsPerMin FINAL)
    Q_PROPERTY(double masterAngleDeg MEMBER masterAngleDeg FINAL)
    Q_PROPERTY(double knifeAngleDeg MEMBER knifeAngleDeg FINAL)
    Q_PROPERTY(double knifeSpeedMmPerS MEMBER knifeSpeedMmPerS FINAL)
    Q_PROPERTY(double followingErrorMm MEMBER followingErrorMm FINAL)
    Q_PROPERTY(double pulseFrequencyHz MEMBER pulseFrequencyHz FINAL)
    Q_PROPERTY(double cycleCount MEMBER cycleCount FINAL)
    Q_PROPERTY(double positionMm MEMBER positionMm FINAL)
    // The position as a person reads it: the angle of a knife, which turns one way for ever, else mm.
    Q_PROPERTY(double position MEMBER position FINAL)
    Q_PROPERTY(QString positionUnit MEMBER positionUnit FINAL)
    Q_PROPERTY(double masterSpeedPercent MEMBER masterSpeedPercent FINAL)
    Q_PROPERTY(double sealTimeMs MEMBER sealTimeMs FINAL)
    Q_PROPERTY(double forceN MEMBER forceN FINAL)
    Q_PROPERTY(int stage MEMBER stage FINAL)

public:
    double rateBagsPerMin = unknown;
    double masterAngleDeg = unknown;
    double knifeAngleDeg = unknown;
    double knifeSpeedMmPerS = unknown;
    double followingErrorPulses = unknown;
    double followingErrorMm = unknown;
    double pulseFrequencyHz = unknown;
    double cycleCount = unknown; // of the present program, since power-up
    double positionMm = unknown;
    double position = unknown;
    QString positionUnit = QStringLiteral("mm");
    double masterSpeedPercent = unknown;
    double sealTimeMs = unknown; // of a rotary cutter with jaws, while the master turns
    double forceN = unknown;     // of a press
    int stage = -1;              // of a press: 0 approach .. 4 return, an index into Controller.stageNames
};

// `Controller.bags` in QML: the last bag and the last 60.
struct BagValues {
    Q_GADGET
    QML_VALUE_TYPE(bagValues)
    Q_PROPERTY(double count MEMBER count FINAL)
    Q_PROPERTY(double lengthMm MEMBER lengthMm FINAL)
    Q_PROPERTY(double deviationMm MEMBER deviationMm FINAL)
    Q_PROPERTY(int lengths MEMBER lengths FINAL)
    Q_PROPERTY(double meanMm MEMBER meanMm FINAL)
    Q_PROPERTY(double meanDeviationMm MEMBER meanDeviationMm FINAL)
    Q_PROPERTY(double scatterMm MEMBER scatterMm FINAL)
    Q_PROPERTY(QList<double> series MEMBER series FINAL)
    Q_PROPERTY(int counted MEMBER counted FINAL)
    Q_PROPERTY(int within MEMBER within FINAL)
    Q_PROPERTY(int scrap MEMBER scrap FINAL)
    Q_PROPERTY(bool isScrap MEMBER isScrap FINAL)
    Q_PROPERTY(double toleranceMm MEMBER toleranceMm FINAL)

public:
    double count = unknown; // since power-up
    double lengthMm = unknown;
    double deviationMm = unknown;
    int lengths = 1; // bag lengths in the last bag: more than one after skipped cuts
    double meanMm = unknown;
    double meanDeviationMm = unknown;
    double scatterMm = unknown;
    QList<double> series; // deviations, mm; NaN: bags between them are unknown
    int counted = 0;      // deviations of the series
    int within = 0;       // bags of the series within the tolerance
    int scrap = 0;        // bags left out of the series: start-up scrap, of two programs, at jaws
    bool isScrap = false; // the last bag is one of them
    double toleranceMm = unknown;
};

// `Controller.active` in QML: the program that the controller has.
struct ActiveProgramValues {
    Q_GADGET
    QML_VALUE_TYPE(activeProgramValues)
    Q_PROPERTY(bool isPresent MEMBER isPresent FINAL)
    Q_PROPERTY(int kind MEMBER kind FINAL)
    Q_PROPERTY(bool followsMaster MEMBER followsMaster FINAL)
    Q_PROPERTY(QString name MEMBER name FINAL)
    Q_PROPERTY(double version MEMBER version FINAL)
    Q_PROPERTY(double bagLengthMm MEMBER bagLengthMm FINAL)
    Q_PROPERTY(double rateBagsPerMin MEMBER rateBagsPerMin FINAL)
    Q_PROPERTY(double cycleSeconds MEMBER cycleSeconds FINAL)
    Q_PROPERTY(double syncStartDeg MEMBER syncStartDeg FINAL)
    Q_PROPERTY(double syncEndDeg MEMBER syncEndDeg FINAL)
    Q_PROPERTY(double cutAngleDeg MEMBER cutAngleDeg FINAL)
    Q_PROPERTY(QVariant curves MEMBER curves FINAL)
    Q_PROPERTY(double approachPositionMm MEMBER approachPositionMm FINAL)
    Q_PROPERTY(double pressPositionMm MEMBER pressPositionMm FINAL)
    Q_PROPERTY(double minStopForceN MEMBER minStopForceN FINAL)
    Q_PROPERTY(double maxStopForceN MEMBER maxStopForceN FINAL)

public:
    bool isPresent = false;
    int kind = 0;               // as Editor.kind; 0 without a program
    bool followsMaster = false; // a cam with a virtual master
    QString name;
    double version = unknown;
    double bagLengthMm = unknown;
    double rateBagsPerMin = unknown;
    double cycleSeconds = unknown;
    double syncStartDeg = unknown; // angles of the knife's shaft, as LiveValues::knifeAngleDeg
    double syncEndDeg = unknown;
    double cutAngleDeg = unknown;
    QVariant curves; // as Editor.curves
    // The limits of a press.
    double approachPositionMm = unknown;
    double pressPositionMm = unknown;
    double minStopForceN = unknown;
    double maxStopForceN = unknown;
};

} // namespace campanel::panel
