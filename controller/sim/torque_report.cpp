// SPDX-License-Identifier: Apache-2.0
#include "torque_report.h"

#include <cmath>

namespace campanel::controller {
namespace {

constexpr double msPerS = 1000.0;
constexpr double halfAStep = 0.5; // times that are this near to a report belong to it

} // namespace

TorqueReport::TorqueReport(const ReportOptions& options, std::uint64_t seed)
    : m_options(options)
    , m_random(seed)
{
}

void TorqueReport::advance(double stepS, double percent)
{
    m_sinceS += stepS;
    const double everyS = m_options.everyMs / msPerS;
    if (m_sinceS + halfAStep * stepS < everyS)
        return;
    m_sinceS = std::fmod(m_sinceS, std::max(everyS, stepS));
    double measured = percent;
    if (m_options.noisePercent > 0.0)
        measured += std::normal_distribution<double>(0.0, m_options.noisePercent)(m_random);
    const double rounded = m_options.stepPercent * std::round(measured / m_options.stepPercent);
    m_percent = everyS > 0.0 ? m_taken : rounded;
    m_taken = rounded;
}

} // namespace campanel::controller
