// SPDX-License-Identifier: Apache-2.0
// The summary of many values: count, mean, scatter, limits. In whole thousandths, so that sums are exact and
// independent of their order.
#pragma once

#include <QtGlobal>

namespace campanel::store {

// The unit: lengths and rates are stored as whole micrometers and thousandths of a bag per minute.
inline constexpr double thousandthsPerUnit = 1000;

// The quantities; their numbers are stored in the database.
enum class TrendQuantity { BagLength, Deviation, MarkError, FollowingError, Rate, Latency, JamResidue };
inline constexpr int trendQuantities = 7; // at most 8: see trend_schema.cpp

struct TrendBucket {
    qint64 count = 0;
    qint64 sum = 0;     // thousandths of the quantity's unit
    qint64 squares = 0; // sum of their squares
    qint64 low = 0;
    qint64 high = 0;
    qint64 within = 0; // values within the tolerance at their time

    void add(double value, bool isWithin);
    void merge(const TrendBucket& other);
    [[nodiscard]] bool isEmpty() const { return count == 0; }
    // Returns the mean in the quantity's unit; NaN when it is empty.
    [[nodiscard]] double mean() const;
    [[nodiscard]] double lowest() const;
    [[nodiscard]] double highest() const;

    bool operator==(const TrendBucket&) const = default;
};

// The statistics of any number of buckets, even if their sums would overflow.
class TrendStatistics {
public:
    void add(const TrendBucket& bucket);

    [[nodiscard]] double count() const { return m_count; }
    [[nodiscard]] double mean() const;
    [[nodiscard]] double deviation() const; // standard deviation; NaN below two values
    [[nodiscard]] double lowest() const;
    [[nodiscard]] double highest() const;
    [[nodiscard]] double shareWithin() const; // 0..1

private:
    double m_count = 0;
    double m_mean = 0;
    double m_squares = 0; // squares of the differences from the mean
    double m_low = 0;
    double m_high = 0;
    double m_within = 0;
};

} // namespace campanel::store
