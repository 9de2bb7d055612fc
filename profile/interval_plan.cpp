// SPDX-License-Identifier: Apache-2.0
#include "profile/interval_plan.h"

#include "profile/interval_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace campanel::profile::detail {

namespace {

constexpr std::size_t beamWidth = 12;
constexpr double fewPulses = 64;
constexpr std::size_t checksPerRow = 24;
constexpr double mostLateShare = 0.001;
constexpr double leastSpeedShare = 1.0 / 64; // of the tolerance

// The row that leads here, and where it ended.
struct Node {
    IntervalRow row;
    std::int64_t pulses = 0;
    std::uint32_t speed = 0;
    std::uint64_t iterations = 0;
    std::uint64_t rest = 0;
    std::size_t parent = 0;
    double lateShare = 0; // of the last row's time, by the rounding of its registers
    double aside = 0;     // how far the rows up to here have left the lines
};

// An end of a line, with the pulses up to there and the slopes of the lines that meet there.
struct Target {
    double timeS = 0;
    double speedHz = 0;
    double pulses = 0;
    double slopeIn = 0;
    double slopeOut = 0;
};

std::vector<Target> targets(const std::vector<PathPoint>& lines)
{
    const auto slope = [&](std::size_t i) {
        return (lines[i + 1].speedHz - lines[i].speedHz) / (lines[i + 1].timeS - lines[i].timeS);
    };
    std::vector<Target> result;
    double pulses = 0;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        pulses += (lines[k].speedHz + lines[k - 1].speedHz) / 2 * (lines[k].timeS - lines[k - 1].timeS);
        const double in = slope(k - 1);
        result.push_back(
            {lines[k].timeS, lines[k].speedHz, pulses, in, k + 1 < lines.size() ? slope(k) : in});
    }
    return result;
}

// Of the acceleration. Rounded up, the last speed is reached within the row, which its follower needs;
// rounded down, the last pulse comes before it.
enum class Rounding { Up, Down };

// Rows with whole pulses beside given lines.
class RowSearch {
public:
    RowSearch(const SpeedCurve& curve, const PlanRules& rules, double leastHz)
        : m_curve(curve)
        , m_rules(rules)
        , m_leastHz(leastHz)
        , m_unitsPerHz(std::ldexp(rules.iterationS, accumulatorBits + rules.fractionBits))
    {
    }

    // Is there a row of one pulse at the beginning? The first pulse of a longer one would be such a row.
    bool canBegin() const;
    std::optional<std::vector<IntervalRow>> along(const std::vector<PathPoint>& lines) const;

private:
    std::vector<Node> starts(double speedHz) const;
    std::vector<Node> followers(const Node& from, const Target& target) const;
    std::vector<Node> endings(const Node& from, const Target& target) const;
    double meetingHz(const Node& from, std::int64_t pulses, const Target& target, double slope) const;
    std::optional<Node> follow(const Node& from, std::int64_t pulses, double lastHz,
                               Rounding rounding = Rounding::Up) const;
    bool staysNear(double fromS, double firstHz, double rampS, double lastHz, double endS) const;
    double secondsAt(const Node& node) const
    {
        return static_cast<double>(node.iterations) * m_rules.iterationS;
    }
    double hertz(std::uint32_t speed) const { return speed / m_unitsPerHz; }
    std::uint32_t units(double hz) const
    {
        const double most = std::floor(m_rules.maxSpeedHz * m_unitsPerHz);
        return static_cast<std::uint32_t>(
            std::clamp(std::round(hz * m_unitsPerHz), 1.0, std::max(1.0, most)));
    }

    const SpeedCurve& m_curve;
    PlanRules m_rules;
    double m_leastHz;
    double m_unitsPerHz;
};

bool RowSearch::staysNear(double fromS, double firstHz, double rampS, double lastHz, double endS) const
{
    const auto isNear = [&](double timeS, double curveHz) {
        const double speedHz =
            timeS - fromS >= rampS ? lastHz : firstHz + (lastHz - firstHz) * (timeS - fromS) / rampS;
        return std::abs(curveHz - speedHz) <= m_rules.toleranceHz;
    };
    for (const double timeS : {fromS, fromS + rampS, endS}) {
        if (!isNear(timeS, m_curve.speedAt(timeS)))
            return false;
    }
    const std::vector<CurveSample>& samples = m_curve.samples();
    const std::size_t first = m_curve.indexAt(fromS) + 1;
    const std::size_t end = m_curve.indexAt(endS) + 1;
    const std::size_t stride = first < end ? 1 + (end - first) / checksPerRow : 1;
    for (std::size_t i = first; i < end; i += stride) {
        if (!isNear(samples[i].timeS, samples[i].speedHz))
            return false;
    }
    return std::ranges::all_of(m_curve.joints(), [&](std::size_t joint) {
        return joint <= first || joint >= end ||
               (isNear(samples[joint].timeS, samples[joint].speedHz) &&
                isNear(samples[joint].timeS, samples[joint - 1].speedHz));
    });
}

