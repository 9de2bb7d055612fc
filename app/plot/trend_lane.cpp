// SPDX-License-Identifier: Apache-2.0
#include "app/plot/trend_lane.h"

#include "app/plot/plot_panel.h"

#include <QPainter>

#include <qwt_plot_intervalcurve.h>

#include <algorithm>
#include <cmath>

namespace campanel::plot {

namespace {

constexpr double bandOpacity = 0.28;
constexpr double flattest = 0.002;    // a smaller scale would display the jitter of the last digit
constexpr double nearTolerance = 1.0; // share of the data's span up to which a tolerance line is visible

QPolygonF cut(const QPolygonF& points, qsizetype begin, qsizetype end)
{
    return points.mid(begin, end - begin);
}

// Returns the limits of the sections [begin, end) without a gap.
QList<std::pair<qsizetype, qsizetype>> stretches(const QPolygonF& points)
{
    QList<std::pair<qsizetype, qsizetype>> found;
    qsizetype begin = 0;
    for (qsizetype i = 0; i <= points.size(); ++i) {
        if (i < points.size() && std::isfinite(points[i].y()))
            continue;
        if (i > begin)
            found << std::pair(begin, i);
        begin = i + 1;
    }
    return found;
}

} // namespace

void TrendLane::setData(const Lines& lines, double fromMs, double toMs, double tolerance)
{
    m_tolerance = tolerance;
    const auto before = std::ranges::lower_bound(lines.means, fromMs, {}, &QPointF::x) - lines.means.begin();
    const auto after = std::ranges::upper_bound(lines.means, toMs, {}, &QPointF::x) - lines.means.begin();
    const qsizetype begin = std::max<qsizetype>(0, before - 1);
    const qsizetype end = std::min<qsizetype>(lines.means.size(), after + 1);
    m_shown = {cut(lines.means, begin, end), cut(lines.lows, begin, end), cut(lines.highs, begin, end)};
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (qsizetype i = 0; i < m_shown.means.size(); ++i) {
        if (!std::isfinite(m_shown.means[i].y()))
            continue;
        low = std::min(low, m_shown.lows[i].y());
        high = std::max(high, m_shown.highs[i].y());
    }
    if (low > high) {
        m_axis.scale().reset();
        (void)m_axis.scale().fit(m_tolerance > 0 ? -m_tolerance : 0, m_tolerance > 0 ? m_tolerance : 1, 0);
        return;
    }
    const double near = std::max(nearTolerance * (high - low), m_tolerance);
    if (m_tolerance < high + near)
        high = std::max(high, m_tolerance);
    if (-m_tolerance > low - near)
        low = std::min(low, -m_tolerance);
    (void)m_axis.scale().fit(low, high, flattest);
}

TrendLane::Values TrendLane::valuesAt(double timeMs) const
{
    const QPolygonF& means = m_shown.means;
    auto right = std::ranges::lower_bound(means, timeMs, {}, &QPointF::x) - means.begin();
    if (means.isEmpty() || !std::isfinite(timeMs))
        return {};
    right = std::min<qsizetype>(right, means.size() - 1);
    const qsizetype left = std::max<qsizetype>(0, right - 1);
    const qsizetype nearest = timeMs - means[left].x() < means[right].x() - timeMs ? left : right;
    return {m_shown.lows[nearest].y(), means[nearest].y(), m_shown.highs[nearest].y()};
}

void TrendLane::paintGrid(QPainter& painter, const PlotStyle& style) const
{
    m_axis.paintGrid(painter, style);
    if (m_shown.means.isEmpty())
        return; // nothing is known, so no numbers
    m_axis.paintLabels(painter, style);
    for (const double value : {m_tolerance, -m_tolerance})
        m_axis.paintLimit(painter, style, value);
}

void TrendLane::paintCurves(QPainter& painter, const PlotStyle& style, const QColor& color,
                            const QwtScaleMap& timeMap) const
{
    QColor tint = color;
    tint.setAlphaF(static_cast<float>(bandOpacity));
    painter.save();
    painter.setClipRect(m_axis.canvas().adjusted(0, -style.lineWidth, 0, style.lineWidth));
    painter.setRenderHint(QPainter::Antialiasing);
    for (const auto& [begin, end] : stretches(m_shown.means)) {
        if (end - begin == 1) { // a single point has no line
            const double x = timeMap.transform(m_shown.means[begin].x());
            painter.setPen(QPen(color, 2 * style.lineWidth, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(QPointF(x, m_axis.map().transform(m_shown.lows[begin].y())),
                             QPointF(x, m_axis.map().transform(m_shown.highs[begin].y())));
            continue;
        }
        QList<QwtIntervalSample> samples;
        for (qsizetype i = begin; i < end; ++i)
            samples << QwtIntervalSample(m_shown.means[i].x(), m_shown.lows[i].y(), m_shown.highs[i].y());
        QwtPlotIntervalCurve band;
        band.setStyle(QwtPlotIntervalCurve::Tube);
        band.setPen(QPen(Qt::NoPen));
        band.setBrush(tint);
        band.setSamples(samples);
        band.draw(&painter, timeMap, m_axis.map(), m_axis.canvas());
        paintLine(painter, cut(m_shown.means, begin, end), {color, style.lineWidth}, timeMap, m_axis.map());
    }
    painter.restore();
}

} // namespace campanel::plot
