// SPDX-License-Identifier: Apache-2.0
// Finds the real roots of a polynomial within an interval. Internal to profile/.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace campanel::profile::detail {

// Coefficients from the constant one up.
using Polynomial = std::vector<double>;

[[nodiscard]] inline double valueAt(const Polynomial& p, double x)
{
    double value = 0;
    for (auto c = p.rbegin(); c != p.rend(); ++c)
        value = value * x + *c;
    return value;
}

[[nodiscard]] inline Polynomial product(const Polynomial& a, const Polynomial& b)
{
    Polynomial result(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t k = 0; k < b.size(); ++k)
            result[i + k] += a[i] * b[k];
    }
    return result;
}

// Returns the roots between low and high at which the sign changes, ascending. Between two turning points,
// the roots of the derivative, there is one at most.
[[nodiscard]] inline std::vector<double> realRoots(const Polynomial& p, double low, double high)
{
    std::vector<double> roots;
    if (p.size() < 2)
        return roots;
    Polynomial derivative;
    for (std::size_t i = 1; i < p.size(); ++i)
        derivative.push_back(static_cast<double>(i) * p[i]);
    std::vector<double> edges = realRoots(derivative, low, high);
    edges.insert(edges.begin(), low);
    edges.push_back(high);
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        double from = edges[i];
        double to = edges[i + 1];
        const bool isPositive = valueAt(p, from) > 0;
        if ((valueAt(p, to) > 0) == isPositive)
            continue;
        constexpr int halvings = 100;
        for (int k = 0; k < halvings; ++k) {
            const double middle = (from + to) / 2;
            ((valueAt(p, middle) > 0) == isPositive ? from : to) = middle;
        }
        roots.push_back(to);
    }
    return roots;
}

} // namespace campanel::profile::detail
