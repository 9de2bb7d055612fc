// SPDX-License-Identifier: Apache-2.0
#include "app/plot/knife_dial.h"

#include "app/plot/same_number.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace campanel::plot {

namespace {

// The shares of the dial's radius.
constexpr double ringShare = 0.15;
constexpr double tipShare = 0.105;
constexpr double hubShare = 0.075;
constexpr double handShare = 0.047;
constexpr double cutShare = 0.03;
constexpr double haloShare = 0.025; // free space around tip and cut mark

} // namespace

KnifeDial::KnifeDial(QQuickItem* parent)
    : QQuickPaintedItem(parent)
{
    connect(this, &KnifeDial::marksChanged, this, &KnifeDial::updateAll);
    connect(this, &KnifeDial::styleChanged, this, &KnifeDial::updateAll);
}

void KnifeDial::geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry)
{
    QQuickPaintedItem::geometryChange(newGeometry, oldGeometry);
    updateAll();
}

void KnifeDial::setAngleDeg(double angle)
{
    if (sameNumber(angle, m_angleDeg)) {
        return;
    }
    update(handRect(m_angleDeg));
    m_angleDeg = angle;
    update(handRect(m_angleDeg));
    emit angleDegChanged();
}

void KnifeDial::changeMark(double& mark, double angle)
{
    if (!sameNumber(mark, angle)) {
        mark = angle;
        emit marksChanged();
    }
}

double KnifeDial::ringWidth() const
{
    return std::min(width(), height()) / 2 * ringShare;
}

double KnifeDial::ringRadius() const
{
    // The tip is wider than the ring and must stay inside the item.
    const double radius = std::min(width(), height()) / 2;
    return radius * (1 - tipShare - haloShare);
}

QPointF KnifeDial::pointAt(double angle, double radius) const
{
    const double radians = angle * std::numbers::pi / 180;
    return boundingRect().center() + radius * QPointF(std::sin(radians), -std::cos(radians));
}

QRect KnifeDial::handRect(double angle) const
{
    if (std::isnan(angle)) {
        return {};
    }
    const double reach = std::min(width(), height()) / 2 * (tipShare + haloShare) + 1;
    return QRectF(boundingRect().center(), pointAt(angle, ringRadius()))
        .normalized()
        .adjusted(-reach, -reach, reach, reach)
        .toAlignedRect();
}

void KnifeDial::paint(QPainter* painter)
{
    if (boundingRect().isEmpty()) {
        return;
    }
    painter->setRenderHint(QPainter::Antialiasing);
    paintRing(*painter);
    if (!std::isnan(m_angleDeg)) {
        paintHand(*painter);
    }
}

void KnifeDial::paintRing(QPainter& painter) const
{
    const double radius = ringRadius();
    const QPointF center = boundingRect().center();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_ringColor, ringWidth(), Qt::SolidLine, Qt::FlatCap));
    painter.drawEllipse(center, radius, radius);
    if (!std::isnan(m_syncStartDeg) && !std::isnan(m_syncEndDeg)) {
        // QPainter's unit is 1/16 degree, counter-clockwise from three o'clock.
        double sweep = std::fmod(m_syncEndDeg - m_syncStartDeg, 360.0);
        if (sweep < 0) {
            sweep += 360;
        }
        const QRectF circle(center.x() - radius, center.y() - radius, 2 * radius, 2 * radius);
        painter.setPen(QPen(m_syncColor, ringWidth(), Qt::SolidLine, Qt::FlatCap));
        painter.drawArc(circle, qRound(16 * (90 - m_syncStartDeg)), qRound(-16 * sweep));
    }
    if (!std::isnan(m_cutAngleDeg)) {
        const double size = std::min(width(), height()) / 2;
        const QPointF inner = pointAt(m_cutAngleDeg, radius - ringWidth() / 2);
        const QPointF outer = pointAt(m_cutAngleDeg, radius + ringWidth() / 2);
        painter.setPen(QPen(m_surfaceColor, (cutShare + 2 * haloShare) * size, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(inner, outer);
        painter.setPen(QPen(m_cutColor, cutShare * size, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(inner, outer);
    }
}

void KnifeDial::paintHand(QPainter& painter) const
{
    const double size = std::min(width(), height()) / 2;
    const QPointF center = boundingRect().center();
    const QPointF tip = pointAt(m_angleDeg, ringRadius());
    const QColor hand = m_stale ? m_staleColor : m_handColor;
    painter.setPen(QPen(hand, handShare * size, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(center, tip);
    painter.setPen(Qt::NoPen);
    painter.setBrush(hand);
    painter.drawEllipse(center, hubShare * size, hubShare * size);
    painter.setPen(QPen(m_surfaceColor, haloShare * size));
    painter.setBrush(m_stale ? m_staleColor : m_tipColor);
    const double radius = (tipShare + haloShare / 2) * size; // half of the halo lies on the tip
    painter.drawEllipse(tip, radius, radius);
}

} // namespace campanel::plot
