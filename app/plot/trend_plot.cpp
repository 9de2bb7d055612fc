// SPDX-License-Identifier: Apache-2.0
#include "app/plot/trend_plot.h"

#include "app/plot/time_axis.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <memory>

namespace campanel::plot {

namespace {

constexpr double axisGap = 3;       // px between the canvas and the times below it
constexpr double tickSpacing = 1.5; // minimum distance of ticks in widths of a label
constexpr double rightMargin = 8;

} // namespace

TrendPlot::TrendPlot(QQuickItem* parent)
    : QQuickPaintedItem(parent)
{
    setAcceptTouchEvents(true);
    setAcceptedMouseButtons(Qt::LeftButton);
    connect(this, &TrendPlot::dataChanged, this, &TrendPlot::invalidate);
    connect(this, &TrendPlot::styleChanged, this, &TrendPlot::invalidate);
    connect(this, &TrendPlot::cursorChanged, this, [this] { update(boundingRect().toAlignedRect()); });
    m_holdTimer.setSingleShot(true);
    connect(&m_holdTimer, &QTimer::timeout, this, &TrendPlot::takeHold);
}

void TrendPlot::geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry)
{
    QQuickPaintedItem::geometryChange(newGeometry, oldGeometry);
    if (newGeometry.size() != oldGeometry.size())
        invalidate();
}

void TrendPlot::invalidate()
{
    update(boundingRect().toAlignedRect());
    if (std::exchange(m_isLayoutOld, true))
        return;
    emit layoutChanged();
}

void TrendPlot::ensureLayout()
{
    if (!std::exchange(m_isLayoutOld, false))
        return;
    using Curves = std::shared_ptr<const QList<QList<QPointF>>>;
    const Curves curves = m_curves.value<Curves>();
    m_lanes.resize(static_cast<std::size_t>(std::max(1, m_laneCount)));
    for (std::size_t i = 0; i < m_lanes.size(); ++i) {
        const auto at = static_cast<qsizetype>(i);
        TrendLane::Lines lines;
        if (curves && curves->size() >= 3 * (at + 1))
            lines = {curves->at(3 * at), curves->at(3 * at + 1), curves->at(3 * at + 2)};
        m_lanes[i].setFactor(m_factors.value(at, 1.0));
        m_lanes[i].setData(lines, m_fromMs, m_toMs, at < m_tolerances.size() ? m_tolerances[at] : unknown);
        m_labelWidth = std::max(m_labelWidth, std::ceil(m_lanes[i].axis().labelWidth(style())));
    }
    const double axis = QFontMetricsF(m_axisFont).height() + axisGap;
    m_area = QRectF(m_labelWidth, 0, std::max(1.0, width() - m_labelWidth - rightMargin),
                    std::max(1.0, height() - axis));
    const double each = m_area.height() / static_cast<double>(m_lanes.size());
    for (std::size_t i = 0; i < m_lanes.size(); ++i) {
        const double top = static_cast<double>(i) * each + m_headerHeight;
        m_lanes[i].setCanvas({m_area.left(), std::round(top), m_area.width(),
                              std::max(1.0, std::floor(each - m_headerHeight))});
    }
}

PlotStyle TrendPlot::style() const
{
    PlotStyle style;
    style.grid = m_gridColor;
    style.secondaryInk = m_secondaryInkColor;
    style.limit = m_toleranceColor;
    style.lineWidth = m_lineWidth;
    style.axisFont = m_axisFont;
    style.locale = m_locale;
    return style;
}

QwtScaleMap TrendPlot::timeMap() const
{
    QwtScaleMap map;
    map.setScaleInterval(m_fromMs, m_toMs);
    map.setPaintInterval(m_area.left(), m_area.right());
    return map;
}

QRectF TrendPlot::plotArea()
{
    ensureLayout();
    return m_area;
}

