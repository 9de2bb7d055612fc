// SPDX-License-Identifier: Apache-2.0
#include "app/plot/film/film_picture.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace campanel::plot {

namespace {

constexpr double maxBags = 12; // visible; more cannot be distinguished
constexpr double bagsWithoutSensor = 4;
constexpr double bagsBehindSensor = 1.1; // visible, for the expected mark
constexpr double shareAfterKnife = 0.1;  // of the width
constexpr double periodS = 0.1;
constexpr double anyBagMm = 250; // for the scale while the bag length is unknown

double steadySeconds()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace

FilmPicture::FilmPicture(QQuickItem* parent)
    : QQuickPaintedItem(parent)
    , m_clock(&steadySeconds)
{
    connect(this, &FilmPicture::filmChanged, this, &FilmPicture::noteFilm);
    connect(this, &FilmPicture::scaleChanged, this, &FilmPicture::updateAll);
    connect(this, &FilmPicture::styleChanged, this, &FilmPicture::updateAll);
}

// Schedules one update: the properties of a report arrive one by one and are applied together before the next
// frame.
void FilmPicture::noteFilm()
{
    m_isReportNew = true;
    polish();
    // Film that moves is painted by advance().
    const bool isMoving = m_isLive && !m_isStale && m_speedMmPerS != 0;
    if (!isMoving || isDue())
        updateAll();
}

void FilmPicture::takeReport()
{
    if (!std::exchange(m_isReportNew, false))
        return;
    if (std::isnan(m_positionMm))
        m_motion.forget();
    else
        m_motion.report(m_positionMm, m_speedMmPerS, m_clock());
}

// Returns true when the last picture is old enough: a person who reads the film sees no more of them.
bool FilmPicture::isDue() const
{
    return m_clock() - m_paintedS >= periodS;
}

bool FilmPicture::advance()
{
    const bool isPainted = isVisible() && !m_isStale && isDue() && travelledMm() != m_paintedMm;
    if (isPainted)
        updateAll();
    return isPainted;
}

void FilmPicture::geometryChange(const QRectF& newGeometry, const QRectF& oldGeometry)
{
    QQuickPaintedItem::geometryChange(newGeometry, oldGeometry);
    updateAll();
}

double FilmPicture::travelledMm() const
{
    return m_isLive ? m_motion.travelledMm(m_clock()) : 0;
}

double FilmPicture::reachMm() const
{
    if (!(m_bagMm > 0) && !m_cuts.isEmpty())
        return std::ranges::max(m_cuts, {}, &QPointF::x).x();
    const double bagMm = m_bagMm > 0 ? m_bagMm : anyBagMm;
    if (!(m_sensorMm > 0))
        return bagsWithoutSensor * bagMm;
    return std::min(m_sensorMm + bagsBehindSensor * bagMm, maxBags * bagMm);
}

double FilmPicture::knifeX() const
{
    return width() * (1 - shareAfterKnife);
}

double FilmPicture::pxPerMm() const
{
    return knifeX() / reachMm();
}

double FilmPicture::xOf(double distanceMm) const
{
    return knifeX() - (distanceMm - travelledMm()) * pxPerMm();
}

} // namespace campanel::plot
