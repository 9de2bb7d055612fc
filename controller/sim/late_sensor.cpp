// SPDX-License-Identifier: Apache-2.0
#include "late_sensor.h"

#include <algorithm>

namespace campanel::controller {
namespace {

constexpr double sPerMs = 1e-3;

} // namespace

LateSensor::LateSensor(const SensorOptions& options, std::uint64_t seed)
    : m_options(options)
    , m_random(seed)
{
}

double LateSensor::delayS(bool on)
{
    double delayMs = m_options.delayMs + (on ? 0.0 : m_options.offLaterMs);
    if (m_options.scatterMs > 0.0)
        delayMs += m_options.scatterMs * m_normal(m_random);
    return std::max(0.0, delayMs) * sPerMs;
}

void LateSensor::advance(double stepS, double before, double now)
{
    const double way = now - before;
    for (const Edge& passed : m_passed) {
        const double share = way > 0.0 ? std::clamp((passed.position - before) / way, 0.0, 1.0) : 1.0;
        const double delay = delayS(passed.on);
        if (delay == 0.0 && m_pending.empty()) { // as it passed, to the last bit
            m_edges.push_back(passed);
            continue;
        }
        m_lastDueS = std::max(m_lastDueS, m_timeS + share * stepS + delay);
        m_pending.push_back({m_lastDueS, passed.on});
    }
    m_passed.clear();
    while (!m_pending.empty() && m_pending.front().dueS <= m_timeS + stepS) {
        const Pending& pending = m_pending.front();
        const double share = std::clamp((pending.dueS - m_timeS) / stepS, 0.0, 1.0);
        m_edges.push_back({before + share * way, pending.on});
        m_pending.pop_front();
    }
    m_timeS += stepS;
}

bool LateSensor::take(Edge& edge)
{
    if (m_edges.empty())
        return false;
    edge = m_edges.front();
    m_edges.pop_front();
    return true;
}

} // namespace campanel::controller
