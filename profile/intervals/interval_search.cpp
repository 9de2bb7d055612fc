// SPDX-License-Identifier: Apache-2.0
// A beam search: each step keeps the candidates that are closest to the lines.
#include "profile/intervals/interval_search.h"

#include "profile/model/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace campanel::profile::detail {

namespace {

constexpr std::size_t beamWidth = 6;
constexpr double fewPulses = 64;
constexpr std::size_t checksPerRow = 24;
constexpr double skippedPulses = 2;
constexpr double lateShare = 0.001; // share of the last row's time

// A row with its predecessor and its end.
struct Node {
    IntervalRow row;
    std::int64_t pulses = 0;
    std::uint64_t iterations = 0;
    std::uint64_t rest = 0;
    std::size_t parent = 0;
    double endS = 0;
    double aside = 0; // deviation of the rows up to here from the lines

    std::uint32_t speed() const { return row.lastSpeed; }
};

// The intended end of a row, with the pulses up to there and the slopes of the adjacent lines.
struct Target {
    double timeS = 0;
    double speedHz = 0;
    double pulses = 0;
    double slopeIn = 0;
    double slopeOut = 0;
    double rampEndS = 0; // time when the row reaches its last speed
};

bool isFlat(const std::vector<PathPoint>& lines, std::size_t end)
{
    return lines[end].speedHz == lines[end - 1].speedHz;
}

// Returns true when the line to this end continues, in the same row, as the horizontal one after it.
bool isHeld(const std::vector<PathPoint>& lines, std::size_t end)
{
    return end + 1 < lines.size() && !isFlat(lines, end) && isFlat(lines, end + 1);
}

std::vector<Target> targets(const std::vector<PathPoint>& lines)
{
    const auto slope = [&](std::size_t end) {
        return (lines[end].speedHz - lines[end - 1].speedHz) / (lines[end].timeS - lines[end - 1].timeS);
    };
    std::vector<Target> result;
    double pulses = 0;
    double rampEndS = 0;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        pulses += (lines[k].speedHz + lines[k - 1].speedHz) / 2 * (lines[k].timeS - lines[k - 1].timeS);
        if (k < 2 || !isHeld(lines, k - 1))
            rampEndS = lines[k].timeS;
        if (isHeld(lines, k))
            continue;
        const double in = slope(k);
        const double out = k + 1 < lines.size() ? slope(k + 1) : in;
        result.push_back({lines[k].timeS, lines[k].speedHz, pulses, in, out, rampEndS});
    }
    return result;
}

// The rounding of the acceleration. Every row reaches its last speed within its distance.
enum class Rounding {
    Nearest, // the last speed is the reached one
    Up,      // the same
    Down,    // the same
    Keep,    // up, and the last speed stays: the remaining distance passes at it
};

class RowSearch {
public:
    RowSearch(const SpeedCurve& curve, const RowRules& rules, double toleranceHz)
        : m_curve(curve)
        , m_rules(rules)
        , m_toleranceHz(toleranceHz)
        , m_unitsPerHz(std::ldexp(rules.iterationS, accumulatorBits + rules.fractionBits))
    {
    }

    std::optional<std::vector<IntervalRow>> along(const std::vector<PathPoint>& lines) const;

private:
    std::vector<Node> starts(double speedHz) const;
    void addFollowers(std::vector<Node>& result, const Node& from, const Target& target) const;
    void addEndings(std::vector<Node>& result, const Node& from, const Target& target) const;
    void settle(Node& node, const Node& from) const;
    double meetingHz(const Node& from, std::int64_t pulses, const Target& target, double slope) const;
    std::optional<Node> follow(const Node& from, std::int64_t pulses, double lastHz, double rampS,
                               Rounding rounding) const;
    std::uint32_t reached(const IntervalRow& row, double distance) const;
    bool staysNear(double fromS, double firstHz, double rampS, double lastHz, double endS) const;
    double secondsAt(const Node& node) const
    {
        return static_cast<double>(node.iterations) * m_rules.iterationS;
    }
    double hertz(std::uint32_t speed) const { return speed / m_unitsPerHz; }
    std::uint32_t units(double hz) const
    {
        const double max = maxOf(1.0, std::floor(m_rules.maxHz * m_unitsPerHz));
        return static_cast<std::uint32_t>(clamped(std::round(hz * m_unitsPerHz), 1.0, max));
    }

    const SpeedCurve& m_curve;
    RowRules m_rules;
    double m_toleranceHz;
    double m_unitsPerHz;
};

