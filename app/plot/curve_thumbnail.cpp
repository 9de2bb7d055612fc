// SPDX-License-Identifier: Apache-2.0
#include "app/plot/curve_thumbnail.h"

#include <QPainter>
#include <QPolygonF>

namespace campanel::plot {

CurveThumbnail::CurveThumbnail(QQuickItem* parent)
    : QQuickPaintedItem(parent)
{
    connect(this, &CurveThumbnail::pointsChanged, this, &CurveThumbnail::updateAll);
    connect(this, &CurveThumbnail::styleChanged, this, &CurveThumbnail::updateAll);
}

void CurveThumbnail::setPoints(const QList<QPointF>& points)
{
    if (points == m_points)
        return;
    m_points = points;
    emit pointsChanged();
}

void CurveThumbnail::paint(QPainter* painter)
{
    if (m_points.size() < 2)
        return;
    const double margin = m_lineWidth / 2 + 1;
    const QRectF area = boundingRect().adjusted(margin, margin, -margin, -margin);
    QPolygonF line;
    for (const QPointF& point : m_points)
        line << QPointF(area.left() + point.x() * area.width(), area.bottom() - point.y() * area.height());
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(m_color, m_lineWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->drawPolyline(line);
}

} // namespace campanel::plot
