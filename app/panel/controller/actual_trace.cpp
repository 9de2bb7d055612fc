// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/actual_trace.h"

#include <algorithm>

namespace campanel::panel {

namespace {

bool isLeftOf(const QPointF& point, double x)
{
    return point.x() < x;
}

} // namespace

void ActualTrace::add(const Sample& sample, double durationS)
{
    const std::uint32_t cycles = sample.cycle - m_pen.cycle;
    const bool missedACycle = cycles > 1 || (cycles == 1 && sample.share > m_pen.share);
    const double step = durationS / maxPoints; // closer points cannot be distinguished
    const double pen = m_pen.share * durationS;
    const double x = sample.share * durationS;
    if (missedACycle) {
        m_points.clear();
    } else if (cycles == 1) {
        erase(pen + step / 2, durationS + step);
        erase(0, x + step / 2);
    } else {
        if (x < pen + step && !m_points.isEmpty())
            return;
        erase(pen + step / 2, x + step / 2);
    }
    const auto place = std::lower_bound(m_points.begin(), m_points.end(), x, isLeftOf);
    m_points.insert(place, QPointF(x, sample.value));
    m_pen = sample;
}

void ActualTrace::erase(double after, double upTo)
{
    const auto first = std::lower_bound(m_points.begin(), m_points.end(), after, isLeftOf);
    const auto last = std::lower_bound(first, m_points.end(), upTo, isLeftOf);
    m_points.erase(first, last);
}

void ActualTrace::clear()
{
    m_points.clear();
    m_pen = {};
}

} // namespace campanel::panel
