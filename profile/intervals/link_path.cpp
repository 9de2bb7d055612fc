// SPDX-License-Identifier: Apache-2.0
#include "profile/intervals/link_path.h"

#include "profile/model/bounds.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace campanel::profile::detail {

namespace {

// A point of a wall; `next` is the first gate after it.
struct WallPoint {
    double time = 0;
    double value = 0;
    std::size_t next = 0;
};

struct Line {
    WallPoint through;
    double slope = 0;

    double at(double time) const { return through.value + slope * (time - through.time); }
};

double slope(const WallPoint& from, const WallPoint& to)
{
    return (to.value - from.value) / (to.time - from.time);
}

// The points of one wall that a line must stay above (sign 1) or below (sign -1), as their hull towards the
// channel. The comments on "above" hold mirrored for the other wall.
class Wall {
public:
    explicit Wall(double sign)
        : m_sign(sign)
    {
    }
    void clear()
    {
        m_hull.clear();
        m_first = 0;
    }
    void add(const WallPoint& point)
    {
        m_last = point;
        while (m_hull.size() >= m_first + 2 && !isConvex(m_hull[m_hull.size() - 2], m_hull.back(), point))
            m_hull.pop_back();
        m_hull.push_back(point);
    }
    // Returns the point from which the line to `to` stays above all others; drops points that no later line
    // can touch. Returns nothing when no point is earlier than `to`.
    std::optional<WallPoint> tangent(const WallPoint& to)
    {
        if (m_first >= m_hull.size() || m_hull[m_first].time >= to.time)
            return std::nullopt;
        while (m_first + 1 < m_hull.size() && m_hull[m_first + 1].time < to.time &&
               isConvex(m_hull[m_first], m_hull[m_first + 1], to))
            ++m_first;
        return m_hull[m_first];
    }
    const WallPoint& last() const { return m_last; }

private:
    bool isConvex(const WallPoint& a, const WallPoint& b, const WallPoint& c) const
    {
        const double turn = (b.time - a.time) * (c.value - a.value) - (b.value - a.value) * (c.time - a.time);
        return m_sign * turn < 0;
    }

    double m_sign;
    std::vector<WallPoint> m_hull;
    std::size_t m_first = 0;
    WallPoint m_last;
};

// One side of a link: its wall, and the steepest line towards the other wall.
struct Side {
    explicit Side(double wallSign)
        : sign(wallSign)
        , wall(wallSign)
    {
    }
    double sign;
    Wall wall;
    std::optional<Line> extreme; // towards this wall at its far end, away from it at its near one
    WallPoint contact;           // contact of the extreme line with this wall
};

class Links {
public:
    Links(std::span<const Gate> channel, LastLink last)
        : m_channel(channel)
        , m_last(last)
    {
    }

