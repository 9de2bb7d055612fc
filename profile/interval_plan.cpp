// SPDX-License-Identifier: Apache-2.0
#include "profile/interval_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace campanel::profile::detail {

namespace {

constexpr std::size_t beamWidth = 5;
constexpr std::size_t checksPerRow = 24;
constexpr double leastMisfitPulses = 0.5;
constexpr double mostLateShare = 0.001;

// The row that leads here, and where it ended.
struct Node {
    IntervalRow row;
    std::int64_t pulses = 0;
    std::uint32_t speed = 0;
    std::uint64_t iterations = 0;
    std::uint64_t rest = 0;
    std::size_t parent = 0;
};

// Which last speed a row aims at.
enum class Aim { EvenTime, OnCurve, AboveCurve, BelowCurve };

// A row that keeps to the curve, before the accumulators are asked when it ends.
struct Fit {
    IntervalRow row;
    double endS = 0;
};

class Planner {
public:
    Planner(const SpeedCurve& curve, const PlanRules& rules)
        : m_curve(curve)
        , m_rules(rules)
        , m_bits(accumulatorBits + rules.fractionBits)
        , m_unitsPerHz(std::ldexp(rules.iterationS, m_bits))
    {
        for (const std::size_t joint : curve.joints())
            m_jointPulses.push_back(std::llround(curve.samples()[joint].pulses));
    }

    std::optional<std::vector<IntervalRow>> plan(std::size_t mostRows);

private:
    std::vector<Node> starts() const;
    std::vector<Node> followers(const Node& from) const;
    std::int64_t longest(const Node& from, Aim aim) const;
    std::optional<Fit> fit(const Node& from, std::int64_t to, Aim aim, double leastHz = 0) const;
    std::optional<Node> follow(const Node& from, std::int64_t to, Aim aim) const;
    std::optional<Node> finish(const Node& from, const Fit& fit) const;
    bool staysNear(double fromS, double firstHz, double rampS, double lastHz, double endS) const;
    bool isNear(const CurveSample& sample, double speedHz) const
    {
        return std::abs(sample.speedHz - speedHz) <= m_rules.toleranceHz;
    }
    double aimedHz(Aim aim, double evenHz, double curveHz) const
    {
        const double asideHz = 0.8 * m_rules.toleranceHz;
        switch (aim) {
        case Aim::EvenTime:
            return std::clamp(evenHz, curveHz - m_rules.toleranceHz, curveHz + m_rules.toleranceHz);
        case Aim::OnCurve:
            return curveHz;
        case Aim::AboveCurve:
            return curveHz + asideHz;
        case Aim::BelowCurve:
            return curveHz - asideHz;
        }
        return curveHz;
    }
    // A table's speeds are never zero.
    std::uint32_t speedUnits(double hz) const
    {
        const double most = std::floor(m_rules.maxSpeedHz * m_unitsPerHz);
        return static_cast<std::uint32_t>(
            std::clamp(std::round(hz * m_unitsPerHz), 1.0, std::max(1.0, most)));
    }

