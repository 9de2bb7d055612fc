// SPDX-License-Identifier: Apache-2.0
// The touch gestures of TrendPlot; a mouse counts as a finger.
#include "app/plot/trend_plot.h"

#include <QGuiApplication>
#include <QMouseEvent>
#include <QStyleHints>
#include <QTouchEvent>

#include <algorithm>

namespace campanel::plot {

namespace {

constexpr int holdMs = 500; // unless the platform has a smaller value

QList<double> placesOf(const QTouchEvent& event, double left)
{
    QList<double> x;
    for (const QEventPoint& point : event.points()) {
        if (point.state() != QEventPoint::Released && x.size() < 2)
            x << point.position().x() - left;
    }
    return x;
}

} // namespace

void TrendPlot::touchEvent(QTouchEvent* event)
{
    const QList<double> x = placesOf(*event, plotArea().left());
    const bool areOthers = event->touchPointStates() & (QEventPoint::Pressed | QEventPoint::Released);
    if (x.isEmpty())
        liftLast(m_pressX);
    else if (areOthers)
        putFingers(x, event->points().first().position().y());
    else
        moveFingers(x);
    setKeepTouchGrab(true);
    event->accept();
}

void TrendPlot::mousePressEvent(QMouseEvent* event)
{
    setKeepMouseGrab(true);
    putFingers({event->position().x() - plotArea().left()}, event->position().y());
}

void TrendPlot::mouseMoveEvent(QMouseEvent* event)
{
    moveFingers({event->position().x() - plotArea().left()});
}

void TrendPlot::mouseReleaseEvent(QMouseEvent* event)
{
    liftLast(event->position().x() - plotArea().left());
}

void TrendPlot::putFingers(const QList<double>& x, double y)
{
    m_gesture.begin(x, {m_fromMs, m_toMs}, plotArea().width());
    m_pressX = x.first();
    m_pressY = y;
    m_wereTwoFingers = m_wereTwoFingers || x.size() > 1;
    if (!m_wereTwoFingers && !m_isPointing && !m_isDone)
        m_holdTimer.start(std::min(holdMs, QGuiApplication::styleHints()->mousePressAndHoldInterval()));
    else
        m_holdTimer.stop();
}

void TrendPlot::moveFingers(const QList<double>& x)
{
    if (m_isDone)
        return;
    if (m_isPointing) {
        m_pressX = std::clamp(x.first(), 0.0, plotArea().width());
        pointCursor();
        return;
    }
    const WindowGesture::Window wanted = m_gesture.moved(x);
    if (!m_gesture.hasMoved())
        return;
    m_holdTimer.stop();
    emit windowWanted(wanted.fromMs, wanted.toMs);
}

void TrendPlot::liftLast(double x)
{
    const bool isTap = m_holdTimer.isActive() && !m_gesture.hasMoved();
    m_pressX = std::clamp(x, 0.0, plotArea().width());
    endGesture();
    if (isTap)
        emit cursorWanted(timeOfX(m_pressX + m_area.left()));
}

void TrendPlot::endGesture()
{
    m_holdTimer.stop();
    m_isPointing = false;
    m_isDone = false;
    m_wereTwoFingers = false;
}

void TrendPlot::takeHold()
{
    const int lane = headerAt(m_pressY);
    if (lane < 0)
        return pointCursor();
    m_isDone = true;
    emit headerHeld(lane);
}

int TrendPlot::headerAt(double y)
{
    ensureLayout();
    for (std::size_t i = 0; i < m_lanes.size(); ++i) {
        const double below = y - laneTop(static_cast<int>(i));
        if (below >= 0 && below < m_headerReach)
            return static_cast<int>(i);
    }
    return -1;
}

// Moves the cursor with a held finger.
void TrendPlot::pointCursor()
{
    m_isPointing = true;
    emit cursorWanted(timeOfX(m_pressX + plotArea().left()));
}

} // namespace campanel::plot
