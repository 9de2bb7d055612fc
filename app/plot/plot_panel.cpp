// SPDX-License-Identifier: Apache-2.0
#include "app/plot/plot_panel.h"

#include "app/plot/decimation.h"

#include <QPainter>

#include <qwt_plot_curve.h>
#include <qwt_weeding_curve_fitter.h>

#include <algorithm>
#include <cmath>

namespace campanel::plot {

namespace {

// The share of the data's span within which a limit is visible.
constexpr double nearLimit = 0.25;
// The opacity of the panel's tint over a span that exceeds a limit.
constexpr double tintOpacity = 0.12;

struct Span {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

// A point that is so near to the line between its neighbors is not drawn: painting costs by the point.
constexpr double invisiblePx = 0.05;

Span spanOf(const QPolygonF& a, const QPolygonF& b)
{
    Span span;
    for (const QPolygonF* points : {&a, &b}) {
        for (const QPointF& point : *points) {
            span.include(point.y());
        }
    }
    return span;
}

} // namespace

void paintLine(QPainter& painter, const QPolygonF& points, const LineStyle& style, const QwtScaleMap& xMap,
               const QwtScaleMap& yMap)
{
    if (points.size() < 2) {
        return;
    }
    QwtPlotCurve curve;
    curve.setSamples(points);
    curve.setPen(QPen(style.color, style.width, style.pen,
                      style.pen == Qt::SolidLine ? Qt::RoundCap : Qt::FlatCap, Qt::BevelJoin));
    curve.setCurveFitter(new QwtWeedingCurveFitter(invisiblePx)); // the curve owns it
    curve.setCurveAttribute(QwtPlotCurve::Fitted);
    const QRectF canvas(QPointF(xMap.p1(), yMap.p2()), QPointF(xMap.p2(), yMap.p1()));
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    curve.draw(&painter, xMap, yMap, canvas);
    painter.restore();
}

void PlotPanel::setData(const CurveSet& curves, const CurveSet& overlay, double limit)
{
    const double factor = displayFactor(m_quantity);
    m_curve = decimate(timesOf(curves), valuesOf(curves, m_quantity), maximumDrawnPoints, factor);
    m_overlay = decimate(timesOf(overlay), valuesOf(overlay, m_quantity), maximumDrawnPoints, factor);
    m_limit = limit;
    fitScale();
}

void PlotPanel::fitScale()
{
    Span span = spanOf(m_curve, m_overlay);
    if (span.low > span.high) {
        m_axis.scale().reset();
        m_axis.scale().fit(0, 1, 0);
        return;
    }
    const double margin = nearLimit * (span.high - span.low);
    // A limit that is exceeded or nearly reached is always visible; a distant one would only flatten the
    // curve.
    if (m_limit < span.high + margin) {
        span.include(m_limit);
    }
    if (-m_limit > span.low - margin) {
        span.include(-m_limit);
    }
    m_axis.scale().fit(span.low, span.high, minimumSpan(m_quantity));
}

bool PlotPanel::isBroken(double fromS, double toS) const
{
    return std::any_of(m_curve.cbegin(), m_curve.cend(), [&](const QPointF& point) {
        return point.x() >= fromS && point.x() <= toS && std::abs(point.y()) > m_limit;
    });
}

void PlotPanel::paintGrid(QPainter& painter, const PlotStyle& style) const
{
    m_axis.paintGrid(painter, style);
    if (m_curve.isEmpty() && m_overlay.isEmpty())
        return; // nothing is known, so no numbers
    m_axis.paintLabels(painter, style);
    m_axis.paintLimit(painter, style, m_limit, style.limitLabel);
    m_axis.paintLimit(painter, style, -m_limit);
}

void PlotPanel::paintTint(QPainter& painter, const QColor& color, double fromX, double toX) const
{
    QColor tint = color;
    tint.setAlphaF(static_cast<float>(tintOpacity));
    const double left = std::max(fromX, m_axis.canvas().left());
    const double right = std::min(toX, m_axis.canvas().right());
    painter.fillRect(QRectF(QPointF(left, m_axis.canvas().top()), QPointF(right, m_axis.canvas().bottom())),
                     tint);
}

void PlotPanel::paintCurves(QPainter& painter, const PlotStyle& style, const QColor& color,
                            const QwtScaleMap& timeMap) const
{
    painter.save();
    const double margin = style.lineWidth;
    const QRectF frame = m_axis.canvas().adjusted(0, -margin, 0, margin);
    painter.setClipRect(frame);
    paintLine(painter, m_overlay, {style.overlay, style.overlayLineWidth, Qt::DashLine}, timeMap,
              m_axis.map());
    paintLine(painter, m_curve, {color, style.lineWidth}, timeMap, m_axis.map());
    // Paints the curve again beyond the limit, clipped to the outside.
    for (const double limit : {m_limit, -m_limit}) {
        const bool upper = limit > 0;
        if (!(limit > m_axis.scale().lower() && limit < m_axis.scale().upper())) {
            continue;
        }
        QRectF beyond = frame;
        if (upper) {
            beyond.setBottom(m_axis.map().transform(limit));
        } else {
            beyond.setTop(m_axis.map().transform(limit));
        }
        painter.setClipRect(beyond);
        paintLine(painter, m_curve, {style.violation, style.lineWidth}, timeMap, m_axis.map());
    }
    painter.restore();
}

} // namespace campanel::plot
