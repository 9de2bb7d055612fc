// SPDX-License-Identifier: Apache-2.0
#include "app/plot/picture/value_axis.h"

#include "app/plot/picture/label_draw.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPalette>

#include <qwt_plot_grid.h>

#include <algorithm>
#include <cmath>

namespace campanel::plot {

namespace {

constexpr double limitLabelMargin = 6; // px between a limit's line and its label

} // namespace

void ValueAxis::setCanvas(const QRectF& canvas)
{
    m_canvas = canvas;
    m_map.setScaleInterval(m_scale.lower(), m_scale.upper());
    m_map.setPaintInterval(canvas.bottom(), canvas.top());
}

double ValueAxis::labelWidth(const PlotStyle& style) const
{
    const LabelDraw labels(QwtScaleDraw::LeftScale, style.locale, m_scale, style.labelGap);
    return labels.extent(style.axisFont);
}

// Digits have no descenders: their height is the ascent.
QwtScaleDiv ValueAxis::labelDivision(const PlotStyle& style) const
{
    QwtScaleDiv division = m_scale.division();
    const QList<double> ticks = division.ticks(QwtScaleDiv::MajorTick);
    const double room = m_canvas.height() / std::max<double>(1, static_cast<double>(ticks.size() - 1));
    if (ticks.size() > 2 && room < QFontMetricsF(style.axisFont).ascent())
        division.setTicks(QwtScaleDiv::MajorTick, {ticks.first(), ticks.last()});
    return division;
}

void ValueAxis::paintGrid(QPainter& painter, const PlotStyle& style) const
{
    QwtPlotGrid grid;
    grid.enableX(false);
    grid.setMajorPen(QPen(style.grid, 1));
    grid.setYDiv(m_scale.division());
    // QwtPlotGrid omits a line on the lowest row of pixels.
    grid.draw(&painter, QwtScaleMap(), m_map, m_canvas.adjusted(0, 0, 0, 1));
}

void ValueAxis::paintLabels(QPainter& painter, const PlotStyle& style) const
{
    LabelDraw labels(QwtScaleDraw::LeftScale, style.locale, m_scale, style.labelGap);
    labels.setScaleDiv(labelDivision(style));
    labels.move(m_canvas.topLeft());
    labels.setLength(m_canvas.height());
    QPalette palette;
    palette.setColor(QPalette::Text, style.secondaryInk);
    painter.setFont(style.axisFont);
    labels.draw(&painter, palette);
}

void ValueAxis::paintLimit(QPainter& painter, const PlotStyle& style, double value,
                           const QString& label) const
{
    if (!(value >= m_scale.lower() && value <= m_scale.upper()))
        return;
    // The line is between two rows of pixels and two wide, so that the upper and the lower limit look the
    // same.
    const double y = std::round(m_map.transform(value));
    QPen pen(style.limit, 2);
    pen.setDashPattern({4, 3});
    pen.setCapStyle(Qt::FlatCap);
    painter.setPen(pen);
    painter.drawLine(QPointF(m_canvas.left(), y), QPointF(m_canvas.right(), y));
    if (label.isEmpty())
        return;
    const QFontMetricsF metrics(style.axisFont);
    const double width = metrics.horizontalAdvance(label) + limitLabelMargin;
    const QRectF place(m_canvas.right() - width, y - metrics.height() / 2, width, metrics.height());
    painter.fillRect(place, style.surface);
    painter.setFont(style.axisFont);
    painter.drawText(place, Qt::AlignRight | Qt::AlignVCenter, label);
}

} // namespace campanel::plot
