// SPDX-License-Identifier: Apache-2.0
#include "app/plot/bag_chart.h"

#include <QPainter>

#include <qwt_plot_curve.h>
#include <qwt_scale_map.h>
#include <qwt_symbol.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace campanel::plot {

namespace {

constexpr int capacity = 60; // bags
constexpr double toleranceShare =
    0.8; // of half the height, where the tolerance lines are if no bag is beyond them
constexpr double defaultReachMm = 1.0;     // without tolerance and without larger values
constexpr double deviationHeadroom = 1.05; // above the largest deviation
constexpr double levelFactor = 1.5;        // between two levels of zoom
constexpr double scatterOpacity = 0.25;
constexpr double minBand = 2;          // px, of the scatter
constexpr double badPointFactor = 1.5; // color alone must not be the only sign

void paintPoints(QPainter& painter, const QPolygonF& points, std::unique_ptr<QwtSymbol> symbol,
                 const QwtScaleMap& xMap, const QwtScaleMap& yMap)
{
    QwtPlotCurve curve;
    curve.setStyle(QwtPlotCurve::NoCurve);
    curve.setSymbol(symbol.release()); // the curve owns it
    curve.setSamples(points);
    // Qwt omits symbols with their center on the right or lower edge of its canvas.
    const QRectF canvas(QPointF(xMap.p1(), yMap.p2()), QPointF(xMap.p2(), yMap.p1()));
    curve.draw(&painter, xMap, yMap, canvas.adjusted(-1, -1, 1, 1));
}

} // namespace

BagChart::BagChart(QQuickItem* parent)
    : QQuickPaintedItem(parent)
{
    connect(this, &BagChart::valuesChanged, this, &BagChart::updateAll);
    connect(this, &BagChart::toleranceChanged, this, &BagChart::updateAll);
    connect(this, &BagChart::styleChanged, this, &BagChart::updateAll);
}

void BagChart::setTolerance(double tolerance)
{
    if (tolerance == m_tolerance || (std::isnan(tolerance) && std::isnan(m_tolerance))) {
        return;
    }
    m_tolerance = tolerance;
    emit toleranceChanged();
}

BagChart::Points BagChart::points() const
{
    Points points;
    const qsizetype first = std::max<qsizetype>(0, m_values.size() - capacity);
    const qsizetype offset = capacity - (m_values.size() - first);
    for (qsizetype i = first; i < m_values.size(); ++i) {
        const auto x = static_cast<double>(offset + i - first);
        if (std::isnan(m_values[i])) {
            points.gaps << x;
        } else if (std::isfinite(m_values[i])) {
            const QPointF point(x, m_values[i]);
            (std::abs(m_values[i]) > m_tolerance ? points.bad : points.good).append(point);
        }
    }
    return points;
}

double BagChart::halfRange(const Points& points) const
{
    const double normal = (m_tolerance > 0 ? m_tolerance : defaultReachMm) / toleranceShare;
    double needed = normal;
    for (const QPolygonF* part : {&points.good, &points.bad}) {
        for (const QPointF& point : *part) {
            needed = std::max(needed, std::abs(point.y()) * deviationHeadroom);
        }
    }
    // Zooms in a few fixed levels, so that the picture does not change with every bag.
    return normal * std::pow(levelFactor, std::ceil(std::log(needed / normal) / std::log(levelFactor)));
}

void BagChart::paint(QPainter* painter)
{
    if (boundingRect().isEmpty()) {
        return;
    }
    painter->fillRect(boundingRect(), m_backgroundColor);

    const Points all = points();
    const double half = halfRange(all);
    const double margin = m_pointSize;
    QwtScaleMap valueMap;
    valueMap.setScaleInterval(-half, half);
    valueMap.setPaintInterval(height(), 0);
    QwtScaleMap indexMap;
    indexMap.setScaleInterval(0, std::max(1, capacity - 1));
    indexMap.setPaintInterval(margin, width() - margin);

    paintMean(*painter, valueMap);
    paintLines(*painter, valueMap);
    painter->setPen(QPen(m_gridColor, 1, Qt::DotLine));
    for (const double gap : all.gaps)
        painter->drawLine(QPointF(indexMap.transform(gap), 0), QPointF(indexMap.transform(gap), height()));
    painter->setRenderHint(QPainter::Antialiasing);
    const auto symbol = [this](QwtSymbol::Style style, const QColor& color, double size) {
        return std::make_unique<QwtSymbol>(style, m_stale ? m_staleColor : color, QPen(Qt::NoPen),
                                           QSizeF(size, size).toSize());
    };
    paintPoints(*painter, all.good, symbol(QwtSymbol::Ellipse, m_pointColor, m_pointSize), indexMap,
                valueMap);
    paintPoints(*painter, all.bad, symbol(QwtSymbol::Diamond, m_violationColor, badPointFactor * m_pointSize),
                indexMap, valueMap);
}

void BagChart::paintMean(QPainter& painter, const QwtScaleMap& valueMap) const
{
    if (std::isnan(m_mean) || std::isnan(m_scatter)) {
        return;
    }
    const double middle = valueMap.transform(m_mean);
    const double half = std::max(minBand / 2, middle - valueMap.transform(m_mean + m_scatter));
    QColor color = m_stale ? m_staleColor : m_pointColor;
    color.setAlphaF(static_cast<float>(scatterOpacity));
    painter.fillRect(QRectF(0, middle - half, width(), 2 * half), color);
}

void BagChart::paintLines(QPainter& painter, const QwtScaleMap& valueMap) const
{
    painter.setPen(QPen(m_gridColor, 1));
    const double zero = valueMap.transform(0);
    painter.drawLine(QPointF(0, zero), QPointF(width(), zero));
    if (std::isnan(m_tolerance)) {
        return;
    }
    QPen pen(m_toleranceColor, 1.5, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({4, 3});
    painter.setPen(pen);
    for (const double value : {m_tolerance, -m_tolerance}) {
        const double y = valueMap.transform(value);
        painter.drawLine(QPointF(0, y), QPointF(width(), y));
    }
}

} // namespace campanel::plot
