// SPDX-License-Identifier: Apache-2.0
#include "app/program/knife_places.h"

#include <algorithm>
#include <cmath>

namespace campanel::program {

void KnifePlaces::begin(int knives)
{
    m_sums.assign(static_cast<std::size_t>(std::max(0, knives)), Sum());
}

void KnifePlaces::take(int knife, double deviationMm)
{
    if (knife < 1 || knife > knives())
        return;
    Sum& sum = m_sums[static_cast<std::size_t>(knife - 1)];
    ++sum.bags;
    sum.mm += deviationMm;
    sum.squares += deviationMm * deviationMm;
}

// With the mean d of a knife's bags and the mean m of all knives, the place of knife k is the sum of d - m
// over the knives 2..k. Its variance is that of the sum of k - 1 of n means around their mean.
std::optional<KnifePlace> KnifePlaces::place(int knife) const
{
    if (knife < 2 || knife > knives() ||
        std::ranges::any_of(m_sums, [](const Sum& sum) { return sum.bags < minBags; }))
        return std::nullopt;
    double mean = 0.0;
    double variance = 0.0; // of one knife's mean
    for (const Sum& sum : m_sums) {
        const double ofKnife = sum.mm / sum.bags;
        mean += ofKnife / knives();
        variance += (sum.squares / sum.bags - ofKnife * ofKnife) / sum.bags / knives();
    }
    KnifePlace place;
    for (int k = 1; k < knife; ++k)
        place.mm += m_sums[static_cast<std::size_t>(k)].mm / m_sums[static_cast<std::size_t>(k)].bags - mean;
    const double share = static_cast<double>(knife - 1) / knives();
    place.marginMm = std::sqrt(std::max(0.0, variance) * knives() * share * (1.0 - share));
    return place;
}

std::optional<double> KnifePlaces::offered(int knife, double presentMm) const
{
    const auto found = place(knife);
    if (!found || std::abs(found->mm) < std::max(leastMm, 2.0 * found->marginMm))
        return std::nullopt;
    return std::round((presentMm + found->mm) * 1000.0) / 1000.0;
}

} // namespace campanel::program
