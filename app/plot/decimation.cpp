// SPDX-License-Identifier: Apache-2.0
#include "app/plot/decimation.h"

#include <algorithm>
#include <cmath>

namespace campanel::plot {

namespace {

constexpr double levelShare = 1e-9; // share of the value up to which heights are equal

// Returns true when the last point is between two of the same height. A level stretch drawn in pieces would
// look like beads, because the antialiased ends of the pieces overlap.
bool isInsideLevelStretch(const QPolygonF& points, const QPointF& next)
{
    const qsizetype count = points.size();
    const auto sameHeight = [](double a, double b) {
        return std::abs(a - b) <= levelShare * std::max(std::abs(a), std::abs(b));
    };
    return count >= 2 && sameHeight(points[count - 1].y(), points[count - 2].y()) &&
           sameHeight(points[count - 1].y(), next.y());
}

QPolygonF finitePoints(std::span<const double> x, std::span<const double> y, double yFactor)
{
    const std::size_t count = std::min(x.size(), y.size());
    QPolygonF points;
    points.reserve(static_cast<qsizetype>(count));
    for (std::size_t i = 0; i < count; ++i) {
        if (!std::isfinite(x[i]) || !std::isfinite(y[i])) {
            continue;
        }
        const QPointF point(x[i], y[i] * yFactor);
        if (isInsideLevelStretch(points, point)) {
            points.last() = point;
        } else {
            points.append(point);
        }
    }
    return points;
}

} // namespace

QPolygonF decimate(std::span<const double> x, std::span<const double> y, qsizetype maximumPoints,
                   double yFactor)
{
    const QPolygonF points = finitePoints(x, y, yFactor);
    if (points.size() <= maximumPoints) {
        return points;
    }
    const qsizetype inner = points.size() - 2;
    const qsizetype stretches = std::max<qsizetype>(1, (maximumPoints - 2) / 2);
    QPolygonF reduced;
    reduced.reserve(2 * stretches + 2);
    reduced.append(points.first());
    for (qsizetype k = 0; k < stretches; ++k) {
        const auto begin = points.cbegin() + 1 + k * inner / stretches;
        const auto end = points.cbegin() + 1 + (k + 1) * inner / stretches;
        const auto lessY = [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); };
        const auto [lowest, highest] = std::minmax_element(begin, end, lessY);
        reduced.append(*std::min(lowest, highest));
        if (lowest != highest) {
            reduced.append(*std::max(lowest, highest));
        }
    }
    reduced.append(points.last());
    return reduced;
}

} // namespace campanel::plot
