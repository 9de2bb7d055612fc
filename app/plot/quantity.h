// SPDX-License-Identifier: Apache-2.0
// The quantities of a panel, and the conversion from an opaque QML value to the sampled curves of profile/.
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

enum class Quantity : quint8 { Position, Velocity, Acceleration, Jerk, Frequency, Torque };

// Returns the quantity "position", "velocity", "acceleration", "jerk", "frequency" or "torque"; nothing for
// any other name.
[[nodiscard]] std::optional<Quantity> quantityByName(const QString& name);

// Returns the factor displayed = sampled * displayFactor. Curves are in mm, s, Hz and Nm; displayed units are
// mm, mm/s, m/s2, m/s3, kHz and Nm.
[[nodiscard]] double displayFactor(Quantity quantity);

// Returns the difference (in the displayed unit) below which a curve counts as constant, because of rounding.
[[nodiscard]] double minimumSpan(Quantity quantity);

using CurveSet = std::shared_ptr<const profile::Curves>;

// Returns null without a valid curve set: at least two points and arrays of equal length. The torque may be
// missing.
[[nodiscard]] CurveSet curveSetFrom(const QVariant& value);

// Returns an empty span for a null set. The span is valid during the lifetime of the set.
[[nodiscard]] std::span<const double> timesOf(const CurveSet& curves);
[[nodiscard]] std::span<const double> valuesOf(const CurveSet& curves, Quantity quantity);

// Returns the sampled value at a time, interpolated, in the displayed unit; NaN outside the curve or without
// one.
[[nodiscard]] double valueAt(const CurveSet& curves, Quantity quantity, double timeS);

} // namespace campanel::plot
