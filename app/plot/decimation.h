// SPDX-License-Identifier: Apache-2.0
// Reduces a sampled curve to the points that a screen can display, without losing a peak.
#pragma once

#include <QPolygonF>

#include <span>

namespace campanel::plot {

// The maximum number of points of a curve: twice the pixels of the widest supported screen could not be
// distinguished.
inline constexpr qsizetype maximumDrawnPoints = 1000;

// Returns at most maximumPoints (at least 4) of the points (x, y * yFactor), with x not descending. Keeps the
// first and the last point, and the lowest and highest of each equal section between them. Omits points that
// are not finite or inside a level section.
[[nodiscard]] QPolygonF decimate(std::span<const double> x, std::span<const double> y,
                                 qsizetype maximumPoints, double yFactor = 1.0);

} // namespace campanel::plot
