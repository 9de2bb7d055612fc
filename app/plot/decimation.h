// SPDX-License-Identifier: Apache-2.0
// Reduces a sampled curve to what a screen can show without losing a peak.
#pragma once

#include <QPolygonF>

#include <span>

namespace campanel::plot {

// No curve is drawn with more points than this: twice the pixels of the widest screen we serve would not be
// told apart.
inline constexpr qsizetype maximumDrawnPoints = 1000;

// The points (x, y * yFactor), x not descending, with at most maximumPoints (at least 4) of them: the first
// and the last one stay, and of each of the equal stretches between them the lowest and the highest. Points
// that are not finite are left out, and so are those inside a level stretch.
[[nodiscard]] QPolygonF decimate(std::span<const double> x, std::span<const double> y,
                                 qsizetype maximumPoints, double yFactor = 1.0);

} // namespace campanel::plot
