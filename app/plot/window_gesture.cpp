// SPDX-License-Identifier: Apache-2.0
#include "app/plot/window_gesture.h"

#include <algorithm>
#include <cmath>

namespace campanel::plot {

namespace {

constexpr double minApartPx = 24; // a smaller distance between fingers would zoom without limit

} // namespace

void WindowGesture::begin(const QList<double>& fingersPx, const Window& window, double widthPx)
{
    m_fingersPx = fingersPx.first(std::min<qsizetype>(2, fingersPx.size()));
    std::ranges::sort(m_fingersPx);
    m_window = window;
    m_widthPx = std::max(1.0, widthPx);
    m_hasMoved = m_fingersPx.size() > 1;
}

double WindowGesture::timeAt(double px) const
{
    return m_window.fromMs + (m_window.toMs - m_window.fromMs) * px / m_widthPx;
}

WindowGesture::Window WindowGesture::moved(const QList<double>& fingersPx)
{
    if (fingersPx.isEmpty() || fingersPx.size() != m_fingersPx.size())
        return m_window;
    QList<double> now = fingersPx;
    std::ranges::sort(now);
    m_hasMoved = m_hasMoved || std::abs(now.first() - m_fingersPx.first()) > slopPx;
    if (!m_hasMoved)
        return m_window;
    if (now.size() == 1) {
        const double shift = timeAt(m_fingersPx[0]) - timeAt(now[0]);
        return {m_window.fromMs + shift, m_window.toMs + shift};
    }
    const double msPerPx =
        (timeAt(m_fingersPx[1]) - timeAt(m_fingersPx[0])) / std::max(minApartPx, now[1] - now[0]);
    const double from = timeAt(m_fingersPx[0]) - msPerPx * now[0];
    return {from, from + msPerPx * m_widthPx};
}

} // namespace campanel::plot
