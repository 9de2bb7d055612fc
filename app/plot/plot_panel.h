// SPDX-License-Identifier: Apache-2.0
// One panel of a curve plot: a quantity over time with its own value scale, its geometry and painting. Owned
// and controlled by CurvePlot.
#pragma once

#include "app/plot/picture/value_axis.h"
#include "app/plot/quantity.h"

#include <QPointF>
#include <QPolygonF>

#include <limits>

class QPainter;

namespace campanel::plot {

// The style of an anti-aliased line through the points, clipped to `clip`.
struct LineStyle {
    QColor color;
    double width = 1; // px
    Qt::PenStyle pen = Qt::SolidLine;
};
void paintLine(QPainter& painter, const QPolygonF& points, const LineStyle& style, const QwtScaleMap& xMap,
               const QwtScaleMap& yMap);

class PlotPanel {
public:
    explicit PlotPanel(Quantity quantity)
        : m_quantity(quantity)
    {
    }

    [[nodiscard]] Quantity quantity() const { return m_quantity; }
    [[nodiscard]] const ValueAxis& axis() const { return m_axis; }

    // Sets the data; keeps the scale of the panel if possible. The limit is in the displayed unit, NaN for
    // none.
    void setData(const CurveSet& curves, const CurveSet& overlay, double limit);
    // The shown unit of the axis is the panel's times this factor.
    void setFactor(double factor) { m_axis.scale().setFactor(factor); }
    void setCanvas(const QRectF& canvas) { m_axis.setCanvas(canvas); }

    // Returns true if the curve exceeds the limit between the two times.
    [[nodiscard]] bool isBroken(double fromS, double toS) const;

    void paintGrid(QPainter& painter, const PlotStyle& style) const;
    void paintTint(QPainter& painter, const QColor& color, double fromX, double toX) const;
    void paintCurves(QPainter& painter, const PlotStyle& style, const QColor& color,
                     const QwtScaleMap& timeMap) const;

private:
    void fitScale();

    Quantity m_quantity;
    QPolygonF m_curve;
    QPolygonF m_overlay;
    double m_limit = std::numeric_limits<double>::quiet_NaN();
    ValueAxis m_axis;
};

} // namespace campanel::plot
