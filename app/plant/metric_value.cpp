// SPDX-License-Identifier: Apache-2.0
#include "app/plant/metric_value.h"

#include <cmath>
#include <limits>

namespace campanel::plant {

namespace {

bool isWithin(const MetricValue& value, std::int64_t lowest, std::int64_t highest)
{
    const auto* number = std::get_if<std::int64_t>(&value);
    return number && *number >= lowest && *number <= highest;
}

double numberOf(const MetricValue& value)
{
    if (const auto* whole = std::get_if<std::int64_t>(&value))
        return static_cast<double>(*whole);
    const auto* number = std::get_if<double>(&value);
    return number ? *number : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

bool isOfType(const MetricValue& value, MetricType type)
{
    if (!isKnown(value))
        return true;
    switch (type) {
    case MetricType::Int32:
        return isWithin(value, std::numeric_limits<std::int32_t>::min(),
                        std::numeric_limits<std::int32_t>::max());
    case MetricType::Int64:
        return std::holds_alternative<std::int64_t>(value);
    case MetricType::Double:
        return std::holds_alternative<double>(value) && std::isfinite(std::get<double>(value));
    case MetricType::Boolean:
        return std::holds_alternative<bool>(value);
    case MetricType::String:
        break;
    }
    return std::holds_alternative<QString>(value);
}

bool isChange(const MetricRow& row, const MetricValue& before, const MetricValue& now)
{
    if (before == now)
        return false;
    if (row.deadBand <= 0 || before.index() != now.index())
        return true;
    return std::abs(numberOf(now) - numberOf(before)) >= row.deadBand;
}

} // namespace campanel::plant
