// SPDX-License-Identifier: Apache-2.0
#include "app/machine/actual_trace.h"

#include <algorithm>

namespace campanel::machine {

namespace {

bool isLeftOf(const QPointF& point, double x)
{
    return point.x() < x;
}

} // namespace

void ActualTrace::add(const Sample& sample, double durationS)
{
    const std::uint32_t cycles = sample.cycle - m_last.cycle;
    const bool isWholeCycle = cycles > 1 || (cycles == 1 && sample.share > m_last.share);
    if (isWholeCycle)
        m_points.clear();
    // Closer points than a curve can show take each other's place.
    const double step = durationS / mostPoints;
    const double x = sample.share * durationS;
    const double last = m_last.share * durationS;
    if (cycles == 0) {
        erase(last + (x > last + step ? step / 2 : -step), x + step / 2);
    } else {
        erase(last + step / 2, durationS + step);
        erase(-step, x + step / 2);
    }
    const auto place = std::lower_bound(m_points.begin(), m_points.end(), x, isLeftOf);
    m_points.insert(place, QPointF(x, sample.value));
    m_last = sample;
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
    m_last = {};
}

} // namespace campanel::machine
