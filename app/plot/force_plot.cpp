// SPDX-License-Identifier: Apache-2.0
#include "app/plot/force_plot.h"

#include "app/plot/picture/label_draw.h"
#include "app/plot/picture/plot_style.h"
#include "app/plot/plot_panel.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPalette>

#include <qwt_painter.h>
#include <qwt_plot_grid.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace campanel::plot {

namespace {

constexpr double gateArm = 9;        // px of the gate's ends in each direction
constexpr double gateWidth = 2.5;    // px
constexpr double gateHeadroom = 1.1; // above the gate
// The smallest distance and force that do not count as constant.
constexpr double minimumWayMm = 0.1;
constexpr double minimumForceN = 10.0;
constexpr double emptyWayMm = 1.0; // the axis of an empty plot

} // namespace

ForcePlot::ForcePlot(QQuickItem* parent)
    : QQuickPaintedItem(parent)
{
    QwtPainter::setRoundingAlignment(false);
    m_axisFont.setPixelSize(13);
    for (const auto signal : {&ForcePlot::curveChanged, &ForcePlot::marksChanged, &ForcePlot::styleChanged})
        connect(this, signal, this, &ForcePlot::updateAll);
}

void ForcePlot::geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry)
{
    QQuickPaintedItem::geometryChange(newGeometry, oldGeometry);
    updateAll();
}

QPolygonF ForcePlot::finitePoints() const
{
    QPolygonF points;
    std::ranges::copy_if(m_curve, std::back_inserter(points), [](const QPointF& point) {
        return std::isfinite(point.x()) && std::isfinite(point.y());
    });
    return points;
}

void ForcePlot::fitScales(const QPolygonF& points)
{
    const bool hasGate = std::isfinite(m_gatePosition);
    double from = m_fromPosition;
    if (!std::isfinite(from))
        from = points.isEmpty() ? (hasGate ? m_gatePosition - emptyWayMm : 0) : points.first().x();
    double to = hasGate ? m_gatePosition : from + emptyWayMm;
    double maxForceN = std::isfinite(m_gateHigh) ? m_gateHigh * gateHeadroom : minimumForceN;
    for (const QPointF& point : points) {
        to = std::max(to, point.x());
        maxForceN = std::max(maxForceN, point.y());
    }
    m_positionScale.setFactor(m_positionFactor);
    m_positionScale.fit(std::min(from, to), to, minimumWayMm);
    m_forceScale.fit(0, maxForceN, minimumForceN);
}

void ForcePlot::place()
{
    const QFontMetricsF metrics(m_axisFont);
    LabelDraw forces(QwtScaleDraw::LeftScale, m_locale, m_forceScale);
    const double left = std::ceil(forces.extent(m_axisFont));
    const double top = std::ceil(metrics.height() / 2);
    const double bottom = std::ceil(metrics.height() + labelGap);
    const double right = std::ceil(metrics.horizontalAdvance(QStringLiteral("0000 ") + m_positionUnit) / 2);
    m_canvas =
        QRectF(left, top, std::max(1.0, width() - left - right), std::max(1.0, height() - top - bottom));
    m_positionMap.setScaleInterval(m_positionScale.lower(), m_positionScale.upper());
    m_positionMap.setPaintInterval(m_canvas.left(), m_canvas.right());
    m_forceMap.setScaleInterval(m_forceScale.lower(), m_forceScale.upper());
    m_forceMap.setPaintInterval(m_canvas.bottom(), m_canvas.top());
}

void ForcePlot::paint(QPainter* painter)
{
    if (boundingRect().isEmpty())
        return;
    const QPolygonF points = finitePoints();
    fitScales(points);
    place();
    paintAxes(*painter);
    paintGate(*painter);
    painter->save();
    const double margin = m_lineWidth;
    painter->setClipRect(m_canvas.adjusted(0, -margin, margin, margin), Qt::IntersectClip);
    paintLine(*painter, points, {m_curveColor, m_lineWidth}, m_positionMap, m_forceMap);
    painter->restore();
}

void ForcePlot::paintAxes(QPainter& painter) const
{
    QwtPlotGrid grid;
    grid.enableX(false);
    grid.setMajorPen(QPen(m_gridColor, 1));
    grid.setYDiv(m_forceScale.division());
    // QwtPlotGrid omits a line on the lowest row of pixels.
    grid.draw(&painter, QwtScaleMap(), m_forceMap, m_canvas.adjusted(0, 0, 0, 1));

    QPalette palette;
    palette.setColor(QPalette::Text, m_secondaryInkColor);
    painter.setFont(m_axisFont);
    LabelDraw forces(QwtScaleDraw::LeftScale, m_locale, m_forceScale);
    forces.move(m_canvas.topLeft());
    forces.setLength(m_canvas.height());
    forces.draw(&painter, palette);

    LabelDraw positions(QwtScaleDraw::BottomScale, m_locale, m_positionScale);
    const QList<double> ticks = m_positionScale.division().ticks(QwtScaleDiv::MajorTick);
    if (!ticks.isEmpty())
        positions.setSpecialLabel(
            ticks.last(), localNumber(m_locale, ticks.last() * m_positionFactor, m_positionScale.decimals()) +
                              u' ' + m_positionUnit);
    positions.move(m_canvas.bottomLeft());
    positions.setLength(m_canvas.width());
    positions.draw(&painter, palette);
}

// Paints a vertical bar from the minimum to the maximum force at the stop, with arms; without them the
// position alone.
void ForcePlot::paintGate(QPainter& painter) const
{
    if (!std::isfinite(m_gatePosition))
        return;
    const double x = m_positionMap.transform(m_gatePosition);
    painter.save();
    QPen line(m_gateColor, 1, Qt::CustomDashLine, Qt::FlatCap);
    line.setDashPattern({3, 4});
    painter.setPen(line);
    painter.drawLine(QPointF(x, m_canvas.top()), QPointF(x, m_canvas.bottom()));
    if (std::isfinite(m_gateLow) && std::isfinite(m_gateHigh)) {
        const double low = m_forceMap.transform(m_gateLow);
        const double high = m_forceMap.transform(m_gateHigh);
        painter.setPen(QPen(m_gateColor, gateWidth, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(QPointF(x, low), QPointF(x, high));
        for (const double y : {low, high})
            painter.drawLine(QPointF(x - gateArm, y), QPointF(x + gateArm, y));
    }
    painter.restore();
}

} // namespace campanel::plot
