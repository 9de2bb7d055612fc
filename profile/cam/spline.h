// SPDX-License-Identifier: Apache-2.0
// Cubic splines through knots: twice continuously differentiable, computed in linear time. The ends are
// natural, clamped to given slopes, or periodic with a net advance per period (a progressive cam).
#pragma once

#include "profile/program/programs.h"

#include <span>
#include <vector>

namespace campanel::profile {

// The value and the first three derivatives. At a knot the third one is that of the piece to its right.
struct SplinePoint {
    double value = 0;
    double slope = 0;
    double curvature = 0;
    double third = 0;
};

// value + slope d + curvature d^2 / 2 + third d^3 / 6 with d = x - start, from start to start + width.
struct SplinePiece {
    double start = 0;
    double width = 0;
    SplinePoint at0;

    [[nodiscard]] double end() const { return start + width; }
    [[nodiscard]] SplinePoint at(double x) const;
};

// The slopes at both ends of a clamped spline.
struct EndSlopes {
    double start = 0;
    double end = 0;
};

// Returns the slopes at the knots that make the curve twice continuously differentiable. x is strictly
// ascending; x and y have the same size of at least 2. A periodic curve repeats with y.back() - y.front()
// added: its first and last slopes are equal, and so are its curvatures there. clampedTo is used by
// SplineEnds::Clamped only.
[[nodiscard]] std::vector<double> splineSlopes(std::span<const double> x, std::span<const double> y,
                                               SplineEnds ends, EndSlopes clampedTo = {});

// Returns the same for knots at x = 0, 1, 2, ...; faster.
[[nodiscard]] std::vector<double> unitSplineSlopes(std::span<const double> y, SplineEnds ends,
                                                   EndSlopes clampedTo = {});

class Spline {
public:
    // Builds the spline. The inputs are those of splineSlopes().
    Spline(std::span<const double> x, std::span<const double> y, SplineEnds ends, EndSlopes clampedTo = {});

    // Returns the point at x. Outside the knots the first or last piece continues.
    [[nodiscard]] SplinePoint at(double x) const;
    [[nodiscard]] std::span<const SplinePiece> pieces() const { return m_pieces; }

private:
    std::vector<SplinePiece> m_pieces;
};

} // namespace campanel::profile
