// SPDX-License-Identifier: Apache-2.0
#include "app/plot/regime_plot.h"

#include <qwt_painter.h>

#include <algorithm>

namespace campanel::plot {

RegimePlot::RegimePlot(QQuickItem* parent)
    : QQuickPaintedItem(parent)
{
    QwtPainter::setRoundingAlignment(false);
    connect(this, &RegimePlot::dataChanged, this, &RegimePlot::invalidate);
    connect(this, &RegimePlot::styleChanged, this, &RegimePlot::invalidate);
}

void RegimePlot::geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry)
{
    QQuickPaintedItem::geometryChange(newGeometry, oldGeometry);
    invalidate();
}

void RegimePlot::invalidate()
{
    m_isLaidOut = false;
    update(boundingRect().toAlignedRect());
    emit layoutChanged();
}

void RegimePlot::layOut()
{
    if (m_isLaidOut)
        return;
    m_isLaidOut = true;
    RegimeContent& content = m_picture.content;
    content.map = m_map.value<std::shared_ptr<const profile::RegimeMap>>();
    content.limitNames = m_limitNames;
    content.marks = m_marks;
    content.shownRate = m_shownRate;
    content.rateUnit = m_rateUnit;
    content.lengthUnit = m_lengthUnit;
    content.lengthFactor = m_lengthFactor;
    content.refusedName = m_refusedName;
    content.marksName = m_marksName;
    RegimeStyle& style = m_picture.style;
    style.limits = m_limitColors;
    style.grid = m_gridColor;
    style.surface = m_surfaceColor;
    style.inset = m_insetColor;
    style.ink = m_inkColor;
    style.secondaryInk = m_secondaryInkColor;
    style.lineWidth = m_lineWidth;
    style.font = m_axisFont;
    style.locale = m_locale;
    m_picture.layOut(size());
}

void RegimePlot::paint(QPainter* painter)
{
    if (boundingRect().isEmpty())
        return;
    layOut();
    m_picture.paint(*painter);
}

QRectF RegimePlot::plotArea()
{
    layOut();
    return m_picture.canvas();
}

double RegimePlot::xOfLength(double lengthMm)
{
    layOut();
    return m_picture.lengthMap().transform(lengthMm);
}

double RegimePlot::yOfRate(double rateBagsPerMin)
{
    layOut();
    return m_picture.rateMap().transform(rateBagsPerMin);
}

double RegimePlot::lengthOfX(double x)
{
    layOut();
    const QRectF& canvas = m_picture.canvas();
    return m_picture.lengthMap().invTransform(std::clamp(x, canvas.left(), canvas.right()));
}

double RegimePlot::rateOfY(double y)
{
    layOut();
    const QRectF& canvas = m_picture.canvas();
    return m_picture.rateMap().invTransform(std::clamp(y, canvas.top(), canvas.bottom()));
}

} // namespace campanel::plot
