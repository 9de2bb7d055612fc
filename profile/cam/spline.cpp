// SPDX-License-Identifier: Apache-2.0
// The slopes m solve, at every inner knot,
//   m[i-1] / h[i-1] + 2 m[i] (1 / h[i-1] + 1 / h[i]) + m[i+1] / h[i] = 3 (d[i-1] / h[i-1] + d[i] / h[i])
// with h the widths and d the slopes of the chords. The system is tridiagonal and diagonally dominant. The
// periodic one closes in a ring: it is opened at the first knot, whose slope is the last unknown.
#include "profile/cam/spline.h"

#include <algorithm>
#include <cstddef>

namespace campanel::profile {
namespace {

// The equation of one knot, before m[i-1] is eliminated.
struct Row {
    double before = 0;
    double diagonal = 0;
    double after = 0;
    double right = 0;
};

// An empty x stands for 0, 1, 2, ...
enum class Spacing { Given, Unit };

template <Spacing spacing> class KnotRows {
public:
    KnotRows(std::span<const double> x, std::span<const double> y)
        : m_x(x)
        , m_y(y)
    {
    }

    [[nodiscard]] std::size_t last() const { return m_y.size() - 1; }
    [[nodiscard]] double inverseWidth(std::size_t i) const
    {
        if constexpr (spacing == Spacing::Unit)
            return 1;
        else
            return 1 / (m_x[i + 1] - m_x[i]);
    }
    [[nodiscard]] double chord(std::size_t i) const { return (m_y[i + 1] - m_y[i]) * inverseWidth(i); }

    [[nodiscard]] Row between(std::size_t left, std::size_t right) const
    {
        const double p = inverseWidth(left);
        const double q = inverseWidth(right);
        return {p, 2 * (p + q), q,
                3 * ((m_y[left + 1] - m_y[left]) * p * p + (m_y[right + 1] - m_y[right]) * q * q)};
    }

    // Return the equations of the first and the last knot of a spline that is not periodic.
    [[nodiscard]] Row first(SplineEnds ends, const EndSlopes& slopes) const
    {
        return ends == SplineEnds::Clamped ? Row{0, 1, 0, slopes.start} : Row{0, 2, 1, 3 * chord(0)};
    }
    [[nodiscard]] Row final(SplineEnds ends, const EndSlopes& slopes) const
    {
        return ends == SplineEnds::Clamped ? Row{0, 1, 0, slopes.end} : Row{1, 2, 0, 3 * chord(last() - 1)};
    }

private:
    std::span<const double> m_x;
    std::span<const double> m_y;
};

// Returns true when the pivots have settled. With unit spacing the inner equations are equal, and after about
// thirty of them so are their pivots, to the last bit: no further division is needed.
template <Spacing spacing> bool isSettled(const std::vector<double>& ratio, std::size_t i)
{
    return spacing == Spacing::Unit && i > 3 && ratio[i - 1] == ratio[i - 2];
}

template <Spacing spacing>
std::vector<double> openSlopes(const KnotRows<spacing>& knots, SplineEnds ends, const EndSlopes& clampedTo)
{
    const std::size_t last = knots.last();
    std::vector<double> slopes(last + 1);
    std::vector<double> ratio(last + 1); // m[i] = slopes[i] - ratio[i] m[i+1]
    double pivot = 0;
    for (std::size_t i = 0; i <= last; ++i) {
        const Row row = i == 0 ? knots.first(ends, clampedTo)
                               : (i == last ? knots.final(ends, clampedTo) : knots.between(i - 1, i));
        const double ratioBefore = i == 0 ? 0 : ratio[i - 1];
        const double slopeBefore = i == 0 ? 0 : slopes[i - 1];
        if (i == last || !isSettled<spacing>(ratio, i))
            pivot = 1 / (row.diagonal - row.before * ratioBefore);
        ratio[i] = row.after * pivot;
        slopes[i] = (row.right - row.before * slopeBefore) * pivot;
    }
    for (std::size_t i = last; i-- > 0;)
        slopes[i] -= ratio[i] * slopes[i + 1];
    return slopes;
}

// m[i] = slopes[i] + share[i] m[0] for the inner knots; the first knot's equation then gives m[0].
template <Spacing spacing> std::vector<double> periodicSlopes(const KnotRows<spacing>& knots)
{
    const std::size_t last = knots.last();
    std::vector<double> slopes(last + 1);
    std::vector<double> share(last + 1);
    std::vector<double> ratio(last + 1);
    share[0] = 1;
    share[last] = 1;
    double pivot = 0;
    for (std::size_t i = 1; i < last; ++i) {
        const Row row = knots.between(i - 1, i);
        if (!isSettled<spacing>(ratio, i))
            pivot = 1 / (row.diagonal - row.before * ratio[i - 1]);
        ratio[i] = row.after * pivot;
        slopes[i] = (row.right - row.before * slopes[i - 1]) * pivot;
        share[i] = -row.before * share[i - 1] * pivot;
    }
    for (std::size_t i = last; i-- > 1;) {
        slopes[i] -= ratio[i] * slopes[i + 1];
        share[i] -= ratio[i] * share[i + 1];
    }
    const Row wrap = knots.between(last - 1, 0);
    const double first = (wrap.right - wrap.before * slopes[last - 1] - wrap.after * slopes[1]) /
                         (wrap.diagonal + wrap.before * share[last - 1] + wrap.after * share[1]);
    for (std::size_t i = 0; i <= last; ++i)
        slopes[i] += share[i] * first;
    return slopes;
}

template <Spacing spacing>
std::vector<double> slopesOf(const KnotRows<spacing>& knots, SplineEnds ends, const EndSlopes& clampedTo)
{
    return ends == SplineEnds::Periodic ? periodicSlopes(knots) : openSlopes(knots, ends, clampedTo);
}

} // namespace

SplinePoint SplinePiece::at(double x) const
{
    const double d = x - start;
    return {at0.value + d * (at0.slope + d * (at0.curvature / 2 + d * at0.third / 6)),
            at0.slope + d * (at0.curvature + d * at0.third / 2), at0.curvature + d * at0.third, at0.third};
}

std::vector<double> splineSlopes(std::span<const double> x, std::span<const double> y, SplineEnds ends,
                                 EndSlopes clampedTo)
{
    return slopesOf(KnotRows<Spacing::Given>(x, y), ends, clampedTo);
}

std::vector<double> unitSplineSlopes(std::span<const double> y, SplineEnds ends, EndSlopes clampedTo)
{
    return slopesOf(KnotRows<Spacing::Unit>({}, y), ends, clampedTo);
}

Spline::Spline(std::span<const double> x, std::span<const double> y, SplineEnds ends, EndSlopes clampedTo)
{
    const std::vector<double> slopes = splineSlopes(x, y, ends, clampedTo);
    m_pieces.reserve(x.size() - 1);
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        const double width = x[i + 1] - x[i];
        const double chord = (y[i + 1] - y[i]) / width;
        m_pieces.push_back({x[i],
                            width,
                            {y[i], slopes[i], 2 * (3 * chord - 2 * slopes[i] - slopes[i + 1]) / width,
                             6 * (slopes[i] + slopes[i + 1] - 2 * chord) / (width * width)}});
    }
}

SplinePoint Spline::at(double x) const
{
    const auto next = std::upper_bound(m_pieces.begin() + 1, m_pieces.end(), x,
                                       [](double at, const SplinePiece& piece) { return at < piece.start; });
    return (next - 1)->at(x);
}

} // namespace campanel::profile
