// SPDX-License-Identifier: Apache-2.0
// The value of a metric, and one reading of it. A value that is not known, or not fresh, is empty.
#pragma once

#include "app/plant/metric_table.h"

#include <QString>

#include <cstdint>
#include <variant>

namespace campanel::plant {

using MetricValue = std::variant<std::monostate, bool, std::int64_t, double, QString>;

[[nodiscard]] inline bool isKnown(const MetricValue& value)
{
    return !std::holds_alternative<std::monostate>(value);
}

// Returns true when the value may stand for a metric of this type: empty, or of its form and range.
[[nodiscard]] bool isOfType(const MetricValue& value, MetricType type);

// Returns true when the change is to be sent: one of the values is unknown and the other one is not, or they
// differ by the dead band or more.
[[nodiscard]] bool isChange(const MetricRow& row, const MetricValue& before, const MetricValue& now);

struct MetricReading {
    Metric metric{};
    MetricValue value;
    std::int64_t ageMs = 0; // since the value was measured

    bool operator==(const MetricReading&) const = default;
};

} // namespace campanel::plant
