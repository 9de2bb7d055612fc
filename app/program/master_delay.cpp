// SPDX-License-Identifier: Apache-2.0
// Least squares: slope = Sxy / Sxx; its variance is the sum of the squared residuals / (n - 2) / Sxx. Lags
// come in steps of 0.001 mm: equal ones have at least the variance of that step.
#include "app/program/master_delay.h"

#include <algorithm>
#include <cmath>

namespace campanel::program {

namespace {

constexpr std::size_t maxCuts = 400;
constexpr double oneSpeed = 0.05; // share by which the cuts of one speed differ
constexpr double delayMaxMs = 50.0;
constexpr double delayStepMs = 0.001;
constexpr double lagStepMm = 0.001;
constexpr double lagStepVariance = lagStepMm * lagStepMm / 12.0;
constexpr double msOfS = 1000.0;

} // namespace

void MasterDelay::add(double speedMmPerS, double lagMm)
{
    if (!(speedMmPerS > 0))
        return;
    m_cuts.push_back({speedMmPerS, lagMm});
    if (m_cuts.size() > maxCuts)
        m_cuts.pop_front();
}

bool MasterDelay::hasOneSpeed() const
{
    if (m_cuts.empty())
        return false;
    const double slowest = std::ranges::min(m_cuts, {}, &Cut::speed).speed;
    return std::ranges::count_if(m_cuts, [slowest](const Cut& cut) {
               return cut.speed <= slowest * (1 + oneSpeed);
           }) >= minCuts;
}

std::optional<MasterDelay::Delay> MasterDelay::measured() const
{
    if (!hasOneSpeed())
        return std::nullopt;
    const auto [slow, fast] = std::ranges::minmax(m_cuts, {}, &Cut::speed);
    const auto fastCuts = std::ranges::count_if(
        m_cuts, [fast = fast.speed](const Cut& cut) { return cut.speed >= fast * (1 - oneSpeed); });
    if (fast.speed < minRatio * slow.speed || fastCuts < minCuts)
        return std::nullopt;
    const auto count = static_cast<double>(m_cuts.size());
    Cut mean;
    for (const Cut& cut : m_cuts) {
        mean.speed += cut.speed / count;
        mean.lag += cut.lag / count;
    }
    double sxx = 0.0;
    double sxy = 0.0;
    for (const Cut& cut : m_cuts) {
        sxx += (cut.speed - mean.speed) * (cut.speed - mean.speed);
        sxy += (cut.speed - mean.speed) * (cut.lag - mean.lag);
    }
    const double slope = sxy / sxx;
    double squares = 0.0;
    for (const Cut& cut : m_cuts) {
        const double off = cut.lag - mean.lag - slope * (cut.speed - mean.speed);
        squares += off * off;
    }
    const double variance = std::max(squares / (count - 2), lagStepVariance);
    return Delay{msOfS * slope, msOfS * std::sqrt(variance / sxx)};
}

std::optional<double> MasterDelay::offered(double presentMs) const
{
    const auto found = measured();
    if (!found || found->marginMs > maxMarginMs)
        return std::nullopt;
    const double wanted = std::clamp(presentMs + found->ms, 0.0, delayMaxMs);
    if (std::abs(wanted - presentMs) <= std::max(found->marginMs, delayStepMs))
        return std::nullopt;
    return std::round(wanted / delayStepMs) * delayStepMs;
}

} // namespace campanel::program
