// SPDX-License-Identifier: Apache-2.0
// The completed strokes of a press, newest first, and the force over the position of the present stroke.
#pragma once

#include "app/link/link_values.h"

#include <QAbstractListModel>
#include <QPointF>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace campanel::panel {

class StrokeModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("Strokes belong to the Machine")
    Q_PROPERTY(int count READ count NOTIFY changed FINAL)
    Q_PROPERTY(int goodCount READ goodCount NOTIFY changed FINAL)
    // The newest stroke in order of time: x position in mm, y force in N.
    Q_PROPERTY(QList<QPointF> forceCurve READ forceCurve NOTIFY curveChanged FINAL)

public:
    enum Role {
        NumberRole = Qt::UserRole + 1,
        ResultTextRole,
        GoodRole,
        StopErrorTextRole,
        StopForceTextRole,
        PeakForceTextRole
    };

    static constexpr int mostStrokes = 200;
    static constexpr int mostPoints = 1000;

    using QAbstractListModel::QAbstractListModel;

    // Adds one status of a press; pulsesPerMm is that of its program.
    void note(const modbus::StatusBlock& status, double pulsesPerMm);
    void clear();
    // Updates the texts after a change of the language.
    void retranslate();

    [[nodiscard]] int count() const { return static_cast<int>(m_strokes.size()); }
    [[nodiscard]] int goodCount() const;
    [[nodiscard]] const QList<QPointF>& forceCurve() const { return m_forceCurve; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QHash<int, QByteArray> roleNames() const override;

signals:
    void changed();
    void curveChanged();

private:
    struct Stroke {
        std::uint32_t number = 0;
        modbus::PressStatus status;
        double pulsesPerMm = 1;
    };

    void noteCurve(const modbus::StatusBlock& status, double pulsesPerMm);

    QList<Stroke> m_strokes; // newest first
    std::optional<std::uint32_t> m_cycleCount;
    QList<QPointF> m_forceCurve;
    bool m_isInStroke = false;
};

} // namespace campanel::panel
