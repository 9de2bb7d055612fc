// SPDX-License-Identifier: Apache-2.0
// What a panel can show, and the way from an opaque QML value to the sampled curves of profile/.
#pragma once

#include <QString>
#include <QVariant>

#include <memory>
#include <optional>
#include <span>

namespace campanel::profile {
struct Curves;
}

namespace campanel::plot {

enum class Quantity : quint8 { Position, Velocity, Acceleration, Jerk, Frequency };

// "position", "velocity", "acceleration", "jerk", "frequency"; nothing for any other name.
[[nodiscard]] std::optional<Quantity> quantityByName(const QString& name);

// Curves come in mm, s and Hz; on screen they are mm, mm/s, m/s2, m/s3 and kHz. shown = sampled *
// displayFactor.
[[nodiscard]] double displayFactor(Quantity quantity);

// Differences below this (in the unit on screen) are rounding noise of a constant.
[[nodiscard]] double minimumSpan(Quantity quantity);

using CurveSet = std::shared_ptr<const profile::Curves>;

// Null if the value holds no curve set, or one without at least two points or with arrays of unequal length.
[[nodiscard]] CurveSet curveSetFrom(const QVariant& value);

// Empty for a null set. The span lives as long as the set.
[[nodiscard]] std::span<const double> timesOf(const CurveSet& curves);
[[nodiscard]] std::span<const double> valuesOf(const CurveSet& curves, Quantity quantity);

// The sampled value at a time, interpolated, in the unit on screen; NaN outside of the curve or without one.
[[nodiscard]] double valueAt(const CurveSet& curves, Quantity quantity, double timeS);

} // namespace campanel::plot
