// SPDX-License-Identifier: Apache-2.0
// Dead time = difference of the mean places / difference of the mean speeds, at the slowest and the fastest
// speed; its variance is that of the two means over the square of the difference. The edges of a speed are
// few, so that no number of scattered products gives a small margin. Edges of two parts would give any dead
// time at all: what lies elsewhere at the same speed, scatters otherwise, or was long ago is another part.
#include "app/program/eye_dead_time.h"

#include "app/program/dead_time_estimate.h"

#include <algorithm>
#include <cmath>

namespace campanel::program {

namespace {

constexpr double stepsPerPitch = 65536.0;
constexpr double msPerS = 1000.0;
constexpr std::size_t edgesOfASpeed = 30;
constexpr std::size_t minEdges = 10;
constexpr std::size_t maxSpeeds = 8;
constexpr double sameSpeed = 0.05;   // share by which the edges of one speed differ
constexpr double steadySpeed = 0.02; // and those of one part, which pass shortly after one another
constexpr double samePlace = 0.02;   // share of the pitch within which one part is seen at one speed
constexpr double likeScatter = 25.0; // ratio of the variances at two speeds
constexpr double stepVariance = 1.0 / stepsPerPitch / stepsPerPitch;
constexpr std::uint32_t longAgo = 2000; // edges

struct Mean {
    double speed = 0.0;
    double place = 0.0;    // pitches, from a reference
    double variance = 0.0; // of an edge
    double count = 0.0;

    [[nodiscard]] double placeVariance() const { return variance / count; }
};

// The place goes round; no edge is farther than half a pitch from the others.
double placeFrom(std::uint16_t place, std::uint16_t reference)
{
    return static_cast<std::int16_t>(place - reference) / stepsPerPitch;
}

template <class Edges> Mean meanOf(const Edges& edges, std::uint16_t reference)
{
    const auto count = static_cast<double>(edges.size());
    Mean mean;
    mean.count = count;
    for (const auto& seen : edges) {
        mean.speed += seen.speed / count;
        mean.place += placeFrom(seen.place, reference) / count;
    }
    for (const auto& seen : edges) {
        const double off = placeFrom(seen.place, reference) - mean.place;
        mean.variance += off * off / (count - 1);
    }
    return mean;
}

bool isNear(double speed, double other, double share)
{
    return std::abs(speed - other) <= share * other;
}

} // namespace

void EyeDeadTime::take(const modbus::EyeEdge& edge)
{
    if (m_last && edge.number <= m_last->number)
        *this = {}; // the controller was restarted: it counts from another place
    const bool isSteady = m_last && edge.speed > 0 && isNear(edge.speed, m_last->speed, steadySpeed);
    m_last = edge;
    if (!isSteady)
        return;
    // As seen without compensation.
    const double lateSteps = edge.deadMs / msPerS * edge.speed * stepsPerPitch;
    const auto place = static_cast<std::uint16_t>(static_cast<std::uint32_t>(edge.place) +
                                                  static_cast<std::uint32_t>(std::lround(lateSteps)));
    add(m_speeds[edge.begins ? Begin : End], {edge.number, place, edge.speed});
}

void EyeDeadTime::add(Speeds& speeds, const Seen& seen)
{
    const auto same = std::ranges::find_if(
        speeds, [&seen](const Speed& speed) { return isNear(seen.speed, speed.front().speed, sameSpeed); });
    if (same == speeds.end() || std::abs(placeFrom(seen.place, same->back().place)) > samePlace) {
        if (same != speeds.end())
            m_speeds = {};
        else if (speeds.size() == maxSpeeds)
            speeds.erase(speeds.begin());
        speeds.push_back({seen});
        return;
    }
    same->push_back(seen);
    if (same->size() > edgesOfASpeed)
        same->pop_front();
}

std::optional<EyeDelay> EyeDeadTime::measured(Edge edge) const
{
    std::vector<Mean> means;
    std::optional<std::uint16_t> reference;
    for (const Speed& speed : m_speeds[edge]) {
        if (speed.size() < minEdges || m_last->number - speed.back().number > longAgo)
            continue;
        if (!reference)
            reference = speed.back().place;
        means.push_back(meanOf(speed, *reference));
    }
    if (means.size() < 2)
        return std::nullopt;
    const auto [slow, fast] = std::ranges::minmax_element(means, {}, &Mean::speed);
    const auto [calm, wild] = std::minmax(fast->variance, slow->variance);
    const double apart = fast->speed - slow->speed;
    const EyeDelay delay{msPerS * (fast->place - slow->place) / apart,
                         msPerS * std::sqrt(fast->placeVariance() + slow->placeVariance()) / apart};
    const bool isOnePart =
        wild <= likeScatter * (calm + stepVariance) && std::abs(delay.ms) <= maxDeadTimeMs + delay.marginMs;
    return isOnePart ? std::optional(delay) : std::nullopt;
}

std::optional<double> EyeDeadTime::offered(Edge edge, double presentMs) const
{
    const auto found = measured(edge);
    const bool isGood = found && found->marginMs <= maxMarginMs;
    return isGood ? offeredMs(found->ms, found->marginMs, presentMs) : std::nullopt;
}

} // namespace campanel::program
