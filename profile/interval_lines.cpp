// SPDX-License-Identifier: Apache-2.0
#include "profile/interval_lines.h"

#include <algorithm>
#include <cmath>

namespace campanel::profile::detail {

namespace {

constexpr double closeEnough = 0.02; // of the tolerance, by which lines may be raised without room for it

// Under the lines, as pulses.
double distance(const std::vector<PathPoint>& knots)
{
    double sum = 0;
    for (std::size_t i = 1; i < knots.size(); ++i)
        sum += (knots[i].speedHz + knots[i - 1].speedHz) / 2 * (knots[i].timeS - knots[i - 1].timeS);
    return sum;
}

// Raises all knots but the ends, which are the curve's, by what is missing.
std::vector<PathPoint> raised(std::vector<PathPoint> knots, double missingPulses, double leastHz)
{
    if (knots.size() < 3)
        return knots;
    const double firstS = knots[1].timeS - knots.front().timeS;
    const double lastS = knots.back().timeS - knots[knots.size() - 2].timeS;
    const double widthS = knots.back().timeS - knots.front().timeS - (firstS + lastS) / 2;
    for (std::size_t i = 1; i + 1 < knots.size(); ++i)
        knots[i].speedHz = std::max(leastHz, knots[i].speedHz + missingPulses / widthS);
    return knots;
}

} // namespace

IntervalLines::IntervalLines(const SpeedCurve& curve, const LineRules& rules)
    : m_curve(curve)
    , m_rules(rules)
    , m_channel(curve.samples().size())
{
}

void IntervalLines::lay(double errorHz, double evenness, double shiftHz)
{
    const std::vector<CurveSample>& samples = m_curve.samples();
    const double tolerance = m_rules.toleranceHz;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double speed = samples[i].speedHz;
        // Between its ends a line's mean error over a parabola is a third of its largest, towards the inside
        // of the bend.
        const double middle = speed + shiftHz - evenness * samples[i].bend * errorHz / 3;
        m_channel[i] = {samples[i].timeS, std::max({middle - errorHz, speed - tolerance, m_rules.leastHz}),
                        std::min({middle + errorHz, speed + tolerance, m_rules.mostHz})};
    }
    for (Gate* end : {&m_channel.front(), &m_channel.back()}) {
        const double speed = (end == &m_channel.front() ? samples.front() : samples.back()).speedHz;
        if (speed > m_rules.leastHz) // the motion's own, not stretched to whole pulses
            *end = {end->timeS, speed / m_curve.stretch(), speed / m_curve.stretch()};
    }
}

std::optional<std::vector<PathPoint>> IntervalLines::within(std::size_t lines, double errorHz,
                                                            double evenness, double shiftHz)
{
    lay(errorHz, evenness, shiftHz);
    return fewestLinks(m_channel, lines, m_last);
}

std::size_t IntervalLines::fewest(std::size_t mostLines)
{
    const auto knots = within(mostLines, m_rules.toleranceHz, 0, 0);
    return knots ? knots->size() - 1 : 0;
}

// The smallest error, by halving.
std::optional<IntervalLines::Tried> IntervalLines::tightest(std::size_t lines, double evenness,
                                                            double shiftHz)
{
    constexpr int halvings = 8;
    auto best = within(lines, m_rules.toleranceHz, evenness, shiftHz);
    if (!best)
        return std::nullopt;
    double low = 0;
    double high = m_rules.toleranceHz;
    for (int i = 0; i < halvings; ++i) {
        // The first try is whether the lines could follow the curve exactly.
        const double error = i == 0 ? high / 10000 : (low + high) / 2;
        if (auto better = within(lines, error, evenness, shiftHz)) {
            best = std::move(better);
            high = error;
        } else {
            low = error;
        }
    }
    const double missing = m_curve.samples().back().pulses - distance(*best);
    return Tried{std::move(*best), high, missing / m_curve.durationS()};
}

std::optional<std::vector<PathPoint>> IntervalLines::find(std::size_t lines, double evenness, LastLink last)
{
    m_last = last;
    constexpr int attempts = 6;
    double shift = 0;
    for (int i = 0; i < attempts; ++i) {
        auto tried = tightest(lines, evenness, shift);
        if (!tried)
            return std::nullopt;
        const double usedHz = tried->errorHz * (1 + evenness / 3) + std::abs(shift);
        if (std::abs(tried->missingHz) <=
            std::max(m_rules.toleranceHz - usedHz, closeEnough * m_rules.toleranceHz))
            return raised(std::move(tried->knots), tried->missingHz * m_curve.durationS(), m_rules.leastHz);
        shift = std::clamp(shift + tried->missingHz, -m_rules.toleranceHz, m_rules.toleranceHz);
    }
    return std::nullopt;
}

} // namespace campanel::profile::detail
