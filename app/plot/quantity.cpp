// SPDX-License-Identifier: Apache-2.0
#include "app/plot/quantity.h"

#include "profile/cutter/sampling.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace campanel::plot {

namespace {

struct QuantityRow {
    const char* name;
    std::vector<double> profile::Curves::*values;
    double displayFactor;
    double minimumSpan;
};

// The rows in the order of the enum.
constexpr std::array<QuantityRow, 6> rows{{
    {"position", &profile::Curves::positionMm, 1.0, 1e-3},
    {"velocity", &profile::Curves::velocityMmPerS, 1.0, 1e-2},
    {"acceleration", &profile::Curves::accelerationMmPerS2, 1e-3, 1e-3},
    {"jerk", &profile::Curves::jerkMmPerS3, 1e-3, 1e-2},
    {"frequency", &profile::Curves::frequencyHz, 1e-3, 1e-3},
    {"torque", &profile::Curves::torqueNm, 1.0, 1e-4},
}};

const QuantityRow& rowOf(Quantity quantity)
{
    return rows[static_cast<std::size_t>(quantity)];
}

} // namespace

std::optional<Quantity> quantityByName(const QString& name)
{
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (name == QLatin1StringView(rows[i].name)) {
            return static_cast<Quantity>(i);
        }
    }
    return std::nullopt;
}

double displayFactor(Quantity quantity)
{
    return rowOf(quantity).displayFactor;
}

double minimumSpan(Quantity quantity)
{
    return rowOf(quantity).minimumSpan;
}

CurveSet curveSetFrom(const QVariant& value)
{
    auto curves = value.value<CurveSet>();
    if (!curves || curves->timeS.size() < 2) {
        return nullptr;
    }
    const bool complete = std::ranges::all_of(rows, [&](const QuantityRow& row) {
        const auto& values = (*curves).*row.values;
        return values.size() == curves->timeS.size() ||
               (row.values == &profile::Curves::torqueNm && values.empty());
    });
    return complete ? curves : nullptr;
}

std::span<const double> timesOf(const CurveSet& curves)
{
    return curves ? std::span<const double>(curves->timeS) : std::span<const double>();
}

std::span<const double> valuesOf(const CurveSet& curves, Quantity quantity)
{
    return curves ? std::span<const double>((*curves).*rowOf(quantity).values) : std::span<const double>();
}

double valueAt(const CurveSet& curves, Quantity quantity, double timeS)
{
    const std::span<const double> times = timesOf(curves);
    const std::span<const double> values = valuesOf(curves, quantity);
    if (times.empty() || values.empty() || !(timeS >= times.front()) || !(timeS <= times.back())) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double factor = displayFactor(quantity);
    const auto next = std::ranges::upper_bound(times, timeS);
    if (next == times.end()) {
        return values.back() * factor;
    }
    // upper_bound: times[i - 1] <= timeS < times[i], so that a joint of two points gives the value after it.
    const auto i = static_cast<std::size_t>(next - times.begin());
    const double share = (timeS - times[i - 1]) / (times[i] - times[i - 1]);
    return factor * (values[i - 1] + share * (values[i] - values[i - 1]));
}

} // namespace campanel::plot
