// SPDX-License-Identifier: Apache-2.0
// Sums over the iterations of the accumulators. Each is limited by the row's distance, so that it fits 64
// bits.
#include "profile/intervals/interval_row.h"

#include "profile/model/bounds.h"

#include <cmath>
#include <utility>

namespace campanel::profile::detail {

namespace {

// Returns the sum of floor((first + step * i) / 2^23) over i = 0 .. count - 1, by Euclid's algorithm.
std::uint64_t floorSum(std::uint64_t count, std::uint64_t step, std::uint64_t first)
{
    std::uint64_t modulus = std::uint64_t{1} << accumulatorBits;
    std::uint64_t sum = 0;
    while (count != 0) {
        const std::uint64_t pairs = count % 2 == 0 ? count / 2 * (count - 1) : (count - 1) / 2 * count;
        sum += pairs * (step / modulus) + count * (first / modulus);
        step %= modulus;
        const std::uint64_t top = step * count + first % modulus;
        first = top % modulus;
        count = top / modulus;
        std::swap(step, modulus);
    }
    return sum;
}

std::uint64_t change(const IntervalRow& row)
{
    return row.firstSpeed > row.lastSpeed ? row.firstSpeed - row.lastSpeed : row.lastSpeed - row.firstSpeed;
}

// Returns the solution in real numbers: it differs from the exact one by a few iterations.
double estimatedEnd(const IntervalRow& row, double distance)
{
    const double first = row.firstSpeed;
    const double last = row.lastSpeed;
    const auto ramp = static_cast<double>(rampIterations(row));
    const double rampDistance = (first + last) / 2 * ramp;
    if (distance >= rampDistance)
        return ramp + (distance - rampDistance) / last;
    const double rate = (last - first) / ramp;
    return 2 * distance / (first + std::sqrt(maxOf(0.0, first * first + 2 * rate * distance)));
}

} // namespace

std::uint64_t rampIterations(const IntervalRow& row)
{
    if (row.firstSpeed == row.lastSpeed)
        return 0;
    return ((change(row) << accumulatorBits) + row.acceleration - 1) / row.acceleration;
}

std::uint64_t positionAfter(const IntervalRow& row, std::uint64_t rest, std::uint64_t iterations)
{
    const std::uint64_t ramp = rampIterations(row);
    const std::uint64_t rising = ramp > iterations ? iterations : (ramp == 0 ? 0 : ramp - 1);
    const std::uint64_t steps = floorSum(rising, row.acceleration, row.acceleration);
    const std::uint64_t even = rest + rising * row.firstSpeed + (iterations - rising) * row.lastSpeed;
    return row.lastSpeed > row.firstSpeed ? even + steps : even - steps;
}

RowEnd rowEnd(const IntervalRow& row, std::uint64_t rest, int fractionBits)
{
    const std::uint64_t target = std::uint64_t{row.pulses} << (accumulatorBits + fractionBits);
    const auto isReached = [&](std::uint64_t iterations) {
        return positionAfter(row, rest, iterations) >= target;
    };
    // A bracket around the estimate, widened until it contains the end.
    const auto estimate = static_cast<std::uint64_t>(estimatedEnd(row, static_cast<double>(target - rest)));
    std::uint64_t width = 4;
    std::uint64_t low = estimate;
    while (low > 0 && isReached(low)) {
        low -= minOf(low, width);
        width *= 4;
    }
    std::uint64_t end = low + width;
    while (!isReached(end)) {
        low = end;
        width *= 4;
        end += width;
    }
    while (end - low > 1) {
        const std::uint64_t middle = low + (end - low) / 2;
        (isReached(middle) ? end : low) = middle;
    }
    return {end, positionAfter(row, rest, end) - target};
}

} // namespace campanel::profile::detail
