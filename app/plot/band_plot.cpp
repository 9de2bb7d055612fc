// SPDX-License-Identifier: Apache-2.0
#include "app/plot/band_plot.h"

#include "app/plot/film/film_scale.h"
#include "app/plot/picture/label_draw.h"
#include "app/plot/picture/plot_style.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPalette>

#include <qwt_painter.h>
#include <qwt_plot_grid.h>
#include <qwt_scale_engine.h>

#include <algorithm>
#include <cmath>

namespace campanel::plot {

namespace {

constexpr double minimumTorque = 10; // per cent: less does not count as a course
constexpr double minimumAngle = 1;   // degrees
constexpr double marginShare = 0.04; // of the angles, on both sides
constexpr int maxAngleTicks = 6;
constexpr double readingRadius = 2; // px
constexpr double jamReach = 7;      // px of the arms of its cross
constexpr double jamWidth = 3;      // px

bool isFinite(const QPointF& point)
{
    return std::isfinite(point.x()) && std::isfinite(point.y());
}

} // namespace

BandPlot::BandPlot(QQuickItem* parent)
    : QQuickPaintedItem(parent)
{
    QwtPainter::setRoundingAlignment(false);
    m_axisFont.setPixelSize(13);
    connect(this, &BandPlot::changed, this, &BandPlot::updateAll);
}

void BandPlot::geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry)
{
    QQuickPaintedItem::geometryChange(newGeometry, oldGeometry);
    updateAll();
}

bool BandPlot::hasJam() const
{
    return isFinite(m_jam);
}

void BandPlot::fitScales()
{
    double low = 0;
    double high = 0;
    const auto include = [&](double torque) {
        low = std::min(low, torque);
        high = std::max(high, torque);
    };
    for (qsizetype i = 0; i < std::min(m_expected.size(), m_halfWidths.size()); ++i) {
        include(m_expected[i].y() - m_halfWidths[i]);
        include(m_expected[i].y() + m_halfWidths[i]);
    }
    for (const QPointF& reading : m_readings)
        include(reading.y());
    if (hasJam())
        include(m_jam.y());
    m_torqueScale.fit(low, high, minimumTorque);
    const double from = hasJam() ? std::min(m_from, m_jam.x()) : m_from;
    const double to = std::max(hasJam() ? std::max(m_to, m_jam.x()) : m_to, from + minimumAngle);
    const double margin = marginShare * (to - from);
    m_angles = QwtLinearScaleEngine().divideScale(from - margin, to + margin, maxAngleTicks, 0);
}

void BandPlot::place()
{
    const QFontMetricsF metrics(m_axisFont);
    LabelDraw torques(QwtScaleDraw::LeftScale, m_locale, m_torqueScale);
    // The highest number has the unit.
    const double left =
        std::ceil(torques.extent(m_axisFont) + metrics.horizontalAdvance(QStringLiteral(" %")));
    const double top = std::ceil(metrics.height() * 1.5);
    const double bottom = std::ceil(metrics.height() + labelGap);
    const double right = std::ceil(metrics.horizontalAdvance(QStringLiteral("000°")) / 2);
    m_canvas =
        QRectF(left, top, std::max(1.0, width() - left - right), std::max(1.0, height() - top - bottom));
    m_angleMap.setScaleInterval(m_angles.lowerBound(), m_angles.upperBound());
    m_angleMap.setPaintInterval(m_canvas.left(), m_canvas.right());
    m_torqueMap.setScaleInterval(m_torqueScale.lower(), m_torqueScale.upper());
    m_torqueMap.setPaintInterval(m_canvas.bottom(), m_canvas.top());
}

void BandPlot::paint(QPainter* painter)
{
    if (boundingRect().isEmpty())
        return;
    fitScales();
    place();
    painter->save();
    painter->setClipRect(m_canvas.adjusted(-jamReach, 0, jamReach, 0));
    paintBand(*painter);
    painter->restore();
    paintAxes(*painter);
    painter->setRenderHint(QPainter::Antialiasing);
    paintLines(*painter);
    painter->save();
    painter->setClipRect(m_canvas.adjusted(-jamReach, -jamReach, jamReach, jamReach));
    paintReadings(*painter);
    paintJam(*painter);
    painter->restore();
}