double TrendPlot::laneTop(int lane)
{
    ensureLayout();
    const bool isKnown = lane >= 0 && static_cast<std::size_t>(lane) < m_lanes.size();
    return isKnown ? m_lanes[static_cast<std::size_t>(lane)].axis().canvas().top() - m_headerHeight : 0;
}

double TrendPlot::xOfTime(double timeMs)
{
    ensureLayout();
    return timeMap().transform(timeMs);
}

double TrendPlot::timeOfX(double x)
{
    ensureLayout();
    return timeMap().invTransform(x);
}

QList<double> TrendPlot::valuesAt(int lane, double timeMs)
{
    ensureLayout();
    if (lane < 0 || static_cast<std::size_t>(lane) >= m_lanes.size())
        return {unknown, unknown, unknown};
    const TrendLane::Values values = m_lanes[static_cast<std::size_t>(lane)].valuesAt(timeMs);
    return {values.low, values.mean, values.high};
}

QString TrendPlot::momentText(double timeMs) const
{
    return plot::momentText(timeMs, m_toMs - m_fromMs, m_locale);
}

qsizetype TrendPlot::drawnPoints(int lane)
{
    ensureLayout();
    return m_lanes.at(static_cast<std::size_t>(lane)).drawnPoints();
}

void TrendPlot::paint(QPainter* painter)
{
    if (width() < 1 || height() < 1)
        return;
    ensureLayout();
    paintPicture(*painter);
    paintCursor(*painter);
}

void TrendPlot::paintPicture(QPainter& painter)
{
    paintTimeAxis(painter);
    const QwtScaleMap map = timeMap();
    for (std::size_t i = 0; i < m_lanes.size(); ++i) {
        m_lanes[i].paintGrid(painter, style());
        const auto at = static_cast<qsizetype>(i);
        m_lanes[i].paintCurves(painter, style(), at < m_laneColors.size() ? m_laneColors[at] : m_inkColor,
                               map);
    }
}

void TrendPlot::paintTimeAxis(QPainter& painter) const
{
    const QFontMetricsF metrics(m_axisFont);
    const double widest = metrics.horizontalAdvance(QStringLiteral("00:00:00"));
    const int maxTicks = std::max(2, static_cast<int>(m_area.width() / (tickSpacing * widest)));
    const QwtScaleMap map = timeMap();
    painter.setFont(m_axisFont);
    for (const TimeTick& tick : timeTicks(m_fromMs, m_toMs, maxTicks, m_locale)) {
        const double x = std::round(map.transform(tick.timeMs)) + 0.5;
        painter.setPen(QPen(m_gridColor, 1));
        for (const TrendLane& lane : m_lanes)
            painter.drawLine(QPointF(x, lane.axis().canvas().top()),
                             QPointF(x, lane.axis().canvas().bottom()));
        const double wide = metrics.horizontalAdvance(tick.text) + 1;
        const double left = std::clamp(x - wide / 2, m_area.left(), std::max(m_area.left(), width() - wide));
        painter.setPen(m_secondaryInkColor);
        painter.drawText(QRectF(left, m_area.bottom() + axisGap, wide, metrics.height()), Qt::AlignCenter,
                         tick.text);
    }
}

void TrendPlot::paintCursor(QPainter& painter) const
{
    if (!(m_cursorMs >= m_fromMs && m_cursorMs <= m_toMs))
        return;
    const double x = timeMap().transform(m_cursorMs);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const TrendLane& lane : m_lanes) {
        painter.setPen(QPen(m_inkColor, cursorWidth));
        painter.drawLine(QPointF(x, lane.axis().canvas().top()), QPointF(x, lane.axis().canvas().bottom()));
        const double mean = lane.valuesAt(m_cursorMs).mean;
        if (!std::isfinite(mean))
            continue;
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_inkColor);
        painter.drawEllipse(QPointF(x, lane.axis().map().transform(mean)), dotRadius, dotRadius);
    }
}

} // namespace campanel::plot
