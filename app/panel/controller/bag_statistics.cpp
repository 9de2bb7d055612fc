// SPDX-License-Identifier: Apache-2.0
#include "app/panel/controller/bag_statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace campanel::panel {

bool BagStatistics::note(std::uint32_t bagCount, std::optional<double> lengthMm,
                         std::optional<double> deviationMm)
{
    if (m_bagCount == bagCount)
        return false;
    if (m_bagCount && bagCount < *m_bagCount)
        restart(true); // the controller restarted the count
    else if (m_bagCount && bagCount > *m_bagCount + 1)
        noteGap();
    m_bagCount = bagCount;
    if (!lengthMm || !deviationMm)
        return true;
    m_lengthMm = *lengthMm;
    count(*deviationMm, *lengthMm - *deviationMm);
    return true;
}

void BagStatistics::note(const modbus::BagRecord& bag, double setLengthMm)
{
    m_lengths = std::max(1, bag.lengths);
    m_lengthMm = m_lengths * setLengthMm + bag.deviationMm;
    m_isRecorded = true;
    m_isLastScrap = bag.isScrap();
    if (m_isLastScrap) {
        m_isNextOfTwoLengths = false;
        ++m_scrap;
        return;
    }
    count(std::isfinite(setLengthMm) ? bag.deviationMm : unknown, setLengthMm);
}

bool BagStatistics::noteLength(std::optional<double> lengthMm)
{
    if (m_isRecorded || !lengthMm || m_lengthMm == *lengthMm)
        return false;
    m_lengthMm = *lengthMm;
    return true;
}

void BagStatistics::count(double deviationMm, double setLengthMm)
{
    if (std::exchange(m_isNextOfTwoLengths, false) || !std::isfinite(deviationMm))
        return;
    m_setLengthMm = setLengthMm;
    m_deviationsMm << deviationMm;
    m_series << deviationMm;
    if (m_deviationsMm.size() <= bagsKept)
        return;
    m_deviationsMm.removeFirst();
    do
        m_series.removeFirst();
    while (std::isnan(m_series.first()));
}

void BagStatistics::noteGap()
{
    if (!m_series.isEmpty() && std::isfinite(m_series.last()))
        m_series << unknown;
}

void BagStatistics::restart(bool isNextOfTwo)
{
    m_isNextOfTwoLengths = isNextOfTwo;
    m_scrap = 0;
    m_deviationsMm.clear();
    m_series.clear();
}

double BagStatistics::meanMm() const
{
    return m_setLengthMm + meanDeviationMm();
}

double BagStatistics::meanDeviationMm() const
{
    return mean(m_deviationsMm);
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

int BagStatistics::countWithin(double toleranceMm) const
{
    return static_cast<int>(std::ranges::count_if(
        m_deviationsMm, [toleranceMm](double deviation) { return std::abs(deviation) <= toleranceMm; }));
}

} // namespace campanel::panel
