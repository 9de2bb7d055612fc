// SPDX-License-Identifier: Apache-2.0
// Groups of what the editor shows, as values for QML.
#pragma once

#include "app/panel/editor/cam_files.h"
#include "app/panel/editor/cutter_map.h"
#include "app/panel/editor/editor_field.h"
#include "app/panel/editor/knot_model.h"
#include "app/panel/editor/ramp_control.h"
#include "app/panel/editor/segment_model.h"
#include "app/panel/kit/numbers.h"

#include <QList>
#include <QObject>
#include <QPointF>
#include <QVariant>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

// `Editor.cutter` in QML: the ratios of a rotary cutter and its regime map.
struct CutterParts {
    Q_GADGET
    QML_VALUE_TYPE(cutterParts)
    Q_PROPERTY(campanel::panel::RampControl* ramps MEMBER ramps CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::CutterMap* map MEMBER map CONSTANT FINAL)

public:
    RampControl* ramps = nullptr;
    CutterMap* map = nullptr;
};

// `Editor.cam` in QML: the knots of a point cam, the segments of a segment cam, and the files
// of either.
struct CamLists {
    Q_GADGET
    QML_VALUE_TYPE(camLists)
    Q_PROPERTY(campanel::panel::KnotModel* knots MEMBER knots CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::CamFiles* files MEMBER files CONSTANT FINAL)
    Q_PROPERTY(campanel::panel::SegmentModel* segments MEMBER segments CONSTANT FINAL)

public:
    KnotModel* knots = nullptr;
    CamFiles* files = nullptr;
    SegmentModel* segments = nullptr;
};

// `Editor.plot` in QML: the curves of the edited recipe and what is drawn with them. Times in s.
struct EditorPlot {
    Q_GADGET
    QML_VALUE_TYPE(editorPlot)
    Q_PROPERTY(QVariant curves MEMBER curves FINAL)
    Q_PROPERTY(double cycleSeconds MEMBER cycleSeconds FINAL)
    Q_PROPERTY(QList<double> ratioTimes MEMBER ratioTimes FINAL)
    Q_PROPERTY(QList<double> markTimes MEMBER markTimes FINAL)
    Q_PROPERTY(double limitVelocity MEMBER limitVelocity FINAL)
    Q_PROPERTY(double limitAcceleration MEMBER limitAcceleration FINAL)
    Q_PROPERTY(double limitFrequency MEMBER limitFrequency FINAL)
    Q_PROPERTY(bool hasTorque MEMBER hasTorque FINAL)
    Q_PROPERTY(double limitTorque MEMBER limitTorque FINAL)
    Q_PROPERTY(double rmsTorque MEMBER rmsTorque FINAL)
    Q_PROPERTY(QList<QPointF> violations MEMBER violations FINAL)
    Q_PROPERTY(QString peakText MEMBER peakText FINAL)

public:
    QVariant curves;
    double cycleSeconds = 0;
    QList<double> ratioTimes; // of a rotary cutter, else empty
    QList<double> markTimes;
    double limitVelocity = 0;     // mm/s
    double limitAcceleration = 0; // mm/s^2
    double limitFrequency = 0;    // Hz
    bool hasTorque = false;       // the inertia is known
    double limitTorque = unknown; // Nm
    double rmsTorque = unknown;   // Nm
    QList<QPointF> violations;    // from and to
    QString peakText;             // the peaks in one line
};

} // namespace campanel::panel
