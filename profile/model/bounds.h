// SPDX-License-Identifier: Apache-2.0
// Minimum, maximum and clamped value. Those of the standard library drop a NaN or keep it by the order of
// their arguments, and a limit or an error is lost. Here the result is NaN, and a build with tests aborts.
#pragma once

#include <algorithm>
#include <concepts>
#include <limits>

namespace campanel::profile {
namespace detail {

// Aborts in a build with tests; does nothing in an installed program.
void reportNan();

constexpr bool isNan(double x)
{
    return !(x <= 0) && !(x > 0);
}

// Returns true without a report when no argument is NaN.
constexpr bool areNumbers(double a, double b)
{
    if (!isNan(a) && !isNan(b)) [[likely]]
        return true;
    reportNan();
    return false;
}

} // namespace detail

[[nodiscard]] constexpr double minOf(double a, double b)
{
    return detail::areNumbers(a, b) ? std::min(a, b) : std::numeric_limits<double>::quiet_NaN();
}
[[nodiscard]] constexpr double maxOf(double a, double b)
{
    return detail::areNumbers(a, b) ? std::max(a, b) : std::numeric_limits<double>::quiet_NaN();
}
template <std::integral T> [[nodiscard]] constexpr T minOf(T a, T b)
{
    return std::min(a, b);
}
template <std::integral T> [[nodiscard]] constexpr T maxOf(T a, T b)
{
    return std::max(a, b);
}
template <typename... More> [[nodiscard]] constexpr double minOf(double a, double b, double c, More... more)
{
    return minOf(minOf(a, b), c, more...);
}
template <typename... More> [[nodiscard]] constexpr double maxOf(double a, double b, double c, More... more)
{
    return maxOf(maxOf(a, b), c, more...);
}

// Return the value within low and high; low where rounding has crossed these.
[[nodiscard]] constexpr double clamped(double x, double low, double high)
{
    return maxOf(minOf(x, high), low);
}
template <std::integral T> [[nodiscard]] constexpr T clamped(T x, T low, T high)
{
    return maxOf(minOf(x, high), low);
}

// Raises the largest magnitude so far, and sets its time. Returns false when the candidate is not larger by
// more than this share.
constexpr bool raise(double& largest, double& largestTimeS, double candidate, double timeS, double share = 0)
{
    const double magnitude = candidate < 0 ? -candidate : candidate;
    if (detail::areNumbers(magnitude, largest) && magnitude <= largest * (1 + share))
        return false;
    largest = maxOf(magnitude, largest);
    largestTimeS = timeS;
    return true;
}

// The smallest and the largest of some values.
struct Extent {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();

    constexpr void add(double value)
    {
        min = minOf(min, value);
        max = maxOf(max, value);
    }
    [[nodiscard]] constexpr double span() const { return max - min; }
};

// Returns the nearest whole number. NaN and whatever an int may not hold become a number beyond every field.
[[nodiscard]] int wholeOf(double value);

} // namespace campanel::profile