// The row goes evenly from the speed that it finds to lastHz; the time that this takes with whole pulses is
// its own.
std::optional<Node> RowSearch::follow(const Node& from, std::int64_t pulses, double lastHz,
                                      Rounding rounding) const
{
    if (pulses <= from.pulses || pulses > m_curve.wholePulses() || !(lastHz >= m_leastHz))
        return std::nullopt;
    const std::uint32_t speed = units(lastHz);
    const double fromS = secondsAt(from);
    const double firstHz = hertz(from.speed);
    const auto distance = static_cast<double>(pulses - from.pulses);
    const double rampS = 2 * distance / (firstHz + hertz(speed));
    if (!staysNear(fromS, firstHz, rampS, hertz(speed), fromS + rampS))
        return std::nullopt;
    const double change = std::abs(static_cast<double>(speed) - static_cast<double>(from.speed));
    const double exact = std::ldexp(change * m_rules.iterationS / rampS, accumulatorBits);
    const double acceleration =
        rounding == Rounding::Up ? std::ceil(exact) : std::max(1.0, std::floor(exact));
    if (acceleration > std::numeric_limits<std::uint32_t>::max() ||
        distance > std::numeric_limits<std::uint32_t>::max())
        return std::nullopt;

    Node node;
    node.row = {static_cast<std::uint32_t>(pulses - from.pulses), from.speed, speed,
                static_cast<std::uint32_t>(acceleration)};
    const RowEnd end = rowEnd(node.row, from.rest, m_rules.fractionBits);
    node.pulses = pulses;
    node.speed = speed;
    node.iterations = from.iterations + end.iterations;
    node.rest = end.rest;
    node.lateShare = static_cast<double>(end.iterations) * m_rules.iterationS / rampS - 1;
    return node;
}

// From rest the first speed is free within the tolerance.
std::vector<Node> RowSearch::starts(double speedHz) const
{
    constexpr int choices = 8;
    std::vector<Node> result(1);
    result.front().speed = units(speedHz);
    if (m_curve.samples().front().speedHz > m_leastHz)
        return result;
    for (int i = 0; i <= choices; ++i) {
        const double hz = std::max(m_leastHz, m_rules.toleranceHz * i / choices);
        Node start;
        start.speed = units(hz);
        start.aside = std::pow((hz - speedHz) / m_rules.toleranceHz, 2);
        result.push_back(start);
    }
    return result;
}

bool RowSearch::canBegin() const
{
    constexpr int choices = 16;
    const double curveHz = m_curve.speedAt(m_curve.timeAt(1));
    for (const Node& start : starts(m_curve.samples().front().speedHz)) {
        for (int i = -choices; i <= choices; ++i) {
            if (follow(start, 1, curveHz + m_rules.toleranceHz * i / choices))
                return true;
        }
    }
    return false;
}

// Last speeds of a row over so many pulses that meet the line of a slope through the target.
double RowSearch::meetingHz(const Node& from, std::int64_t pulses, const Target& target, double slope) const
{
    const double firstHz = hertz(from.speed);
    const double sum = firstHz + target.speedHz + slope * (secondsAt(from) - target.timeS);
    const double root = sum * sum + 8 * slope * static_cast<double>(pulses - from.pulses);
    return (sum + std::sqrt(std::max(0.0, root))) / 2 - firstHz;
}

std::vector<Node> RowSearch::followers(const Node& from, const Target& target) const
{
    std::vector<Node> result;
    const auto add = [&](std::int64_t pulses, double lastHz) {
        auto node = follow(from, pulses, lastHz);
        // Rounding must not leave a part of a pulse to a slow end.
        if (!node || node->lateShare > mostLateShare)
            return;
        const double lateS = secondsAt(*node) - target.timeS;
        const double aboveHz =
            hertz(node->speed) - target.speedHz - lateS * (target.slopeIn + target.slopeOut) / 2;
        const double aheadPulses =
            static_cast<double>(pulses) - lateS * (target.speedHz + hertz(node->speed)) / 2 - target.pulses;
        node->aside = from.aside + std::pow(aboveHz / m_rules.toleranceHz, 2) + aheadPulses * aheadPulses;
        result.push_back(*node);
    };
    const auto nearest = std::llround(target.pulses);
    for (const std::int64_t pulses : {nearest, nearest - 1, nearest + 1}) {
        for (const double slope : {(target.slopeIn + target.slopeOut) / 2, target.slopeIn, target.slopeOut})
            add(pulses, meetingHz(from, pulses, target, slope));
        if (target.pulses - static_cast<double>(from.pulses) > fewPulses)
            continue;
        // Rows of few pulses leave the lines by more than a step in time.
        const double middleHz = meetingHz(from, pulses, target, (target.slopeIn + target.slopeOut) / 2);
        for (const double share : {-0.8, -0.6, -0.4, -0.2, 0.2, 0.4, 0.6, 0.8})
            add(pulses, middleHz + share * m_rules.toleranceHz);
    }
    return result;
}