    std::optional<std::vector<PathPoint>> find(std::size_t maxLinks)
    {
        addTo(m_lower, m_upper, {m_channel[0].timeS, m_channel[0].lowerHz, 1});
        addTo(m_upper, m_lower, {m_channel[0].timeS, m_channel[0].upperHz, 1});
        for (std::size_t i = 1; i < m_channel.size();) {
            if (passes(i))
                ++i;
            else if (m_lines.size() >= maxLinks)
                return std::nullopt;
        }
        m_lines.push_back(lastLine());
        return knots();
    }

private:
    // Extends the link to gate i, or ends it before and begins the next one.
    bool passes(std::size_t i)
    {
        const Gate& gate = m_channel[i];
        const WallPoint lower{gate.timeS, gate.lowerHz, i + 1};
        const WallPoint upper{gate.timeS, gate.upperHz, i + 1};
        if (isBlocked(m_upper, lower)) {
            turn(m_upper, m_lower, lower, i);
            return false;
        }
        if (isBlocked(m_lower, upper)) {
            turn(m_lower, m_upper, upper, i);
            return false;
        }
        addTo(m_lower, m_upper, lower);
        addTo(m_upper, m_lower, upper);
        return true;
    }
    // Returns true when the opposite wall's point is beyond the line that extends farthest towards it.
    static bool isBlocked(const Side& side, const WallPoint& opposite)
    {
        constexpr double roundingShare = 1e-12;
        if (!side.extreme)
            return false;
        const double beyond = -side.sign * (opposite.value - side.extreme->at(opposite.time));
        return beyond > roundingShare * maxOf(1.0, std::abs(opposite.value));
    }
    // Sets the steepest line that touches `side` at the new point and the other wall before it.
    static void addTo(Side& side, Side& other, const WallPoint& point)
    {
        if (!side.extreme || side.sign * (point.value - side.extreme->at(point.time)) > 0) {
            if (const auto from = other.wall.tangent(point)) {
                side.extreme = Line{point, slope(*from, point)};
                side.contact = point;
            }
        }
        side.wall.add(point);
    }
    // Handles an extreme line that touches `near` and then hits `far` before gate i. The cut-off part begins
    // there: the next link starts between these two points.
    void turn(Side& near, Side& far, const WallPoint& beyond, std::size_t i)
    {
        const Line line = *near.extreme;
        const WallPoint contact = near.contact;
        const WallPoint exit = crossing(line, far.wall.last(), beyond, i);
        m_lines.push_back(line);
        m_windows.push_back({contact.time, maxOf(contact.time, exit.time)});
        const double wallSign = near.sign;
        for (Side* side : {&near, &far}) {
            side->wall.clear();
            side->extreme.reset();
        }
        addTo(near, far, contact);
        for (std::size_t j = contact.next; j < i; ++j)
            addTo(near, far,
                  {m_channel[j].timeS, wallSign > 0 ? m_channel[j].lowerHz : m_channel[j].upperHz, j + 1});
        addTo(far, near, exit);
    }
    static WallPoint crossing(const Line& line, const WallPoint& from, const WallPoint& to, std::size_t next)
    {
        const double inside = std::abs(line.at(from.time) - from.value);
        const double outside = std::abs(line.at(to.time) - to.value);
        const double share = inside + outside > 0 ? inside / (inside + outside) : 1;
        const double time = from.time + (to.time - from.time) * share;
        return {time, line.at(time), next};
    }
    Line lastLine() const
    {
        const std::optional<Line>& rising = m_upper.extreme;
        const std::optional<Line>& falling = m_lower.extreme;
        const double start = m_channel.front().timeS;
        if (!rising && !falling)
            return {{start, (m_channel.front().lowerHz + m_channel.front().upperHz) / 2, 0}, 0};
        if (!rising || !falling)
            return rising ? *rising : *falling;
        const double range = rising->slope - falling->slope;
        double share = 0.5;
        if (m_last == LastLink::LeastTurn && !m_lines.empty() && range > 0)
            share = clamped((m_lines.back().slope - falling->slope) / range, 0.0, 1.0);
        return {{start, falling->at(start) + share * (rising->at(start) - falling->at(start)), 0},
                falling->slope + share * range};
    }
    std::vector<PathPoint> knots() const
    {
        std::vector<PathPoint> result;
        const double start = m_channel.front().timeS;
        const double end = m_channel.back().timeS;
        result.push_back({start, m_lines.front().at(start)});
        for (std::size_t k = 0; k + 1 < m_lines.size(); ++k) {
            const Line& a = m_lines[k];
            const Line& b = m_lines[k + 1];
            double time = m_windows[k].second;
            if (a.slope != b.slope)
                time = a.through.time + (b.at(a.through.time) - a.through.value) / (a.slope - b.slope);
            time = clamped(time, m_windows[k].first, m_windows[k].second);
            result.push_back({time, a.at(time)});
        }
        result.push_back({end, m_lines.back().at(end)});
        return result;
    }

    std::span<const Gate> m_channel;
    LastLink m_last;
    Side m_lower{1};
    Side m_upper{-1};
    std::vector<Line> m_lines;
    std::vector<std::pair<double, double>> m_windows; // times of both ends
};

} // namespace

std::optional<std::vector<PathPoint>> minLinks(std::span<const Gate> channel, std::size_t maxLinks,
                                               LastLink last)
{
    const auto isShut = [](const Gate& gate) { return !(gate.lowerHz <= gate.upperHz); };
    const auto isWall = [](const Gate& a, const Gate& b) {
        return a.timeS == b.timeS && (a.lowerHz > b.upperHz || b.lowerHz > a.upperHz);
    };
    if (channel.empty() || maxLinks == 0 || std::ranges::any_of(channel, isShut) ||
        std::ranges::adjacent_find(channel, isWall) != channel.end())
        return std::nullopt;
    return Links(channel, last).find(maxLinks);
}

} // namespace campanel::profile::detail