bool RowSearch::staysNear(double fromS, double firstHz, double rampS, double lastHz, double endS) const
{
    const auto isNear = [&](double timeS, double curveHz) {
        const double speedHz =
            timeS - fromS >= rampS ? lastHz : firstHz + (lastHz - firstHz) * (timeS - fromS) / rampS;
        return std::abs(curveHz - speedHz) <= m_toleranceHz;
    };
    const double endOfMotionS = clamped(m_curve.durationS(), fromS, endS);
    for (const double timeS : {fromS, minOf(fromS + rampS, endS), endOfMotionS, endS}) {
        if (!isNear(timeS, m_curve.speedAt(timeS)))
            return false;
    }
    const std::vector<CurveSample>& samples = m_curve.samples();
    const std::size_t first = m_curve.indexAt(fromS) + 1;
    const std::size_t end = m_curve.indexAt(endS) + 1;
    for (const double share : {0.25, 0.5, 0.75}) {
        const double timeS = fromS + share * (endS - fromS);
        if (!isNear(timeS, m_curve.speedAt(timeS)))
            return false;
    }
    const std::size_t stride = first < end ? 1 + (end - first) / checksPerRow : 1;
    for (std::size_t i = first; i < end; i += stride) {
        if (!isNear(samples[i].timeS, samples[i].speedHz))
            return false;
    }
    return std::ranges::all_of(m_curve.corners(), [&](std::size_t corner) {
        return corner < first || corner >= end || isNear(samples[corner].timeS, samples[corner].speedHz);
    });
}

// Returns the last speed that the row's acceleration reaches within its distance, at the most.
std::uint32_t RowSearch::reached(const IntervalRow& row, double distance) const
{
    const double first = row.firstSpeed;
    const double change =
        2 * std::ldexp(static_cast<double>(row.acceleration), m_rules.fractionBits) * distance;
    const double min = maxOf(1.0, std::ceil(m_rules.minHz * m_unitsPerHz));
    const double max = maxOf(1.0, std::floor(m_rules.maxHz * m_unitsPerHz));
    if (row.lastSpeed > row.firstSpeed)
        return static_cast<std::uint32_t>(clamped(std::floor(std::sqrt(first * first + change)), first, max));
    const double left = std::sqrt(maxOf(0.0, first * first - change));
    return static_cast<std::uint32_t>(clamped(std::ceil(left), minOf(min, first), first));
}

// Returns the row that reaches lastHz after rampS, or at the end of its distance if that is earlier.
std::optional<Node> RowSearch::follow(const Node& from, std::int64_t pulses, double lastHz, double rampS,
                                      Rounding rounding) const
{
    if (pulses <= from.pulses || pulses > m_curve.wholePulses() || !(lastHz >= m_rules.minHz))
        return std::nullopt;
    constexpr double max = std::numeric_limits<std::uint32_t>::max();
    const int bits = accumulatorBits + m_rules.fractionBits;
    const auto whole = static_cast<double>(pulses - from.pulses);
    const double firstHz = hertz(from.speed());
    IntervalRow row{static_cast<std::uint32_t>(pulses - from.pulses), from.speed(), units(lastHz), 0};
    const double sum = firstHz + hertz(row.lastSpeed);
    // On average the speed register is half a unit behind the linear ramp, and half an iteration ahead.
    const double changeHz = hertz(row.lastSpeed) - firstHz;
    const double unitHz = std::copysign(hertz(1), changeHz);
    const double behindPulses = (unitHz * minOf(rampS, 2 * whole / sum) - changeHz * m_rules.iterationS) / 2;
    const double distance = whole + behindPulses - std::ldexp(static_cast<double>(from.rest), -bits);
    if (!(distance > 0))
        return std::nullopt;
    const double evenS = 2 * distance / sum;
    const bool isHeld = rampS < evenS * (1 - 1e-9);
    const double change = std::abs(static_cast<double>(row.lastSpeed) - row.firstSpeed);
    if (change > 0) {
        const double exact = std::ldexp(change * m_rules.iterationS / minOf(rampS, evenS), accumulatorBits);
        double acceleration = std::ceil(exact);
        if (!isHeld && rounding == Rounding::Nearest)
            acceleration = std::round(exact);
        else if (!isHeld && rounding == Rounding::Down)
            acceleration = std::floor(exact);
        const double squares = change * (static_cast<double>(row.firstSpeed) + row.lastSpeed);
        const double minAcceleration = std::ceil(squares / (std::ldexp(2 * whole, m_rules.fractionBits)));
        acceleration = maxOf(1.0, acceleration);
        if (isHeld || rounding == Rounding::Keep)
            acceleration = maxOf(acceleration, minAcceleration);
        if (!(maxOf(acceleration, whole) <= max))
            return std::nullopt;
        row.acceleration = static_cast<std::uint32_t>(acceleration);
        if (!isHeld && rounding != Rounding::Keep)
            row.lastSpeed = reached(row, minOf(distance, whole));
    }
    if (row.lastSpeed == row.firstSpeed)
        row.acceleration = 0;
    const double endHz = hertz(row.lastSpeed);
    const double realRampS = static_cast<double>(rampIterations(row)) * m_rules.iterationS;
    const double leftPulses = maxOf(0.0, distance - realRampS * (firstHz + endHz) / 2);
    Node node;
    node.endS = secondsAt(from) + realRampS + leftPulses / endHz;
    if (!staysNear(secondsAt(from), firstHz, realRampS, endHz, node.endS))
        return std::nullopt;
    node.row = row;
    node.pulses = pulses;
    return node;
}

