// SPDX-License-Identifier: Apache-2.0
// The completed strokes of a press, newest first, and the force over the position of the present stroke.
#pragma once

#include "app/link/link_values.h"
#include "app/panel/kit/row_model.h"

#include <QPointF>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

struct StrokeRow {
    Q_GADGET
    Q_PROPERTY(quint32 number MEMBER number)
    Q_PROPERTY(QString resultText READ resultText)
    Q_PROPERTY(bool good READ good)
    Q_PROPERTY(QString stopErrorText READ stopErrorText)
    Q_PROPERTY(QString stopForceText READ stopForceText)

public:
    quint32 number = 0;
    modbus::PressStatus status;
    double pulsesPerMm = 1;

    [[nodiscard]] QString resultText() const;
    [[nodiscard]] bool good() const { return status.result == modbus::StrokeResult::Ok; }
    [[nodiscard]] QString stopErrorText() const;
    [[nodiscard]] QString stopForceText() const;
};

using StrokeRows = RowModel<StrokeRow, &StrokeRow::number>;

class StrokeModel : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Strokes belong to the Controller")
    Q_PROPERTY(campanel::panel::RowModelBase* rows READ rows CONSTANT FINAL)
    Q_PROPERTY(int goodCount READ goodCount NOTIFY changed FINAL)
    // The newest stroke in order of time: x position in mm, y force in N.
    Q_PROPERTY(QList<QPointF> forceCurve READ forceCurve NOTIFY curveChanged FINAL)

public:
    static constexpr int maxStrokes = 200;
    static constexpr int maxPoints = 1000;

    using QObject::QObject;

    // Adds one status of a press; pulsesPerMm is that of its program.
    void note(const modbus::StatusBlock& status, double pulsesPerMm);
    void clear();

    [[nodiscard]] StrokeRows* rows() { return &m_rows; } // newest first
    [[nodiscard]] int goodCount() const;
    [[nodiscard]] const QList<QPointF>& forceCurve() const { return m_forceCurve; }

signals:
    void changed();
    void curveChanged();

private:
    void noteCurve(const modbus::StatusBlock& status, double pulsesPerMm);

    StrokeRows m_rows{this};
    std::optional<std::uint32_t> m_cycleCount;
    std::uint32_t m_before = 0; // strokes before the present program
    QList<QPointF> m_forceCurve;
    bool m_isInStroke = false;
};

} // namespace campanel::panel
