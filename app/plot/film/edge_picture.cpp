// SPDX-License-Identifier: Apache-2.0
#include "app/plot/film/edge_picture.h"

#include "app/plot/film/film_scale.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace campanel::plot {

namespace {

constexpr double signHeadShare = 0.4; // of the height of a sign
constexpr double minWindow = 5;       // px
constexpr double edgeWidth = 3;       // px
constexpr double maxHatched = 0.3;    // of the width

struct EdgeLook {
    QList<qreal> dashes;     // empty: one line
    double heightShare = 1;  // of the film's width, from its lower edge
    bool isRejected = false; // with a cross, and hatched up to the expected mark
};

const EdgeLook& lookOf(int look)
{
    static const std::array looks{EdgeLook{}, EdgeLook{{3, 2}}, EdgeLook{{1, 2}, 0.5}, EdgeLook{{}, 1, true}};
    return looks.at(std::clamp<std::size_t>(static_cast<std::size_t>(look), 0, looks.size() - 1));
}

} // namespace

EdgePicture::EdgePicture(QQuickItem* parent)
    : QQuickPaintedItem(parent)
{
    connect(this, &EdgePicture::changed, this, &EdgePicture::updateAll);
}

void EdgePicture::geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry)
{
    QQuickPaintedItem::geometryChange(newGeometry, oldGeometry);
    updateAll();
}

EdgePicture::Rows EdgePicture::rows() const
{
    const double line = QFontMetricsF(m_textFont).height();
    if (isSign())
        return {0, height() * signHeadShare, height()};
    return {line, line * (1 + film::headShare), height() - line - FilmScale::tickLength};
}

double EdgePicture::pxPerMm() const
{
    return isSign() ? 1 : width() / m_spanMm;
}

double EdgePicture::xOf(double placeMm) const
{
    if (isSign())
        return width() / 2;
    return width() * (1 - rightShare) + (placeMm + m_backMm) * pxPerMm();
}

void EdgePicture::paint(QPainter* painter)
{
    const Rows places = rows();
    if (width() < 1 || places.filmBottom - places.filmTop < 1)
        return;
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setFont(m_textFont);
    painter->setClipRect(boundingRect());
    paintFilm(*painter, places);
    paintWindows(*painter, places);
    const qsizetype count = std::min(m_places.size(), m_looks.size());
    for (qsizetype i = 0; i < count; ++i)
        paintEdge(*painter, places, m_places[i], m_looks[i]);
    paintNotes(*painter);
}

void EdgePicture::paintFilm(QPainter& painter, const Rows& rows) const
{
    painter.fillRect(QRectF(0, rows.filmTop, width(), rows.filmBottom - rows.filmTop), m_filmColor);
    painter.setPen(QPen(m_edgeColor, 1));
    for (const double y : {rows.filmTop, rows.filmBottom})
        painter.drawLine(QPointF(0, y), QPointF(width(), y));
    if (isSign())
        return;
    FilmScale scale;
    scale.width = width();
    scale.height = height();
    scale.zeroX = xOf(0);
    scale.pxPerMm = pxPerMm();
    scale.reachMm = m_spanMm + m_backMm;
    scale.filmBottom = rows.filmBottom;
    scale.font = m_textFont;
    scale.unit = m_lengthUnit;
    scale.factor = m_lengthFactor;
    scale.locale = m_locale;
    scale.tickColor = m_edgeColor;
    scale.textColor = m_textColor;
    scale.paint(painter);
}

void EdgePicture::paintWindows(QPainter& painter, const Rows& rows) const
{
    QColor tint = m_windowColor;
    tint.setAlphaF(static_cast<float>(film::windowOpacity));
    for (const QPointF& window : m_windows) {
        const double half = std::max(minWindow / 2, window.y() * pxPerMm());
        const double x = xOf(window.x());
        painter.fillRect(QRectF(x - half, rows.filmTop, 2 * half, rows.filmBottom - rows.filmTop), tint);
        painter.setPen(QPen(m_windowColor, 1));
        for (const double side : {x - half, x + half})
            painter.drawLine(QPointF(side, rows.filmTop), QPointF(side, rows.filmBottom));
    }
}

void EdgePicture::paintEdge(QPainter& painter, const Rows& rows, double placeMm, int look) const
{
    const EdgeLook& style = lookOf(look);
    if (style.isRejected)
        paintRejected(painter, rows, placeMm);
    QPen pen(style.isRejected ? m_rejectedColor : m_markColor, edgeWidth, Qt::SolidLine, Qt::FlatCap);
    if (!style.dashes.isEmpty())
        pen.setDashPattern(style.dashes);
    painter.setPen(pen);
    const double x = xOf(placeMm);
    const double top = rows.filmBottom - style.heightShare * (rows.filmBottom - rows.filmTop);
    painter.drawLine(QPointF(x, rows.filmBottom), QPointF(x, top));
}

double EdgePicture::gapMm(double placeMm) const
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const QPointF& window : m_windows) {
        const double gap = placeMm - window.x();
        if (std::abs(gap) < std::abs(nearest))
            nearest = gap;
    }
    return nearest;
}

// Paints a cross above the film, and the way to the expected mark hatched.
void EdgePicture::paintRejected(QPainter& painter, const Rows& rows, double placeMm) const
{
    const double x = xOf(placeMm);
    const double gap = gapMm(placeMm) * pxPerMm();
    if (std::abs(gap) < maxHatched * width())
        painter.fillRect(QRectF(QPointF(x - gap, rows.filmTop), QPointF(x, rows.filmBottom)).normalized(),
                         QBrush(m_rejectedColor, Qt::BDiagPattern));
    const double reach = (rows.filmTop - rows.headsTop) / 2 - 1;
    const QPointF middle(x, (rows.filmTop + rows.headsTop) / 2);
    painter.setPen(QPen(m_rejectedColor, film::lineWidth));
    painter.drawLine(middle - QPointF(reach, reach), middle + QPointF(reach, reach));
    painter.drawLine(middle - QPointF(reach, -reach), middle + QPointF(reach, -reach));
}

// Paints the newest notes first: those without space are left out.
void EdgePicture::paintNotes(QPainter& painter) const
{
    if (isSign())
        return;
    const QFontMetricsF metrics(m_textFont);
    painter.setPen(m_rejectedColor);
    double freeUpTo = width();
    for (qsizetype i = std::min(m_notes.size(), m_places.size()) - 1; i >= 0; --i) {
        const double x = xOf(m_places[i]);
        const double half = metrics.horizontalAdvance(m_notes[i]) / 2;
        if (m_notes[i].isEmpty() || x < 0 || x > width() || std::min(x + half, width()) > freeUpTo)
            continue;
        freeUpTo = paintTextWithin(painter, width(), x, 0, m_notes[i]).left() - film::textGap;
    }
}

} // namespace campanel::plot