// Sets the true end of the row.
void RowSearch::settle(Node& node, const Node& from) const
{
    const RowEnd end = rowEnd(node.row, from.rest, m_rules.fractionBits);
    node.iterations = from.iterations + end.iterations;
    node.rest = end.rest;
}

// Returns the possible first speeds: from rest they are free within the tolerance.
std::vector<Node> RowSearch::starts(double speedHz) const
{
    constexpr int choices = 8;
    std::vector<Node> result(1);
    result.front().row.lastSpeed = units(speedHz);
    if (!m_curve.beginsAtRest())
        return result;
    for (int i = 0; i <= choices; ++i) {
        const double hz = maxOf(m_rules.minHz, m_toleranceHz * i / choices);
        Node start;
        start.row.lastSpeed = units(hz);
        start.aside = std::pow((hz - speedHz) / m_toleranceHz, 2);
        result.push_back(start);
    }
    return result;
}

// Returns the last speed of a row over this many pulses that meets the line of a slope through the target.
double RowSearch::meetingHz(const Node& from, std::int64_t pulses, const Target& target, double slope) const
{
    const double firstHz = hertz(from.speed());
    const double sum = firstHz + target.speedHz + slope * (secondsAt(from) - target.timeS);
    const double root = sum * sum + 8 * slope * static_cast<double>(pulses - from.pulses);
    return (sum + std::sqrt(maxOf(0.0, root))) / 2 - firstHz;
}

void RowSearch::addFollowers(std::vector<Node>& result, const Node& from, const Target& target) const
{
    const bool isHeld = target.rampEndS < target.timeS;
    const double rampS = isHeld ? target.rampEndS - secondsAt(from) : std::numeric_limits<double>::infinity();
    if (!(rampS > 0))
        return;
    const double meanSlope = (target.slopeIn + target.slopeOut) / 2;
    const auto add = [&](std::int64_t pulses, double lastHz) {
        auto node = follow(from, pulses, lastHz, rampS, Rounding::Nearest);
        if (!node)
            return;
        const double speedHz = hertz(node->speed());
        const double lateS = node->endS - target.timeS;
        const double aboveHz = speedHz - target.speedHz - lateS * meanSlope;
        const double aheadPulses =
            static_cast<double>(pulses) - lateS * (target.speedHz + speedHz) / 2 - target.pulses;
        node->aside = from.aside + std::pow(aboveHz / m_toleranceHz, 2) + aheadPulses * aheadPulses;
        result.push_back(*node);
    };
    const auto nearest = std::llround(target.pulses);
    const bool isShort = target.pulses - static_cast<double>(from.pulses) <= fewPulses;
    for (const std::int64_t pulses : {nearest, nearest - 1, nearest + 1}) {
        const double middleHz = isHeld ? target.speedHz : meetingHz(from, pulses, target, meanSlope);
        add(pulses, middleHz);
        if (!isHeld) {
            add(pulses, meetingHz(from, pulses, target, target.slopeIn));
            add(pulses, meetingHz(from, pulses, target, target.slopeOut));
        }
        if (!isShort)
            continue;
        // Rows of few pulses deviate from the lines by more than a step in time.
        for (const double share : {-0.8, -0.6, -0.4, -0.2, 0.2, 0.4, 0.6, 0.8})
            add(pulses, middleHz + share * m_toleranceHz);
    }
}

