// SPDX-License-Identifier: Apache-2.0
// The vertical axis of one panel of a plot: its scale, its place on the screen, grid, labels and limit lines.
#pragma once

#include "app/plot/picture/axis_scale.h"
#include "app/plot/picture/plot_style.h"

#include <QRectF>

#include <qwt_scale_map.h>

class QPainter;

namespace campanel::plot {

class ValueAxis {
public:
    [[nodiscard]] AxisScale& scale() { return m_scale; }
    [[nodiscard]] const AxisScale& scale() const { return m_scale; }
    [[nodiscard]] const QRectF& canvas() const { return m_canvas; }
    [[nodiscard]] const QwtScaleMap& map() const { return m_map; }

    // Places the axis; call it after each change of the scale.
    void setCanvas(const QRectF& canvas);
    // Returns the width of the tick labels left of the canvas, in px.
    [[nodiscard]] double labelWidth(const PlotStyle& style) const;

    void paintGrid(QPainter& painter, const PlotStyle& style) const;
    void paintLabels(QPainter& painter, const PlotStyle& style) const;
    // Paints a dashed line at a limit inside the scale, with its label at the right end.
    void paintLimit(QPainter& painter, const PlotStyle& style, double value, const QString& label = {}) const;

private:
    // Returns the ticks with a number: in a low panel only those at the ends, so that they do not overlap.
    [[nodiscard]] QwtScaleDiv labelDivision(const PlotStyle& style) const;

    AxisScale m_scale;
    QRectF m_canvas;
    QwtScaleMap m_map;
};

} // namespace campanel::plot
