// SPDX-License-Identifier: Apache-2.0
#include "app/plot/strip_chart.h"

#include "app/plot/picture/label_draw.h"
#include "app/plot/plot_panel.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>

#include <qwt_plot_curve.h>
#include <qwt_scale_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace campanel::plot {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double laneHeadroom = 1.1; // above the largest value of a lane
constexpr double laneGap = 4;        // px between two lanes
constexpr double areaOpacity = 0.35;
constexpr double laneLineWidth = 1.5; // px
constexpr double barWidth = 2;        // px; a single bad minute must be seen
constexpr double titleGap = 6;        // px beside a title
constexpr int clockStepHours = 3;
constexpr int secondsOfHour = 3600;

// Returns the sections of known values, without bridging gaps.
QList<QPolygonF> runsOf(const QList<double>& columns)
{
    QList<QPolygonF> runs(1);
    for (qsizetype i = 0; i < columns.size(); ++i) {
        if (std::isfinite(columns[i]))
            runs.last() << QPointF(static_cast<double>(i) + 0.5, columns[i]);
        else if (!runs.last().isEmpty())
            runs << QPolygonF();
    }
    return runs;
}

void paintSticks(QPainter& painter, const QPolygonF& points, const QColor& color, const QwtScaleMap& xMap,
                 const QwtScaleMap& yMap)
{
    QPolygonF bad;
    std::ranges::copy_if(points, std::back_inserter(bad), [](const QPointF& point) { return point.y() > 0; });
    QwtPlotCurve curve;
    curve.setStyle(QwtPlotCurve::Sticks);
    curve.setPen(QPen(color, barWidth, Qt::SolidLine, Qt::FlatCap));
    curve.setSamples(bad);
    curve.draw(&painter, xMap, yMap, QRectF(QPointF(xMap.p1(), yMap.p2()), QPointF(xMap.p2(), yMap.p1())));
}

void paintArea(QPainter& painter, const QPolygonF& points, const QColor& color, const QwtScaleMap& xMap,
               const QwtScaleMap& yMap)
{
    QPolygonF area;
    for (const QPointF& point : points)
        area << QPointF(xMap.transform(point.x()), yMap.transform(point.y()));
    if (area.isEmpty())
        return;
    area.prepend(QPointF(area.first().x(), yMap.p1()));
    area.append(QPointF(area.last().x(), yMap.p1()));
    QColor tint = color;
    tint.setAlphaF(static_cast<float>(areaOpacity));
    painter.setPen(Qt::NoPen);
    painter.setBrush(tint);
    painter.drawPolygon(area);
}

} // namespace

QList<double> worstOfColumns(const QList<double>& values, int minutes, int columns)
{
    QList<double> worst(columns, unknown);
    const qsizetype first = std::max<qsizetype>(0, values.size() - minutes);
    const qsizetype offset = minutes - (values.size() - first);
    for (qsizetype i = first; i < values.size(); ++i) {
        double& column = worst[(offset + i - first) * columns / minutes];
        if (std::isfinite(values[i]) && !(column >= values[i]))
            column = values[i];
    }
    return worst;
}

StripChart::StripChart(QQuickItem* parent)
    : QQuickPaintedItem(parent)
{
    connect(this, &StripChart::dataChanged, this, &StripChart::updateAll);
    connect(this, &StripChart::styleChanged, this, &StripChart::updateAll);
}

void StripChart::paint(QPainter* painter)
{
    const QFontMetricsF metrics(m_textFont);
    const double clockHeight = metrics.height();
    const double laneHeight = (height() - clockHeight - 3 * laneGap) / 3;
    if (width() < 1 || laneHeight < 1)
        return;
    painter->setFont(m_textFont);
    const QRectF whole(0, 0, width(), height() - clockHeight - laneGap);
    paintClock(*painter, whole);
    const std::array lanes{Lane{m_answers, m_answersTitle, m_answersColor, Shape::Area, 0},
                           Lane{m_timesMs, m_timesTitle, m_timesColor, Shape::Line, 1},
                           Lane{m_errors, m_errorsTitle, m_errorsColor, Shape::Bars, 0}};
    double y = 0;
    for (const Lane& lane : lanes) {
        paintLane(*painter, lane, {0, y, width(), laneHeight});
        y += laneHeight + laneGap;
    }
}

