// SPDX-License-Identifier: Apache-2.0
// One quantity over the time of day: the mean as a line in the band from the lowest to the highest value,
// with its own value scale and tolerance lines. Owned and controlled by TrendPlot.
#pragma once

#include "app/plot/picture/value_axis.h"

#include <QPolygonF>

#include <limits>

class QPainter;

namespace campanel::plot {

class TrendLane {
public:
    struct Lines {
        QPolygonF means; // x in ms since 1970 UTC; NaN as y: a gap
        QPolygonF lows;  // at the same times
        QPolygonF highs;
    };
    struct Values {
        double low = std::numeric_limits<double>::quiet_NaN();
        double mean = std::numeric_limits<double>::quiet_NaN();
        double high = std::numeric_limits<double>::quiet_NaN();
    };

    // Sets the data. Only points in the window, and one beyond each end, are drawn and used for the scale.
    void setData(const Lines& lines, double fromMs, double toMs, double tolerance);
    // The shown unit of the axis is that of the data times this factor.
    void setFactor(double factor) { m_axis.scale().setFactor(factor); }
    void setCanvas(const QRectF& canvas) { m_axis.setCanvas(canvas); }
    [[nodiscard]] const ValueAxis& axis() const { return m_axis; }
    // Returns the values of the nearest point; NaN in a gap.
    [[nodiscard]] Values valuesAt(double timeMs) const;
    [[nodiscard]] qsizetype drawnPoints() const { return m_shown.means.size(); }

    void paintGrid(QPainter& painter, const PlotStyle& style) const;
    void paintCurves(QPainter& painter, const PlotStyle& style, const QColor& color,
                     const QwtScaleMap& timeMap) const;

private:
    Lines m_shown;
    double m_tolerance = std::numeric_limits<double>::quiet_NaN(); // in both directions from zero
    ValueAxis m_axis;
};

} // namespace campanel::plot
