// SPDX-License-Identifier: Apache-2.0
#include "app/plot/film/film_picture.h"
#include "app/plot/film/film_scale.h"
#include "app/plot/picture/label_draw.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace campanel::plot {

namespace {

constexpr double markShare = 0.3;       // of the film's width; marks are printed along its lower edge
constexpr double productShare = 0.5;    // of the film's width, in its middle
constexpr double windowShare = 0.42;    // of the film's width; higher than a mark
constexpr double markWidth = 7;         // px
constexpr double knifeShare = 0.6;      // of a line of text: half of the knife's width
constexpr double cutFilmOpacity = 0.45; // film beyond the knife

enum Kind { Present, Skipped, Next, NextScrap };

bool isOf(const QPointF& cut, Kind kind)
{
    return cut.y() == static_cast<double>(kind);
}

QPolygonF triangle(const QPointF& tip, double halfWidth, double height)
{
    return {{tip, tip + QPointF(-halfWidth, -height), tip + QPointF(halfWidth, -height)}};
}

} // namespace

FilmPicture::Rows FilmPicture::rows() const
{
    const double line = QFontMetricsF(m_textFont).height();
    return {line, line * (1 + film::headShare), height() - line - FilmScale::tickLength};
}

void FilmPicture::paint(QPainter* painter)
{
    const Rows places = rows();
    if (width() < 1 || places.filmBottom - places.filmTop < 1)
        return;
    takeReport();
    m_paintedMm = travelledMm();
    m_paintedS = m_clock();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setFont(m_textFont);
    paintFilm(*painter, places);
    paintScale(*painter, places);
    if (!std::isnan(m_positionMm)) {
        painter->save();
        painter->setClipRect(boundingRect());
        paintScrap(*painter, places);
        paintProducts(*painter, places);
        paintWindow(*painter, places);
        paintMarks(*painter, places);
        paintCuts(*painter, places);
        painter->restore();
    }
    paintNextText(*painter);
    paintSensor(*painter, places);
    paintKnife(*painter, places);
}

// Paints the film; paler after the cut.
void FilmPicture::paintFilm(QPainter& painter, const Rows& rows) const
{
    const QRectF before(0, rows.filmTop, knifeX(), rows.filmBottom - rows.filmTop);
    painter.fillRect(before, m_filmColor);
    painter.save();
    painter.setOpacity(cutFilmOpacity);
    painter.fillRect(QRectF(before.topRight(), QPointF(width(), rows.filmBottom)), m_filmColor);
    painter.restore();
    painter.setPen(QPen(m_edgeColor, 1));
    for (const double y : {rows.filmTop, rows.filmBottom})
        painter.drawLine(QPointF(0, y), QPointF(width(), y));
}

void FilmPicture::paintScale(QPainter& painter, const Rows& rows) const
{
    FilmScale scale;
    scale.width = width();
    scale.height = height();
    scale.zeroX = knifeX();
    scale.pxPerMm = pxPerMm();
    scale.reachMm = reachMm();
    scale.filmBottom = rows.filmBottom;
    scale.font = m_textFont;
    scale.unit = m_lengthUnit;
    scale.factor = m_lengthFactor;
    scale.locale = m_locale;
    scale.tickColor = m_edgeColor;
    scale.textColor = m_textColor;
    scale.paint(painter);
}

// Hatches the bags that will be scrap, from the knife on, and the last one behind it. A skipped cut ends no
// bag.
void FilmPicture::paintScrap(QPainter& painter, const Rows& rows) const
{
    const QBrush hatch(live(m_skippedColor), Qt::BDiagPattern);
    const auto paint = [&](double left, double right) {
        painter.fillRect(QRectF(left, rows.filmTop, right - left, rows.filmBottom - rows.filmTop), hatch);
    };
    if (m_scrap.y() > 0)
        paint(knifeX(), width());
    double right = knifeX();
    int bags = 0;
    for (const QPointF& cut : m_cuts) {
        if (bags == m_scrap.x())
            break;
        const double left = xOf(cut.x());
        if (left >= knifeX() || isOf(cut, Skipped))
            continue; // made already, or skipped
        paint(left, right);
        right = left;
        ++bags;
    }
    right = knifeX();
    for (const QPointF& cut : m_cuts) {
        const double left = std::min(xOf(cut.x()), knifeX());
        if (isOf(cut, NextScrap))
            paint(left, right);
        if (!isOf(cut, Skipped))
            right = left;
    }
}

