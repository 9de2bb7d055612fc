// SPDX-License-Identifier: Apache-2.0
// The shapes of recipes, laws and motions of segments, computed from the curves themselves, for small
// pictures.
#pragma once

#include "app/program/recipe.h"
#include "profile/model/law.h"
#include "profile/segments/segment_cam.h"

#include <QList>
#include <QObject>
#include <QPointF>
#include <QString>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

// Points with x and y from 0 to 1, y upwards; empty without a curve.
using CurveShape = QList<QPointF>;

// A choice with its picture.
struct ShapedName {
    Q_GADGET
    QML_VALUE_TYPE(shapedName)
    Q_PROPERTY(QString name MEMBER name FINAL)
    Q_PROPERTY(QList<QPointF> shape MEMBER shape FINAL)

public:
    QString name;
    CurveShape shape;
};

// Returns the position over a cycle that ends where it began, and over a position move with its rests; of any
// other one the speed.
[[nodiscard]] CurveShape shapeOf(const program::Recipe& recipe);
// Returns the slope of the law: the speed of a displacement law, the acceleration of a speed law.
[[nodiscard]] CurveShape shapeOf(const profile::Law& law);
// Returns the position over the segment, from its lower to its upper end.
[[nodiscard]] CurveShape shapeOf(const profile::SegmentMotionInfo& motion);

} // namespace campanel::panel
