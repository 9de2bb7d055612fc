// SPDX-License-Identifier: Apache-2.0
#include "app/plot/plot_panel.h"

#include "app/plot/decimation.h"
#include "app/plot/picture/label_draw.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPalette>

#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>

#include <algorithm>
#include <cmath>

namespace campanel::plot {

namespace {

// The share of the data's span within which a limit is visible.
constexpr double nearLimit = 0.25;
// The opacity of the panel's tint over a span that exceeds a limit.
constexpr double tintOpacity = 0.12;
constexpr double limitLabelMargin = 6; // px between a limit's line and its label

struct Span {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void include(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

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
    curve.setPen(QPen(style.color, style.width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
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
        m_scale.reset();
        m_scale.fit(0, 1, 0);
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
    m_scale.fit(span.low, span.high, minimumSpan(m_quantity));
}

void PlotPanel::setCanvas(const QRectF& canvas)
{
    m_canvas = canvas;
    m_valueMap.setScaleInterval(m_scale.lower(), m_scale.upper());
    m_valueMap.setPaintInterval(canvas.bottom(), canvas.top());
}

double PlotPanel::labelWidth(const PlotStyle& style) const
{
    LabelDraw labels(QwtScaleDraw::LeftScale, style.locale, decimalsOfStep(m_scale.step()));
    labels.setScaleDiv(m_scale.division());
    return labels.extent(style.axisFont);
}

bool PlotPanel::isBroken(double fromS, double toS) const
{
    return std::any_of(m_curve.cbegin(), m_curve.cend(), [&](const QPointF& point) {
        return point.x() >= fromS && point.x() <= toS && std::abs(point.y()) > m_limit;
    });
}

QwtScaleDiv PlotPanel::labelDivision(const PlotStyle& style) const
{
    QwtScaleDiv division = m_scale.division();
    const QList<double> ticks = division.ticks(QwtScaleDiv::MajorTick);
    const double room = m_canvas.height() / std::max<double>(1, static_cast<double>(ticks.size() - 1));
    if (ticks.size() > 2 && room < QFontMetricsF(style.axisFont).ascent())
        division.setTicks(QwtScaleDiv::MajorTick, {ticks.first(), ticks.last()});
    return division;
}

void PlotPanel::paintGrid(QPainter& painter, const PlotStyle& style) const
{
    QwtPlotGrid grid;
    grid.enableX(false);
    grid.setMajorPen(QPen(style.grid, 1));
    grid.setYDiv(m_scale.division());
    // QwtPlotGrid omits a line on the lowest row of pixels.
    grid.draw(&painter, QwtScaleMap(), m_valueMap, m_canvas.adjusted(0, 0, 0, 1));
    if (m_curve.isEmpty() && m_overlay.isEmpty()) {
        return; // nothing is known, so no numbers
    }

    LabelDraw labels(QwtScaleDraw::LeftScale, style.locale, decimalsOfStep(m_scale.step()));
    labels.setScaleDiv(labelDivision(style));
    labels.move(m_canvas.topLeft());
    labels.setLength(m_canvas.height());
    QPalette palette;
    palette.setColor(QPalette::Text, style.secondaryInk);
    painter.setFont(style.axisFont);
    labels.draw(&painter, palette);

    paintLimit(painter, style, m_limit, style.limitLabel);
    paintLimit(painter, style, -m_limit, QString());
}

void PlotPanel::paintLimit(QPainter& painter, const PlotStyle& style, double value,
                           const QString& label) const
{
    if (!(value >= m_scale.lower() && value <= m_scale.upper())) {
        return;
    }
    // The line is between two rows of pixels and two wide, so that the upper and the lower limit look the
    // same.
    const double y = std::round(m_valueMap.transform(value));
    QPen pen(style.limit, 2);
    pen.setDashPattern({4, 3});
    pen.setCapStyle(Qt::FlatCap);
    painter.setPen(pen);
    painter.drawLine(QPointF(m_canvas.left(), y), QPointF(m_canvas.right(), y));
    if (!label.isEmpty()) {
        const QFontMetricsF metrics(style.axisFont);
        const double width = metrics.horizontalAdvance(label) + limitLabelMargin;
        const QRectF place(m_canvas.right() - width, y - metrics.height() / 2, width, metrics.height());
        painter.fillRect(place, style.surface);
        painter.setFont(style.axisFont);
        painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, label);
    }
}

void PlotPanel::paintTint(QPainter& painter, const QColor& color, double fromX, double toX) const
{
    QColor tint = color;
    tint.setAlphaF(static_cast<float>(tintOpacity));
    const double left = std::max(fromX, m_canvas.left());
    const double right = std::min(toX, m_canvas.right());
    painter.fillRect(QRectF(QPointF(left, m_canvas.top()), QPointF(right, m_canvas.bottom())), tint);
}

void PlotPanel::paintCurves(QPainter& painter, const PlotStyle& style, const QColor& color,
                            const QwtScaleMap& timeMap) const
{
    painter.save();
    const double margin = style.lineWidth;
    const QRectF frame = m_canvas.adjusted(0, -margin, 0, margin);
    painter.setClipRect(frame);
    paintLine(painter, m_overlay, {style.overlay, style.overlayLineWidth}, timeMap, m_valueMap);
    paintLine(painter, m_curve, {color, style.lineWidth}, timeMap, m_valueMap);
    // Paints the curve again beyond the limit, clipped to the outside.
    for (const double limit : {m_limit, -m_limit}) {
        const bool upper = limit > 0;
        if (!(limit > m_scale.lower() && limit < m_scale.upper())) {
            continue;
        }
        QRectF beyond = frame;
        if (upper) {
            beyond.setBottom(m_valueMap.transform(limit));
        } else {
            beyond.setTop(m_valueMap.transform(limit));
        }
        painter.setClipRect(beyond);
        paintLine(painter, m_curve, {style.violation, style.lineWidth}, timeMap, m_valueMap);
    }
    painter.restore();
}

} // namespace campanel::plot