void FilmPicture::paintProducts(QPainter& painter, const Rows& rows) const
{
    const double film = rows.filmBottom - rows.filmTop;
    const double top = rows.filmTop + film * (1 - productShare) / 2 - film * markShare / 3;
    painter.setPen(Qt::NoPen);
    painter.setBrush(live(m_productColor));
    for (const QPointF& product : m_products) {
        const QRectF box(QPointF(xOf(product.y()), top),
                         QPointF(xOf(product.x()), top + film * productShare));
        const double radius = std::min(box.height(), std::abs(box.width())) / 4;
        painter.drawRoundedRect(box.normalized(), radius, radius);
    }
}

// Paints the expected place of the next mark: a tint between two brackets.
void FilmPicture::paintWindow(QPainter& painter, const Rows& rows) const
{
    if (std::isnan(m_nextMarkMm) || std::isnan(m_windowMm))
        return;
    const double left = xOf(m_nextMarkMm + m_windowMm);
    const double right = xOf(m_nextMarkMm - m_windowMm);
    const double top = rows.filmBottom - windowShare * (rows.filmBottom - rows.filmTop);
    const double half = std::max(markWidth, (right - left) / 2);
    const QRectF box(QPointF((left + right) / 2 - half, top),
                     QPointF((left + right) / 2 + half, rows.filmBottom));
    QColor tint = live(m_windowColor);
    painter.setPen(QPen(tint, film::lineWidth));
    tint.setAlphaF(static_cast<float>(film::windowOpacity));
    painter.fillRect(box, tint);
    const double lip = half / 2;
    painter.drawPolyline(QPolygonF({box.topLeft() + QPointF(lip, 0), box.topLeft(), box.bottomLeft()}));
    painter.drawPolyline(QPolygonF({box.topRight() - QPointF(lip, 0), box.topRight(), box.bottomRight()}));
}

