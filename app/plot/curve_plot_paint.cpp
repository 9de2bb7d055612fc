// SPDX-License-Identifier: Apache-2.0
// The painting of CurvePlot. It runs while the GUI thread waits, so it may read all members.
#include "app/plot/curve_plot.h"

#include "app/plot/decimation.h"
#include "app/plot/picture/label_draw.h"

#include <QPainter>
#include <QPalette>

#include <algorithm>
#include <cmath>

namespace campanel::plot {

namespace {

constexpr double dotHalo = 1.5; // px of surface around a dot
constexpr int timeDigits = 3;   // of the cycle time at the end of the axis

} // namespace

void CurvePlot::paint(QPainter* painter)
{
    ensureLayout();
    const double pixelRatio = painter->deviceTransform().m11();
    const QSize pixels = (boundingRect().size() * pixelRatio).toSize();
    if (pixels.isEmpty()) {
        return;
    }
    if (!m_imageValid || m_image.size() != pixels) {
        m_image = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
        m_image.setDevicePixelRatio(pixelRatio);
        paintImage();
    }
    painter->drawImage(QPointF(0, 0), m_image);
    paintTrace(*painter);
    paintCursor(*painter);
}

void CurvePlot::paintImage()
{
    m_image.fill(Qt::transparent);
    QPainter painter(&m_image);
    paintStatic(painter);
    m_imageValid = true;
    ++m_staticPaintCount;
}

void CurvePlot::print(QPainter& painter)
{
    ensureLayout();
    paintStatic(painter);
}

void CurvePlot::paintStatic(QPainter& painter) const
{
    const PlotStyle plotStyle = style();
    paintTints(painter);
    for (const PlotPanel& panel : m_panels) {
        panel.paintGrid(painter, plotStyle);
    }
    paintMarkers(painter);
    for (const PlotPanel& panel : m_panels) {
        panel.paintCurves(painter, plotStyle, colorOf(panel.quantity()), m_timeMap);
    }
    paintTitles(painter);
    paintTimeLabels(painter, plotStyle);
}

void CurvePlot::paintTints(QPainter& painter) const
{
    for (const QPointF& stretch : m_violations) {
        const double fromX = m_timeMap.transform(stretch.x());
        const double toX = m_timeMap.transform(stretch.y());
        // Without a panel for the exceeded limit, all panels mark the time.
        const bool shown = std::ranges::any_of(
            m_panels, [&](const PlotPanel& p) { return p.isBroken(stretch.x(), stretch.y()); });
        for (const PlotPanel& panel : m_panels) {
            if (!shown || panel.isBroken(stretch.x(), stretch.y())) {
                panel.paintTint(painter, m_style.violationColor, fromX, toX);
            }
        }
    }
}

void CurvePlot::paintMarkers(QPainter& painter) const
{
    QPen pen(m_style.markerColor, 1, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({3, 4});
    // The lines are interrupted at the titles.
    QRegion free(QRectF(m_plotArea).toAlignedRect());
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        free -= titleRect(i).toAlignedRect();
    }
    painter.save();
    painter.setClipRegion(free);
    painter.setPen(pen);
    for (const double time : m_markerTimes) {
        if (time >= 0 && time <= m_timeMap.s2()) {
            const double x = m_timeMap.transform(time);
            painter.drawLine(QPointF(x, m_plotArea.top()), QPointF(x, m_plotArea.bottom()));
        }
    }
    painter.restore();
}

QRectF CurvePlot::titleRect(std::size_t panel) const
{
    if (panel >= static_cast<std::size_t>(m_titles.size())) {
        return {};
    }
    const QFontMetricsF metrics(m_style.titleFont);
    const QRectF canvas = m_panels[panel].axis().canvas();
    const double width = metrics.horizontalAdvance(m_titles[static_cast<qsizetype>(panel)]);
    return {canvas.left() + titleGap, canvas.top() - titleGap - metrics.height(), width, metrics.height()};
}

void CurvePlot::paintTitles(QPainter& painter) const
{
    painter.setFont(m_style.titleFont);
    painter.setPen(m_style.secondaryInkColor);
    const auto count = std::min(static_cast<std::size_t>(m_titles.size()), m_panels.size());
    for (std::size_t i = 0; i < count; ++i) {
        painter.drawText(titleRect(i), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip,
                         m_titles[static_cast<qsizetype>(i)]);
    }
}

void CurvePlot::paintTimeLabels(QPainter& painter, const PlotStyle& plotStyle) const
{
    if (!m_curveSet && !m_overlaySet && std::isnan(m_timeMaximum)) {
        return;
    }
    const QList<double> ticks = m_timeDivision.ticks(QwtScaleDiv::MajorTick);
    const double step = ticks.size() < 3 ? 0.0 : ticks[1] - ticks[0];
    LabelDraw labels(QwtScaleDraw::BottomScale, m_style.locale, decimalsOfStep(step));
    const double end = m_timeMap.s2();
    labels.setScaleDiv(m_timeDivision);
    labels.setSpecialLabel(end,
                           m_style.locale.toString(end, 'G', timeDigits) + QLatin1Char(' ') + m_timeUnit);
    labels.move(m_plotArea.bottomLeft());
    labels.setLength(m_plotArea.width());
    QPalette palette;
    palette.setColor(QPalette::Text, plotStyle.secondaryInk);
    painter.setFont(plotStyle.axisFont);
    labels.draw(&painter, palette);
}

void CurvePlot::paintTrace(QPainter& painter) const
{
    const PlotPanel* panel = velocityPanel();
    if (!panel || m_trace.isEmpty()) {
        return;
    }
    std::vector<double> times;
    std::vector<double> speeds;
    times.reserve(static_cast<std::size_t>(m_trace.size()));
    speeds.reserve(static_cast<std::size_t>(m_trace.size()));
    for (const QPointF& point : m_trace) {
        times.push_back(point.x());
        speeds.push_back(point.y());
    }
    const double margin = m_style.traceLineWidth;
    painter.save();
    painter.setClipRect(panel->axis().canvas().adjusted(0, -margin, 0, margin), Qt::IntersectClip);
    paintLine(painter, decimate(times, speeds, maximumDrawnPoints),
              {m_style.traceColor, m_style.traceLineWidth}, m_timeMap, panel->axis().map());
    painter.restore();
}

void CurvePlot::paintCursor(QPainter& painter) const
{
    if (!(m_cursorTime >= 0 && m_cursorTime <= m_timeMap.s2())) {
        return;
    }
    const double x = m_timeMap.transform(m_cursorTime);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(m_style.inkColor, cursorWidth, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(x, m_plotArea.top()), QPointF(x, m_plotArea.bottom()));
    if (m_cursorDotsVisible) {
        painter.setPen(QPen(m_style.surfaceColor, dotHalo));
        for (const PlotPanel& panel : m_panels) {
            const double value = valueAt(m_curveSet, panel.quantity(), m_cursorTime);
            if (!std::isnan(value)) {
                painter.setBrush(colorOf(panel.quantity()));
                painter.drawEllipse(QPointF(x, panel.axis().map().transform(value)), dotRadius, dotRadius);
            }
        }
    }
    painter.restore();
}

PlotStyle CurvePlot::style() const
{
    PlotStyle plotStyle;
    plotStyle.grid = m_style.gridColor;
    plotStyle.surface = m_style.surfaceColor;
    plotStyle.secondaryInk = m_style.secondaryInkColor;
    plotStyle.overlay = m_style.overlayColor;
    plotStyle.limit = m_style.limitColor;
    plotStyle.violation = m_style.violationColor;
    plotStyle.lineWidth = m_style.lineWidth;
    plotStyle.overlayLineWidth = m_style.overlayLineWidth;
    plotStyle.axisFont = m_style.axisFont;
    plotStyle.locale = m_style.locale;
    plotStyle.labelGap = m_style.labelGap;
    plotStyle.limitLabel = m_limitLabel;
    return plotStyle;
}

QColor CurvePlot::colorOf(Quantity quantity) const
{
    switch (quantity) {
    case Quantity::Position:
        return m_style.positionColor;
    case Quantity::Velocity:
        return m_style.velocityColor;
    case Quantity::Acceleration:
        return m_style.accelerationColor;
    case Quantity::Jerk:
        return m_style.jerkColor;
    case Quantity::Frequency:
        return m_style.frequencyColor;
    case Quantity::Torque:
        return m_style.torqueColor;
    }
    return m_style.inkColor;
}

} // namespace campanel::plot
