// SPDX-License-Identifier: Apache-2.0
#include "app/machine/bag_statistics.h"

#include <cmath>
#include <numeric>
#include <utility>

namespace campanel::machine {

namespace {

double mean(const QList<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

} // namespace

bool BagStatistics::note(std::uint32_t bagCount, std::optional<double> lengthMm,
                         std::optional<double> deviationMm)
{
    if (m_bagCount == bagCount)
        return false;
    if (m_bagCount && bagCount < *m_bagCount)
        restart(); // so did the controller
    m_bagCount = bagCount;
    if (!lengthMm || !deviationMm)
        return true;
    m_lengthMm = *lengthMm;
    if (std::exchange(m_isNextOfTwoLengths, false))
        return true;
    m_setLengthMm = *lengthMm - *deviationMm;
    m_deviationsMm << *deviationMm;
    if (m_deviationsMm.size() > bagsKept)
        m_deviationsMm.removeFirst();
    return true;
}

void BagStatistics::restart()
{
    m_isNextOfTwoLengths = true;
    m_deviationsMm.clear();
}

double BagStatistics::meanMm() const
{
    return m_deviationsMm.isEmpty() ? unknown : m_setLengthMm + mean(m_deviationsMm);
}

double BagStatistics::scatterMm() const
{
    if (m_deviationsMm.size() < 2)
        return unknown;
    const double center = mean(m_deviationsMm);
    const double squares = std::accumulate(
        m_deviationsMm.begin(), m_deviationsMm.end(), 0.0,
        [center](double sum, double value) { return sum + (value - center) * (value - center); });
    return std::sqrt(squares / static_cast<double>(m_deviationsMm.size() - 1));
}

} // namespace campanel::machine