    const SpeedCurve& m_curve;
    PlanRules m_rules;
    int m_bits;
    double m_unitsPerHz;
    std::vector<std::int64_t> m_jointPulses;
};

std::vector<Node> Planner::starts() const
{
    std::vector<Node> result;
    for (const double share : {0.0, 1.0 / 64, 1.0 / 16, 0.25, 0.5, 1.0, -0.5, -1.0}) {
        Node start;
        start.speed = speedUnits(m_curve.samples().front().speedHz + share * m_rules.toleranceHz);
        if (std::ranges::find(result, start.speed, &Node::speed) == result.end())
            result.push_back(start);
    }
    return result;
}

bool Planner::staysNear(double fromS, double firstHz, double rampS, double lastHz, double endS) const
{
    const auto speedHz = [&](double timeS) {
        return timeS - fromS >= rampS ? lastHz : firstHz + (lastHz - firstHz) * (timeS - fromS) / rampS;
    };
    const auto isNearAt = [&](double timeS) {
        return std::abs(m_curve.speedAt(timeS) - speedHz(timeS)) <= m_rules.toleranceHz;
    };
    if (!isNearAt(endS) || !isNearAt(fromS) || !isNearAt(fromS + rampS))
        return false;
    const std::vector<CurveSample>& samples = m_curve.samples();
    const std::size_t first = m_curve.indexAt(fromS) + 1;
    const std::size_t end = m_curve.indexAt(endS) + 1;
    if (first < end && !isNear(samples[end - 1], speedHz(samples[end - 1].timeS)))
        return false;
    const std::size_t stride = first < end ? 1 + (end - first) / checksPerRow : 1;
    for (std::size_t i = first; i < end; i += stride) {
        if (!isNear(samples[i], speedHz(samples[i].timeS)))
            return false;
    }
    return std::ranges::all_of(m_curve.joints(), [&](std::size_t joint) {
        return joint <= first || joint >= end ||
               (isNear(samples[joint], speedHz(samples[joint].timeS)) &&
                isNear(samples[joint - 1], speedHz(samples[joint].timeS)));
    });
}

std::optional<Fit> Planner::fit(const Node& from, std::int64_t to, Aim aim, double leastHz) const
{
    const double fromS = static_cast<double>(from.iterations) * m_rules.iterationS;
    const double timeS = m_curve.timeAt(to) - fromS;
    if (timeS <= m_rules.iterationS)
        return std::nullopt;
    const auto pulses = static_cast<double>(to - from.pulses);
    const double firstHz = from.speed / m_unitsPerHz;
    const double meanHz = pulses / timeS;
    const double evenHz = 2 * meanHz - firstHz;
    const double curveHz = m_curve.speedAt(fromS + timeS);
    const double aimHz = aimedHz(aim, evenHz, curveHz);
    const std::uint32_t speed = speedUnits(std::max(aimHz, leastHz));
    const double lastHz = speed / m_unitsPerHz;
    const double changeHz = lastHz - firstHz;
    // Either the last pulse ends evenly, in the time given, or the ramp takes its own time.
    double rampS = 2 * pulses / (firstHz + lastHz);
    double endS = fromS + rampS;
    double misfitPulses = std::abs(evenHz - lastHz) * timeS / 2;
    if ((lastHz - meanHz) * (evenHz - lastHz) > 0) {
        const double shorterS = 2 * (lastHz * timeS - pulses) / changeHz;
        if (shorterS > 0 && lastHz * (timeS - shorterS) < 1) {
            rampS = shorterS;
            endS = fromS + timeS;
            misfitPulses = 0;
        }
    }
    if (misfitPulses > std::max(leastMisfitPulses, m_rules.misfitShare * m_rules.toleranceHz * timeS))
        return std::nullopt;
    if (!staysNear(fromS, firstHz, rampS, lastHz, endS))
        return std::nullopt;

    const double change = std::abs(static_cast<double>(speed) - static_cast<double>(from.speed));
    const double acceleration = std::ceil(std::ldexp(change * m_rules.iterationS / rampS, accumulatorBits));
    if (acceleration > std::numeric_limits<std::uint32_t>::max())
        return std::nullopt;
    return Fit{{static_cast<std::uint32_t>(to - from.pulses), from.speed, speed,
                static_cast<std::uint32_t>(acceleration)},
               endS};
}

std::optional<Node> Planner::finish(const Node& from, const Fit& fit) const
{
    const RowEnd end = rowEnd(fit.row, from.rest, m_rules.fractionBits);
    Node node;
    node.row = fit.row;
    node.pulses = from.pulses + fit.row.pulses;
    node.speed = fit.row.lastSpeed;
    node.iterations = from.iterations + end.iterations;
    node.rest = end.rest;
    // Rounding must not leave a part of a pulse to a slow end.
    const double plannedS = fit.endS - static_cast<double>(from.iterations) * m_rules.iterationS;
    const double lateS = static_cast<double>(end.iterations) * m_rules.iterationS - plannedS;
    if (lateS > mostLateShare * plannedS + 2 * m_rules.iterationS)
        return std::nullopt;
    return node;
}

std::optional<Node> Planner::follow(const Node& from, std::int64_t to, Aim aim) const
{
    // The last pulse comes at a speed as far above rest as the tolerance and the time allow.
    if (to == m_curve.wholePulses()) {
        for (const double share : {0.25, 1.0 / 16, 1.0 / 64, 1.0 / 256}) {
            const auto ending = fit(from, to, aim, share * m_rules.toleranceHz);
            const auto node = ending ? finish(from, *ending) : std::nullopt;
            if (node)
                return node;
        }
    }
    const auto fitting = fit(from, to, aim);
    return fitting ? finish(from, *fitting) : std::nullopt;
}

// Doubles the distance until it fails for good, then halves what is between.
std::int64_t Planner::longest(const Node& from, Aim aim) const
{
    constexpr int mostFailures = 3;
    const std::int64_t all = m_curve.wholePulses() - from.pulses;
    if (follow(from, from.pulses + all, aim))
        return all;
    std::int64_t good = 0;
    std::int64_t bad = all;
    int failures = 0;
    for (std::int64_t distance = 1; distance < all && failures < mostFailures; distance *= 2) {
        if (fit(from, from.pulses + distance, aim)) {
            good = distance;
            bad = all;
            failures = 0;
        } else {
            bad = std::min(bad, distance);
            ++failures;
        }
    }
    while (bad - good > 1) {
        const std::int64_t middle = good + (bad - good) / 2;
        (fit(from, from.pulses + middle, aim) ? good : bad) = middle;
    }
    return good;
}

std::vector<Node> Planner::followers(const Node& from) const
{
    constexpr std::array shares{1.0, 0.9, 0.75, 0.5};
    std::vector<Node> result;
    const auto add = [&](std::int64_t to, Aim aim) {
        if (to <= from.pulses || to > m_curve.wholePulses())
            return;
        if (const auto node = follow(from, to, aim))
            result.push_back(*node);
    };
    constexpr std::array aims{Aim::EvenTime, Aim::OnCurve, Aim::AboveCurve, Aim::BelowCurve};
    const std::size_t aimCount = m_rules.misfitShare > 0 ? aims.size() : 2; // half a pulse leaves no choice
    for (const Aim aim : std::span(aims).first(aimCount)) {
        const std::int64_t most = longest(from, aim);
        for (const double share : shares)
            add(from.pulses + std::llround(share * static_cast<double>(most)), aim);
        // A joint of the motion is a natural end.
        auto joint = std::ranges::upper_bound(m_jointPulses, from.pulses);
        for (int i = 0; i < 2 && joint != m_jointPulses.end(); ++i, ++joint) {
            for (const std::int64_t beside : {-1, 0, 1})
                add(*joint + beside, aim);
        }
    }
    return result;
}

std::optional<std::vector<IntervalRow>> Planner::plan(std::size_t mostRows)
{
    struct Branch {
        std::size_t node = 0;
        std::vector<Node> next;
        std::int64_t reach = 0;
    };
    std::vector<Node> nodes = starts(); // every one that went on, parents before their followers
    const std::size_t startCount = nodes.size();
    std::vector<std::size_t> level;
    for (std::size_t i = 0; i < startCount; ++i)
        level.push_back(i);
    for (std::size_t rows = 0; rows < mostRows && !level.empty(); ++rows) {
        std::vector<Branch> branches;
        for (const std::size_t i : level) {
            Branch branch{i, followers(nodes[i]), 0};
            for (const Node& node : branch.next)
                branch.reach = std::max(branch.reach, node.pulses);
            if (!branch.next.empty())
                branches.push_back(std::move(branch));
        }
        std::ranges::stable_sort(branches, std::ranges::greater{}, &Branch::reach);
        branches.resize(std::min(branches.size(), beamWidth));
        level.clear();
        std::optional<std::size_t> finished;
        for (const Branch& branch : branches) {
            for (Node node : branch.next) {
                node.parent = branch.node;
                if (node.pulses == m_curve.wholePulses() && !finished)
                    finished = nodes.size();
                level.push_back(nodes.size());
                nodes.push_back(node);
            }
        }
        if (!finished)
            continue;
        std::vector<IntervalRow> result;
        for (std::size_t i = *finished; i >= startCount; i = nodes[i].parent)
            result.push_back(nodes[i].row);
        std::ranges::reverse(result);
        return result;
    }
    return std::nullopt;
}

} // namespace

std::optional<std::vector<IntervalRow>> planRows(const SpeedCurve& curve, const PlanRules& rules,
                                                 std::size_t mostRows)
{
    return Planner(curve, rules).plan(mostRows);
}

} // namespace campanel::profile::detail