void FilmPicture::paintMarks(QPainter& painter, const Rows& rows) const
{
    const double markHeight = markShare * (rows.filmBottom - rows.filmTop);
    const double rim = film::lineWidth / 2;
    for (const QPointF& mark : m_marks) {
        const QRectF box(xOf(mark.x()) - markWidth / 2, rows.filmBottom - markHeight, markWidth, markHeight);
        const bool isReckoned = mark.y() != 0;
        painter.setPen(QPen(live(m_markColor), film::lineWidth, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
        painter.setBrush(isReckoned ? m_filmColor : live(m_markColor));
        painter.drawRect(box.adjusted(rim, rim, -rim, -rim));
    }
}

// Paints a cut: a line down to the marks with a full head. A skipped one has a broken line, and a cross as
// head.
void FilmPicture::paintCuts(QPainter& painter, const Rows& rows) const
{
    const double head = rows.filmTop - rows.headsTop;
    const double bottom = rows.filmBottom - markShare * (rows.filmBottom - rows.filmTop) - film::lineWidth;
    for (const QPointF& cut : m_cuts) {
        const double x = xOf(cut.x());
        if (x > knifeX())
            continue; // already cut
        const bool isSkipped = isOf(cut, Skipped);
        const QColor color = live(isSkipped            ? m_skippedColor
                                  : isOf(cut, Present) ? m_cutColor
                                                       : m_windowColor);
        QPen pen(color, film::lineWidth, Qt::SolidLine, Qt::FlatCap);
        if (isSkipped)
            pen.setDashPattern({2, 2});
        painter.setPen(pen);
        painter.drawLine(QPointF(x, rows.filmTop), QPointF(x, bottom));
        if (isSkipped) {
            const double reach = head / 2 - 1;
            const QPointF middle(x, rows.filmTop - head / 2);
            painter.setPen(QPen(color, film::lineWidth));
            painter.drawLine(middle - QPointF(reach, reach), middle + QPointF(reach, reach));
            painter.drawLine(middle - QPointF(reach, -reach), middle + QPointF(reach, -reach));
        } else {
            painter.setPen(Qt::NoPen);
            painter.setBrush(color);
            painter.drawPolygon(triangle({x, rows.filmTop}, head / 2, head));
        }
    }
}

// The text ends at the first cut of the next program: its bags are at the left.
QRectF FilmPicture::nextTextRect() const
{
    const auto first = std::ranges::find_if(
        m_cuts, [](const QPointF& cut) { return isOf(cut, Next) || isOf(cut, NextScrap); });
    if (m_nextText.isEmpty() || first == m_cuts.end() || std::isnan(m_positionMm))
        return {};
    const QFontMetricsF metrics(m_textFont);
    const double length = metrics.horizontalAdvance(m_nextText);
    const double knifeLeft = knifeX() - metrics.horizontalAdvance(m_knifeText) / 2 - film::textGap;
    const double right = std::max(length, std::min(xOf(first->x()), knifeLeft));
    return {right - length, 0, length, metrics.height()};
}

void FilmPicture::paintNextText(QPainter& painter) const
{
    const QRectF place = nextTextRect();
    if (place.isEmpty())
        return;
    painter.setPen(live(m_windowColor));
    painter.drawText(place, Qt::AlignCenter, m_nextText);
}

// Paints the sensor above its place, or at the left edge with an arrow when it is not visible.
void FilmPicture::paintSensor(QPainter& painter, const Rows& rows) const
{
    if (!(m_sensorMm > 0))
        return;
    const double head = rows.filmTop - rows.headsTop;
    const bool isInSight = m_sensorMm <= reachMm();
    const double x = isInSight ? knifeX() - m_sensorMm * pxPerMm() : 0;
    const QColor color = live(m_windowColor);
    const QFontMetricsF metrics(m_textFont);
    painter.setPen(QPen(color, film::lineWidth));
    painter.setBrush(color);
    if (isInSight) {
        painter.drawLine(QPointF(x, rows.filmTop), QPointF(x, rows.filmBottom));
        painter.drawRect(QRectF(x - head / 2, rows.headsTop + 1, head, head - 1));
    } else {
        const double y = (rows.headsTop + rows.filmTop) / 2;
        painter.drawPolygon(
            QPolygonF({QPointF(1, y), QPointF(1 + head, y - head / 2), QPointF(1 + head, y + head / 2)}));
    }
    const QString text = isInSight ? m_sensorText
                                   : m_sensorText + QLatin1Char(' ') +
                                         localNumber(m_locale, m_sensorMm * m_lengthFactor, 0) + u' ' +
                                         m_lengthUnit;
    const double knifeLeft = std::min(knifeX(), width() - metrics.horizontalAdvance(m_knifeText) / 2) -
                             metrics.horizontalAdvance(m_knifeText) / 2;
    const double right = std::max(x + metrics.horizontalAdvance(text) / 2, metrics.horizontalAdvance(text));
    const QRectF next = nextTextRect();
    const bool isCovered = !next.isEmpty() && right + film::textGap > next.left() &&
                           right - metrics.horizontalAdvance(text) - film::textGap < next.right();
    if (right + film::textGap > knifeLeft || isCovered)
        return; // no space for both names
    painter.setPen(m_textColor);
    paintTextWithin(painter, width(), x, 0, text);
}

// Paints a blade above the film and a thin line at the cut; hollow while it waits open.
void FilmPicture::paintKnife(QPainter& painter, const Rows& rows) const
{
    const double half = knifeShare * QFontMetricsF(m_textFont).height();
    const QColor color = live(m_knifeColor);
    painter.setPen(QPen(color, 1, Qt::DashLine));
    painter.drawLine(QPointF(knifeX(), rows.filmTop),
                     QPointF(knifeX(), rows.filmBottom + FilmScale::tickLength));
    painter.setPen(QPen(color, film::lineWidth, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.setBrush(m_isKnifeOpen ? QBrush() : QBrush(color));
    const double head = rows.filmTop - rows.headsTop - film::lineWidth;
    painter.drawPolygon(triangle({knifeX(), rows.filmTop - film::lineWidth}, half, head));
    if (m_faultColor.alpha() > 0) {
        const double radius = (rows.filmBottom - rows.filmTop) / 2;
        painter.setPen(QPen(m_faultColor, 2 * film::lineWidth));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(QPointF(knifeX(), (rows.filmTop + rows.filmBottom) / 2), radius, radius);
    }
    painter.setPen(m_textColor);
    paintTextWithin(painter, width(), knifeX(), 0, m_knifeText);
}

} // namespace campanel::plot