void StripChart::paintLane(QPainter& painter, const Lane& lane, const QRectF& rect) const
{
    // The points are limited to the number of pixels.
    const int columns = std::clamp(static_cast<int>(rect.width() / 2), 1, minutes);
    const QList<double> worst = worstOfColumns(lane.values, minutes, columns);
    double largest = unknown;
    for (const double value : worst) {
        if (std::isfinite(value) && !(largest >= value))
            largest = value;
    }
    painter.setPen(QPen(m_gridColor, 1));
    painter.drawLine(rect.bottomLeft(), rect.bottomRight());
    const QString number = std::isfinite(largest) ? localNumber(QLocale(m_localeName), largest, lane.decimals)
                                                  : QStringLiteral("--");
    // The text uses the upper half of its lane if the lane is high enough.
    const QFontMetricsF metrics(m_textFont);
    const double textHeight = std::min(metrics.height(), rect.height() / 2);
    QwtScaleMap xMap;
    xMap.setScaleInterval(0, columns);
    xMap.setPaintInterval(rect.left(), rect.right());
    QwtScaleMap yMap;
    yMap.setScaleInterval(0, largest > 0 ? laneHeadroom * largest : 1);
    yMap.setPaintInterval(rect.bottom(), rect.top() + textHeight);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const QPolygonF& run : runsOf(worst)) {
        if (lane.shape == Shape::Area)
            paintArea(painter, run, lane.color, xMap, yMap);
        if (lane.shape == Shape::Bars)
            paintSticks(painter, run, lane.color, xMap, yMap);
        else
            paintLine(painter, run, {lane.color, laneLineWidth}, xMap, yMap);
    }
    painter.restore();
    const QString title = lane.title.arg(number);
    const QRectF place(rect.left(), rect.top(), metrics.horizontalAdvance(title) + titleGap, textHeight);
    painter.fillRect(place, m_backgroundColor); // grid lines would cross the text
    painter.setPen(m_textColor);
    painter.drawText(QRectF(place.topLeft(), QSizeF(place.width(), metrics.height())),
                     Qt::AlignLeft | Qt::AlignTop, title);
}

void StripChart::paintClock(QPainter& painter, const QRectF& rect) const
{
    if (!m_end.isValid())
        return;
    const QFontMetricsF metrics(m_textFont);
    const QDateTime last = m_end.addSecs(60); // end of the minute
    // The last full step of the clock, then backward.
    QDateTime tick(last.date(), QTime(last.time().hour() / clockStepHours * clockStepHours, 0));
    const double width = metrics.horizontalAdvance(QStringLiteral("00:00"));
    for (; tick.secsTo(last) < 24 * secondsOfHour; tick = tick.addSecs(-clockStepHours * secondsOfHour)) {
        const double share = 1 - static_cast<double>(tick.secsTo(last)) / (24.0 * secondsOfHour);
        const double x = rect.left() + share * rect.width();
        painter.setPen(QPen(m_gridColor, 1));
        painter.drawLine(QPointF(x, rect.top()), QPointF(x, rect.bottom()));
        const double left = std::clamp(x - width / 2, rect.left(), rect.right() - width);
        painter.setPen(m_textColor);
        painter.drawText(QRectF(left, rect.bottom() + laneGap, 2 * width, metrics.height()),
                         Qt::AlignLeft | Qt::AlignTop, tick.time().toString(QStringLiteral("HH:mm")));
    }
}

} // namespace campanel::plot
