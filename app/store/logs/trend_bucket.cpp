// SPDX-License-Identifier: Apache-2.0
#include "app/store/logs/trend_bucket.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace campanel::store {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
// The maximum: ten meters in micrometers. Larger values are impossible, and their squares would overflow.
constexpr qint64 largest = 10'000'000;

} // namespace

void TrendBucket::add(double value, bool isWithin)
{
    const qint64 whole = std::clamp<qint64>(std::llround(value * thousandthsPerUnit), -largest, largest);
    merge({1, whole, whole * whole, whole, whole, isWithin ? 1 : 0});
}

void TrendBucket::merge(const TrendBucket& other)
{
    if (other.isEmpty())
        return;
    low = isEmpty() ? other.low : std::min(low, other.low);
    high = isEmpty() ? other.high : std::max(high, other.high);
    count += other.count;
    sum += other.sum;
    squares += other.squares;
    within += other.within;
}

double TrendBucket::mean() const
{
    return isEmpty() ? unknown : static_cast<double>(sum) / static_cast<double>(count) / thousandthsPerUnit;
}

double TrendBucket::lowest() const
{
    return isEmpty() ? unknown : static_cast<double>(low) / thousandthsPerUnit;
}

double TrendBucket::highest() const
{
    return isEmpty() ? unknown : static_cast<double>(high) / thousandthsPerUnit;
}

// Joins two parts by the difference of their means (Chan, Golub, LeVeque).
void TrendStatistics::add(const TrendBucket& bucket)
{
    if (bucket.isEmpty())
        return;
    const auto count = static_cast<double>(bucket.count);
    const double mean = bucket.mean();
    // count * squares - sum^2 may overflow 64 bits, unless it is computed relative to a value near the mean.
    const qint64 shift = bucket.sum / bucket.count;
    const auto near =
        static_cast<double>(bucket.squares - 2 * shift * bucket.sum + bucket.count * shift * shift);
    const auto rest = static_cast<double>(bucket.sum - bucket.count * shift);
    const double squares = (near - rest * rest / count) / (thousandthsPerUnit * thousandthsPerUnit);
    const double apart = mean - m_mean;
    const double all = m_count + count;
    m_low = m_count > 0 ? std::min(m_low, bucket.lowest()) : bucket.lowest();
    m_high = m_count > 0 ? std::max(m_high, bucket.highest()) : bucket.highest();
    m_squares += squares + apart * apart * m_count * count / all;
    m_mean += apart * count / all;
    m_count = all;
    m_within += static_cast<double>(bucket.within);
}

double TrendStatistics::mean() const
{
    return m_count > 0 ? m_mean : unknown;
}

double TrendStatistics::deviation() const
{
    return m_count > 1 ? std::sqrt(std::max(0.0, m_squares) / (m_count - 1)) : unknown;
}

double TrendStatistics::lowest() const
{
    return m_count > 0 ? m_low : unknown;
}

double TrendStatistics::highest() const
{
    return m_count > 0 ? m_high : unknown;
}

double TrendStatistics::shareWithin() const
{
    return m_count > 0 ? m_within / m_count : unknown;
}

} // namespace campanel::store
