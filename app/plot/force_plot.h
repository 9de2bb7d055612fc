// SPDX-License-Identifier: Apache-2.0
// The force of one press stroke over its position, with its end gate: a position and the forces allowed
// there. Drawn by Qwt into a Qt Quick item.
#pragma once

#include "app/plot/picture/axis_scale.h"

#include <QColor>
#include <QFont>
#include <QList>
#include <QLocale>
#include <QPointF>
#include <QPolygonF>
#include <QQuickPaintedItem>
#include <QRectF>
#include <QtQml/qqmlregistration.h>

#include <qwt_scale_map.h>

#include <limits>

namespace campanel::plot {

class ForcePlot : public QQuickPaintedItem {
    Q_OBJECT
    QML_ELEMENT
    // The curve, x position in mm, y force in N, in order of time; points that are not finite are omitted.
    Q_PROPERTY(QList<QPointF> curve MEMBER m_curve NOTIFY curveChanged FINAL)
    // The start of the axis in mm; earlier points are not visible. NaN: at the first point.
    Q_PROPERTY(double fromPosition MEMBER m_fromPosition NOTIFY marksChanged FINAL)
    // The gate: mm, N and N; NaN for none.
    Q_PROPERTY(double gatePosition MEMBER m_gatePosition NOTIFY marksChanged FINAL)
    Q_PROPERTY(double gateLow MEMBER m_gateLow NOTIFY marksChanged FINAL)
    Q_PROPERTY(double gateHigh MEMBER m_gateHigh NOTIFY marksChanged FINAL)
    Q_PROPERTY(QColor gridColor MEMBER m_gridColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor secondaryInkColor MEMBER m_secondaryInkColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor curveColor MEMBER m_curveColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor gateColor MEMBER m_gateColor NOTIFY styleChanged FINAL)
    Q_PROPERTY(double lineWidth MEMBER m_lineWidth NOTIFY styleChanged FINAL) // px
    Q_PROPERTY(QFont axisFont MEMBER m_axisFont NOTIFY styleChanged FINAL)
    // The unit of the positions' axis, and its factor from mm.
    Q_PROPERTY(QString positionUnit MEMBER m_positionUnit NOTIFY styleChanged FINAL)
    Q_PROPERTY(double positionFactor MEMBER m_positionFactor NOTIFY styleChanged FINAL)
    Q_PROPERTY(QLocale locale MEMBER m_locale NOTIFY styleChanged FINAL)

public:
    explicit ForcePlot(QQuickItem* parent = nullptr);

    void paint(QPainter* painter) override;

    // Return px of the item, as last painted.
    [[nodiscard]] double xOfPosition(double positionMm) const { return m_positionMap.transform(positionMm); }
    [[nodiscard]] double yOfForce(double forceN) const { return m_forceMap.transform(forceN); }

signals:
    void curveChanged();
    void marksChanged();
    void styleChanged();

private:
    static constexpr double none = std::numeric_limits<double>::quiet_NaN();

    void geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry) override;
    void updateAll() { update(boundingRect().toAlignedRect()); }
    [[nodiscard]] QPolygonF finitePoints() const;
    void fitScales(const QPolygonF& points);
    void place();
    void paintAxes(QPainter& painter) const;
    void paintGate(QPainter& painter) const;

    QList<QPointF> m_curve;
    double m_fromPosition = none;
    double m_gatePosition = none;
    double m_gateLow = none;
    double m_gateHigh = none;
    QColor m_gridColor{Qt::lightGray};
    QColor m_secondaryInkColor{Qt::darkGray};
    QColor m_curveColor{Qt::blue};
    QColor m_gateColor{Qt::darkYellow};
    double m_lineWidth = 3;
    QFont m_axisFont;
    QString m_positionUnit = QStringLiteral("mm");
    double m_positionFactor = 1;
    QLocale m_locale;

    AxisScale m_positionScale;
    AxisScale m_forceScale;
    QRectF m_canvas;
    QwtScaleMap m_positionMap;
    QwtScaleMap m_forceMap;
};

} // namespace campanel::plot