void BandPlot::paintAxes(QPainter& painter) const
{
    QwtPlotGrid grid;
    grid.enableX(false);
    grid.setMajorPen(QPen(m_gridColor, 1));
    grid.setYDiv(m_torqueScale.division());
    // QwtPlotGrid omits a line on the lowest row of pixels.
    grid.draw(&painter, QwtScaleMap(), m_torqueMap, m_canvas.adjusted(0, 0, 0, 1));

    QPalette palette;
    palette.setColor(QPalette::Text, m_secondaryInkColor);
    painter.setFont(m_axisFont);
    const auto paintScale = [&](QwtScaleDraw::Alignment side, const QwtScaleDiv& division, const QPointF& at,
                                double length, const QString& unit) {
        const QList<double> ticks = division.ticks(QwtScaleDiv::MajorTick);
        const int decimals = ticks.size() > 1 ? decimalsOfStep(ticks[1] - ticks[0]) : 0;
        LabelDraw labels(side, m_locale, decimals);
        labels.setScaleDiv(division);
        if (!ticks.isEmpty())
            labels.setSpecialLabel(ticks.last(), localNumber(m_locale, ticks.last(), decimals) + unit);
        labels.move(at);
        labels.setLength(length);
        labels.draw(&painter, palette);
    };
    paintScale(QwtScaleDraw::LeftScale, m_torqueScale.division(), m_canvas.topLeft(), m_canvas.height(),
               QStringLiteral(" %"));
    paintScale(QwtScaleDraw::BottomScale, m_angles, m_canvas.bottomLeft(), m_canvas.width(),
               QStringLiteral("°"));
}

// Paints each part of the band as wide as the controller compares it.
void BandPlot::paintBand(QPainter& painter) const
{
    const qsizetype parts = std::min(m_expected.size(), m_halfWidths.size());
    double half = (m_to - m_from) / 2;
    for (qsizetype i = 1; i < parts; ++i)
        half = std::min(half, (m_expected[i].x() - m_expected[i - 1].x()) / 2);
    painter.setRenderHint(QPainter::Antialiasing, false);
    const auto leftOf = [&](double deg) { return std::round(xOfAngle(deg - half)); };
    for (qsizetype i = 0; i < parts; ++i) {
        const QPointF part = m_expected[i];
        const double left = leftOf(part.x());
        const double right = std::round(xOfAngle(part.x() + half));
        painter.fillRect(QRectF(QPointF(left, yOfTorque(part.y() + m_halfWidths[i])),
                                QPointF(right, yOfTorque(part.y() - m_halfWidths[i]))),
                         m_bandColor);
        painter.setPen(QPen(m_expectedColor, m_lineWidth, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(QPointF(left, yOfTorque(part.y())), QPointF(right, yOfTorque(part.y())));
    }
}

// Paints the cut and the start of the monitoring as lines with their names.
void BandPlot::paintLines(QPainter& painter) const
{
    const auto paintAt = [&](double deg, const QString& label, Qt::PenStyle style) {
        if (!m_angles.contains(deg))
            return;
        const double x = xOfAngle(deg);
        painter.setPen(QPen(m_secondaryInkColor, 1, style));
        painter.drawLine(QPointF(x, m_canvas.top()), QPointF(x, m_canvas.bottom()));
        painter.setFont(m_axisFont);
        paintTextWithin(painter, width(), x, 0, label);
    };
    paintAt(0, m_cutLabel, Qt::SolidLine);
    paintAt(m_closing, m_closingLabel, Qt::DashLine);
}

void BandPlot::paintReadings(QPainter& painter) const
{
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_readingColor);
    for (qsizetype i = 0; i < m_readings.size(); ++i) {
        const double radius = i + 1 == m_readings.size() ? dotRadius : readingRadius;
        painter.drawEllipse(QPointF(xOfAngle(m_readings[i].x()), yOfTorque(m_readings[i].y())), radius,
                            radius);
    }
}

void BandPlot::paintJam(QPainter& painter) const
{
    if (!hasJam())
        return;
    const QPointF middle(xOfAngle(m_jam.x()), yOfTorque(m_jam.y()));
    painter.setPen(QPen(m_jamColor, jamWidth));
    painter.drawLine(middle - QPointF(jamReach, jamReach), middle + QPointF(jamReach, jamReach));
    painter.drawLine(middle - QPointF(jamReach, -jamReach), middle + QPointF(jamReach, -jamReach));
}

} // namespace campanel::plot