// Adds last rows that end on time, as nearly as whole pulses allow.
void RowSearch::addEndings(std::vector<Node>& result, const Node& from, const Target& target) const
{
    constexpr double latePulses = 0.5;
    constexpr double maxLate = 2; // in lateS, which counts as much as the tolerance
    constexpr double even = std::numeric_limits<double>::infinity();
    const std::int64_t pulses = m_curve.wholePulses();
    const auto distance = static_cast<double>(pulses - from.pulses);
    const double timeS = target.timeS - secondsAt(from);
    if (!(timeS > 0))
        return;
    const double firstHz = hertz(from.speed());
    // The pulses needed at the slow end of the row because of the registers' units.
    const double acceleration = std::abs(firstHz - target.speedHz) / timeS;
    const double unitHzPerS = 1 / (std::ldexp(m_rules.iterationS, accumulatorBits) * m_unitsPerHz);
    const double leftPulses = timeS / m_unitsPerHz / 2 + distance * unitHzPerS / acceleration;
    const double unitS = acceleration > 0 ? std::sqrt(2 * leftPulses / acceleration) : 0;
    const double lateS = maxOf(timeS * lateShare, timeS * latePulses / maxOf(1.0, distance), unitS);
    const auto add = [&](double speedHz, double rampS, Rounding rounding) {
        if (!(rampS > 0))
            return;
        auto node = follow(from, pulses, speedHz, rampS, rounding);
        if (!node)
            return;
        settle(*node, from);
        const double late = (secondsAt(*node) - target.timeS) / lateS;
        if (std::abs(late) > maxLate)
            return;
        node->aside = from.aside + late * late;
        result.push_back(*node);
    };
    // Returns the ramp time with which the row ends on time.
    const auto onTimeRampS = [&](double lastHz) {
        return (timeS - distance / lastHz) / (1 - (firstHz + lastHz) / 2 / lastHz);
    };
    std::vector<double> speeds{target.speedHz};
    if (m_curve.endsAtRest()) {
        constexpr double finest = 1.0 / 64; // share of the tolerance
        constexpr double factor = 1.5;
        speeds.push_back(2 * distance / timeS - firstHz);
        for (double speed = maxOf(m_rules.minHz, finest * m_toleranceHz); speed <= m_toleranceHz;
             speed *= factor)
            speeds.push_back(speed);
    }
    for (const double speed : speeds) {
        add(speed, even, Rounding::Keep);
        add(speed, onTimeRampS(speed), Rounding::Keep);
        if (target.rampEndS < target.timeS)
            add(speed, target.rampEndS - secondsAt(from), Rounding::Keep);
        if (m_curve.endsAtRest()) {
            add(speed, even, Rounding::Up);
            add(speed, even, Rounding::Down);
        }
    }
}

std::optional<std::vector<IntervalRow>> RowSearch::along(const std::vector<PathPoint>& lines) const
{
    std::vector<Node> nodes = starts(lines.front().speedHz); // parents before their successors
    std::vector<std::size_t> level(nodes.size());
    std::iota(level.begin(), level.end(), std::size_t{0});
    std::vector<Node> next;
    for (const Target& target : targets(lines)) {
        next.clear();
        const bool isLast = target.timeS >= lines.back().timeS;
        for (const std::size_t i : level) {
            const std::size_t first = next.size();
            if (isLast)
                addEndings(next, nodes[i], target);
            else
                addFollowers(next, nodes[i], target);
            for (std::size_t j = first; j < next.size(); ++j)
                next[j].parent = i;
            // Near rest less than a pulse may remain: a later row covers it.
            if (!isLast && target.pulses - static_cast<double>(nodes[i].pulses) < skippedPulses)
                next.push_back(nodes[i]);
        }
        std::ranges::stable_sort(next, {}, &Node::aside);
        const auto isSame = [](const Node& a, const Node& b) {
            return a.parent == b.parent && a.row == b.row;
        };
        next.erase(std::unique(next.begin(), next.end(), isSame), next.end());
        next.resize(minOf(next.size(), beamWidth));
        level.clear();
        for (Node& node : next) {
            if (node.iterations == 0 && node.row.pulses > 0)
                settle(node, nodes[node.parent]);
            level.push_back(nodes.size());
            nodes.push_back(node);
        }
    }
    if (level.empty())
        return std::nullopt;
    std::vector<IntervalRow> result;
    for (std::size_t i = level.front(); nodes[i].row.pulses > 0; i = nodes[i].parent)
        result.push_back(nodes[i].row);
    std::ranges::reverse(result);
    return result;
}

} // namespace

std::size_t rowsOf(const std::vector<PathPoint>& lines)
{
    return targets(lines).size();
}

std::size_t maxRowsOf(const std::vector<PathPoint>& lines)
{
    const std::vector<Target> ends = targets(lines);
    std::size_t rows = 1; // the last one
    std::int64_t before = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const std::int64_t nearest = std::llround(ends[i].pulses);
        const std::int64_t pulses = maxOf(before + 1, nearest - 1);
        if (pulses > nearest + 1)
            continue;
        before = pulses;
        ++rows;
    }
    return rows;
}

std::optional<std::vector<IntervalRow>> rowsAlong(const std::vector<PathPoint>& lines,
                                                  const SpeedCurve& curve, const RowRules& rules,
                                                  double toleranceHz)
{
    return RowSearch(curve, rules, toleranceHz).along(lines);
}

} // namespace campanel::profile::detail
