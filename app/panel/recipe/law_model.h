// SPDX-License-Identifier: Apache-2.0
// The speed laws with their demands on the machine for the recipe being edited.
#pragma once

#include "app/panel/kit/row_model.h"
#include "app/panel/recipe/curve_shape.h"

#include <QString>

namespace campanel::panel {

struct LawRow {
    Q_GADGET
    Q_PROPERTY(QString lawId MEMBER lawId)
    Q_PROPERTY(QString name MEMBER name)
    Q_PROPERTY(QList<QPointF> shape MEMBER shape)
    Q_PROPERTY(QString strength MEMBER strength)
    Q_PROPERTY(QString weakness MEMBER weakness)
    Q_PROPERTY(QString peakRpmText MEMBER peakRpmText)
    Q_PROPERTY(QString peakAccelerationText MEMBER peakAccelerationText)
    Q_PROPERTY(QString rmsText MEMBER rmsText)
    Q_PROPERTY(QString peakFrequencyText MEMBER peakFrequencyText)
    Q_PROPERTY(QString peakJerkText MEMBER peakJerkText)
    Q_PROPERTY(QString vibrationText MEMBER vibrationText)
    Q_PROPERTY(bool current MEMBER current)
    Q_PROPERTY(bool usable MEMBER usable)
    Q_PROPERTY(bool compared MEMBER compared)

public:
    QString lawId;
    QString name;
    CurveShape shape;
    QString strength; // one sentence each
    QString weakness;
    QString peakRpmText;
    QString peakAccelerationText;
    QString rmsText;           // RMS acceleration, only of a rotary cutter
    QString peakFrequencyText; // or the torque, where it is known
    QString peakJerkText;
    QString vibrationText; // empty while the natural frequency is unknown
    bool current = false;
    bool usable = false;   // exceeds no limit with this recipe
    bool compared = false; // its curves are in the background

    bool operator==(const LawRow&) const = default;
};

using LawModel = RowModel<LawRow, &LawRow::lawId>;

} // namespace campanel::panel