// The last row ends on time, or at its speed on time to half a pulse.
std::vector<Node> RowSearch::endings(const Node& from, const Target& target) const
{
    constexpr double leastPulses = 0.5;
    const std::int64_t pulses = m_curve.wholePulses();
    const auto distance = static_cast<double>(pulses - from.pulses);
    const double timeS = target.timeS - secondsAt(from);
    const double onTimeHz = 2 * distance / timeS - hertz(from.speed);
    // The registers' units leave so many pulses to the slow end of the row.
    const double acceleration = std::abs(hertz(from.speed) - target.speedHz) / timeS;
    const double unitHzPerS = 1 / (std::ldexp(m_rules.iterationS, accumulatorBits) * m_unitsPerHz);
    const double leftPulses = timeS / m_unitsPerHz / 2 + distance * unitHzPerS / acceleration;
    const double unitS = acceleration > 0 ? std::sqrt(2 * leftPulses / acceleration) : 0;
    const double mostLateS = std::max({timeS * mostLateShare, timeS * leastPulses / distance, unitS});
    std::vector<double> speeds{target.speedHz};
    if (m_curve.samples().back().speedHz <= m_leastHz) {
        speeds.push_back(onTimeHz);
        for (double speed = m_leastHz; speed <= m_rules.toleranceHz; speed *= 1.5)
            speeds.push_back(speed);
    }
    std::vector<Node> result;
    for (const double speed : speeds) {
        for (const Rounding rounding : {Rounding::Up, Rounding::Down}) {
            auto node = follow(from, pulses, speed, rounding);
            if (!node)
                continue;
            const double lateS = secondsAt(*node) - target.timeS;
            if (std::abs(lateS) > mostLateS)
                continue;
            node->aside = from.aside + std::pow(lateS / (timeS * mostLateShare), 2);
            result.push_back(*node);
        }
    }
    return result;
}

std::optional<std::vector<IntervalRow>> RowSearch::along(const std::vector<PathPoint>& lines) const
{
    std::vector<Node> nodes = starts(lines.front().speedHz); // parents before their followers
    const std::size_t startCount = nodes.size();
    std::vector<std::size_t> level(startCount);
    std::iota(level.begin(), level.end(), std::size_t{0});
    for (const Target& target : targets(lines)) {
        const bool isLast = target.timeS >= lines.back().timeS;
        std::vector<Node> next;
        for (const std::size_t i : level) {
            for (Node node : isLast ? endings(nodes[i], target) : followers(nodes[i], target)) {
                node.parent = i;
                next.push_back(node);
            }
        }
        std::ranges::stable_sort(next, {}, &Node::aside);
        next.resize(std::min(next.size(), beamWidth));
        level.clear();
        for (const Node& node : next) {
            level.push_back(nodes.size());
            nodes.push_back(node);
        }
    }
    if (level.empty())
        return std::nullopt;
    std::vector<IntervalRow> result;
    for (std::size_t i = level.front(); i >= startCount; i = nodes[i].parent)
        result.push_back(nodes[i].row);
    std::ranges::reverse(result);
    return result;
}

} // namespace

std::optional<IntervalPlan> planRows(const SpeedCurve& curve, const PlanRules& rules, std::size_t mostRows)
{
    const double leastHz = leastSpeedShare * rules.toleranceHz;
    IntervalLines lines(curve, {rules.toleranceHz, leastHz, rules.maxSpeedHz});
    const RowSearch search(curve, rules, leastHz);
    const std::size_t fewest = search.canBegin() ? lines.fewest(mostRows) : 0;
    if (fewest == 0)
        return std::nullopt;
    const std::size_t most = std::min(mostRows, fewest + fewest / 4 + 3);
    constexpr std::array evennesses{1.0, 0.75, 0.5, 0.25, 0.0};
    for (std::size_t count = fewest; count <= most; ++count) {
        for (const double evenness : evennesses) {
            for (const LastLink last : {LastLink::LeastTurn, LastLink::Middle}) {
                const auto knots = lines.find(count, evenness, last);
                auto rows = knots ? search.along(*knots) : std::nullopt;
                if (rows)
                    return IntervalPlan{std::move(*rows), fewest};
            }
        }
    }
    return std::nullopt;
}

} // namespace campanel::profile::detail
